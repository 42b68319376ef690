// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "common/errors.hpp"
#include "coupler/record/probes.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

nlohmann::json entry() {
  return {{"stress_xx", -15e6},     {"stress_yy", -10e6},      {"stress_xy", 1e5},
          {"displacement_x", 1e-3}, {"displacement_y", -2e-3}, {"slip", -3e-4},
          {"opening", 4e-5},        {"normal_traction", -5e6}, {"shear_traction", 6e5}};
}

nlohmann::json beside_no_joint() {
  nlohmann::json object = entry();
  for (const char* key : {"slip", "opening", "normal_traction", "shear_traction"}) object[key] = nullptr;
  return object;
}

}  // namespace

TEST_CASE("probes.csv has a group of columns for each probe and a line for each coupling time",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  ProbeSeries probes({"at the joint", "far, away"});
  probes.write_to(folder.path());
  probes.add(0.5, {probe_values_from_json(entry()), probe_values_from_json(beside_no_joint())});
  probes.flush();
  const auto lines = sample::lines(folder.path() / "probes.csv");
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].starts_with(
      "time,at the joint.stress_xx,at the joint.stress_yy,at the joint.stress_xy,at the joint.displacement_x,"
      "at the joint.displacement_y,at the joint.slip,at the joint.opening,at the joint.normal_traction,"
      "at the joint.shear_traction,\"far, away.stress_xx\","));
  CHECK(lines[1] ==
        "0.5,-15000000,-10000000,100000,0.001,-0.002,-0.0003,4e-05,-5000000,600000,"
        "-15000000,-10000000,100000,0.001,-0.002,nan,nan,nan,nan");
}

TEST_CASE("a quantity of a probe is also there as the change from its first value", "[coupler][record]") {
  ProbeSeries probes({"a", "b"});
  ProbeValues first, second;
  first.stress_yy = -10e6;
  second.stress_yy = -12.5e6;
  probes.add(1, {first, second});
  probes.add(2, {second, first});
  CHECK(probes.series("probe.a.stress_yy")->back() == -12.5e6);
  CHECK(probes.series("probe.a.stress_yy_change")->front() == 0);
  CHECK(probes.series("probe.a.stress_yy_change")->back() == -2.5e6);
  CHECK(probes.series("probe.b.stress_yy_change")->back() == 2.5e6);
  CHECK(std::isnan(probes.series("probe.a.slip")->back()));
  CHECK_FALSE(probes.series("probe.c.stress_yy").has_value());
  CHECK_FALSE(probes.series("probe.a.stress_zz").has_value());
}

TEST_CASE("every quantity of a probe has its own member and its unit", "[coupler][record]") {
  const ProbeValues values = probe_values_from_json(entry());
  std::set<double> seen;
  for (const ProbeQuantity& quantity : probe_quantities()) {
    INFO(quantity.name);
    CHECK(quantity.value(values) == entry()[std::string(quantity.name)].get<double>());
    CHECK(seen.insert(quantity.value(values).value()).second);
  }
  CHECK(seen.size() == entry().size());
  for (const ProbeColumn& column : probe_columns({"a"})) {
    const bool is_pressure =
        column.name.find("stress") != std::string::npos || column.name.find("traction") != std::string::npos;
    CHECK(column.unit == (is_pressure ? "Pa" : "m"));
  }
}

TEST_CASE("a structure that tells nothing of the probes leaves nan, one that tells of others is refused",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  ProbeSeries probes({"a"});
  probes.add(1, {});
  CHECK(std::isnan(probes.series("probe.a.stress_xx")->back()));
  CHECK_THROWS_AS(probes.add(2, std::vector<ProbeValues>(2)), ProtocolError);
  nlohmann::json incomplete = entry();
  incomplete.erase("slip");
  CHECK_THROWS_AS(probe_values_from_json(incomplete), ProtocolError);
}

TEST_CASE("a run without probes has no probes.csv", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  ProbeSeries probes({});
  probes.write_to(folder.path());
  probes.add(1, {});
  probes.flush();
  CHECK_FALSE(std::filesystem::exists(folder.path() / "probes.csv"));
}
