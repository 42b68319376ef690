// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/triangulate.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>

#include "common/errors.hpp"
#include "structure/mesh/hilbert.hpp"

namespace fissura::structure {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Storage = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage, CGAL::No_constraint_intersection_tag>;

std::vector<Delaunay::Vertex_handle> insert_points(Delaunay& delaunay, std::span<const Point> points) {
  std::vector<Delaunay::Vertex_handle> vertex(points.size());
  Delaunay::Face_handle near;
  for (const std::uint32_t i : hilbert_order(points)) {
    const std::size_t before = delaunay.number_of_vertices();
    vertex[i] = delaunay.insert({points[i][0], points[i][1]}, near);
    if (delaunay.number_of_vertices() == before)
      throw SolverError(
          fmt::format("the mesh has two points at ({:.6g}, {:.6g}) m", points[i][0], points[i][1]));
    vertex[i]->info() = i;
    near = vertex[i]->face();
  }
  return vertex;
}

PointTriple lowest_first(PointTriple t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

}  // namespace

std::vector<PointTriple> triangulate(std::span<const Point> points, std::span<const PointPair> edges) {
  Delaunay delaunay;
  const auto vertex = insert_points(delaunay, points);
  const auto fault = [&](const PointPair& edge) {
    return SolverError(
        fmt::format("the mesh cannot keep the edge from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m: another "
                    "point or line lies across it",
                    points[edge[0]][0], points[edge[0]][1], points[edge[1]][0], points[edge[1]][1]));
  };
  for (const PointPair& edge : edges) {
    try {
      delaunay.insert_constraint(vertex[edge[0]], vertex[edge[1]]);
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
      throw fault(edge);
    }
  }
  for (const PointPair& edge : edges)
    if (!delaunay.is_edge(vertex[edge[0]], vertex[edge[1]])) throw fault(edge);

  std::vector<PointTriple> triangles;
  triangles.reserve(delaunay.number_of_faces());
  for (const auto face : delaunay.finite_face_handles())
    triangles.push_back(
        lowest_first({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}));
  return triangles;
}

}  // namespace fissura::structure
