// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "structure/structure_fields.hpp"
#include "structure/structure_run.hpp"
#include "tests/fakes/structure/shale_case.hpp"

/// Bulk failure through the loop of the process, without any fracture or fluid.

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double loading_time = 0.02;  // [s]: fifty transits of a wave, so slow

// Sides given by displacements that stretch (positive) or squeeze the block along y.
Case loaded_block(double stretch) {
  Case settings = fakes::shale_case();
  settings.domain.width = settings.domain.height = settings.domain.thickness = 1;
  settings.mesh.fracture_size = settings.mesh.far_size = settings.mesh.corridor = 0.1;
  settings.mesh.gradation = 0.1;
  settings.boundary.south = {BoundaryKind::roller, {}, 0};
  settings.boundary.north = {BoundaryKind::displacement, {0, stretch}, loading_time};
  settings.dynamics.initial_mass_scale = 1;
  settings.bulk_failure.active = true;
  return settings;
}

struct Loaded {
  StructureModel model;
  Geometry geometry;
  StructureState state;

  explicit Loaded(const Case& settings)
      : model{settings, elasticity(settings.rock), 1},
        geometry(build_geometry(model)),
        state(initial_state(model, geometry)) {
    StructureRun run(model, geometry);
    for (int interval = 0; interval < 10; ++interval)
      run.advance(0.1 * interval * loading_time, 0.1 * (interval + 1) * loading_time, state);
  }

  [[nodiscard]] double greatest(const char* field) const {
    const auto values = structure_fields(model, geometry, state, MeshInReport::known).numbers(field);
    return *std::max_element(values.begin(), values.end());
  }
};

}  // namespace

TEST_CASE("failing run: a block that is torn apart spends about its fracture energy",
          "[verification][structure]") {
  const Loaded block(loaded_block(3e-4));
  const double work = failure_work(block.model, block.geometry, block.state);
  CHECK(work > 0.8 * 50);  // a free band in an even block: at least one crack through it
  CHECK(work < 2 * 50);
  CHECK(block.greatest("damage") > 0.95);
  CHECK(block.greatest("damage") <= 1);
  CHECK(block.greatest("plastic_strain") == 0);
}

TEST_CASE("failing run: a block that is squeezed beyond its strength shears", "[verification][structure]") {
  Case settings = loaded_block(-1.6e-3);
  settings.bulk_failure.cohesion = 10e6;
  settings.bulk_failure.friction_angle = 0.5235987755982988;
  settings.bulk_failure.dilation_angle = 0.17453292519943295;
  const Loaded block(settings);
  const double unconfined = 34.641016e6;  // 2 c cos(phi) / (1 - sin(phi))
  const auto stress = structure_fields(block.model, block.geometry, block.state, MeshInReport::known)
                          .numbers("effective_stress_yy");
  double mean = 0;
  for (const double value : stress) mean += value / static_cast<double>(stress.size());
  CHECK(mean < -0.9 * unconfined);
  CHECK(mean > -1.1 * unconfined);  // the sides hold on to the ends, and shear bands confine each other
  CHECK(block.greatest("plastic_strain") > 1e-4);
  const double elastic_limit = unconfined / block.model.run_case.rock.plane_strain_modulus();
  CHECK(failure_work(block.model, block.geometry, block.state) ==
        Approx(unconfined * (1.6e-3 - elastic_limit)).epsilon(0.15));
}

TEST_CASE("failing run: a case without bulk failure stays elastic", "[verification][structure]") {
  Case settings = loaded_block(3e-4);
  settings.bulk_failure.active = false;
  const Loaded block(settings);
  CHECK(failure_work(block.model, block.geometry, block.state) == 0);
  CHECK_FALSE(structure_fields(block.model, block.geometry, block.state, MeshInReport::known).has("damage"));
}
