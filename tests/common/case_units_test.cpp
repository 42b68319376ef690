// SPDX-License-Identifier: GPL-3.0-or-later
#include <clocale>
#include <cmath>

#include <catch2/catch.hpp>

#include "common/case/units.hpp"
#include "common/errors.hpp"

using namespace fissura;
using namespace fissura::input;

// A conversion multiplies once; what remains is the rounding of a factor and of that product.
constexpr double rounding = 1e-15;

TEST_CASE("units: text becomes SI", "[common][case][units]") {
  CHECK(in_si("32 GPa", dimension::stress) == 32e9);
  CHECK(in_si("  +1.5e1\tMPa ", dimension::stress) == 15e6);
  CHECK(in_si("10 um", dimension::length) == 10e-6);
  CHECK(in_si("10 µm", dimension::length) == 10e-6);
  CHECK(in_si("2.5 g/cm^3", dimension::density) == Approx(2500).epsilon(rounding));
  CHECK(in_si("50 N/m", dimension::energy_per_area) == 50);
  CHECK(in_si("1 cP", dimension::viscosity) == 1e-3);
  CHECK(in_si("6 m3/min", dimension::rate) == Approx(0.1).epsilon(rounding));
  CHECK(in_si("180 degree", dimension::angle) == Approx(3.14159265358979323846).epsilon(rounding));
  CHECK(in_si("40 MPa", dimension::stress) == in_si("400 bar", dimension::stress));
}

TEST_CASE("units: the Carter coefficient is a length per square root of time in any units",
          "[common][case][units]") {
  CHECK(in_si("5e-5 m/s^0.5", dimension::carter_coefficient) == 5e-5);
  CHECK(in_si("5e-5 m/sqrt(s)", dimension::carter_coefficient) == 5e-5);
  CHECK(in_si("5e-5 m s^-0.5", dimension::carter_coefficient) == 5e-5);
  CHECK(in_si("1 mm/sqrt(min)", dimension::carter_coefficient) ==
        Approx(1e-3 / std::sqrt(60)).epsilon(rounding));
  CHECK(in_si("0.003 ft/min^0.5", dimension::carter_coefficient) ==
        Approx(0.003 * 0.3048 / std::sqrt(60)).epsilon(rounding));
  for (const char* wrong :
       {"5e-5 m/s", "5e-5 m s^0.5", "5e-5 m/s^0.25", "5e-5 m^2/s^0.5", "5e-5 m/m^0.5", "5e-5 m"})
    CHECK_THROWS_AS(in_si(wrong, dimension::carter_coefficient), InputError);
}

TEST_CASE("units: the consistency index is a stress times a time to the power index",
          "[common][case][units]") {
  CHECK(in_si("0.5 Pa s^n", dimension::consistency_index(0.5)) == 0.5);
  CHECK(in_si("0.5 Pa s^0.6", dimension::consistency_index(0.6)) == 0.5);
  CHECK(in_si("0.5 Pa s", dimension::consistency_index(1)) == 0.5);
  CHECK(in_si("0.5 Pa min^n", dimension::consistency_index(0.5)) ==
        Approx(0.5 * std::sqrt(60)).epsilon(rounding));
  CHECK_THROWS_AS(in_si("0.5 Pa s^0.6", dimension::consistency_index(0.5)), InputError);
  CHECK_THROWS_AS(in_si("0.5 Pa s", dimension::consistency_index(0.5)), InputError);
  CHECK_THROWS_AS(in_si("0.5 Pa/s^n", dimension::consistency_index(0.5)), InputError);
}

TEST_CASE("units: what is not one number with one proportional unit of the dimension is refused",
          "[common][case][units]") {
  for (const char* wrong : {"", "m", "1", "1 s", "1 m^2", "1,5 m", "1 2 m", "1 m 2", "1 m m", "0x10 m",
                            "nan m", "1e999 m", "1 1/m", "1 lg(re m)", "1 Gm/", "1 m since 2000-01-01"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(in_si(wrong, dimension::length), InputError);
  }
  CHECK_THROWS_AS(in_si("1 Hz", dimension::time), InputError);
  CHECK_THROWS_AS(in_si("40 1", dimension::angle), InputError);
  CHECK_THROWS_AS(in_si("40 percent", dimension::angle), InputError);
}

TEST_CASE("units: a locale with a decimal comma changes nothing", "[common][case][units]") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const char* comma = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"})
    if (comma == nullptr) comma = std::setlocale(LC_ALL, name);
  if (comma == nullptr) WARN("no locale with a decimal comma on this machine: only the usual one is tested");
  CHECK(in_si("1.5 N/mm^2", dimension::stress) == 1.5e6);
  CHECK(in_si("5e-5 m/s^0.5", dimension::carter_coefficient) == 5e-5);
  std::setlocale(LC_ALL, before.c_str());
}
