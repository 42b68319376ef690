// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace fissura::coupler {

/// A rectangle of the plane [m].
struct View {
  std::string name;
  double west = 0, east = 0, south = 0, north = 0;
};

/// The views of a fracture within the domain: "near the tip" that is farthest from the middle of the
/// fracture, "whole fracture" and "whole domain". `nodes` holds x and y of its nodes in turn [m];
/// without any there is only the domain.
std::vector<View> views_of(const std::vector<double>& nodes, const View& domain);

}  // namespace fissura::coupler
