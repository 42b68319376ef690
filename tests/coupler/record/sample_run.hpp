// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "coupler/record/interval_record.hpp"
#include "coupler/record/segments.hpp"
#include "tests/coupler/temporary_directory.hpp"

/// A run small enough to be written down: a square of two triangles with a fracture of three nodes.
namespace fissura::coupler::sample {

std::vector<double> doubles(const Array& array);

/// Revision 0: nodes 10, 11, 12 in a row; segments 20, 21.
FractureNetwork network();
/// Revision 1: node 13 and segment 22 grown at the end.
FractureNetwork grown_network();

/// FIELDS of the structure: displacement (i, 10 i) of node i plus `time`, stress of the elements; the mesh if
/// `geometry` is told for the first time. The square has 4 nodes and 2 elements; `extra_nodes` more nodes
/// make it another geometry.
Message structure_fields(double time, std::uint64_t geometry, std::uint64_t extra_nodes);
Message without_mesh(Message fields);

/// Adds position, normal, slip `time` and kind of two contact units to FIELDS of the structure.
Message with_joints(Message fields, double time);

/// FIELDS of the network: `content` of every node.
Message network_fields(const FractureNetwork& network);

/// Aperture and pressure of every node.
std::vector<NodeField> node_fields(const FractureNetwork& network, double time);

/// An interval that ends at `time`; every scalar differs.
IntervalRecord interval(std::uint64_t number, double time);

}  // namespace fissura::coupler::sample
