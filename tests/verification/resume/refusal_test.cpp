// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/case/case_json.hpp"
#include "common/case/read_case.hpp"
#include "common/errors.hpp"
#include "structure/structure_solver.hpp"
#include "tests/fakes/in_process/coupled_run.hpp"
#include "tests/network/messaged_network.hpp"

using namespace fissura;

namespace {

Case slit_case() {
  return read_case({std::string(FISSURA_CASES) + "/kgd_mixed", {"free", "short"}, {}}).value;
}

struct TwoSolvers {
  structure::StructureSolver structure;
  network::test::MessagedNetwork network;

  explicit TwoSolvers(const Case& run_case) {
    structure.join({case_to_json(run_case), 1});
    network.join({case_to_json(run_case), 1});
  }
  fakes::Pair pair() { return {structure, network}; }
};

}  // namespace

TEST_CASE("a structure that has proposed an insertion is not saved before its INSERT",
          "[verification][resume]") {
  /// Saves before it inserts.
  class Hasty : public structure::StructureSolver {
   public:
    std::string insert(const Insertion& insertion) override {
      REQUIRE_THROWS_AS(save(), ProtocolError);
      ++refused;
      return StructureSolver::insert(insertion);
    }
    int refused = 0;
  };
  const Case run_case = slit_case();
  Hasty structure;
  network::test::MessagedNetwork network;
  structure.join({case_to_json(run_case), 1});
  network.join({case_to_json(run_case), 1});
  fakes::CoupledRun run(run_case);
  (void)run.begin({structure, network});
  while (structure.refused < 2) (void)run.advance({structure, network});
  CHECK_NOTHROW(structure.save());
}

TEST_CASE("participants that refuse a state go on as if it had never come", "[verification][resume]") {
  const Case run_case = slit_case();
  TwoSolvers one(run_case), other(run_case);
  fakes::CoupledRun run(run_case), other_run(run_case);
  (void)run.begin(one.pair());
  (void)other_run.begin(other.pair());
  for (int k = 0; k < 20; ++k) {
    auto of_structure = one.structure.save(), of_network = one.network.save();
    CHECK_THROWS_WITH(one.structure.restore(of_network), Catch::Contains("another solver"));
    CHECK_THROWS_WITH(one.network.restore(of_structure), Catch::Contains("another solver"));
    of_structure[of_structure.size() / 2] ^= std::byte{1};
    of_network.pop_back();
    CHECK_THROWS_WITH(one.structure.restore(of_structure), Catch::Contains("checksum"));
    CHECK_THROWS_AS(one.network.restore(of_network), Error);
    const auto found = fakes::difference(run.advance(one.pair()), other_run.advance(other.pair()));
    CAPTURE(found.value_or("nothing"));
    CHECK_FALSE(found);
  }
  CHECK(one.structure.save() == other.structure.save());
  CHECK(one.network.save() == other.network.save());
}
