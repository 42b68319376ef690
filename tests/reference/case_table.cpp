// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/case_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "tests/reference/kgd_dontsov.hpp"
#include "tests/reference/kgd_self_similar.hpp"
#include "tests/reference/shut_in.hpp"

namespace fissura::reference {
namespace {

const Rock& shale() {
  static const double modulus = 32e9 / (1 - 0.2 * 0.2), fracture_energy = 50;
  static const Rock rock{modulus, std::sqrt(modulus * fracture_energy)};
  return rock;
}

std::vector<double> evenly(double step, double end) {
  std::vector<double> times;
  for (int i = 1; i <= std::lround(end / step); ++i) times.push_back(i * step);
  return times;
}

std::vector<KgdState> pumped(const Treatment& treatment, const std::vector<double>& times) {
  const ScaledParameters p = scaled(shale(), treatment);
  std::vector<KgdState> rows;
  for (const double time : times) rows.push_back(kgd_dontsov::state(p, time));
  return rows;
}

/// The rate is reached linearly in `ramp`: as much is pumped as if it had begun at once half a ramp later.
std::vector<KgdState> pumped_after_a_ramp(const Treatment& treatment, double ramp,
                                          const std::vector<double>& times) {
  std::vector<double> later;
  for (const double time : times)
    if (time > ramp) later.push_back(time - ramp / 2);
  std::vector<KgdState> rows = pumped(treatment, later);
  for (KgdState& row : rows) row.time += ramp / 2;
  return rows;
}

std::vector<KgdState> pumped_then_shut_in(const Treatment& treatment, double shut_in_time,
                                          const std::vector<double>& times_after) {
  std::vector<KgdState> rows = pumped(treatment, evenly(0.1, shut_in_time));
  for (const KgdState& state :
       shut_in::solve(scaled(shale(), treatment), shut_in_time, times_after, {60, 0.01}))
    rows.push_back(state);
  return rows;
}

std::vector<KgdState> pumped_with_power_law(double power_index, double consistency_index, double rate,
                                            const std::vector<double>& times) {
  const double scaled_toughness = scaled(shale(), {}).toughness;
  std::vector<KgdState> rows;
  for (const double time : times) {
    const auto unit = kgd_self_similar::scales(power_index, consistency_index, rate,
                                               shale().plane_strain_modulus, scaled_toughness, time);
    const auto solution = kgd_self_similar::solve(power_index, unit.toughness, 80);
    if (!solution.converged) throw std::runtime_error("the power-law fracture did not converge");
    rows.push_back({time, solution.gamma * unit.length, solution.inlet_aperture * unit.aperture,
                    solution.inlet_pressure * unit.pressure, 1});
  }
  return rows;
}

using Table = std::function<std::vector<KgdState>()>;

const std::map<std::string, Table>& tables() {
  static const Treatment mixed{1.67e-3, 1e-3, 0};
  static const std::map<std::string, Table> all{
      {"case_1_intact_rock",
       [] {
         return pumped_after_a_ramp({1.67e-3, 5e-4, 1e-6}, 30, evenly(5, 1000));
       }},
      {"kgd_leak_off",
       [] {
         return pumped({1.67e-3, 1e-3, 5e-5}, evenly(0.25, 20));
       }},
      {"kgd_mixed", [] { return pumped(mixed, evenly(0.1, 10)); }},
      {"kgd_power_law", [] { return pumped_with_power_law(0.5, 0.5, 1e-3, evenly(0.25, 10)); }},
      {"kgd_shut_in",
       [] {
         std::vector<double> after;
         for (double age = 0.05; age < 195 / 1.1; age *= 1.1) after.push_back(5 + age);
         after.push_back(200);
         return pumped_then_shut_in(mixed, 5, after);
       }},
      {"kgd_toughness",
       [] {
         return pumped({1e-6, 1e-4, 0}, evenly(0.5, 50));
       }},
      {"kgd_viscosity",
       [] {
         return pumped({0.1, 1e-3, 0}, evenly(0.25, 20));
       }},
  };
  return all;
}

}  // namespace

std::vector<std::string> cases_with_reference() {
  std::vector<std::string> names;
  for (const auto& [name, table] : tables()) names.push_back(name);
  return names;
}

std::vector<KgdState> case_table(const std::string& name) {
  const auto found = tables().find(name);
  if (found == tables().end()) throw std::invalid_argument("no reference solution for case " + name);
  return found->second();
}

std::string as_csv(const std::vector<KgdState>& rows) {
  std::string text = "time,half_length,inlet_aperture,inlet_net_pressure,efficiency\n";
  for (const KgdState& row : rows)
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", row.time, row.half_length, row.inlet_aperture,
                        row.inlet_net_pressure, row.efficiency);
  return text;
}

}  // namespace fissura::reference
