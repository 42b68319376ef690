// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/flow_solver_command.hpp"

#include <catch2/catch.hpp>

#include "common/errors.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("any words but the name of a shipped flow solver are a shell command as they stand",
          "[coupler][cli]") {
  for (const char* words : {"./mysolver", "python3 solver.py --fast", "Implicit", "explicit ", "network"})
    CHECK(flow_solver_command(words) == words);
}

TEST_CASE("a shipped flow solver that is not installed is a sentence that names its program", "[coupler][cli]") {
  // Nothing stands beside the program of this test.
  for (const auto& [name, program] :
       {std::pair{"implicit", "/network"}, {"fissura", "/network"}, {"uniform", "/network_uniform"}}) {
    std::string found;
    try {
      found = flow_solver_command(name);
    } catch (const Error& error) {
      CHECK(error.code() == ExitCode::precondition);
      found = error.what();
    }
    CHECK_THAT(found, Catch::StartsWith(std::string("the flow solver \"") + name + "\" is not installed"));
    CHECK_THAT(found, Catch::EndsWith(program));
  }
}
