// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/case/read_case.hpp"
#include "tests/fakes/in_process/resume_sweep.hpp"

using namespace fissura;
using namespace fissura::fakes;

namespace {

Case case_of(const std::string& name, const std::vector<std::string>& variants,
             const std::vector<std::string>& overrides) {
  return read_case({std::string(FISSURA_CASES) + "/" + name, variants, overrides}).value;
}

/// Nothing may differ, and something must have happened.
void require_same(const Case& run_case, const SweepOptions& options, std::uint64_t insertions) {
  const SweepReport report = sweep(run_case, options);
  INFO((report.differences.empty() ? std::string("nothing differs") : report.differences.front()));
  CHECK(report.differences.empty());
  CHECK(report.insertions >= insertions);
  CHECK(report.restored > 1);
}

}  // namespace

TEST_CASE("resumed along a prescribed path, every answer is the same", "[verification][resume]") {
  require_same(case_of("kgd_mixed", {"short"}, {}), {40, 5, 50, 160, 1}, 3);
}

TEST_CASE("resumed on a free path through changes of the mesh, every answer is the same",
          "[verification][resume]") {
  require_same(case_of("kgd_mixed", {"free", "short"}, {}), {30, 5, 50, 120, 1}, 4);
}

TEST_CASE("resumed while the rock fails ahead of the tips, every answer is the same",
          "[verification][resume]") {
  require_same(case_of("reorientation", {"damage", "short"}, {}), {25, 5, 50, 75, 1}, 2);
}

TEST_CASE("resumed around a meeting with a natural fracture, every answer is the same",
          "[verification][resume]") {
  require_same(case_of("crossing", {}, {}), {50, 5, 40, 250, 1}, 8);
}

TEST_CASE("resumed under the scheme of 2016 with leak-off, every answer is the same",
          "[verification][resume]") {
  require_same(case_of("kgd_leak_off", {"short"}, {"coupling.scheme=\"profit2016\""}), {40, 5, 50, 120, 1},
               1);
}

TEST_CASE("resumed between two reports of a crack that slips, every answer and report is the same",
          "[verification][resume]") {
  require_same(case_of("closed_crack_slip", {"short"}, {}), {25, 5, 30, 180, 1}, 0);
}
