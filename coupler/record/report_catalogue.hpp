// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "common/byte_archive.hpp"

/// Where the field reports of a run are found; what a reader such as ParaView needs to know.
namespace fissura::coupler {

/// One array in a segment.
struct StoredArray {
  std::string name;                  ///< as shown to a reader
  std::string dtype, unit;           ///< as in Array
  std::vector<std::uint64_t> shape;  ///< row-major
  std::string
      location;  ///< "segments/000001.h5:/reports/000001/structure/displacement", from the run directory
};

/// The mesh of one geometry number.
struct StoredMesh {
  StoredArray position;  ///< [nodes x 2], m
  StoredArray elements;  ///< [elements x 3], node indices
};

/// The fracture network of one topology revision.
struct StoredNetwork {
  StoredArray position;  ///< [nodes x 2], m
  StoredArray segments;  ///< [segments x 2], node indices
};

/// One field report.
struct StoredReport {
  std::uint64_t number = 0;                            ///< from 1, through all segments
  double time = 0;                                     ///< [s]
  std::uint64_t geometry = 0;                          ///< number of its mesh
  std::uint64_t revision = 0;                          ///< topology revision of its network
  std::vector<StoredArray> mesh_nodes, mesh_elements;  ///< first dimension: nodes, elements of the mesh
  std::vector<StoredArray> network_nodes,
      network_segments;  ///< first dimension: nodes, segments of the network
  std::vector<StoredArray>
      joints;  ///< first dimension: contact units; empty without any, else with `position` [n x 2] (m)
};

/// Records of seismic sources, several intervals together.
struct StoredSources {
  std::uint64_t number = 0;         ///< from 1, through all segments
  double time = 0;                  ///< to which the records are complete [s]
  std::vector<StoredArray> arrays;  ///< first dimension: records
};

struct ReportCatalogue {
  std::map<std::uint64_t, StoredMesh> meshes;       ///< by geometry number
  std::map<std::uint64_t, StoredNetwork> networks;  ///< by topology revision
  std::vector<StoredReport> reports;                ///< in time order
  std::vector<StoredSources> sources;               ///< in time order
};

/// For a checkpoint.
void put(ByteWriter& archive, const ReportCatalogue& catalogue);
/// Throws Error(checkpoint_unusable) if a shape is not as above, or there are more network nodes or contact
/// units than can be drawn.
ReportCatalogue get_catalogue(ByteReader& archive);

/// Throws Error(checkpoint_unusable) unless mesh and network of every report in `reports` are in one of
/// `catalogues`.
void require_meshes_and_networks(const std::vector<StoredReport>& reports,
                                 std::initializer_list<const ReportCatalogue*> catalogues);

}  // namespace fissura::coupler
