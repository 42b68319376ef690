// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/case_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "tests/reference/kgd_dontsov.hpp"

namespace fissura::reference {
namespace {

struct Entry {
  Treatment treatment;
  double time_step, end;
};

const Rock& shale() {
  static const double modulus = 32e9 / (1 - 0.2 * 0.2), fracture_energy = 50;
  static const Rock rock{modulus, std::sqrt(modulus * fracture_energy)};
  return rock;
}

const std::map<std::string, Entry>& entries() {
  static const std::map<std::string, Entry> table{
      {"kgd_leak_off", {{1.67e-3, 1e-3, 5e-5}, 0.25, 20}},
      {"kgd_mixed", {{1.67e-3, 1e-3, 0}, 0.1, 10}},
      {"kgd_toughness", {{1e-6, 1e-4, 0}, 0.5, 50}},
      {"kgd_viscosity", {{0.1, 1e-3, 0}, 0.25, 20}},
  };
  return table;
}

}  // namespace

std::vector<std::string> cases_with_reference() {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries()) names.push_back(name);
  return names;
}

std::vector<KgdState> case_table(const std::string& name) {
  const auto found = entries().find(name);
  if (found == entries().end()) throw std::invalid_argument("no reference solution for case " + name);
  const Entry& entry = found->second;
  const ScaledParameters p = scaled(shale(), entry.treatment);
  std::vector<KgdState> rows;
  const int count = static_cast<int>(std::lround(entry.end / entry.time_step));
  for (int i = 1; i <= count; ++i) rows.push_back(kgd_dontsov::state(p, i * entry.time_step));
  return rows;
}

std::string as_csv(const std::vector<KgdState>& rows) {
  std::string text = "time,half_length,inlet_aperture,inlet_net_pressure,efficiency\n";
  for (const KgdState& row : rows)
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", row.time, row.half_length, row.inlet_aperture,
                        row.inlet_net_pressure, row.efficiency);
  return text;
}

}  // namespace fissura::reference
