// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/mohr_coulomb.hpp"

#include <algorithm>
#include <optional>

namespace fissura::structure {

namespace {

using Principals = std::array<double, 3>;

// A plane of the surface: the principal stresses it bounds.
struct Plane {
  int major, minor;
};
constexpr Plane main_plane{0, 2}, right_plane{0, 1}, left_plane{1, 2};

struct Return {
  const MohrCoulomb& law;
  const Principals& predictor;
  const Principals& transmitted;
  double sine_dilation;

  [[nodiscard]] double value(const Plane& plane, const Principals& stress) const {
    const auto& [cohesion, sine, cosine] = law.surface;
    return slope(plane, stress) - 2 * cohesion * cosine;
  }

  // Derivative of the value in the direction of a stress.
  [[nodiscard]] double slope(const Plane& plane, const Principals& direction) const {
    const double sine = law.surface.sine_friction;
    return transmitted[plane.major] * direction[plane.major] * (1 + sine) -
           transmitted[plane.minor] * direction[plane.minor] * (1 - sine);
  }

  [[nodiscard]] Principals flow(const Plane& plane) const {
    Principals strain{};
    strain[plane.major] = 1 + sine_dilation;
    strain[plane.minor] = -(1 - sine_dilation);
    return strain;
  }

  [[nodiscard]] Principals stress_of(const Principals& strain) const {
    const double mean = law.moduli.lame * (strain[0] + strain[1] + strain[2]);
    const double twice = 2 * law.moduli.shear;
    return {mean + twice * strain[0], mean + twice * strain[1], mean + twice * strain[2]};
  }

  [[nodiscard]] PlasticReturn after(const Principals& strain, ReturnedTo place) const {
    PlasticReturn result{predictor, strain, place};
    const Principals relaxed = stress_of(strain);
    for (int i = 0; i < 3; ++i) result.stress[i] -= relaxed[i];
    return result;
  }

  [[nodiscard]] PlasticReturn to_plane() const {
    Principals strain = flow(main_plane);
    const double multiplier = value(main_plane, predictor) / slope(main_plane, stress_of(strain));
    for (double& component : strain) component *= multiplier;
    return after(strain, ReturnedTo::plane);
  }

  [[nodiscard]] std::optional<PlasticReturn> to_edge(const Plane& other, ReturnedTo place) const {
    const Principals flow_main = flow(main_plane), flow_other = flow(other);
    const Principals relaxed_main = stress_of(flow_main), relaxed_other = stress_of(flow_other);
    const double a = slope(main_plane, relaxed_main), b = slope(main_plane, relaxed_other);
    const double c = slope(other, relaxed_main), d = slope(other, relaxed_other);
    const double determinant = a * d - b * c;
    if (!(determinant > 0)) return std::nullopt;
    const double value_main = value(main_plane, predictor), value_other = value(other, predictor);
    const double multiplier_main = (d * value_main - b * value_other) / determinant;
    const double multiplier_other = (a * value_other - c * value_main) / determinant;
    if (multiplier_main < 0 || multiplier_other < 0) return std::nullopt;
    Principals strain;
    for (int i = 0; i < 3; ++i) strain[i] = multiplier_main * flow_main[i] + multiplier_other * flow_other[i];
    return after(strain, place);
  }

  [[nodiscard]] PlasticReturn to_apex() const {
    const auto& [cohesion, sine, cosine] = law.surface;
    PlasticReturn result{{}, {}, ReturnedTo::apex};
    Principals relaxed;
    for (int i = 0; i < 3; ++i) {
      result.stress[i] = cohesion * cosine / sine / transmitted[i];
      relaxed[i] = predictor[i] - result.stress[i];
    }
    const double twice = 2 * law.moduli.shear;
    const double mean =
        law.moduli.lame * (relaxed[0] + relaxed[1] + relaxed[2]) / (3 * law.moduli.lame + twice);
    for (int i = 0; i < 3; ++i) result.strain[i] = (relaxed[i] - mean) / twice;
    return result;
  }
};

// Rounding of stresses of this size.
double rounding(const Principals& predictor) {
  constexpr double relative = 1e-12;
  double largest = 0;
  for (const double stress : predictor) largest = std::max(largest, std::abs(stress));
  return relative * largest;
}

bool in_order(const PlasticReturn& result, double tolerance) {
  return result.stress[0] >= result.stress[1] - tolerance && result.stress[1] >= result.stress[2] - tolerance;
}

}  // namespace

double yield_value(const MohrCoulombSurface& surface, const std::array<double, 3>& stress) {
  return (stress[0] - stress[2]) + (stress[0] + stress[2]) * surface.sine_friction -
         2 * surface.cohesion * surface.cosine_friction;
}

PlasticReturn return_to_surface(const MohrCoulomb& law, const std::array<double, 3>& predictor,
                                const std::array<double, 3>& transmitted) {
  const double least = *std::min_element(transmitted.begin(), transmitted.end());
  const Return attempt{law, predictor, transmitted, least * law.sine_dilation};
  if (attempt.value(main_plane, predictor) <= 0) return {predictor, {}, ReturnedTo::inside};
  const double tolerance = rounding(predictor);
  const PlasticReturn on_plane = attempt.to_plane();
  if (in_order(on_plane, tolerance)) return on_plane;

  const bool toward_right = (1 - attempt.sine_dilation) * predictor[0] - 2 * predictor[1] +
                                (1 + attempt.sine_dilation) * predictor[2] >
                            0;
  const auto on_edge = toward_right ? attempt.to_edge(right_plane, ReturnedTo::right_edge)
                                    : attempt.to_edge(left_plane, ReturnedTo::left_edge);
  if (on_edge && in_order(*on_edge, tolerance)) return *on_edge;
  return law.surface.sine_friction > 0 && least > 0 ? attempt.to_apex() : on_edge.value_or(on_plane);
}

}  // namespace fissura::structure
