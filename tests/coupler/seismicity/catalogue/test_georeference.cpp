// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "coupler/seismicity/catalogue/geographic_place.hpp"
#include "coupler/seismicity/catalogue/utc_time.hpp"
#include "coupler/seismicity/extraction.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double a = 6378137.0, f = 1 / 298.257223563, e2 = f * (2 - f);

using Vector = std::array<double, 3>;

/// Earth-centred coordinates of a geodetic place, exact.
Vector earth_centred(double latitude, double longitude, double height) {
  const double n = a / std::sqrt(1 - e2 * std::pow(std::sin(latitude), 2));
  return {(n + height) * std::cos(latitude) * std::cos(longitude),
          (n + height) * std::cos(latitude) * std::sin(longitude),
          (n * (1 - e2) + height) * std::sin(latitude)};
}

/// The same of a point in the east-north-up frame at (latitude, longitude, height).
Vector earth_centred_of_local(double latitude, double longitude, double height, const Vector& local) {
  const double sp = std::sin(latitude), cp = std::cos(latitude), sl = std::sin(longitude),
               cl = std::cos(longitude);
  const Vector east{-sl, cl, 0}, north{-sp * cl, -sp * sl, cp}, up{cp * cl, cp * sl, sp};
  Vector point = earth_centred(latitude, longitude, height);
  for (std::size_t i = 0; i < 3; ++i) point[i] += local[0] * east[i] + local[1] * north[i] + local[2] * up[i];
  return point;
}

Geography geography_of(const Georeference& georeference) {
  Case value;
  value.rock.density = value.rock.youngs_modulus = 1;
  value.georeference = georeference;
  return extraction_controls(value).geography;
}

GeographicPlace place(const std::array<double, 2>& position, const Georeference& georeference) {
  return geographic_place(position, georeference, geography_of(georeference));
}

}  // namespace

TEST_CASE("one degree is as long as the tables of WGS 84 say", "[seismicity][catalogue]") {
  // Metres of a degree at the latitudes 0 and 45, given to one decimal of a metre.
  struct Known {
    double latitude, of_latitude, of_longitude;
  };
  for (const auto& [latitude, of_latitude, of_longitude] :
       {Known{0, 110574.3, 111319.5}, Known{45, 111131.8, 78846.8}}) {
    const Georeference georeference{latitude, 10, 0, "2026-01-01T00:00:00Z", 0, {}};
    CHECK(place({0, 100}, georeference).latitude - latitude == Approx(100 / of_latitude).epsilon(1e-6));
    CHECK(place({100, 0}, georeference).longitude - 10 == Approx(100 / of_longitude).epsilon(1e-6));
  }
}

TEST_CASE("a plan-view model of three kilometres is placed to two centimetres", "[seismicity][catalogue]") {
  for (const double latitude : {-65.0, 0.0, 31.5, 56.7})
    for (const double azimuth : {0.0, 30.0, 200.0})
      for (const std::array<double, 2> position :
           {std::array{2000.0, 2200.0}, std::array{-2900.0, 300.0}, std::array{10.0, -3000.0}}) {
        const Georeference georeference{latitude, -120.5, 2500, "2026-01-01T00:00:00Z", azimuth * degree, {}};
        const GeographicPlace found = place(position, georeference);
        CHECK(found.depth == 2500);
        // East and north of a frame turned clockwise by the azimuth.
        const double s = std::sin(azimuth * degree), c = std::cos(azimuth * degree);
        const Vector local{position[0] * c + position[1] * s, position[1] * c - position[0] * s, 0};
        const Vector exact = earth_centred_of_local(latitude * degree, -120.5 * degree, -2500, local);
        // The plane of the model leaves the surface of equal depth by r^2 / 2R: compared at its own height.
        const double radius2 = position[0] * position[0] + position[1] * position[1];
        const Vector ours =
            earth_centred(found.latitude * degree, found.longitude * degree, -2500 + radius2 / (2 * 6.371e6));
        // Third order in the distance, and the mean radius in place of that of the ellipsoid in the height.
        CHECK(std::hypot(ours[0] - exact[0], ours[1] - exact[1], ours[2] - exact[2]) < 0.02);
      }
}

TEST_CASE("in a section y is up and x points along its azimuth", "[seismicity][catalogue]") {
  const Georeference georeference{0, 0, 3000, "2026-01-01T00:00:00Z", 0, 90 * degree};
  const GeographicPlace found = place({1000, 500}, georeference);
  CHECK(found.depth == 2500);
  CHECK(found.longitude == Approx(1000 / (a - 2500) / degree).epsilon(1e-12));
  CHECK(std::abs(found.latitude) < 1e-12);
}

TEST_CASE("a place beyond the date line has its own longitude", "[seismicity][catalogue]") {
  const Georeference east{10, 179.9999, 0, "2026-01-01T00:00:00Z", 0, {}};
  CHECK(place({100, 0}, east).longitude < -179.99);
  const Georeference west{10, -179.9999, 0, "2026-01-01T00:00:00Z", 0, {}};
  CHECK(place({-100, 0}, west).longitude > 179.99);
}

TEST_CASE("seconds after a start are a time of day", "[seismicity][catalogue]") {
  CHECK(microseconds_of_utc("1970-01-01T00:00:00Z") == 0);
  CHECK(microseconds_of_utc("2000-03-01T00:00:00.000001Z") == 951868800000001);
  CHECK(utc_after("2026-02-28T23:59:59.5Z", 0.6) == "2026-03-01T00:00:00.100000Z");
  CHECK(utc_after("2028-02-28T00:00:00Z", 86400) == "2028-02-29T00:00:00.000000Z");
  CHECK(utc_after("2026-01-01T00:00:00Z", -1e-6) == "2025-12-31T23:59:59.999999Z");
  CHECK(utc_after("1969-12-31T23:59:59Z", 0.25) == "1969-12-31T23:59:59.250000Z");
  CHECK(utc_after("2026-01-01T00:00:00Z", 0.9999996) == "2026-01-01T00:00:01.000000Z");
}

TEST_CASE("what is no time of day is refused", "[seismicity][catalogue]") {
  for (const char* text :
       {"", "now", "2026-01-01", "2026-01-01T00:00:00", "2026-02-29T00:00:00Z", "2026-13-01T00:00:00Z",
        "2026-01-01T24:00:00Z", "2026-01-01T00:60:00Z", "2026-01-01T00:00:60Z", "2026-01-01 00:00:00Z",
        "2026-01-01T00:00:00.Z", "2026-01-01T00:00:00.5+01:00Z", "20x6-01-01T00:00:00Z",
        "2026-01-01T00:00:00,5Z"}) {
    INFO(text);
    CHECK_THROWS_AS(microseconds_of_utc(text), InputError);
  }
}
