// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "common/case/expected.hpp"
#include "common/errors.hpp"
#include "coupler/report/classical_kgd.hpp"
#include "coupler/verdict/reference_table.hpp"
#include "coupler/verdict/verdict.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// The one expected*.toml among the inputs; empty if there is none.
fs::path expectations_file(const fs::path& inputs) {
  if (!fs::exists(inputs)) return {};
  for (const fs::directory_entry& entry : fs::directory_iterator(inputs)) {
    const fs::path& file = entry.path();
    if (file.extension() == ".toml" && file.filename().string().starts_with("expected")) return file;
  }
  return {};
}

json curve(const Series& series) {
  return {{"time", std::vector<double>(series.time.begin(), series.time.end())},
          {"value", std::vector<double>(series.value.begin(), series.value.end())}};
}

}  // namespace

json comparison(const fs::path& run_directory, double end_time, const std::vector<std::string>& probes) {
  json curves = json::object(), points = json::array();
  std::string remark;
  try {
    const fs::path file = expectations_file(run_directory / "input");
    const Expectations expectations =
        file.empty() ? Expectations{} : read_expectations(file, end_time, judgeable_columns(probes));
    for (const ExpectedQuantity& quantity : expectations.quantities) {
      if (quantity.measure == Measure::mean_relative_error)
        curves[quantity.name] = curve(ReferenceTable(quantity.reference).series(quantity.name));
      if (quantity.measure == Measure::value_at)
        points.push_back({{"name", quantity.name},
                          {"time", quantity.at},
                          {"value", quantity.value},
                          {"tolerance", quantity.tolerance}});
    }
  } catch (const Error& fault) {
    remark = fault.what();
  }
  return {{"curves", curves}, {"points", points}, {"remark", remark}};
}

json classical_curves(const json& effective_case, double last_time) {
  const std::optional<ClassicalKgd> kgd = classical_kgd(effective_case);
  if (!kgd) return nullptr;
  const double end = std::min(kgd->end, last_time);
  constexpr int parts = 200;
  std::vector<double> time, half_length, aperture, pressure;
  for (int part = 1; part <= parts && end > kgd->begin; ++part) {
    // Dense at the beginning, where the pressure falls fast.
    const double at = kgd->begin + (end - kgd->begin) * std::pow(double(part) / parts, 2);
    time.push_back(at);
    half_length.push_back(kgd->half_length(at - kgd->advance));
    aperture.push_back(kgd->inlet_aperture(at - kgd->advance));
    pressure.push_back(kgd->inlet_net_pressure(at - kgd->advance));
  }
  return {{"time", time},
          {"half_length", half_length},
          {"inlet_aperture", aperture},
          {"inlet_net_pressure", pressure}};
}

}  // namespace fissura::coupler
