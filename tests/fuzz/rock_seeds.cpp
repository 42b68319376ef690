// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_rock_seeds DIRECTORY: writes DIRECTORY/structure_state/NAME, sound states of the structure in the
// format of this build.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <string>

#include "structure/joints/network_topology.hpp"
#include "tests/fuzz/small_rock.hpp"

using namespace fissura;
using namespace fissura::structure;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "fuzz_rock_seeds DIRECTORY\n";
    return 2;
  }
  const std::filesystem::path folder = std::filesystem::path(argv[1]) / "structure_state";
  std::filesystem::create_directories(folder);
  const StructureModel model = fuzz::small_rock_model();
  const StateOwner owner = structure_owner(model.run_case);
  const auto write = [&](const std::string& name, std::span<const std::byte> bytes) {
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  const auto write_state = [&](const std::string& name, const std::vector<std::byte>& blob) {
    write(name, blob);
    write(name + "_inside", state_inside(blob, owner));
  };
  Geometry geometry = build_geometry(model);
  const StructureState state = initial_state(model, geometry);
  StructureHistory history;
  history.time = 0.5;
  history.steps = 12;
  history.insertions = {first_insertion(geometry.mesh, state.joints, model.run_case)};
  write_state("of_the_case", save_snapshot(owner, history, geometry, state, {}));
  geometry.number = 1;
  write_state("with_geometry", save_snapshot(owner, history, geometry, state, {0, 2}));
  return 0;
}
