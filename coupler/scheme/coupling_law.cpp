// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/coupling_law.hpp"

#include <algorithm>

namespace fissura::coupler {

namespace {

double normal_compliance(double fracture_normal_stiffness) {
  return fracture_normal_stiffness > 0 ? 1 / fracture_normal_stiffness : 0;
}

bool filled(const NetworkAnswer& network, std::size_t i) {
  return network.filled[i] >= 1;
}

}  // namespace

StructureEstimate robin_estimate(const StructureResponse& structure, const std::vector<double>& compliance) {
  StructureEstimate estimate;
  estimate.aperture = structure.aperture;
  estimate.aperture_rate.assign(structure.aperture.size(), 0);
  estimate.compliance = compliance;
  estimate.closed = structure.closed;
  estimate.arm_aperture_a = structure.arm_aperture_a;
  estimate.arm_aperture_b = structure.arm_aperture_b;
  for (std::size_t i = 0; i < structure.aperture.size(); ++i)
    estimate.reference_pressure.push_back(
        structure.closed[i] > 0 ? std::max(structure.pressure_applied[i], structure.pressure_opening[i])
                                : structure.pressure_applied[i]);
  return estimate;
}

StructureEstimate profit_estimate(const StructureResponse& structure,
                                  const std::vector<double>& last_pressure,
                                  const std::vector<double>& last_rate, double fracture_normal_stiffness) {
  StructureEstimate estimate;
  estimate.aperture = structure.aperture;
  estimate.aperture_rate = last_rate;
  estimate.reference_pressure = last_pressure;
  estimate.compliance.assign(structure.aperture.size(), normal_compliance(fracture_normal_stiffness));
  estimate.closed.assign(structure.aperture.size(), 0);
  estimate.arm_aperture_a = structure.arm_aperture_a;
  estimate.arm_aperture_b = structure.arm_aperture_b;
  estimate.carry = "pressure";
  return estimate;
}

std::vector<PressureRamp> robin_ramps(const StructureResponse& structure, const NetworkAnswer& network,
                                      const std::vector<double>& compliance, double fluid_bulk_modulus) {
  std::vector<PressureRamp> ramps;
  for (std::size_t i = 0; i < compliance.size(); ++i) {
    const double predicted = network.aperture_predicted[i];
    const double stiffness = filled(network, i) ? 1 / (compliance[i] + predicted / fluid_bulk_modulus) : 0;
    ramps.push_back(
        {structure.pressure_applied[i], network.pressure[i], structure.aperture[i], predicted, stiffness});
  }
  return ramps;
}

std::vector<PressureRamp> profit_ramps(const StructureResponse& structure, const NetworkAnswer& network,
                                       double fracture_normal_stiffness, double fluid_bulk_modulus,
                                       double minimum_aperture) {
  std::vector<PressureRamp> ramps;
  for (std::size_t i = 0; i < structure.aperture.size(); ++i) {
    const double aperture = structure.aperture[i];
    const double storage = normal_compliance(fracture_normal_stiffness) +
                           std::max(aperture, minimum_aperture) / fluid_bulk_modulus;
    ramps.push_back({structure.pressure_applied[i], network.pressure[i], aperture, aperture,
                     filled(network, i) ? 1 / storage : 0});
  }
  return ramps;
}

Message advance_network(const ClockInterval& interval, std::uint64_t revision,
                        const StructureEstimate& estimate) {
  Message command(MessageType::advance);
  command.interval = interval.index;
  command.revision = revision;
  command.body = {{"begin", interval.begin}, {"end", interval.end}, {"carry", estimate.carry}};
  command.add("aperture", "m", estimate.aperture);
  command.add("aperture_rate", "m/s", estimate.aperture_rate);
  command.add("reference_pressure", "Pa", estimate.reference_pressure);
  command.add("compliance", "m/Pa", estimate.compliance);
  command.add("closed", "1", estimate.closed);
  if (!estimate.arm_aperture_a.empty()) {
    command.add("arm_aperture_a", "m", estimate.arm_aperture_a);
    command.add("arm_aperture_b", "m", estimate.arm_aperture_b);
  }
  return command;
}

Message advance_structure(const ClockInterval& interval, std::uint64_t revision,
                          const std::vector<PressureRamp>& ramps, StrainEnergy strain_energy) {
  Message command(MessageType::advance);
  command.interval = interval.index;
  command.revision = revision;
  command.body = {{"begin", interval.begin},
                  {"end", interval.end},
                  {"strain_energy", strain_energy == StrainEnergy::wanted}};
  std::vector<double> pressure_begin, pressure_end, aperture_begin, aperture_end, stiffness;
  for (const PressureRamp& ramp : ramps) {
    pressure_begin.push_back(ramp.pressure_begin);
    pressure_end.push_back(ramp.pressure_end);
    aperture_begin.push_back(ramp.aperture_begin);
    aperture_end.push_back(ramp.aperture_end);
    stiffness.push_back(ramp.stiffness);
  }
  command.add("pressure_begin", "Pa", pressure_begin);
  command.add("pressure_end", "Pa", pressure_end);
  command.add("aperture_begin", "m", aperture_begin);
  command.add("aperture_end", "m", aperture_end);
  command.add("stiffness", "Pa/m", stiffness);
  return command;
}

}  // namespace fissura::coupler
