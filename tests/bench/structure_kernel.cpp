// SPDX-License-Identifier: GPL-3.0-or-later

/// Million element updates per second of the tiled element loop, next to a naive loop on the same mesh.
///
/// Run it on a machine with nothing else to do:
///   cmake --build build/release --target structure_kernel
///   GLIBC_TUNABLES=glibc.malloc.hugetlb=1 GOMP_SPINCOUNT=1000 build/release/bin/structure_kernel
/// The first variable lets all columns use large pages; without it the largest mesh suffers, the tiles more
/// than the naive loop. The second keeps two threads useful when a core is shared.
///
/// A jittered mesh of edge length `edge` carries an elastic wave. All columns of a row are measured in turns
/// in the same run: the tiles on one and two threads, the naive loop in Hilbert order and in random order,
/// with the failure check on and 0, 2 or 10 % of the elements in a band already softening. Rates on one
/// thread count processor time, on two threads wall time. A probe of multiply-adds before and after says
/// whether both cores were free.

#include <fmt/core.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/naive_structure.hpp"
#include "tests/fakes/structure/shale_case.hpp"

namespace {

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

constexpr double edge = 0.5;
constexpr double jitter = 0.25;
constexpr int trials = 7;
constexpr double updates_per_trial = 3e6;
constexpr double free_cores_ratio = 1.9;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double multiply_add_rate(int threads) {
  constexpr int rounds = 4'000'000, chains = 64;
  double sink = 0;
  const double begin = wall_time();
#pragma omp parallel num_threads(threads) reduction(+ : sink)
  {
    double chain[chains];
    for (int i = 0; i < chains; ++i) chain[i] = i;
    for (int round = 0; round < rounds; ++round)
      for (double& value : chain) value = value * 0.999999 + 1e-6;
    for (const double value : chain) sink += value;
  }
  const double rate = threads * double{rounds} * chains / (wall_time() - begin);
  return std::isfinite(sink) ? rate : 0;
}

double two_core_ratio() {
  double one = 0, two = 0;
  for (int trial = 0; trial < 3; ++trial) {
    one = std::max(one, multiply_add_rate(1));
    two = std::max(two, multiply_add_rate(2));
  }
  return two / one;
}

struct Wave {
  Mesh mesh;
  Body body;
  std::vector<double> velocity;
  std::vector<ElementDamage> softening;
};

BulkFailure linear_softening() {
  BulkFailure settings;
  settings.active = true;
  settings.softening = Softening::linear;
  return settings;
}

struct Setting {
  Case settings = shale_case();
  Elasticity moduli = elasticity(settings.rock);
  RockFailure law = rock_failure(settings.rock, linear_softening());
};

Wave wave_on(Mesh mesh, const Setting& setting, double extent, double softening_share) {
  Wave wave{std::move(mesh), {}, {}, {}};
  wave.body = build_body(wave.mesh, setting.settings);
  for (const Point& p : wave.mesh.position) {
    wave.velocity.push_back(0.03 * std::sin(0.2 * p[0]) * std::cos(0.17 * p[1]));
    wave.velocity.push_back(0.03 * std::cos(0.13 * p[0]) * std::sin(0.2 * p[1]));
  }
  for (ElementIndex e = 0; e < wave.mesh.elements.size(); ++e) {
    if (std::abs(centroid(wave.mesh, e)[1]) > 0.5 * softening_share * extent) continue;
    DamageHistory history = undamaged_band(setting.law.tension, {0, 1}, edge);
    grow_damage(setting.law.tension, 2 * history.equivalent_strain, history);
    wave.softening.push_back({e, history, {}});
  }
  return wave;
}

struct Rates {
  std::vector<double> samples;

  [[nodiscard]] double best() const { return *std::max_element(samples.begin(), samples.end()); }
  [[nodiscard]] double median() const {
    auto sorted = samples;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

struct Contestant {
  std::function<void()> advance;
  double (*clock)();
  Rates rates;
};

std::string column(const Rates& rates) {
  return fmt::format("{:6.1f} /{:6.1f}", rates.best(), rates.median());
}

void measure(int cells, double softening_share) {
  const Setting setting;
  const double extent = cells * edge;
  const Grid grid{extent, extent, cells, cells, jitter, 1};
  const Wave ordered = wave_on(jittered_mesh(grid), setting, extent, softening_share);
  const Wave random = wave_on(shuffled(ordered.mesh, 2), setting, extent, softening_share);
  const auto stiffest = stiffest_element(ordered.mesh, setting.moduli, setting.settings.rock.density);
  const Step step{stable_step(stiffest.frequency_squared, 0, {0.5, 1, 0.2}), 0, 1, 0.2};

  const Tiles tiles = build_tiles(ordered.mesh, ordered.body, {});
  State one_state{std::vector<double>(ordered.velocity.size()), ordered.velocity,
                  damage_from_records(tiles, ordered.softening)};
  State two_state = one_state;
  CentralDifference one(ordered.body, tiles, setting.moduli, setting.law, 1);
  CentralDifference two(ordered.body, tiles, setting.moduli, setting.law, 2);
  const auto naive = [&](const Wave& wave) {
    NaiveStructure structure(wave.mesh, wave.body, setting.moduli, setting.law);
    structure.set_velocity(wave.velocity);
    structure.set_damage(wave.softening);
    return structure;
  };
  NaiveStructure naive_hilbert = naive(ordered), naive_random = naive(random);

  std::vector<Contestant> contestants{{[&] { one.advance(one_state, step); }, processor_time, {}},
                                      {[&] { two.advance(two_state, step); }, wall_time, {}},
                                      {[&] { naive_hilbert.advance(step); }, processor_time, {}},
                                      {[&] { naive_random.advance(step); }, processor_time, {}}};
  const auto elements = static_cast<double>(ordered.mesh.elements.size());
  const int steps = std::max(2, static_cast<int>(updates_per_trial / elements));
  for (int trial = 0; trial < trials; ++trial)
    for (Contestant& contestant : contestants) {
      const double begin = contestant.clock();
      for (int k = 0; k < steps; ++k) contestant.advance();
      contestant.rates.samples.push_back(1e-6 * steps * elements / (contestant.clock() - begin));
    }
  const Rates &tiled = contestants[0].rates, &hilbert = contestants[2].rates,
              &scattered = contestants[3].rates;
  fmt::print("{:8.0f} {:5.0f} %  {}  {}  {}  {}  {:5.2f} {:5.2f}  {:6.1f}\n", elements,
             100 * static_cast<double>(ordered.softening.size()) / elements, column(tiled),
             column(contestants[1].rates), column(hilbert), column(scattered),
             tiled.median() / hilbert.median(), tiled.median() / scattered.median(),
             streamed_bytes_per_element(tiles));
}

}  // namespace

int main() {
  const double before = two_core_ratio();
  fmt::print("Million element updates per second, best / median of {} trials; x = median over median\n",
             trials);
  fmt::print(
      "elements  soft   tiles, 1 thread  tiles, 2 threads  naive, Hilbert  naive, random    x H   x R  "
      "bytes\n");
  for (const int cells : {100, 224, 388})
    for (const double softening_share : {0.0, 0.02, 0.1}) measure(cells, softening_share);
  const double after = two_core_ratio();
  fmt::print(
      "Multiply-adds on two threads over one: {:.2f} before, {:.2f} after: both cores were {}.\n", before,
      after,
      std::min(before, after) >= free_cores_ratio ? "free" : "NOT free; judge the one-thread ratios only");
  return 0;
}
