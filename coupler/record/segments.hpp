// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "coupler/record/hdf5_file.hpp"

/// Field reports on disk. A report exists once its segment is closed: written as segments/NNNNNN.h5.part,
/// checked, synced, renamed to segments/NNNNNN.h5 and entered in segments/index.jsonl. A reader needs only
/// the index; a `.part` is what a run that died left behind.
namespace fissura::coupler {

/// A scalar of every network node, as the coupler knows it.
struct NodeField {
  std::string name;            ///< e.g. "aperture"
  std::string unit;            ///< SI
  std::vector<double> values;  ///< in the order of FractureNetwork::nodes()
};

/// Where one array is found.
struct StoredArray {
  std::string name, unit, dtype;
  std::vector<std::uint64_t> shape;
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

/// One field report and where its arrays are.
struct StoredReport {
  double time = 0;  ///< [s]
  std::uint64_t geometry = 0, revision = 0;
  std::vector<StoredArray> mesh_node_arrays, element_arrays, network_node_arrays, network_segment_arrays;
};

/// What a closed segment adds for readers.
struct ClosedReports {
  std::map<std::uint64_t, StoredMesh> meshes;       ///< by geometry number
  std::map<std::uint64_t, StoredNetwork> networks;  ///< by topology revision
  std::vector<StoredReport> reports;                ///< in time order
};

class Segments {
 public:
  /// Segments of `reports_per_segment` > 0 reports in `run_directory`/segments, which is created by the first
  /// add().
  Segments(const std::filesystem::path& run_directory, int reports_per_segment);

  /// Adds a report at simulated `time` [s]; true if it closed a segment.
  /// `structure_fields`: body entry `geometry` (uint64); arrays `position` [n x 2] (m) and `elements` [m x 3]
  /// (uint64) at least with the first report of a geometry number; any further arrays with first dimension n
  /// (node values) or m (element values; n values if n = m). `network_fields`: arrays with one entry per
  /// network node. Arrays of two columns on the mesh nodes are stored with a third one of zeros: vectors, for
  /// ParaView. Throws ProtocolError if an array does not fit, StorageError if the segment cannot be written.
  bool add(double time, const Message& structure_fields, const Message& network_fields,
           const FractureNetwork& network, const std::vector<NodeField>& node_fields);

  /// Closes the open segment; false if there is none. Throws StorageError.
  bool close();

  /// All reports in closed segments.
  [[nodiscard]] const ClosedReports& closed() const { return closed_; }

 private:
  void open();
  void write_mesh(std::uint64_t geometry, const Message& fields);
  void write_network(const FractureNetwork& network);
  StoredArray write(const std::string& dataset, const Array& array);

  std::filesystem::path run_directory_;
  int reports_per_segment_;
  std::uint64_t number_ = 0;   ///< of the open segment, from 1
  std::uint64_t reports_ = 0;  ///< written so far in all segments
  std::optional<Hdf5File> file_;
  ClosedReports closed_;
  ClosedReports pending_;  ///< in the open segment
};

}  // namespace fissura::coupler
