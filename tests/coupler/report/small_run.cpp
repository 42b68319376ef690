// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/report/small_run.hpp"

#include <fstream>

#include "coupler/record/run_record.hpp"
#include "tests/coupler/record/sample_run.hpp"

namespace fissura::coupler::small_run {

nlohmann::json effective_case() {
  return {{"title", "sample"},
          {"time", {{"end", 1.0}}},
          {"domain", {{"width", 4.0}, {"height", 2.0}, {"thickness", 10.0}}},
          {"rock", {{"youngs_modulus", 20e9}, {"poissons_ratio", 0.25}, {"biot_coefficient", 1.0}}},
          {"in_situ", {{"stress", {-15e6, -10e6, 0.0, -12e6}}, {"pore_pressure", 0.0}}},
          {"fluids", {{{"name", "water"}, {"consistency_index", 1e-3}, {"power_index", 1.0}}}},
          {"fractures", nlohmann::json::array()},
          {"injection",
           {{"perforations", {{{"name", "p"}, {"position", {0.0, 0.0}}}}},
            {"stages",
             {{{"begin", 0.0}, {"control", "rate"}, {"rate", 0.01}, {"ramp", 0.0}, {"fluid", "water"}}}}}}};
}

Message structure_fields() {
  Message fields = sample::structure_fields(0, 0, 0);
  fields.add("effective_stress_xx", "Pa", std::vector<double>{-15e6, -15e6});
  fields.add("effective_stress_yy", "Pa", std::vector<double>{-10e6, -10e6});
  fields.add("effective_stress_xy", "Pa", std::vector<double>{0, 0});
  return fields;
}

Message network_fields(const FractureNetwork& network) {
  std::vector<double> aperture, pressure;
  for (std::size_t node = 1; node <= network.nodes().size(); ++node) {
    aperture.push_back(1e-4 * double(node));
    pressure.push_back(1e6 * double(node));
  }
  Message fields(MessageType::fields);
  fields.add("aperture", "m", aperture);
  fields.add("pressure", "Pa", pressure);
  return fields;
}

void write(const std::filesystem::path& directory, Comparison comparison) {
  RunDescription description;
  description.run_id = "0123";
  description.title = "sample </title> & more";
  description.effective_case = effective_case();
  const sample::TemporaryDirectory inputs;
  if (comparison == Comparison::reference) {
    std::ofstream(inputs.path() / "reference.csv") << "time,half_length\n0.5,5.25\n1,6.5\n";
    std::ofstream(inputs.path() / "expected.toml")
        << "[[quantity]]\nname = \"half_length\"\nunit = \"m\"\nmeasure = \"mean_relative_error\"\nreference "
           "= "
           "\"reference.csv\"\ntolerance = 0.1\nreason = \"r\"\n"
           "[[quantity]]\nname = \"inlet_aperture\"\nunit = \"mm\"\nmeasure = \"value_at\"\nat = \"1 "
           "s\"\nvalue = \"2 "
           "mm\"\ntolerance = 0.03\nreason = \"r\"\n";
    description.input_files = {inputs.path() / "expected.toml", inputs.path() / "reference.csv"};
  }
  RunRecord record(directory, 1);
  record.begin(description);
  const FractureNetwork first = sample::network(), grown = sample::grown_network();
  record.interval(sample::interval(1, 0.5), {});
  record.fields(0.5, structure_fields(), network_fields(first), first, {});
  record.interval(sample::interval(2, 1.0), {});
  record.fields(1.0, sample::without_mesh(structure_fields()), network_fields(grown), grown, {});
  record.close();
}

}  // namespace fissura::coupler::small_run
