// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/element_loop.hpp"

#include <algorithm>
#include <optional>

#include "structure/dynamics/lanes.hpp"
#include "structure/material/failure_trigger.hpp"

namespace fissura::structure {

namespace {

// Edge vectors from the first corner and strain of a triangle; all the loop ever needs of its geometry.
struct EdgeStrain {
  Lanes x1, y1, x2, y2;
  InPlane<Lanes> strain;
};

inline EdgeStrain edge_strain(const RecordLanes& a, const RecordLanes& b, const RecordLanes& c) {
  const Lanes x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
  const Lanes u1 = b.ux - a.ux, v1 = b.uy - a.uy, u2 = c.ux - a.ux, v2 = c.uy - a.uy;
  const Lanes scale = 1.0 / (x1 * y2 - x2 * y1);
  return {x1,
          y1,
          x2,
          y2,
          {(u1 * y2 - u2 * y1) * scale, (v2 * x1 - v1 * x2) * scale,
           ((u2 * x1 - u1 * x2) + (v1 * y2 - v2 * y1)) * scale}};
}

struct CornerForces {
  Lanes x0, y0, x1, y1, x2, y2;
};

// - A stress . grad N_i ; the slopes of N_1 and N_2 are edge normals over twice the area.
inline CornerForces corner_forces(const EdgeStrain& edge, const InPlane<Lanes>& total) {
  const Lanes half_xx = 0.5 * total.xx, half_yy = 0.5 * total.yy, half_xy = 0.5 * total.xy;
  const Lanes fx1 = half_xy * edge.x2 - half_xx * edge.y2, fy1 = half_yy * edge.x2 - half_xy * edge.y2;
  const Lanes fx2 = half_xx * edge.y1 - half_xy * edge.x1, fy2 = half_xy * edge.y1 - half_yy * edge.x1;
  return {-(fx1 + fx2), -(fy1 + fy2), fx1, fy1, fx2, fy2};
}

inline void add_corner_forces(std::array<double, 2>* force, const std::uint16_t* a, const std::uint16_t* b,
                              const std::uint16_t* c, const CornerForces& f) {
  const PairLanes at_a = interleave(f.x0, f.y0), at_b = interleave(f.x1, f.y1), at_c = interleave(f.x2, f.y2);
  add_quad<0>(force, a, at_a);
  add_quad<0>(force, b, at_b);
  add_quad<0>(force, c, at_c);
  if constexpr (lanes == 8) {
    add_quad<lanes - 4>(force, a, at_a);
    add_quad<lanes - 4>(force, b, at_b);
    add_quad<lanes - 4>(force, c, at_c);
  }
}

struct ElasticOnly {
  void operator()(std::size_t, const InPlane<Lanes>&, InPlane<Lanes>&, Lanes&) const {}
};

struct TensionSurface {
  RankineSurface rankine;

  LaneMask exceeded(std::size_t, const InPlane<Lanes>&, const InPlane<Lanes>& stress) const {
    return exceeds(mohr_radius_squared(stress), rankine.radius_limit(mohr_centre(stress)));
  }
};

struct TensionAndShearSurface {
  RankineSurface rankine;
  MohrCoulombLimit mohr_coulomb;
  double lame;
  const float* in_situ_out_of_plane;

  LaneMask exceeded(std::size_t place, const InPlane<Lanes>& strain, const InPlane<Lanes>& stress) const {
    const Lanes centre = mohr_centre(stress);
    const Lanes out_of_plane = load_floats(in_situ_out_of_plane + place) + lame * (strain.xx + strain.yy);
    const Lanes tension = rankine.radius_limit(centre);
    const Lanes shear = mohr_coulomb.radius_limit(centre, out_of_plane);
    return exceeds(mohr_radius_squared(stress), tension < shear ? tension : shear);
  }
};

// Lists the elements that may fail or have failed and takes their stress out of the first pass.
template <class Surface>
struct ListFailing {
  Surface surface;
  const std::uint8_t* failed;
  std::vector<std::uint16_t>* listed;

  void operator()(std::size_t place, const InPlane<Lanes>& strain, InPlane<Lanes>& stress,
                  Lanes& pressure) const {
    const LaneMarks marks = marks_of(surface.exceeded(place, strain, stress)) | load_marks(failed + place);
    if (marks == 0) [[likely]]
      return;
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (marked(marks, lane)) listed->push_back(static_cast<std::uint16_t>(place + lane));
    stress = {unmarked(stress.xx, marks), unmarked(stress.yy, marks), unmarked(stress.xy, marks)};
    pressure = unmarked(pressure, marks);
  }
};

// Strains first, then forces, a few groups at a time: two short chains of dependent instructions, of which
// the processor overlaps several, in place of a long one.
constexpr std::size_t groups_per_batch = 8;
constexpr std::size_t vectors_per_group = group_width / lanes;

template <class Failure>
void first_pass(const Tile& tile, const Elasticity& moduli, const Failure& failure, const ReadAhead& ahead,
                TileWorkspace& workspace) {
  const NodeRecord* record = workspace.record.data();
  std::array<double, 2>* force = workspace.force.data();
  EdgeStrain edges[groups_per_batch * vectors_per_group];
  for (std::size_t batch = 0; batch < tile.groups.size(); batch += groups_per_batch) {
    const std::size_t vectors = vectors_per_group * std::min(groups_per_batch, tile.groups.size() - batch);
    const ElementGroup* groups = tile.groups.data() + batch;
    for (std::size_t v = 0; v < vectors; ++v) {
      const auto& node = groups[v / vectors_per_group].node;
      const std::size_t lane = v % vectors_per_group * lanes;
      edges[v] = edge_strain(load_records(record, node[0] + lane), load_records(record, node[1] + lane),
                             load_records(record, node[2] + lane));
    }
    for (std::size_t v = 0; v < vectors; ++v) {
      const ElementGroup& group = groups[v / vectors_per_group];
      if (v % vectors_per_group == 0) ahead.fetch(batch + v / vectors_per_group);
      const std::size_t lane = v % vectors_per_group * lanes;
      InPlane<Lanes> stress = elastic_stress(moduli, edges[v].strain);
      stress.xx += load_floats(group.stress[0] + lane);
      stress.yy += load_floats(group.stress[1] + lane);
      stress.xy += load_floats(group.stress[2] + lane);
      Lanes pressure = load_floats(group.pore_pressure + lane);
      failure(batch * group_width + v * lanes, edges[v].strain, stress, pressure);
      const auto f = corner_forces(edges[v], {stress.xx - pressure, stress.yy - pressure, stress.xy});
      add_corner_forces(force, group.node[0] + lane, group.node[1] + lane, group.node[2] + lane, f);
    }
  }
}

// Listed elements, gathered like a group of the tile; filled up with padding elements.
struct Gathered {
  std::uint16_t node[3][lanes];
  InPlane<Lanes> in_situ{};
  Lanes out_of_plane{};
  Lanes pressure{};
};

Gathered gather_listed(const Tile& tile, const std::uint16_t* places, std::size_t count) {
  Gathered gathered;
  for (std::size_t i = 0; i < lanes; ++i) {
    if (i >= count) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        gathered.node[corner][i] = static_cast<std::uint16_t>(tile.nodes.size() + corner);
      continue;
    }
    const ElementGroup& group = tile.groups[places[i] / group_width];
    const std::size_t lane = places[i] % group_width;
    for (std::size_t corner = 0; corner < 3; ++corner) gathered.node[corner][i] = group.node[corner][lane];
    gathered.in_situ.xx[i] = group.stress[0][lane];
    gathered.in_situ.yy[i] = group.stress[1][lane];
    gathered.in_situ.xy[i] = group.stress[2][lane];
    gathered.out_of_plane[i] = tile.out_of_plane[places[i]];
    gathered.pressure[i] = group.pore_pressure[lane];
  }
  return gathered;
}

struct ListedElements {
  const Gathered& gathered;
  const std::uint16_t* places;
  std::size_t count;
  const NodeRecord* node_record;

  [[nodiscard]] std::array<Point, 3> corners(std::size_t i) const {
    const auto corner = [&](int c) {
      const NodeRecord& node = node_record[gathered.node[c][i]];
      return Point{node.x, node.y};
    };
    return {corner(0), corner(1), corner(2)};
  }
};

// Index of the record of a listed element, which starts here if it may; none while it stays elastic.
std::optional<std::size_t> record_of(const ListedElements& elements, std::size_t i, const RockFailure& law,
                                     const PlaneStrainStress& elastic, TileDamage& damage) {
  const std::uint16_t place = elements.places[i];
  if (damage.failed[place]) return damage.record_of[place];
  if (std::binary_search(damage.forbidden.begin(), damage.forbidden.end(), place)) return std::nullopt;
  const auto onset = failure_onset(law, elastic, elements.corners(i));
  if (!onset) return std::nullopt;
  damage.failed[place] = 1;
  damage.record_of[place] = static_cast<std::uint16_t>(damage.record.size());
  damage.record.push_back(*onset);
  damage.plastic.emplace_back();
  return damage.record.size() - 1;
}

PlaneStrainStress in_lane(const InPlane<Lanes>& stress, const Lanes& out_of_plane, std::size_t i) {
  return {{stress.xx[i], stress.yy[i], stress.xy[i]}, out_of_plane[i]};
}

// s - D s+ of elements that fail in tension only: the roots and the tensile part in lanes.
InPlane<Lanes> stress_of_cracking(const ListedElements& elements, const InPlane<Lanes>& stress,
                                  const Lanes& out_of_plane, const RockFailure& law, TileDamage& damage) {
  const Lanes centre = mohr_centre(stress), radius = square_root(mohr_radius_squared(stress));
  const Lanes equivalent_strain = (centre + radius) / law.tension.band_modulus;
  Lanes damaged{};
  for (std::size_t i = 0; i < elements.count; ++i) {
    const auto record = record_of(elements, i, law, in_lane(stress, out_of_plane, i), damage);
    if (!record) continue;
    DamageHistory& history = damage.record[*record];
    grow_damage(law.tension, equivalent_strain[i], history);
    damaged[i] = history.damage;
  }
  const auto tensile = tensile_part(stress, centre, radius);
  return {stress.xx - damaged * tensile.xx, stress.yy - damaged * tensile.yy,
          stress.xy - damaged * tensile.xy};
}

// The same with plastic flow, which takes the elements one by one.
InPlane<Lanes> stress_of_shearing(const ListedElements& elements, InPlane<Lanes> stress,
                                  const Lanes& out_of_plane, const RockFailure& law, TileDamage& damage) {
  for (std::size_t i = 0; i < elements.count; ++i) {
    const PlaneStrainStress elastic = in_lane(stress, out_of_plane, i);
    const auto record = record_of(elements, i, law, elastic, damage);
    if (!record) continue;
    const auto failed = failed_stress(law, elastic, damage.record[*record], damage.plastic[*record]);
    stress.xx[i] = failed.in_plane.xx;
    stress.yy[i] = failed.in_plane.yy;
    stress.xy[i] = failed.in_plane.xy;
  }
  return stress;
}

void second_pass(const Tile& tile, const Elasticity& moduli, const RockFailure& law, TileDamage& damage,
                 TileWorkspace& workspace) {
  const NodeRecord* record = workspace.record.data();
  for (std::size_t begin = 0; begin < workspace.listed.size(); begin += lanes) {
    const std::uint16_t* places = workspace.listed.data() + begin;
    const std::size_t count = std::min(lanes, workspace.listed.size() - begin);
    const Gathered gathered = gather_listed(tile, places, count);
    const auto edge =
        edge_strain(load_records(record, gathered.node[0]), load_records(record, gathered.node[1]),
                    load_records(record, gathered.node[2]));
    InPlane<Lanes> stress = elastic_stress(moduli, edge.strain);
    stress.xx += gathered.in_situ.xx;
    stress.yy += gathered.in_situ.yy;
    stress.xy += gathered.in_situ.xy;
    const Lanes out_of_plane = gathered.out_of_plane + moduli.lame * (edge.strain.xx + edge.strain.yy);
    const ListedElements elements{gathered, places, count, record};
    stress = law.shear ? stress_of_shearing(elements, stress, out_of_plane, law, damage)
                       : stress_of_cracking(elements, stress, out_of_plane, law, damage);
    const auto f =
        corner_forces(edge, {stress.xx - gathered.pressure, stress.yy - gathered.pressure, stress.xy});
    add_corner_forces(workspace.force.data(), gathered.node[0], gathered.node[1], gathered.node[2], f);
  }
}

}  // namespace

void gather_nodes(const Tile& tile, const std::vector<double>& displacement, TileWorkspace& workspace) {
  const std::size_t nodes = tile.nodes.size(), padded = nodes + padding_corners.size();
  if (workspace.record.size() < padded) workspace.record.resize(padded);
  workspace.force.assign(padded, {0, 0});
  for (std::size_t i = 0; i < nodes; ++i) {
    const double* u = displacement.data() + 2 * std::size_t{tile.nodes[i]};
    workspace.record[i] = {tile.position[i][0], tile.position[i][1], u[0], u[1]};
  }
  for (std::size_t corner = 0; corner < padding_corners.size(); ++corner)
    workspace.record[nodes + corner] = {padding_corners[corner][0], padding_corners[corner][1], 0, 0};
}

void add_elastic_forces(const Tile& tile, const Elasticity& moduli, const ReadAhead& ahead,
                        TileWorkspace& workspace) {
  first_pass(tile, moduli, ElasticOnly{}, ahead, workspace);
}

void add_failing_forces(const Tile& tile, const Elasticity& moduli, const RockFailure& law,
                        double lowest_strength, const ReadAhead& ahead, TileDamage& damage,
                        TileWorkspace& workspace) {
  workspace.listed.clear();
  const std::uint8_t* failed = damage.failed.data();
  const RankineSurface rankine{lowest_strength};
  if (law.shear) {
    const TensionAndShearSurface surface{rankine, MohrCoulombLimit(law.shear->surface), moduli.lame,
                                         tile.out_of_plane.data()};
    first_pass(tile, moduli, ListFailing<TensionAndShearSurface>{surface, failed, &workspace.listed}, ahead,
               workspace);
  } else {
    first_pass(tile, moduli, ListFailing<TensionSurface>{{rankine}, failed, &workspace.listed}, ahead,
               workspace);
  }
  second_pass(tile, moduli, law, damage, workspace);
}

}  // namespace fissura::structure
