// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/classical_kgd.hpp"

#include <cmath>

namespace fissura::coupler {

double ClassicalKgd::half_length(double time) const {
  const double drive = 8 * shear_modulus * std::pow(wing_rate, 3) / ((1 - poissons_ratio) * viscosity);
  return 0.48 * std::pow(drive, 1.0 / 6) * std::pow(time, 2.0 / 3);
}

double ClassicalKgd::inlet_aperture(double time) const {
  const double drive = 8 * (1 - poissons_ratio) * viscosity * std::pow(wing_rate, 3) / shear_modulus;
  return 1.32 * std::pow(drive, 1.0 / 6) * std::cbrt(time);
}

double ClassicalKgd::inlet_net_pressure(double time) const {
  const double plane_strain_modulus = 2 * shear_modulus / (1 - poissons_ratio);
  return inlet_aperture(time) * plane_strain_modulus / (4 * half_length(time));
}

std::optional<ClassicalKgd> classical_kgd(const nlohmann::json& effective_case) {
  const nlohmann::json injection = effective_case.value("injection", nlohmann::json::object());
  const nlohmann::json stages = injection.value("stages", nlohmann::json::array());
  if (stages.empty() || injection.value("perforations", nlohmann::json::array()).size() != 1)
    return std::nullopt;
  const nlohmann::json& stage = stages.front();
  if (stage.at("control") != "rate" || stage.at("rate").get<double>() <= 0) return std::nullopt;
  for (const nlohmann::json& fluid : effective_case.at("fluids")) {
    if (fluid.at("name") != stage.at("fluid") || fluid.at("power_index") != 1.0) continue;
    const nlohmann::json& rock = effective_case.at("rock");
    const double nu = rock.at("poissons_ratio"), modulus = rock.at("youngs_modulus"), rate = stage.at("rate");
    const double ramp = stage.value("ramp", 0.0), start = stage.value("begin", 0.0);
    ClassicalKgd kgd;
    kgd.shear_modulus = modulus / (2 * (1 + nu));
    kgd.poissons_ratio = nu;
    kgd.viscosity = fluid.at("consistency_index");
    kgd.wing_rate = rate / 2 / effective_case.at("domain").at("thickness").get<double>();
    kgd.begin = start + ramp;
    kgd.end = stages.size() > 1 ? stages[1].at("begin").get<double>()
                                : effective_case.at("time").at("end").get<double>();
    kgd.advance = start + ramp / 2;
    return kgd;
  }
  return std::nullopt;
}

}  // namespace fissura::coupler
