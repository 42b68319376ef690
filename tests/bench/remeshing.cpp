// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

#include "structure/dynamics/untouched_hash.hpp"
#include "structure/structure_state.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/mesh_changes.hpp"
#include "tests/fakes/structure/shale_case.hpp"

/// What it costs that everything built from the mesh follows a change, and the proof that the rest is
/// untouched, beside an explicit step.
namespace {

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

constexpr double edge = 0.5;  // [m]
constexpr int changes = 100;
constexpr int steps = 50;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double milliseconds(const std::function<void()>& work) {
  const double begin = processor_time();
  work();
  return processor_time() - begin;
}

struct Times {
  std::vector<double> samples;

  void print(const char* name) {
    std::sort(samples.begin(), samples.end());
    fmt::print("{:34} {:7.2f} ms median {:7.2f} ms greatest\n", name, samples[samples.size() / 2],
               samples.back());
  }
};

Geometry geometry_on(Mesh mesh, const StructureModel& model) {
  Geometry geometry;
  geometry.mesh = std::move(mesh);
  geometry.node_elements = NodeElements(geometry.mesh);
  geometry.body = build_body(geometry.mesh, model.run_case);
  geometry.tiles = build_tiles(geometry.mesh, geometry.body, {});
  geometry.frequency_bound = bound_frequencies(geometry.mesh, model.moduli, model.run_case.rock.density);
  geometry.frequency_squared = stiffest_element(geometry.mesh, geometry.frequency_bound).frequency_squared;
  return geometry;
}

void measure(int cells) {
  const StructureModel model{shale_case(), elasticity(shale_case().rock), 1};
  const double extent = cells * edge;
  Geometry geometry = geometry_on(jittered_mesh({extent, extent, cells, cells, 0.2, 1}), model);
  const Geometry before = geometry;
  fmt::print("{} elements, {} changes along a path; processor time\n", geometry.mesh.elements.size(),
             changes);

  Times follow_times, hash_times, step_times, tile_times, body_times, frequency_times, node_times;
  std::size_t removed = 0, made = 0;
  for (int k = 0; k < changes; ++k) {
    const double x = 0.8 * extent * (k / double{changes} - 0.5);
    const Point at{x, 0.1 * extent * std::sin(10 * x / extent)};
    const MeshChange change = k % 2 == 0 ? refine(geometry.mesh, at, 1.6) : coarsen(geometry.mesh, at, 2.5);
    Geometry twin = geometry;
    node_times.samples.push_back(milliseconds([&] { twin.node_elements.follow(twin.mesh, change); }));
    body_times.samples.push_back(
        milliseconds([&] { update_body(twin.mesh, twin.node_elements, model.run_case, change, twin.body); }));
    tile_times.samples.push_back(milliseconds([&] {
      update_tiles(twin.mesh, twin.node_elements, twin.body, joint_nodes(twin.mesh), change, twin.tiles);
    }));
    frequency_times.samples.push_back(milliseconds([&] {
      update_frequencies(twin.mesh, twin.node_elements, model.moduli, model.run_case.rock.density, change,
                         twin.frequency_bound);
    }));
    follow_times.samples.push_back(milliseconds([&] { follow(model, change, geometry); }));
    State state = state_at_rest(geometry.body);
    hash_times.samples.push_back(milliseconds([&] {
      untouched_hash(geometry.mesh, geometry.body, state.displacement, state.velocity,
                     {change.made, change.new_nodes});
    }));
    removed += change.removed.size();
    made += change.made.size();
  }

  State state = state_at_rest(geometry.body);
  CentralDifference dynamics(geometry.body, geometry.tiles, model.moduli, 1);
  const Step step{stable_step(geometry.frequency_squared, 0, {0.5, 1, 0.2}), 0, 1, 0.2};
  for (int k = 0; k < steps; ++k)
    step_times.samples.push_back(milliseconds([&] { dynamics.advance(state, step); }));
  State state_before = state_at_rest(before.body);
  CentralDifference dynamics_before(before.body, before.tiles, model.moduli, 1);
  Times step_times_before;
  for (int k = 0; k < steps; ++k)
    step_times_before.samples.push_back(milliseconds([&] { dynamics_before.advance(state_before, step); }));

  follow_times.print("follow(): all of the below");
  node_times.print("  elements around each node");
  body_times.print("  masses, forces, constraints");
  tile_times.print("  tiles and slots");
  frequency_times.print("  bound of the stable step");
  hash_times.print("hash of the untouched rest");
  step_times_before.print("explicit step, 1 thread, before");
  step_times.print("explicit step, 1 thread, after all");
  const double fresh =
      stiffest_element(geometry.mesh, model.moduli, model.run_case.rock.density).frequency_squared;
  fmt::print("elements removed {} and made {} per change; tiles {} -> {}, slots {} -> {}\n",
             removed / changes, made / changes, before.tiles.tile.size(), geometry.tiles.tile.size(),
             before.tiles.slots, geometry.tiles.slots);
  fmt::print("stable step that was followed over one computed anew: {:.4f}\n\n",
             std::sqrt(fresh / geometry.frequency_squared));
}

}  // namespace

int main() {
  measure(316);
  return 0;
}
