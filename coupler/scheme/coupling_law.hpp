// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/case/case.hpp"
#include "common/coupling/coupling_clock.hpp"
#include "common/coupling/pressure_ramp.hpp"
#include "coupler/scheme/exchange.hpp"

/// What each side is told about the other. Pure functions of the interface; one value per node of the
/// network.
namespace fissura::coupler {

/// What the network may assume about the structure in the coming interval.
struct StructureEstimate {
  std::vector<double> aperture;       ///< e(t1) [m]
  std::vector<double> aperture_rate;  ///< [m/s]; 0 under robin
  std::vector<double>
      reference_pressure;  ///< p_ref, the pressure the structure carried when it had that aperture [Pa]
  std::vector<double> compliance;                      ///< C_R [m/Pa]
  std::vector<double> closed;                          ///< 1: only pressure beyond p_ref opens
  std::vector<double> arm_aperture_a, arm_aperture_b;  ///< of each segment [m]; empty if not known
  const char* carry = "content";  ///< what the network carries over: "content" or "pressure"
};

/// robin: the compliance acts on the increment beyond the pressure the structure has felt - the applied one
/// where the faces are apart, the one that would part them where they touch. It stores no fluid.
/// @param compliance  of interface_compliance() [m/Pa]
StructureEstimate robin_estimate(const StructureResponse& structure, const std::vector<double>& compliance);

/// profit2016: 1/K_n as compliance (Eq. 4), aperture rate of the last interval (Eq. 12), pressure carried
/// over.
/// @param last_pressure  p_n of the network at t1 [Pa];  @param last_rate  average aperture rate of the last
/// interval [m/s]
StructureEstimate profit_estimate(const StructureResponse& structure,
                                  const std::vector<double>& last_pressure,
                                  const std::vector<double>& last_rate, double fracture_normal_stiffness);

/// Pressure on the faces through the interval (Eqs. 18-22). k_s = 1 / (C_R + e^/K_f) at filled nodes, 0
/// elsewhere; the same compliance as the network's, or the scheme is unstable.
std::vector<PressureRamp> robin_ramps(const StructureResponse& structure, const NetworkAnswer& network,
                                      const std::vector<double>& compliance, double fluid_bulk_modulus);

/// The same with S_fr of Eq. 4:  k_s = 1 / (1/K_n + e/K_f), relative to the aperture at t1.
/// @param minimum_aperture  floor of e in k_s [m]
std::vector<PressureRamp> profit_ramps(const StructureResponse& structure, const NetworkAnswer& network,
                                       double fracture_normal_stiffness, double fluid_bulk_modulus,
                                       double minimum_aperture);

Message advance_network(const ClockInterval& interval, std::uint64_t revision,
                        const StructureEstimate& estimate);
enum class StrainEnergy { wanted, not_wanted };

Message advance_structure(const ClockInterval& interval, std::uint64_t revision,
                          const std::vector<PressureRamp>& ramps, StrainEnergy strain_energy);

}  // namespace fissura::coupler
