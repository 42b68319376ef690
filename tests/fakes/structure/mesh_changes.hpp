// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/mesh/mesh.hpp"
#include "structure/mesh/mesh_change.hpp"

/// Changes of a mesh that stand for insertions where the fracture itself plays no part.
namespace fissura::structure::fakes {

/// Cuts every element whose centroid lies within `radius` of `centre` [m] into three at its centroid.
MeshChange refine(Mesh& mesh, const Point& centre, double radius);

/// Removes nodes with four elements around them within `radius` of `centre` [m], no two of them neighbours;
/// two elements fill each gap. Nodes on sides and fractures stay.
MeshChange coarsen(Mesh& mesh, const Point& centre, double radius);

/// Doubles the node nearest to `centre` [m] inside the mesh: the elements around it above the line through it
/// along x get the new node, and a contact unit joins the two.
MeshChange tear(Mesh& mesh, const Point& centre);

}  // namespace fissura::structure::fakes
