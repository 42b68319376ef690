// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_rock_seeds DIRECTORY: writes DIRECTORY/structure_state/NAME, sound states of the structure in the format of this build.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/fuzz/sample_network.hpp"
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
  const auto write = [&](const char* name, const std::vector<std::byte>& bytes) {
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  const StructureModel model = fuzz::small_rock_model();
  Geometry geometry = build_geometry(model);
  const Snapshot snapshot{0.5, 12, {fuzz::first_insertion(5)}, initial_state(model, geometry)};
  write("of_the_case", save_snapshot(snapshot, geometry));
  geometry.number = 1;
  write("with_geometry", save_snapshot(snapshot, geometry));
  return 0;
}
