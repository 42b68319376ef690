// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"

namespace fissura::coupler {

/// The arrays of a FIELDS message by what their rows belong to.
struct SortedFields {
  std::vector<const Array*> nodes;  ///< one row per node; valid as long as the message
  std::vector<const Array*> cells;  ///< one row per cell: element or segment
};

/// Sorts the arrays of `message`, all but those named in `geometry_names`, by their first dimension: `nodes`
/// or else `cells`. Throws ProtocolError, naming `participant` and the array, if it fits neither, if its
/// bytes are not those of its shape, or if the name is not made of letters, digits and underscores or comes
/// twice.
SortedFields sort_fields(const Message& message, std::string_view participant, std::uint64_t nodes,
                         std::uint64_t cells, const std::vector<std::string_view>& geometry_names);

/// Takes the arrays whose names start with `joint_` out of `message` and leaves that away from their names:
/// one row per contact unit. Empty without any. Throws ProtocolError, naming `participant` and the array, if
/// there is no `joint_position` of two columns, if they differ in their rows, or for what sort_fields
/// refuses.
std::vector<Array> take_joint_arrays(Message& message, std::string_view participant);

/// The array `name` of the message as a table. Throws ProtocolError if it is missing or not a `dtype` array
/// of `columns` columns (and any number of rows).
const Array& require_table(const Message& message, std::string_view participant, std::string_view name,
                           std::string_view dtype, std::uint64_t columns);

/// The network as arrays: `position` [nodes x 2] (m), `lumped_length` (m), `exposure_time` (s), `id`,
/// `fracture` and `role` of the nodes; `segments` [segments x 2] (positions of their nodes in nodes()),
/// `segment_id`, `segment_fracture` and `segment_kind`.
Message topology_arrays(const FractureNetwork& network);

/// A float64 array of two columns with a third one of zeros: a vector of the plane for readers that know only
/// vectors in space. @pre array.shape == {rows, 2}
Array with_zero_third_column(const Array& array);

}  // namespace fissura::coupler
