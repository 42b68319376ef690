// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fissura {

namespace {

constexpr double cut = 3;          // deviations
constexpr int exponent_parts = 5;  // so that each part of cut^2 / 2 is below 1

std::uint64_t mixed(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
  return hash ^ seed;
}

double density(double x) {
  return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
}
double distribution(double x) {
  return std::erfc(-x / std::numbers::sqrt2) / 2;
}

Moments cut_moments(const Scattered& quantity, double lower, double upper) {
  const double share = distribution(upper) - distribution(lower);
  const double shift = (density(lower) - density(upper)) / share;
  const double variance = 1 + (lower * density(lower) - upper * density(upper)) / share - shift * shift;
  return {quantity.mean + shift * quantity.deviation, quantity.deviation * std::sqrt(variance)};
}

}  // namespace

Moments moments(const Scattered& quantity) {
  return cut_moments(quantity, -cut, cut);
}

Moments positive_moments(const Scattered& quantity) {
  if (quantity.mean > cut * quantity.deviation) return moments(quantity);
  return cut_moments(quantity, -quantity.mean / quantity.deviation, cut);
}

Scatter::Scatter(std::uint64_t seed, std::string_view name) : random_(mixed(seed, name)) {}

double Scatter::uniform() {
  return static_cast<double>(random_() >> 11) * 0x1p-53;
}

bool Scatter::happens_with_probability_of_exponential(double exponent) {
  bool odd = true;
  for (double last = exponent;; odd = !odd) {
    const double next = uniform();
    if (next >= last) return odd;
    last = next;
  }
}

double Scatter::normal() {
  for (;;) {
    const double x = cut * (2 * uniform() - 1);
    int part = 0;
    while (part < exponent_parts && happens_with_probability_of_exponential(x * x / (2 * exponent_parts)))
      ++part;
    if (part == exponent_parts) return x;
  }
}

double Scatter::draw(const Scattered& quantity) {
  return quantity.mean + quantity.deviation * normal();
}

double Scatter::draw_positive(const Scattered& quantity) {
  for (;;)
    if (const double value = draw(quantity); value > 0) return value;
}

}  // namespace fissura
