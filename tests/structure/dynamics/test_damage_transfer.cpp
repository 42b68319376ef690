// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "structure/dynamics/damage_transfer.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/material/crack_band.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

RockFailure law_with(Softening softening) {
  BulkFailure settings;
  settings.active = true;
  settings.softening = softening;
  return rock_failure(shale_case().rock, settings);
}

ElementDamage record_on(const RockFailure& law, const Mesh& mesh, ElementIndex element,
                        double kappa_over_onset) {
  const std::array<double, 2> normal{0.6, 0.8};
  const auto& [a, b, c] = mesh.elements[element];
  ElementDamage record{element, {}, {{1e-5, -2e-5, 3e-6}, 4e-6, 70, 3}};
  record.history = undamaged_band(
      law.tension, normal, crack_band_length({mesh.position[a], mesh.position[b], mesh.position[c]}, normal));
  grow_damage(law.tension, kappa_over_onset * record.history.equivalent_strain, record.history);
  return record;
}

bool same(const DamageHistory& a, const DamageHistory& b) {
  return a.equivalent_strain == b.equivalent_strain && a.damage == b.damage &&
         a.band_length == b.band_length && a.tensile_strength == b.tensile_strength && a.normal == b.normal;
}

const ElementDamage* record_of(const std::vector<ElementDamage>& records, ElementIndex element) {
  const auto found = std::find_if(records.begin(), records.end(), [element](const ElementDamage& record) {
    return record.element == element;
  });
  return found == records.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("failure is carried: kept and moved elements bit for bit, made ones from the nearest removed",
          "[structure][dynamics]") {
  const auto law = law_with(GENERATE(Softening::linear, Softening::exponential));
  const Mesh before_mesh = jittered_mesh({4, 4, 16, 16, 0.2, 3});
  const auto body = build_body(before_mesh, shale_case());
  const Tiles tiles = build_tiles(before_mesh, body, {});
  const auto last = static_cast<ElementIndex>(before_mesh.elements.size() - 1);
  const std::vector<ElementDamage> records{
      record_on(law, before_mesh, 20, 5), record_on(law, before_mesh, 40, 3),
      record_on(law, before_mesh, 41, 8), record_on(law, before_mesh, last, 2)};
  const Damage damage = damage_from_records(tiles, records);

  // 40 and 41 leave, a triangle of another shape is made in place of 40, the last one moves to 41.
  MeshChange change;
  change.elements_before = before_mesh.elements.size();
  change.removed = {40, 41};
  change.made = {40};
  change.moved = {{last, 41}};
  Mesh after = before_mesh;
  const auto& corners = before_mesh.elements[41];
  const Point middle = centroid(before_mesh, 41);
  after.position.push_back({1.2 * middle[0] - 0.2 * before_mesh.position[corners[0]][0],
                            1.2 * middle[1] - 0.2 * before_mesh.position[corners[0]][1]});
  after.elements[40] = {static_cast<NodeIndex>(after.position.size() - 1), corners[1], corners[2]};
  after.elements[41] = before_mesh.elements[last];
  after.elements.pop_back();
  REQUIRE(triangle(after, 40).area > 0);

  const auto before = damage_before_change(before_mesh, tiles, damage, change.removed);
  const auto carried = carry_damage(before, change, after, law);
  REQUIRE(carried.size() == 3);
  REQUIRE(std::is_sorted(carried.begin(), carried.end(),
                         [](const auto& a, const auto& b) { return a.element < b.element; }));
  CHECK(same(record_of(carried, 20)->history, records[0].history));
  CHECK(same(record_of(carried, 41)->history, records[3].history));
  CHECK(record_of(carried, 41)->plastic.work == records[3].plastic.work);

  const ElementDamage& made = *record_of(carried, 40);
  const ElementDamage& source = records[2];
  CHECK(made.history.band_length != source.history.band_length);
  CHECK(made.history.normal == source.history.normal);
  CHECK(lost_strength(law.tension, made.history) ==
        Approx(lost_strength(law.tension, source.history)).epsilon(1e-12));
  CHECK(made.plastic.strain_zz == source.plastic.strain_zz);
  CHECK(made.plastic.worn * made.history.band_length ==
        Approx(source.plastic.worn * source.history.band_length).epsilon(1e-12));
  CHECK(made.history.damage == damage_of_strain(law.tension, made.history.tensile_strength,
                                                made.history.band_length, made.history.equivalent_strain));
}

TEST_CASE("failure is carried: a made element beside intact rock is intact", "[structure][dynamics]") {
  const auto law = law_with(Softening::linear);
  const Mesh mesh = jittered_mesh({4, 4, 16, 16, 0.2, 3});
  const auto body = build_body(mesh, shale_case());
  const Tiles tiles = build_tiles(mesh, body, {});
  MeshChange change;
  change.elements_before = mesh.elements.size();
  change.removed = change.made = {40, 200};
  const Damage damage = damage_from_records(tiles, {record_on(law, mesh, 40, 5)});
  const auto carried =
      carry_damage(damage_before_change(mesh, tiles, damage, change.removed), change, mesh, law);
  REQUIRE(carried.size() == 1);
  CHECK(carried[0].element == 40);
}
