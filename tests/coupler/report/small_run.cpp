// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/report/small_run.hpp"

#include <fstream>
#include <initializer_list>

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

FractureNetwork joined_network() {
  Insertion joining;
  joining.revision = 2;
  joining.updated_nodes = {{13, 2, 0, 1.5, 1, NodeRole::junction, 0.5}};
  joining.new_nodes = {{14, 2, 1, 0.5, 2, NodeRole::tip, 1.5}};
  joining.new_segments = {{23, 13, 14, 2, SegmentKind::natural, 1.0}};
  FractureNetwork result = sample::grown_network();
  result.apply(joining);
  return result;
}

Message with_joints(Message fields) {
  const auto bytes = [](std::initializer_list<int> values) {
    std::vector<std::byte> made;
    for (const int value : values) made.push_back(static_cast<std::byte>(value));
    return made;
  };
  // The two arms at (2, 0), the upper one first; the unit at rest below, the one above, and one of the slit.
  fields.add("joint_position", "m", std::vector<double>{2, 0, 2, 0, 2, -1, 2, 1, 0, 0}, 5, 2);
  fields.add("joint_normal", "1", std::vector<double>{-1, 0, -1, 0, -1, 0, -1, 0, 0, 1}, 5, 2);
  fields.add_bytes("joint_kind", bytes({1, 1, 1, 1, 0}));
  fields.add_ids("joint_line", std::vector<std::uint64_t>{1, 1, 1, 1, 0});
  fields.add("joint_slip", "m", std::vector<double>{2.5e-4, -2e-4, 0, 1e-5, 1e-3});
  fields.add("joint_opening", "m", std::vector<double>{3e-5, 0, 0, 0, 1e-3});
  fields.add_bytes("joint_wetted", bytes({1, 1, 0, 0, 1}));
  return fields;
}

void write_with_natural_fracture(const std::filesystem::path& directory) {
  RunDescription description;
  description.title = "one natural fracture";
  description.effective_case = effective_case();
  description.effective_case["fractures"] = {
      {{"name", "slit"}, {"kind", "open"}, {"points", {{-1.0, 0.0}, {1.0, 0.0}}}},
      {{"name", "nf"}, {"kind", "natural"}, {"points", {{2.0, -1.0}, {2.0, 1.0}}}}};
  std::filesystem::create_directories(directory);
  RunRecord record(directory, 1);
  record.begin(description);
  const FractureNetwork first = sample::network(), joined = joined_network();
  record.interval(sample::interval(1, 0.5), {});
  record.fields(0.5, structure_fields(), network_fields(first), first, {});
  const Meeting meeting{.time = 0.5,
                        .x = 2,
                        .hydraulic = "slit",
                        .natural = "nf",
                        .friction = 0.6,
                        .criterion = "renshaw_pollard",
                        .critical_friction = 0.375,
                        .crosses = true};
  record.meetings(joined, {meeting});
  record.interval(sample::interval(2, 1.0), {});
  record.fields(1.0, with_joints(sample::without_mesh(structure_fields())), network_fields(joined), joined,
                {});
  record.close();
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
  std::filesystem::create_directories(directory);
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
