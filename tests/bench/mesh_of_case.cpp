// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "common/case/read_case.hpp"
#include "structure/mesh/build_mesh.hpp"
#include "structure/mesh/line_arrangement.hpp"
#include "structure/mesh/mesh_quality.hpp"

/// mesh_of_case CASE: one line of JSON about the natural fractures and the mesh of a case, and what each step
/// takes.
int main(int argc, char** argv) try {
  using Clock = std::chrono::steady_clock;
  if (argc != 2) {
    std::fprintf(stderr, "mesh_of_case CASE\n");
    return 2;
  }
  const auto seconds_since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  Clock::time_point begin = Clock::now();
  const fissura::CaseReading reading = fissura::read_case({argv[1], {}, {}});
  const double read = seconds_since(begin);
  begin = Clock::now();
  const fissura::structure::LineArrangement lines = fissura::structure::arrange_lines(reading.value);
  const double arrange = seconds_since(begin);
  begin = Clock::now();
  const fissura::structure::Mesh mesh = fissura::structure::build_mesh(reading.value);
  const double build = seconds_since(begin);
  const fissura::structure::MeshQuality quality = fissura::structure::measure(mesh);
  fmt::print(
      "{{\"traces\": {}, \"cleaned\": {}, \"pieces\": {}, \"edges\": {}, \"elements\": {}, \"nodes\": {}, "
      "\"smallest_angle\": {:.3g}, \"smallest_altitude\": {:.3g}, \"read\": {:.3f}, \"arrange\": {:.3f}, "
      "\"mesh\": {:.3f}}}\n",
      reading.natural_fractures.kept, reading.natural_fractures.cleaning.size(), lines.pieces.size(),
      mesh.edges.size(), quality.elements, quality.nodes, quality.smallest_angle, quality.smallest_altitude,
      read, arrange, build);
  return 0;
} catch (const std::exception& fault) {
  std::fprintf(stderr, "mesh_of_case: %s\n", fault.what());
  return 1;
}
