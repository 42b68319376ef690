// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/interval_figures.hpp"

#include <algorithm>
#include <cmath>

#include "coupler/scheme/fracture_extent.hpp"

namespace fissura::coupler {

namespace {

double total_closure(const InSitu& in_situ, double biot, const NetworkNode& at, double normal_x,
                     double normal_y) {
  const auto stress = [&](std::size_t k) {
    return in_situ.stress[k] + in_situ.stress_gradient[k][0] * at.x + in_situ.stress_gradient[k][1] * at.y;
  };
  return -(stress(0) * normal_x * normal_x + stress(1) * normal_y * normal_y +
           2 * stress(2) * normal_x * normal_y) +
         biot * pore_pressure(in_situ, {at.x, at.y});
}

struct VolumeDifference {
  double sum = 0, sum_of_magnitudes = 0,
         volume = 0;  ///< of l (e - e^), l |e - e^|, l e over filled nodes [m2]
};

VolumeDifference volume_difference(const FractureNetwork& network, const StructureResponse& structure,
                                   const NetworkAnswer& answer) {
  VolumeDifference difference;
  for (std::size_t i = 0; i < answer.filled.size(); ++i) {
    if (answer.filled[i] < 1) continue;
    const double length = network.nodes()[i].lumped_length;
    const double gap = structure.aperture[i] - answer.aperture_predicted[i];
    difference.sum += length * gap;
    difference.sum_of_magnitudes += length * std::abs(gap);
    difference.volume += length * structure.aperture[i];
  }
  return difference;
}

double junction_pressure(const FractureNetwork& network, const std::vector<double>& pressure) {
  double greatest = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (network.nodes()[i].role == NodeRole::junction) greatest = std::max(greatest, pressure[i]);
  return greatest;
}

std::vector<double> opened(const StructureResponse& structure) {
  std::vector<double> marks;
  for (const double closed : structure.closed) marks.push_back(1 - closed);
  return marks;
}

}  // namespace

std::optional<Inlet> find_inlet(const FractureNetwork& network, const Case& run_case) {
  if (network.perforations().empty()) return std::nullopt;
  const PerforationNode& perforation = network.perforations().front();
  Inlet inlet;
  inlet.node = network.index_of(perforation.node);
  for (const Perforation& given : run_case.injection.perforations)
    if (given.name == perforation.name) inlet.stored_aperture = given.aperture;
  const NetworkNode& at = network.nodes()[inlet.node];
  double normal_x = 0, normal_y = 1;
  if (const auto segments = network.segments_at(inlet.node); !segments.empty()) {
    const NetworkSegment& segment = network.segments()[segments.front()];
    const NetworkNode &a = network.nodes()[network.index_of(segment.node_a)],
                      &b = network.nodes()[network.index_of(segment.node_b)];
    normal_x = -(b.y - a.y) / segment.length;
    normal_y = (b.x - a.x) / segment.length;
  }
  inlet.closure = total_closure(run_case.in_situ, run_case.rock.biot_coefficient, at, normal_x, normal_y);
  return inlet;
}

IntervalRecord interval_figures(const ClockInterval& interval, const FractureNetwork& network,
                                const std::optional<Inlet>& inlet, const StructureResponse& structure,
                                const NetworkAnswer& answer) {
  IntervalRecord record;
  record.interval = interval.index;
  record.revision = network.revision();
  record.time = interval.end;
  record.duration = interval.duration();
  record.explicit_steps = structure.steps;
  record.half_length_open = marked_half_length(network, opened(structure));
  record.half_length_broken = marked_half_length(network, structure.broken);
  record.half_length =
      (record.half_length_open + std::min(record.half_length_broken, record.half_length_open)) / 2;
  if (inlet) {
    record.inlet_aperture = structure.aperture[inlet->node] - inlet->stored_aperture;
    record.inlet_pressure = answer.pressure[inlet->node];
    record.inlet_net_pressure = record.inlet_pressure - inlet->closure;
  }
  record.well_pressure = answer.well_pressure;
  record.rate = answer.rate;
  record.ledger = answer.ledger;
  const double supplied = answer.ledger.injected + answer.ledger.in_place + answer.ledger.found;
  record.efficiency = supplied > 0 ? answer.ledger.in_fractures / supplied : 1;
  const VolumeDifference difference = volume_difference(network, structure, answer);
  record.mismatch = difference.volume > 0 ? std::abs(difference.sum) / difference.volume : 0;
  record.drift = drift(network, structure, answer);
  record.newton_iterations = answer.newton_iterations;
  record.halvings = answer.halvings;
  record.natural_fractures = structure.natural_fractures;
  record.junction_pressure = junction_pressure(network, answer.pressure);
  record.kinetic_energy = structure.kinetic_energy;
  record.mass_scale = structure.mass_scale;
  record.stable_step = structure.stable_step;
  return record;
}

void add_growth_figures(const FractureNetwork& network, const FracturePath& path,
                        const StructureResponse& structure, const Case& run_case, IntervalRecord& record) {
  record.cohesive_work = structure.cohesive_work;
  record.failure_work = structure.failure_work;
  record.elements = structure.elements;
  record.path_deviation = path.deviation;
  record.path_angle = path.chord_angle;
  record.first_angle = path.first_angle;
  record.end_angle = path.end_angle;
  const double length = grown_length(network, path, opened(structure), structure.broken);
  const double needed = run_case.rock.fracture_energy * run_case.domain.thickness * length;
  record.cohesive_share = needed > 0 ? structure.cohesive_work / needed : 0;
}

double drift(const FractureNetwork& network, const StructureResponse& structure,
             const NetworkAnswer& answer) {
  const VolumeDifference difference = volume_difference(network, structure, answer);
  return difference.volume > 0 ? difference.sum_of_magnitudes / difference.volume : 0;
}

}  // namespace fissura::coupler
