// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/seismicity/element_sources.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

namespace {

constexpr double negligible_growth = 1e-9;  // of the inelastic strain in an interval [-]

double cracking(const DamageHistory& history) {
  return history.damage * history.equivalent_strain;
}

double plastic_size(const PlasticHistory& plastic) {
  return plastic.work == 0 ? 0 : size_of(plastic);
}

double plastic_volume(const PlasticHistory& plastic) {
  return plastic.strain.xx + plastic.strain.yy + plastic.strain_zz;
}

struct StressPair {
  PlaneStrainStress transmitted;
  PlaneTensor glut{};
};

StressPair stress_of(const ObservedRock& rock, ElementIndex element, const DamageHistory& history,
                     const PlasticHistory& plastic) {
  const PlaneStrainStress elastic =
      undamaged_stress(rock.mesh, rock.body, rock.moduli, element, rock.displacement);
  const PlaneStrainStress transmitted =
      transmitted_stress(without_plastic_part(rock.moduli, elastic, plastic), history.damage);
  return {transmitted, stress_glut(elastic, transmitted)};
}

double volume_of(const ObservedRock& rock, ElementIndex element) {
  return rock.thickness() * element_area(rock.mesh, element);
}

// Edge of the equilateral triangle of the same area.
double edge_length(const Mesh& mesh, ElementIndex element) {
  return std::sqrt(4 / std::sqrt(3.0) * element_area(mesh, element));
}

SourceRecord record_of(const ObservedRock& rock, const ObservedInterval& interval, ElementIndex element,
                       const DamageHistory& history, const PlaneTensor& glut, const PlaneStrainStress& before,
                       const PlaneStrainStress& after) {
  SourceRecord record;
  record.kind = SourceKind::bulk_tension;
  record.entity = element;
  record.geometry = rock.geometry;
  record.end = interval.end;
  record.position = centroid(rock.mesh, element);
  record.extent = volume_of(rock, element);
  record.element_size = edge_length(rock.mesh, element);
  record.normal = history.normal;
  record.moment = record.extent * glut;
  record.pseudo_moment = -record.extent * (tensor_of(after) - tensor_of(before));
  const PlaneTraction first = traction_on(before, history.normal), last = traction_on(after, history.normal);
  record.normal_before = first.normal;
  record.normal_after = last.normal;
  record.shear_before = first.shear;
  record.shear_after = last.shear;
  record.fluid_pressure = rock.body.in_situ[element].pore_pressure;
  record.mass_scale = interval.mass_scale;
  return record;
}

}  // namespace

std::vector<ElementSources::Failed> ElementSources::failed_elements(const ObservedRock& rock) {
  std::vector<Failed> failed;
  for (std::uint32_t tile = 0; tile < rock.damage.size(); ++tile) {
    const TileDamage& damage = rock.damage[tile];
    if (damage.record.empty()) continue;
    const auto& elements = rock.tiles.tile[tile].elements;
    for (std::size_t place = 0; place < elements.size(); ++place)
      if (damage.failed[place]) failed.push_back({elements[place], tile, damage.record_of[place]});
  }
  std::sort(failed.begin(), failed.end(),
            [](const Failed& a, const Failed& b) { return a.element < b.element; });
  return failed;
}

PlaneTensor ElementSources::begin_interval(const ObservedRock& rock, double time) {
  begin_ = time;
  growth_.resize(rock.damage.size());
  seen_.resize(rock.damage.size());
  for (std::size_t tile = 0; tile < growth_.size(); ++tile) {
    const TileDamage& damage = rock.damage[tile];
    growth_[tile].resize(damage.record.size());
    seen_[tile].resize(damage.record.size());
    for (std::size_t k = 0; k < damage.record.size(); ++k) {
      const double cracked = cracking(damage.record[k]), sheared = plastic_size(damage.plastic[k]);
      growth_[tile][k] = {cracked, sheared, plastic_volume(damage.plastic[k]), damage.record[k].damage};
      seen_[tile][k] = cracked + sheared;
    }
  }
  PlaneTensor came{};
  if (!anew_) return came;
  anew_ = false;
  failed_ = failed_elements(rock);
  const std::size_t before = known_.size();
  for (const Failed& failed : failed_) {
    const auto end = known_.begin() + static_cast<std::ptrdiff_t>(before);
    const auto found = std::lower_bound(known_.begin(), end, failed.element,
                                        [](const Known& a, ElementIndex b) { return a.element < b; });
    if (found != end && found->element == failed.element) continue;
    const TileDamage& damage = rock.damage[failed.tile];
    const StressPair stress =
        stress_of(rock, failed.element, damage.record[failed.record], damage.plastic[failed.record]);
    came = came + volume_of(rock, failed.element) * stress.glut;
    known_.push_back({failed.element, stress.glut, {}, time, stress.transmitted, stress.transmitted});
  }
  std::sort(known_.begin(), known_.end(),
            [](const Known& a, const Known& b) { return a.element < b.element; });
  return came;
}

void ElementSources::note_onsets(const ObservedRock& rock, std::uint32_t tile) {
  const TileDamage& damage = rock.damage[tile];
  const auto& elements = rock.tiles.tile[tile].elements;
  for (std::size_t place = 0; place < elements.size(); ++place) {
    if (!damage.failed[place] || damage.record_of[place] < growth_[tile].size()) continue;
    const PlaneStrainStress stress =
        undamaged_stress(rock.mesh, rock.body, rock.moduli, elements[place], rock.displacement);
    onsets_.push_back({elements[place], {}, {}, begin_, stress, stress});
  }
  growth_[tile].resize(damage.record.size());
  seen_[tile].resize(damage.record.size(), 0);
}

void ElementSources::watch(const ObservedRock& rock, double place, double step) {
  const bool flows = rock.run_case.bulk_failure.cohesion > 0;
  for (std::uint32_t tile = 0; tile < rock.damage.size(); ++tile) {
    const TileDamage& damage = rock.damage[tile];
    if (damage.record.size() > seen_[tile].size()) note_onsets(rock, tile);
    double* seen = seen_[tile].data();
    for (std::size_t k = 0; k < damage.record.size(); ++k) {
      double measure = cracking(damage.record[k]);
      if (flows) measure += plastic_size(damage.plastic[k]);
      if (measure <= seen[k]) continue;
      const double grown = measure - seen[k];
      seen[k] = measure;
      Growth& growth = growth_[tile][k];
      if (growth.size == 0) growth.first = place;
      growth.last = place;
      growth.size += grown;
      growth.size_time += grown * place;
      growth.peak_rate = std::max(growth.peak_rate, grown / step);
    }
  }
}

void ElementSources::end_interval(const ObservedRock& rock, const ObservedInterval& interval,
                                  std::vector<SourceRecord>& records) {
  const auto earlier = [](const Known& a, const Known& b) { return a.element < b.element; };
  if (!onsets_.empty()) {
    known_.insert(known_.end(), onsets_.begin(), onsets_.end());
    std::sort(known_.begin(), known_.end(), earlier);
    onsets_.clear();
    failed_ = failed_elements(rock);
  }
  if (known_.empty()) return;
  auto next = known_.begin();
  for (const Failed& failed : failed_) {
    while (next != known_.end() && next->element < failed.element) ++next;
    if (next == known_.end()) break;
    Known& known = *next;
    const TileDamage& damage = rock.damage[failed.tile];
    const DamageHistory& history = damage.record[failed.record];
    const PlasticHistory& plastic = damage.plastic[failed.record];
    const StressPair now = stress_of(rock, failed.element, history, plastic);
    const PlaneTensor change = now.glut - known.glut;
    const PlaneStrainStress before = known.last;
    known.glut = now.glut;
    known.last = now.transmitted;
    const Growth& growth = growth_[failed.tile][failed.record];
    if (growth.size <= negligible_growth) {
      known.quiet = known.quiet + change;
      continue;
    }
    SourceRecord& record =
        records.emplace_back(record_of(rock, interval, failed.element, history, change, before, known.last));
    const double cracked = cracking(history) - growth.cracking,
                 sheared = plastic_size(plastic) - growth.plastic;
    if (sheared > cracked)
      record.kind =
          plastic_volume(plastic) < growth.volume ? SourceKind::bulk_compaction : SourceKind::bulk_shear;
    record.failing = true;
    record.begin = interval.begin_of_step(growth.first);
    record.end = interval.time(growth.last);
    record.centroid_time =
        std::clamp(interval.time(growth.size_time / growth.size), record.begin, record.end);
    record.measure = record.kind == SourceKind::bulk_tension ? history.damage - growth.damage : sheared;
    record.peak_rate = history.band_length * growth.peak_rate;
  }
}

ElementSources::Known* ElementSources::find(ElementIndex element) {
  const auto found = std::lower_bound(known_.begin(), known_.end(), element,
                                      [](const Known& a, ElementIndex b) { return a.element < b; });
  return found != known_.end() && found->element == element ? &*found : nullptr;
}

void ElementSources::tell(const ObservedRock& rock, const ObservedInterval& interval, Known& known,
                          const DamageHistory& history, std::vector<SourceRecord>& records) const {
  if (known.quiet == PlaneTensor{}) return;
  SourceRecord& record = records.emplace_back(
      record_of(rock, interval, known.element, history, known.quiet, known.then, known.last));
  record.begin = known.since;
  record.centroid_time = (known.since + interval.end) / 2;
  known.quiet = {};
  known.since = interval.end;
  known.then = known.last;
}

void ElementSources::tell(const ObservedRock& rock, const ObservedInterval& interval, ElementIndex element,
                          std::vector<SourceRecord>& records) {
  Known* known = find(element);
  if (known == nullptr) return;
  const std::uint32_t tile = rock.tiles.tile_of_element[element];
  const auto& elements = rock.tiles.tile[tile].elements;
  const auto place = static_cast<std::size_t>(std::find(elements.begin(), elements.end(), element) - elements.begin());
  const TileDamage& damage = rock.damage[tile];
  if (damage.failed[place]) tell(rock, interval, *known, damage.record[damage.record_of[place]], records);
}

void ElementSources::tell_all(const ObservedRock& rock, const ObservedInterval& interval,
                              std::vector<SourceRecord>& records) {
  if (known_.empty()) return;
  for (const Failed& failed : failed_)
    if (Known* known = find(failed.element))
      tell(rock, interval, *known, rock.damage[failed.tile].record[failed.record], records);
}

PlaneTensor ElementSources::leave(const ObservedRock& rock, std::span<const ElementIndex> elements) {
  anew_ = true;
  PlaneTensor told{};
  std::erase_if(known_, [&](const Known& known) {
    if (!std::binary_search(elements.begin(), elements.end(), known.element)) return false;
    told = told + volume_of(rock, known.element) * (known.glut - known.quiet);
    return true;
  });
  return told;
}

void ElementSources::require_of(const ObservedRock& rock) const {
  ByteReader::require(
      std::is_sorted(known_.begin(), known_.end(),
                     [](const Known& a, const Known& b) { return a.element < b.element; }) &&
      (known_.empty() || (!rock.damage.empty() && known_.back().element < rock.mesh.elements.size())));
}

void ElementSources::follow(const MeshChange& change) {
  std::unordered_map<ElementIndex, ElementIndex> moved;
  for (const MovedElement& element : change.moved) moved.emplace(element.from, element.to);
  for (Known& known : known_)
    if (const auto found = moved.find(known.element); found != moved.end()) known.element = found->second;
  std::sort(known_.begin(), known_.end(),
            [](const Known& a, const Known& b) { return a.element < b.element; });
}

}  // namespace fissura::structure
