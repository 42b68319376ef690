// SPDX-License-Identifier: GPL-3.0-or-later

/// Time of the joints against that of the elements in a step of rock full of natural fractures.
///
///   cmake --build build/release --target joint_kernel
///   build/release/bin/joint_kernel
///
/// Two families of natural fractures that cross, some 20 000 contact units, in compression: with friction
/// enough to rest, and without.

#include <fmt/core.h>

#include "structure/structure_run.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

namespace {

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

constexpr double half = 100;  // of the side [m]
constexpr int lines = 25;     // of each family
constexpr int steps = 200;

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

void measure(const char* what, double friction, int threads) {
  GrowingRock rock(fractured_rock(friction));
  rock.model.threads = threads;
  StructureRun run(rock.model, rock.geometry);
  const double duration = steps * 0.99 * stable_step(rock.model, rock.geometry, rock.state);
  run.advance(0, duration, rock.state);
  const LoopTimes& times = run.loop_times();
  double slip = 0;
  for (const JointState& state : rock.state.joints.state) slip = std::max(slip, state.slip);
  fmt::print("{:8} {:7} {:9} {:8} {:9.3f} {:9.3f} {:10.2e}\n", what, threads,
             rock.geometry.mesh.elements.size(), rock.geometry.mesh.units.size(),
             1e3 * times.elements / steps, 1e3 * times.joints / steps, slip);
}

}  // namespace

int main() {
  fmt::print("state    threads  elements    units   elem./ms joints/ms   slip/m   (per step)\n");
  for (const int threads : {1, 2}) {
    measure("resting", 0.6, threads);
    measure("sliding", 0.02, threads);
  }
  return 0;
}
