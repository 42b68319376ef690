// SPDX-License-Identifier: GPL-3.0-or-later

/// Time of the joints against that of the elements in a step of rock full of natural fractures.
///
///   cmake --build build/release --target joint_kernel
///   build/release/bin/joint_kernel
///
/// Two families of natural fractures that cross, some 20 000 contact units, in compression: with friction
/// enough to rest, and without. Each is measured in turns without and with (told) the observation of seismic
/// sources; times of a step, `all` with what is done once an interval, records of an interval.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "structure/structure_run.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

namespace {

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

constexpr double half = 100;  // of the side [m]
constexpr int lines = 25;     // of each family
constexpr int steps = 15;     // of a coupling interval
constexpr int trials = 25;    // of which the fastest counts

Case fractured_rock(double friction) {
  Case given = free_case(2 * half);
  given.mesh.fracture_size = given.mesh.natural_size = 0.45;
  given.mesh.far_size = 1;
  given.in_situ.stress = {-10e6, -12e6, 1e6, -10e6};
  for (int k = 0; k < lines; ++k) {
    const double at = -half + (k + 0.5) * 2 * half / lines;
    add_line(given, fmt::format("level {}", k), FractureKind::natural, {-0.9 * half, at}, {0.9 * half, at});
    add_line(given, fmt::format("steep {}", k), FractureKind::natural, {at, -0.9 * half}, {at, 0.9 * half});
  }
  for (FractureLine& line : given.fractures) line.friction_coefficient = friction;
  return given;
}

struct Times {
  double elements = 1e9, joints = 1e9, all = 1e9;  // of a step, least of all trials [s]
};

/// The same rock twice, with and without telling of seismic sources.
struct Contestant {
  Contestant(Case given, bool told, int threads) : rock(tell(std::move(given), told)) {
    rock.model.threads = threads;
    duration = steps * 0.99 * stable_step(rock.model, rock.geometry, rock.state);
  }

  static Case tell(Case given, bool told) {
    given.seismicity.active = told;
    return given;
  }

  void advance() {
    StructureRun run(rock.model, rock.geometry);
    const auto start = std::chrono::steady_clock::now();
    run.advance(time, time + duration, rock.state);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    records += rock.state.sources.take(1).size();
    time += duration;
    least.elements = std::min(least.elements, run.loop_times().elements / steps);
    least.joints = std::min(least.joints, run.loop_times().joints / steps);
    least.all = std::min(least.all, wall.count() / steps);
  }

  GrowingRock rock;
  double duration = 0, time = 0;
  std::size_t records = 0;
  Times least;
};

void measure(const char* what, double friction, int threads) {
  Contestant silent(fractured_rock(friction), false, threads), told(fractured_rock(friction), true, threads);
  for (int trial = 0; trial < trials; ++trial)
    for (Contestant* contestant : {&silent, &told}) contestant->advance();
  double slip = 0;
  for (const JointState& state : told.rock.state.joints.state) slip = std::max(slip, state.slip);
  fmt::print("{:8} {:7} {:9} {:8} {:9.3f} {:9.3f} {:9.3f} {:9.3f} {:9.3f} {:9} {:9.2e}\n", what, threads,
             told.rock.geometry.mesh.elements.size(), told.rock.geometry.mesh.units.size(),
             1e3 * silent.least.elements, 1e3 * silent.least.joints, 1e3 * told.least.joints,
             1e3 * silent.least.all, 1e3 * told.least.all, told.records / trials, slip);
}

}  // namespace

int main() {
  fmt::print(
      "state    threads  elements    units   elem./ms joints/ms      told    all/ms      told   records    "
      "slip/m\n");
  for (const int threads : {1, 2}) {
    measure("resting", 0.6, threads);
    measure("sliding", 0.02, threads);
  }
  return 0;
}
