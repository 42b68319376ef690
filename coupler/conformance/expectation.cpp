// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/expectation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "coupler/conformance/check.hpp"

namespace fissura::coupler::conformance {

namespace {

void require_as_many(const std::string& what, std::size_t obtained, std::size_t expected) {
  if (obtained != expected)
    throw Deviation(fmt::format("{} values of {}", expected, what), fmt::format("{}", obtained));
}

std::string place(const std::string& what, std::size_t i) {
  return fmt::format("{} {}", what, i);
}

}  // namespace

void require(bool holds, const std::string& expected, const std::string& obtained) {
  if (!holds) throw Deviation(expected, obtained);
}

void require_close(const std::string& what, double obtained, double expected, double tolerance) {
  if (!(std::abs(obtained - expected) <= tolerance))
    throw Deviation(fmt::format("{} {:.9g} within {:.2g}", what, expected, tolerance),
                    fmt::format("{:.9g} ({:+.3g})", obtained, obtained - expected));
}

void require_ratio(const std::string& what, double obtained, double expected, double relative_tolerance) {
  if (!(std::abs(obtained - expected) <= relative_tolerance * std::abs(expected)))
    throw Deviation(fmt::format("{} {:.9g} within {:.2g} of it", what, expected, relative_tolerance),
                    fmt::format("{:.9g} ({:+.3g} of it)", obtained, obtained / expected - 1));
}

void require_within(const std::string& what, double obtained, double minimum, double maximum) {
  if (!(std::isfinite(obtained) && obtained >= minimum && obtained <= maximum))
    throw Deviation(fmt::format("{} in [{:.6g}, {:.6g}]", what, minimum, maximum),
                    fmt::format("{:.9g}", obtained));
}

void require_all_close(const std::string& what, const std::vector<double>& obtained,
                       const std::vector<double>& expected, double tolerance) {
  require_as_many(what, obtained.size(), expected.size());
  for (std::size_t i = 0; i < obtained.size(); ++i)
    require_close(place(what, i), obtained[i], expected[i], tolerance);
}

void require_all_within(const std::string& what, const std::vector<double>& obtained, double minimum,
                        double maximum) {
  for (std::size_t i = 0; i < obtained.size(); ++i)
    require_within(place(what, i), obtained[i], minimum, maximum);
}

void require_same(const std::string& what, const std::string& obtained, const std::string& expected) {
  if (obtained != expected)
    throw Deviation(fmt::format("{} \"{}\"", what, expected), fmt::format("\"{}\"", obtained));
}

void require_same_bits(const std::string& what, const std::vector<double>& obtained,
                       const std::vector<double>& expected) {
  require_as_many(what, obtained.size(), expected.size());
  for (std::size_t i = 0; i < obtained.size(); ++i)
    if (std::memcmp(&obtained[i], &expected[i], sizeof(double)) != 0)
      throw Deviation(fmt::format("{} {:.17g}, bit for bit", place(what, i), expected[i]),
                      fmt::format("{:.17g}", obtained[i]));
}

}  // namespace fissura::coupler::conformance
