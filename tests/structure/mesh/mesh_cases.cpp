// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_cases.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace fissura::structure {

Case square(double side) {
  Case given;
  given.domain = {side, side, 1};
  given.mesh = {.fracture_size = 0.5,
                .far_size = 4,
                .corridor = 2,
                .gradation = 0.2,
                .lattice_angle = {},
                .refinements = {}};
  return given;
}

void add_line(Case& given, const std::string& name, std::vector<Point> points) {
  FractureLine line;
  line.name = name;
  line.points = std::move(points);
  given.fractures.push_back(line);
}

Case single_line() {
  Case given = square(40);
  add_line(given, "slit", {{-5, 0}, {5, 0}});
  return given;
}

Case crossing() {
  Case given = square(40);
  const double y = 4 * std::sqrt(3.0) / 2;
  add_line(given, "level", {{-4, 0}, {4, 0}});
  add_line(given, "steep", {{-2, -y}, {2, y}});
  return given;
}

Case touching() {
  Case given = square(40);
  add_line(given, "through", {{-4, 0}, {4, 0}});
  add_line(given, "arriving", {{0, -4}, {0, 0}});
  return given;
}

Case random_lines(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  Case given = square(20);
  given.mesh.seed = seed;
  const int lines = 1 + static_cast<int>(uniform(0, 6));
  for (int line = 0; line < lines; ++line) {
    std::vector<Point> points;
    double x = uniform(-6, 6), y = uniform(-6, 6), angle = uniform(0, 6);
    const int corners = 2 + static_cast<int>(uniform(0, 3));
    for (int corner = 0; corner < corners; ++corner) {
      points.push_back({std::round(4 * x) / 4, std::round(4 * y) / 4});
      const double length = uniform(0.5, 3.5);
      angle += uniform(-1, 1);
      x += length * std::cos(angle);
      y += length * std::sin(angle);
    }
    add_line(given, std::string(1, static_cast<char>('a' + line)), points);
    given.fractures.back().tensile_strength = uniform(0, 1e6);
  }
  return given;
}

double distance(Point a, Point b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

long euler_characteristic(const Mesh& mesh) {
  std::set<std::pair<NodeIndex, NodeIndex>> edges;
  for (const auto& e : mesh.elements)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(e[k], e[(k + 1) % 3]));
  return static_cast<long>(mesh.position.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(mesh.elements.size());
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (ElementIndex e = 0; e < mesh.elements.size(); ++e) sum += element_area(mesh, e);
  return sum;
}

}  // namespace fissura::structure
