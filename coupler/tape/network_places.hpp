// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "common/fracture_network/fracture_network.hpp"
#include "coupler/faults/frame_link.hpp"

namespace fissura::coupler {

/// Whose value stands in a row of an array, as far as the messages so far have told: follows the fracture
/// network from INSERT to INSERT.
class NetworkPlaces {
 public:
  /// Any message of either direction; what is no insertion changes nothing.
  void follow(const Frames& message);

  /// "node 40 at (1.25, 0) m", "segment 7 between nodes 3 and 40"; empty where the array is of neither.
  /// Arrays by arm, and those with a row for each segment, are of segments.
  [[nodiscard]] std::string place(const Frames& message, const std::string& array, std::uint64_t row) const;

 private:
  FractureNetwork network_;
};

}  // namespace fissura::coupler
