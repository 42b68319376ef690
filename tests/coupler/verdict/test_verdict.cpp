// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <optional>

#include "common/errors.hpp"
#include "coupler/verdict/verdict.hpp"
#include "tests/coupler/verdict/reference_file.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

/// Ten intervals of one second: length 1 m/s, aperture 10 mm falling by 1 mm/s, one bad residual at 3 s.
History ten_seconds() {
  History history;
  for (int i = 1; i <= 10; ++i) {
    IntervalRecord record;
    record.interval = static_cast<std::uint64_t>(i);
    record.time = i;
    record.half_length = i;
    record.inlet_aperture = 0.010 - 0.001 * i;
    record.ledger.relative_residual = i == 3 ? 1e-6 : 1e-14;
    history.add(record);
  }
  return history;
}

ExpectedQuantity quantity(const std::string& name, const std::string& unit, double unit_in_si,
                          Measure measure) {
  ExpectedQuantity result;
  result.name = name;
  result.unit = unit;
  result.unit_in_si = unit_in_si;
  result.measure = measure;
  result.to = 10;
  return result;
}

QuantityResult judge_one(const ExpectedQuantity& expected, const History& history) {
  const Verdict verdict = judge({{expected}}, history);
  CHECK((verdict.judgement == Judgement::pass) == verdict.quantities.at(0).pass);
  return verdict.quantities.at(0);
}

}  // namespace

TEST_CASE("a length that is 1 % long against its reference has a mean relative error of 1 %",
          "[coupler][verdict]") {
  const ReferenceFile file("time,half_length\n1,0.99009900990099009\n10,9.9009900990099009\n");
  ExpectedQuantity expected = quantity("half_length", "cm", 0.01, Measure::mean_relative_error);
  expected.reference = file.path();
  expected.from = 6;
  SECTION("within a tolerance of 1.1 %") {
    expected.tolerance = 0.011;
  }
  SECTION("outside a tolerance of 0.9 %") {
    expected.tolerance = 0.009;
  }
  const QuantityResult result = judge_one(expected, ten_seconds());
  CHECK(result.relative_error.value() == Approx(0.01).epsilon(1e-12));
  CHECK(result.obtained.value() == Approx(800).epsilon(1e-12));
  CHECK(result.expected == Approx(800 / 1.01).epsilon(1e-12));
  CHECK(result.pass == (expected.tolerance > 0.01));
}

TEST_CASE("errors of both signs cancel in the mean relative error, as its definition says",
          "[coupler][verdict]") {
  const ReferenceFile file("time,half_length\n5,5.5\n6,5.5\n");
  ExpectedQuantity expected = quantity("half_length", "m", 1, Measure::mean_relative_error);
  expected.reference = file.path();
  expected.from = 5;
  expected.to = 6;
  expected.tolerance = 1e-12;
  CHECK(judge_one(expected, ten_seconds()).pass);
}

TEST_CASE("a value at a time is judged in SI and told in its own unit", "[coupler][verdict]") {
  ExpectedQuantity expected = quantity("inlet_aperture", "mm", 1e-3, Measure::value_at);
  expected.at = 4.5;
  expected.value = 0.005;
  expected.tolerance = 0.11;
  const QuantityResult result = judge_one(expected, ten_seconds());
  CHECK(result.expected == Approx(5));
  CHECK(result.obtained.value() == Approx(5.5));
  CHECK(result.relative_error.value() == Approx(0.1));
  CHECK(result.pass);
}

TEST_CASE("one bad interval breaks a maximum but need not break a mean", "[coupler][verdict]") {
  ExpectedQuantity expected = quantity("relative_residual", "1", 1, Measure::maximum);
  expected.bound = 1e-10;
  CHECK_FALSE(judge_one(expected, ten_seconds()).pass);
  CHECK(judge_one(expected, ten_seconds()).obtained.value() == 1e-6);
  expected.from = 4;
  CHECK(judge_one(expected, ten_seconds()).pass);
  expected.from = 0;
  expected.measure = Measure::mean;
  expected.bound = 1.1e-7;
  CHECK(judge_one(expected, ten_seconds()).pass);
}

TEST_CASE("a minimum is a bound from below", "[coupler][verdict]") {
  ExpectedQuantity expected = quantity("inlet_aperture", "mm", 1e-3, Measure::minimum);
  expected.to = 5;
  expected.bound = 0.0049;
  CHECK(judge_one(expected, ten_seconds()).pass);
  expected.bound = 0.0051;
  CHECK_FALSE(judge_one(expected, ten_seconds()).pass);
}

TEST_CASE("the time of closing is told in seconds", "[coupler][verdict]") {
  ExpectedQuantity expected = quantity("inlet_aperture", "mm", 1e-3, Measure::time_when_below);
  expected.value = 0.0025;
  expected.expected_time = 7.5;
  expected.tolerance = 1e-9;
  const QuantityResult result = judge_one(expected, ten_seconds());
  CHECK(result.unit == "s");
  CHECK(result.obtained.value() == Approx(7.5));
  CHECK(result.pass);
}

TEST_CASE("what cannot be judged fails and says why", "[coupler][verdict]") {
  std::optional<History> history(ten_seconds());
  ExpectedQuantity expected = quantity("half_length", "m", 1, Measure::maximum);
  expected.bound = std::numeric_limits<double>::infinity();
  const auto fails_with = [&](const char* remark) {
    const QuantityResult result = judge_one(expected, *history);
    CHECK_FALSE(result.pass);
    CHECK_FALSE(result.obtained.has_value());
    CHECK_THAT(result.remark, Catch::Contains(remark));
  };
  SECTION("a quantity that is not recorded") {
    expected.name = "half_lenght";
    fails_with("no column \"half_lenght\"");
  }
  SECTION("a run that ended early") {
    expected.to = 20;
    fails_with("the run ended at 10 s, before 20 s");
  }
  SECTION("a run without intervals") {
    history.emplace();
    fails_with("the run ended at 0 s");
  }
  SECTION("a window between two coupling times") {
    expected.from = 4.2;
    expected.to = 4.8;
    fails_with("no coupling time between 4.2 s and 4.8 s");
  }
  SECTION("a value that is not a number") {
    IntervalRecord record;
    record.time = 11;
    record.half_length = std::numeric_limits<double>::quiet_NaN();
    history->add(record);
    expected.to = 11;
    fails_with("the value at 11 s is not finite");
  }
  SECTION("a value at a time that was not reached") {
    expected.measure = Measure::value_at;
    expected.at = 12;
    expected.tolerance = 1e9;
    fails_with("the run ended at 10 s, before 12 s");
  }
  SECTION("a fracture that never closes") {
    expected.measure = Measure::time_when_below;
    expected.tolerance = 1e9;
    expected.expected_time = 1;
    fails_with("never below 0 m between 0 s and 10 s");
  }
  SECTION("a reference that ends too soon") {
    const ReferenceFile file("time,half_length\n1,1\n9,9\n");
    expected.measure = Measure::mean_relative_error;
    expected.tolerance = 1e9;
    expected.reference = file.path();
    fails_with("the reference does not reach 10 s");
  }
  SECTION("a reference that has gone") {
    expected.measure = Measure::mean_relative_error;
    expected.tolerance = 1e9;
    expected.reference = "/nonexistent.csv";
    fails_with("/nonexistent.csv");
  }
}

TEST_CASE("one missed quantity fails the run, and nothing expected is no verdict", "[coupler][verdict]") {
  ExpectedQuantity good = quantity("half_length", "m", 1, Measure::maximum), bad = good;
  good.bound = 11;
  bad.bound = 9;
  CHECK(judge({{good, good}}, ten_seconds()).judgement == Judgement::pass);
  CHECK(judge({{good, bad}}, ten_seconds()).judgement == Judgement::fail);
  CHECK(judge({}, ten_seconds()).judgement == Judgement::none);
}

TEST_CASE("a bad reference is known before the run", "[coupler][verdict]") {
  const ReferenceFile file("time,efficiency\n1,1\n");
  ExpectedQuantity expected = quantity("half_length", "m", 1, Measure::mean_relative_error);
  expected.reference = file.path();
  CHECK_THROWS_AS(check_references({{expected}}), InputError);
  expected.name = "efficiency";
  CHECK_NOTHROW(check_references({{expected}}));
}

TEST_CASE("a probe is judged by its quantities and by their change from the first coupling time",
          "[coupler][verdict]") {
  History history;
  history.observe({"between"});
  for (int i = 1; i <= 3; ++i) {
    IntervalRecord record;
    record.time = i;
    ProbeValues values;
    values.stress_yy = -10e6 - 1e6 * (i - 1);
    history.add(record, {values});
  }
  ExpectedQuantity expected = quantity("probe.between.stress_yy", "MPa", 1e6, Measure::value_at);
  expected.at = 3;
  expected.value = -12e6;
  expected.tolerance = 1e-12;
  CHECK(judge_one(expected, history).pass);
  expected.name = "probe.between.stress_yy_change";
  expected.value = -2e6;
  CHECK(judge_one(expected, history).pass);
  expected.value = -2.1e6;
  CHECK_FALSE(judge_one(expected, history).pass);
  // No joint is near: nothing to judge, and so a failure.
  expected.name = "probe.between.slip";
  CHECK_FALSE(judge_one(expected, history).pass);
  CHECK(judge_one(expected, history).remark.find("not finite") != std::string::npos);
}

TEST_CASE("the quantities of a probe may be expected under its name, with their units",
          "[coupler][verdict]") {
  std::map<std::string, std::string_view> unit;
  for (const HistoryColumn& column : judgeable_columns({"between"})) unit[column.name] = column.unit;
  CHECK(unit.at("junction_pressure") == "Pa");
  CHECK(unit.at("meetings") == "1");
  CHECK(unit.at("probe.between.stress_xy_change") == "Pa");
  CHECK(unit.at("probe.between.slip") == "m");
  CHECK_FALSE(unit.contains("probe.elsewhere.slip"));
}
