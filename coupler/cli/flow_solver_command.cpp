// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/flow_solver_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "common/case/shipped_flow_solvers.hpp"
#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

std::filesystem::path beside(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace

std::string sibling(const std::string& name) {
  return fmt::format("'{}'", beside(name).string());
}

std::string flow_solver_command(const std::string& words) {
  const auto program = shipped_program(words);
  if (!program) return words;
  const std::filesystem::path file = beside(std::string(*program));
  if (!std::filesystem::is_regular_file(file))
    throw Error(ExitCode::precondition,
                fmt::format("the flow solver \"{}\" is not installed: expected the program {}", words, file.string()));
  return sibling(std::string(*program));
}

}  // namespace fissura::coupler
