// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// A square of `side` [m] with mesh size h = 0.5 m, corridor 2 m, gradation 0.2, far size 4 m, and no lines.
Case square(double side);

/// Adds an open line named `name`.
void add_line(Case& given, const std::string& name, std::vector<Point> points);

/// The line y = 0 from -5 to 5 m.
Case single_line();
/// Two lines that cross at the origin at 60 degrees.
Case crossing();
/// A line that ends at right angles on the middle of another.
Case touching();

/// Up to six polylines at random places on a quarter-metre grid; many such cases have no valid mesh.
Case random_lines(std::uint64_t seed);

double distance(Point a, Point b);

/// Number of nodes - edges + elements: 1 for a plate, less 1 for each hole.
long euler_characteristic(const Mesh& mesh);

/// Total area of the elements [m2].
double area(const Mesh& mesh);

}  // namespace fissura::structure
