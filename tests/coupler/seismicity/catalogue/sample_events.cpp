// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/seismicity/catalogue/sample_events.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <tuple>

namespace fissura::coupler::sample {

namespace {

using Random = std::mt19937_64;

/// Random bits: any size, either sign, denormal numbers too.
double any_number(Random& random) {
  for (;;) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

double in(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

SeismicEvent random_event(Random& random) {
  constexpr double pi = std::numbers::pi;
  SeismicEvent e;
  e.id = random();
  for (double* value : {&e.origin_time,       &e.centroid_time, &e.duration,       &e.origin[0],
                        &e.origin[1],         &e.centroid[0],   &e.centroid[1],    &e.scalar_moment,
                        &e.scalar_sum,        &e.coherence,     &e.shares.iso,     &e.shares.clvd,
                        &e.shares.dc,         &e.hudson.u,      &e.hudson.v,       &e.normal[0],
                        &e.normal[1],         &e.area,          &e.slip,           &e.opening,
                        &e.stress_drop,       &e.radius,        &e.length,         &e.thickness,
                        &e.element_size,      &e.peak_rate,     &e.fluid_pressure, &e.radius_of_clustering,
                        &e.time_of_clustering})
    *value = any_number(random);
  for (double& component : e.moment) component = any_number(random);
  for (double& component : e.pseudo_moment) component = any_number(random);
  e.magnitude = in(random, -4, 2);
  e.slope = in(random, -pi / 2, pi / 2);
  e.plane = {in(random, 0, 2 * pi), in(random, 0, pi / 2), in(random, -pi, pi)};
  e.auxiliary_plane = {in(random, 0, 2 * pi), in(random, 0, pi / 2), in(random, -pi, pi)};
  e.type = static_cast<EventType>(1 + random() % 4);
  e.fracture = std::array{SourceFracture::open, SourceFracture::natural, SourceFracture::grown,
                          SourceFracture::none}[random() % 4];
  e.line = static_cast<std::uint32_t>(random());
  e.sources = random();
  e.records = random();
  e.interval = random();
  return e;
}

auto numbers_of(const SeismicEvent& e) {
  return std::vector<double>{e.origin_time,
                             e.centroid_time,
                             e.duration,
                             e.origin[0],
                             e.origin[1],
                             e.centroid[0],
                             e.centroid[1],
                             e.moment[0],
                             e.moment[1],
                             e.moment[2],
                             e.moment[3],
                             e.pseudo_moment[0],
                             e.pseudo_moment[1],
                             e.pseudo_moment[2],
                             e.pseudo_moment[3],
                             e.scalar_moment,
                             e.scalar_sum,
                             e.coherence,
                             e.magnitude.value_or(-99),
                             e.shares.iso,
                             e.shares.clvd,
                             e.shares.dc,
                             e.hudson.u,
                             e.hudson.v,
                             e.slope,
                             e.normal[0],
                             e.normal[1],
                             e.plane.strike,
                             e.plane.dip,
                             e.plane.rake,
                             e.auxiliary_plane.strike,
                             e.auxiliary_plane.dip,
                             e.auxiliary_plane.rake,
                             e.area,
                             e.slip,
                             e.opening,
                             e.stress_drop,
                             e.radius,
                             e.length,
                             e.thickness,
                             e.element_size,
                             e.peak_rate,
                             e.fluid_pressure,
                             e.radius_of_clustering,
                             e.time_of_clustering};
}

auto rest_of(const SeismicEvent& e) {
  return std::tuple(e.id, e.magnitude.has_value(), e.type, e.fracture, e.line, e.sources, e.records,
                    e.interval);
}

}  // namespace

std::vector<SeismicEvent> random_events(std::size_t count, std::uint32_t seed) {
  Random random(seed);
  std::vector<SeismicEvent> events;
  for (std::size_t i = 0; i < count; ++i) {
    SeismicEvent& event = events.emplace_back(random_event(random));
    if (i % 7 == 3) event.magnitude.reset();
  }
  using Limits = std::numeric_limits<double>;
  events.push_back(SeismicEvent{});
  SeismicEvent extreme;
  extreme.id = std::numeric_limits<std::uint64_t>::max();
  extreme.line = std::numeric_limits<std::uint32_t>::max();
  extreme.moment = {-0.0, Limits::denorm_min(), Limits::max(), Limits::lowest()};
  extreme.plane = {-0.0, Limits::denorm_min(), -Limits::min()};
  extreme.slope = std::numbers::pi / 2;
  extreme.magnitude = -0.0;
  events.push_back(extreme);
  return events;
}

bool same_bits(const SeismicEvent& a, const SeismicEvent& b) {
  const std::vector<double> left = numbers_of(a), right = numbers_of(b);
  for (std::size_t i = 0; i < left.size(); ++i)
    if (std::bit_cast<std::uint64_t>(left[i]) != std::bit_cast<std::uint64_t>(right[i])) return false;
  return rest_of(a) == rest_of(b);
}

Case placed_case() {
  Case value;
  value.title = "sample of a <catalogue> & more";
  value.rock.density = 2400;
  value.rock.youngs_modulus = 32e9;
  value.rock.poissons_ratio = 0.2;
  value.domain.thickness = 10;
  value.georeference = Georeference{56.7, -120.5, 2500, "2026-01-31T23:59:00.25Z", std::numbers::pi / 6, {}};
  return value;
}

CatalogueContext placed_context() {
  const Case value = placed_case();
  return {"0123456789abcdef", value.title, "2026-02-01T10:20:30Z", extraction_controls(value),
          value.georeference};
}

CatalogueContext context_without_place() {
  CatalogueContext context = placed_context();
  context.georeference.reset();
  return context;
}

std::vector<SourceRecord> random_sources(std::size_t count, std::uint32_t seed) {
  constexpr double apart = 5, lambda = 80e9 / 9, mu = 40e9 / 3;
  Random random(seed);
  std::vector<SourceRecord> records;
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  for (std::size_t i = 0; i < count; ++i) {
    SourceRecord& r = records.emplace_back();
    const double angle = in(random, 0, 2 * std::numbers::pi), slope = in(random, 0, std::numbers::pi / 2);
    const double size = std::pow(10, in(random, -5, -3));
    const double slip = size * std::cos(slope) * (random() % 2 == 0 ? 1 : -1),
                 opening = size * std::sin(slope);
    const double nx = std::cos(angle), ny = std::sin(angle);
    r.kind = random() % 2 == 0 ? SourceKind::contact_slip : SourceKind::new_crack;
    r.fracture = r.kind == SourceKind::contact_slip ? SourceFracture::natural : SourceFracture::grown;
    r.failing = true;
    r.line = static_cast<std::uint32_t>(random() % 50);
    r.entity = i;
    r.interval = i / 100 + 1;
    r.begin = static_cast<double>(r.interval) - in(random, 0.5, 0.9);
    r.end = r.begin + in(random, 1e-4, 1e-2);
    r.centroid_time = r.begin + 0.4 * (r.end - r.begin);
    r.position = {apart * (static_cast<double>(i % columns) + in(random, -0.2, 0.2)) - 250,
                  apart * (static_cast<double>(i / columns) + in(random, -0.2, 0.2)) - 250};
    r.extent = 10;
    r.element_size = 1;
    r.normal = {nx, ny};
    r.jump = {opening * nx + slip * ny, opening * ny - slip * nx};
    const double dx = r.jump[0], dy = r.jump[1];
    r.moment = {r.extent * (lambda * opening + 2 * mu * nx * dx),
                r.extent * (lambda * opening + 2 * mu * ny * dy), r.extent * lambda * opening,
                r.extent * mu * (nx * dy + ny * dx)};
    for (std::size_t k = 0; k < r.moment.size(); ++k) r.pseudo_moment[k] = in(random, -1, 1) * r.moment[0];
    r.measure = size;
    r.peak_rate = 0.1;
    r.shear_before = 2e6;
    r.shear_after = 1e6;
    r.normal_before = -1e6;
    r.normal_after = -2e6;
    r.fluid_pressure = in(random, 1e7, 3e7);
  }
  return records;
}

}  // namespace fissura::coupler::sample
