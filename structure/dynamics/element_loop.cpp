// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/element_loop.hpp"

#include "structure/material/crack_band.hpp"
#include "structure/material/failure_trigger.hpp"

namespace fissura::structure {

namespace {

// Edge vectors from the first corner and strain of a triangle; all the loop ever needs of its geometry.
template <class Real>
struct EdgeStrain {
  Real x1, y1, x2, y2;
  InPlane<Real> strain;
};

template <class Record>
inline auto edge_strain(const Record& a, const Record& b, const Record& c) {
  using Real = std::decay_t<decltype(a.x)>;
  const Real x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
  const Real u1 = b.ux - a.ux, v1 = b.uy - a.uy, u2 = c.ux - a.ux, v2 = c.uy - a.uy;
  const Real scale = 1.0 / (x1 * y2 - x2 * y1);
  return EdgeStrain<Real>{x1,
                          y1,
                          x2,
                          y2,
                          {(u1 * y2 - u2 * y1) * scale, (v2 * x1 - v1 * x2) * scale,
                           ((u2 * x1 - u1 * x2) + (v1 * y2 - v2 * y1)) * scale}};
}

template <class Real>
struct CornerForces {
  Real x0, y0, x1, y1, x2, y2;
};

// - A stress . grad N_i ; the slopes of N_1 and N_2 are edge normals over twice the area.
template <class Real>
inline CornerForces<Real> corner_forces(const EdgeStrain<Real>& edge, const InPlane<Real>& total) {
  const Real half_xx = 0.5 * total.xx, half_yy = 0.5 * total.yy, half_xy = 0.5 * total.xy;
  const Real fx1 = half_xy * edge.x2 - half_xx * edge.y2, fy1 = half_yy * edge.x2 - half_xy * edge.y2;
  const Real fx2 = half_xx * edge.y1 - half_xy * edge.x1, fy2 = half_xy * edge.y1 - half_yy * edge.x1;
  return {-(fx1 + fx2), -(fy1 + fy2), fx1, fy1, fx2, fy2};
}

template <std::size_t bytes>
bool any_byte(const std::uint8_t* first) {
  std::uint64_t combined = 0;
  std::memcpy(&combined, first, bytes);
  return combined != 0;
}

struct ElasticOnly {
  void operator()(std::size_t, InPlane<Lanes>&, Lanes&) const {}
};

// Lists the lanes that may fail and takes their stress out of the first pass.
struct ListFailing {
  RankineSurface surface;
  const std::uint8_t* cracked;
  std::vector<std::uint16_t>* listed;

  void operator()(std::size_t place, InPlane<Lanes>& stress, Lanes& pressure) const {
    const LaneMask outside = exceeds(mohr_radius_squared(stress), surface.radius_limit(mohr_centre(stress)));
    if (any(outside) || any_byte<lanes>(cracked + place)) [[unlikely]]
      list(place, outside, stress, pressure);
  }

  void list(std::size_t place, const LaneMask& outside, InPlane<Lanes>& stress, Lanes& pressure) const {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (!outside[lane] && !cracked[place + lane]) continue;
      listed->push_back(static_cast<std::uint16_t>(place + lane));
      stress.xx[lane] = stress.yy[lane] = stress.xy[lane] = pressure[lane] = 0;
    }
  }
};

template <class Failure>
void first_pass(const Tile& tile, const Elasticity& moduli, const Failure& failure,
                TileWorkspace& workspace) {
  const NodeRecord* record = workspace.record.data();
  std::array<double, 2>* force = workspace.force.data();
  for (std::size_t g = 0; g < tile.groups.size(); ++g) {
    const ElementGroup& group = tile.groups[g];
    for (std::size_t begin = 0; begin < group_width; begin += lanes) {
      const auto edge = edge_strain(load_records(record, group.node[0] + begin),
                                    load_records(record, group.node[1] + begin),
                                    load_records(record, group.node[2] + begin));
      InPlane<Lanes> stress = elastic_stress(moduli, edge.strain);
      stress.xx += load_floats(group.stress[0] + begin);
      stress.yy += load_floats(group.stress[1] + begin);
      stress.xy += load_floats(group.stress[2] + begin);
      Lanes pressure = load_floats(group.pore_pressure + begin);
      failure(g * group_width + begin, stress, pressure);
      const InPlane<Lanes> total{stress.xx - pressure, stress.yy - pressure, stress.xy};
      const auto f = corner_forces(edge, total);
      add_forces(force, group.node[0] + begin, f.x0, f.y0);
      add_forces(force, group.node[1] + begin, f.x1, f.y1);
      add_forces(force, group.node[2] + begin, f.x2, f.y2);
    }
  }
}

struct SecondPassElement {
  std::array<std::uint16_t, 3> node;
  EdgeStrain<double> edge;
  InPlane<double> undamaged;
  double pressure;
};

SecondPassElement second_pass_element(const Tile& tile, const Elasticity& moduli, std::size_t place,
                                      const NodeRecord* record) {
  const ElementGroup& group = tile.groups[place / group_width];
  const std::size_t lane = place % group_width;
  SecondPassElement element;
  element.node = {group.node[0][lane], group.node[1][lane], group.node[2][lane]};
  element.edge = edge_strain(record[element.node[0]], record[element.node[1]], record[element.node[2]]);
  element.undamaged = elastic_stress(moduli, element.edge.strain);
  element.undamaged.xx += group.stress[0][lane];
  element.undamaged.yy += group.stress[1][lane];
  element.undamaged.xy += group.stress[2][lane];
  element.pressure = group.pore_pressure[lane];
  return element;
}

void start_damage(const RankineDamage& law, const SecondPassElement& element, std::size_t place,
                  const NodeRecord* record, TileDamage& damage) {
  const auto corner = [&](int i) { return Point{record[element.node[i]].x, record[element.node[i]].y}; };
  const double band =
      crack_band_length({corner(0), corner(1), corner(2)}, principal(element.undamaged).direction);
  const auto onset = damage_onset(law, element.undamaged, band);
  if (!onset) return;
  damage.cracked[place] = 1;
  damage.record_of[place] = static_cast<std::uint16_t>(damage.record.size());
  damage.record.push_back(*onset);
}

void add(std::array<double, 2>& sum, double x, double y) {
  sum[0] += x;
  sum[1] += y;
}

void second_pass(const Tile& tile, const Elasticity& moduli, const RankineDamage& law, TileDamage& damage,
                 TileWorkspace& workspace) {
  const NodeRecord* record = workspace.record.data();
  for (const std::uint16_t place : workspace.listed) {
    const auto element = second_pass_element(tile, moduli, place, record);
    if (!damage.cracked[place]) start_damage(law, element, place, record, damage);
    InPlane<double> total = element.undamaged;
    if (damage.cracked[place]) total = damaged_stress(law, total, damage.record[damage.record_of[place]]);
    total.xx -= element.pressure;
    total.yy -= element.pressure;
    const auto f = corner_forces(element.edge, total);
    add(workspace.force[element.node[0]], f.x0, f.y0);
    add(workspace.force[element.node[1]], f.x1, f.y1);
    add(workspace.force[element.node[2]], f.x2, f.y2);
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

void add_elastic_forces(const Tile& tile, const Elasticity& moduli, TileWorkspace& workspace) {
  first_pass(tile, moduli, ElasticOnly{}, workspace);
}

void add_damaging_forces(const Tile& tile, const Elasticity& moduli, const RankineDamage& law,
                         double lowest_strength, TileDamage& damage, TileWorkspace& workspace) {
  workspace.listed.clear();
  first_pass(tile, moduli, ListFailing{{lowest_strength}, damage.cracked.data(), &workspace.listed},
             workspace);
  second_pass(tile, moduli, law, damage, workspace);
}

}  // namespace fissura::structure
