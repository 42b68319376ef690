// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/message_bound.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::coupler {

namespace {

constexpr double bytes_per_element = 4096;
constexpr double smallest_bound = 16.0 * (1 << 20);
constexpr double largest_bound = 64.0 * (1 << 30);
// sqrt(3)/4
constexpr double triangle = 0.4330127018922193;

/// Elements of size h within `half_width` of a line, and where they grow beyond it.
double along(double length, double half_width, double h, double gradation) {
  return 2 * (length + 2 * half_width) * (half_width / (h * h) + 1 / (gradation * h)) / triangle;
}

double length_of(const FractureLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    length +=
        std::hypot(line.points[i][0] - line.points[i - 1][0], line.points[i][1] - line.points[i - 1][1]);
  return length;
}

double or_else(double value, double otherwise) {
  return value > 0 ? value : otherwise;
}

}  // namespace

std::int64_t largest_frame(const Case& run_case) {
  const MeshControls& mesh = run_case.mesh;
  const Domain& domain = run_case.domain;
  const double far = or_else(mesh.far_size, mesh.fracture_size);
  const double gradation = std::clamp(mesh.gradation, 0.01, 1.0);
  double elements = domain.width * domain.height / (triangle * far * far);
  for (const FractureLine& line : run_case.fractures) {
    const double h = line.kind == FractureKind::natural ? or_else(mesh.natural_size, mesh.fracture_size)
                                                        : mesh.fracture_size;
    elements += along(length_of(line), mesh.corridor, h, gradation);
  }
  const double tip = or_else(mesh.tip_size, mesh.fracture_size);
  elements += along(domain.width + domain.height, or_else(mesh.tip_radius, 4 * tip), tip,
                    std::clamp(or_else(mesh.tip_gradation, 0.4), 0.01, 1.0));
  for (const Refinement& each : mesh.refinements)
    elements +=
        along(each.east - each.west, (each.north - each.south) / 2, or_else(each.size, far), gradation);
  return static_cast<std::int64_t>(std::clamp(bytes_per_element * elements, smallest_bound, largest_bound));
}

}  // namespace fissura::coupler
