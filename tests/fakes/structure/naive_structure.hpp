// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/dynamics/central_difference.hpp"
#include "structure/material/rock_failure.hpp"
#include "structure/mesh/mesh.hpp"

/// The explicit step as one would first write it: arrays of structures, one element at a time, forces added
/// straight to the nodes. Reference for the tiled element loop, and what the benchmark compares it with.
namespace fissura::structure::fakes {

class NaiveStructure {
 public:
  /// `law` absent: elastic. Joint nodes are moved like any other. Prescribed displacements are not supported.
  NaiveStructure(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                 std::optional<RockFailure> law);

  void set_displacement(const std::vector<double>& displacement);
  void set_velocity(const std::vector<double>& velocity);

  void set_damage(const std::vector<ElementDamage>& records);

  /// One step of central differences.
  void advance(const Step& step);

  [[nodiscard]] std::vector<double> displacement() const;
  [[nodiscard]] std::vector<double> velocity() const;
  [[nodiscard]] std::size_t cracked_elements() const;

 private:
  struct Node {
    Point position{};
    std::array<double, 2> displacement{}, velocity{}, force{}, external_force{}, inverse_mass{};
  };
  struct Element {
    std::array<NodeIndex, 3> node{};
    InPlane<double> in_situ{};
    double out_of_plane = 0, pore_pressure = 0;
    bool cracked = false;
    DamageHistory history;
    PlasticHistory plastic;
  };

  void add_force(Element& element);

  std::vector<Node> nodes_;
  std::vector<Element> elements_;
  Elasticity moduli_;
  std::optional<RockFailure> law_;
  double lowest_strength_ = 0;
};

}  // namespace fissura::structure::fakes
