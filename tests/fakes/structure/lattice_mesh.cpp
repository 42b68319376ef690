// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/structure/lattice_mesh.hpp"

#include <cmath>
#include <map>

#include "structure/dynamics/triangle.hpp"
#include "structure/mesh/order.hpp"
#include "structure/mesh/triangulate.hpp"

namespace fissura::structure::fakes {

namespace {

void add_line(const Point& begin, const Point& end, int parts, std::vector<Point>& points) {
  for (int i = 0; i < parts; ++i) {
    const double t = static_cast<double>(i) / parts;
    points.push_back({begin[0] + t * (end[0] - begin[0]), begin[1] + t * (end[1] - begin[1])});
  }
}

int parts_of(double length, double edge) {
  return static_cast<int>(std::lround(length / edge));
}

void add_lattice(const Lattice& given, std::vector<Point>& points) {
  const double clearance = 0.5 * given.edge, row_height = given.edge * std::sqrt(3.0) / 2;
  const double cosine = std::cos(given.angle), sine = std::sin(given.angle);
  const int reach = static_cast<int>(2 * std::hypot(given.width, given.height) / given.edge);
  const double tip = given.notch - 0.5 * given.width;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column) {
      // Off the middle, so that no row of triangles is special.
      const double along = (column + 0.5 * (row % 2 == 0) + 0.21) * given.edge,
                   across = (row + 0.37) * row_height;
      const Point p{cosine * along - sine * across, sine * along + cosine * across};
      if (std::abs(p[0]) > 0.5 * given.width - clearance || std::abs(p[1]) > 0.5 * given.height - clearance)
        continue;
      if (given.notch > 0 && std::hypot(std::max(p[0] - tip, 0.0), p[1]) < clearance) continue;
      points.push_back(p);
    }
}

void open_notch(const std::vector<NodeIndex>& notch, Mesh& mesh) {
  std::map<NodeIndex, NodeIndex> above;
  for (const NodeIndex node : notch) {
    above[node] = static_cast<NodeIndex>(mesh.position.size());
    mesh.position.push_back(Point(mesh.position[node]));
  }
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    if (centroid(mesh, element)[1] < 0) continue;
    for (NodeIndex& node : mesh.elements[element])
      if (const auto found = above.find(node); found != above.end()) node = found->second;
  }
}

void list_side_nodes(const Lattice& given, Mesh& mesh) {
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    const auto& [x, y] = mesh.position[node];
    if (x == -0.5 * given.width) mesh.side_nodes[0].push_back(node);
    if (x == 0.5 * given.width) mesh.side_nodes[1].push_back(node);
    if (y == -0.5 * given.height) mesh.side_nodes[2].push_back(node);
    if (y == 0.5 * given.height) mesh.side_nodes[3].push_back(node);
  }
}

}  // namespace

Mesh lattice_mesh(const Lattice& given) {
  const double x = 0.5 * given.width, y = 0.5 * given.height;
  const int along = parts_of(given.width, given.edge), half_up = parts_of(y, given.edge);
  std::vector<Point> points;
  add_line({-x, -y}, {x, -y}, along, points);
  add_line({x, -y}, {x, 0}, half_up, points);
  add_line({x, 0}, {x, y}, half_up, points);
  add_line({x, y}, {-x, y}, along, points);
  add_line({-x, y}, {-x, 0}, half_up, points);
  std::vector<NodeIndex> notch;
  std::vector<PointPair> edges;
  const auto mouth = static_cast<std::uint32_t>(points.size());
  add_line({-x, 0}, {-x, -y}, half_up, points);
  if (given.notch > 0) {
    const int parts = parts_of(given.notch, given.edge);
    notch.push_back(mouth);
    for (int i = 1; i <= parts; ++i) {
      const auto point = static_cast<std::uint32_t>(points.size());
      edges.push_back({i == 1 ? mouth : point - 1, point});
      if (i < parts) notch.push_back(point);
      points.push_back({-x + given.notch * i / parts, 0});
    }
  }
  add_lattice(given, points);

  Mesh mesh;
  mesh.position = points;
  mesh.elements = triangulate(points, edges);
  open_notch(notch, mesh);
  order(mesh);
  list_side_nodes(given, mesh);
  return mesh;
}

}  // namespace fissura::structure::fakes
