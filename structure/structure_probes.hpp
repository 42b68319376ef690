// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "structure/structure_state.hpp"

namespace fissura::structure {

/// What a probe sees.
struct ProbeValues {
  InPlane<double> stress{};              ///< effective, in situ and change together, tension positive [Pa]
  std::array<double, 2> displacement{};  ///< [m]
  std::optional<UnitIndex> joint;        ///< the nearest within one element size, if any
};

/// The probes of a case. The stress at a probe is the value there of the quadratic polynomial that fits those of the
/// elements within two sizes of its own element best by area (a plane where they are too few): the stress of a
/// single constant-strain triangle is that of its centroid. No element counts that lies beyond a fracture.
class Probes {
 public:
  explicit Probes(const std::vector<Probe>& probes) : probes_(probes) {}

  [[nodiscard]] bool any() const { return !probes_.empty(); }

  /// In the order of the case.
  std::vector<ProbeValues> observe(const StructureModel& model, const Geometry& geometry,
                                   const StructureState& state);

 private:
  struct Place {
    ElementIndex element = 0;
    std::array<double, 3> shape{};     ///< of its corners
    std::vector<ElementIndex> around;  ///< ascending, with the element
    std::optional<UnitIndex> joint;
  };

  static Place locate(const Geometry& geometry, const Point& at);

  std::vector<Probe> probes_;
  std::vector<Place> places_;
  std::optional<std::uint64_t> geometry_;  ///< number of that which places_ belong to
};

/// `probes` of a RESPONSE (docs/protocol.md).
nlohmann::json probes_json(const std::vector<ProbeValues>& probes, const Joints& joints);

}  // namespace fissura::structure
