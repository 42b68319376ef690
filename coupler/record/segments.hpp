// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "common/seismicity/source_record.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/report_catalogue.hpp"
#include "coupler/record/segment_journal.hpp"
#include "coupler/record/table_marks.hpp"

/// Field reports on disk. A segment is gathered in memory and written in one go when it is full: as
/// segments/NNNNNN.h5.part, synced, read again and compared, renamed to segments/NNNNNN.h5 and entered in
/// segments/index.jsonl. A report exists once that has been done. A reader needs only the index; a `.part` is
/// what a run that died left behind. The bytes of a segment depend on the reports alone.
namespace fissura::coupler {

/// A scalar of every network node, as the coupler knows it.
struct NodeField {
  std::string name;            ///< e.g. "aperture"
  std::string unit;            ///< SI
  std::vector<double> values;  ///< in the order of FractureNetwork::nodes()
};

class Segments {
 public:
  /// Segments of `reports_per_segment` > 0 reports, or of as many as fill `largest_segment`, in
  /// `run_directory`/segments, which is created with the first of them.
  Segments(const std::filesystem::path& run_directory, int reports_per_segment);

  /// Adds a report at simulated `time` [s]; true if it closed a segment.
  /// `structure_fields`: body entry `geometry` (uint64); arrays `position` [n x 2] (m) and `elements` [m x 3]
  /// (uint64) at least with the first report of a geometry number; any further arrays with first dimension n
  /// (node values) or m (element values; n values if n = m). `network_fields`: arrays with one row per
  /// network node or segment. The structure's arrays `joint_*` have one row per contact unit
  /// (take_joint_arrays). Float64 arrays of two columns are stored with a third one of zeros: vectors, for
  /// ParaView. Throws ProtocolError if an array does not fit, StorageError if the segment cannot be written.
  bool add(double time, const Message& structure_fields, const Message& network_fields,
           const FractureNetwork& network, const std::vector<NodeField>& node_fields);

  /// Adds records of seismic sources, complete up to the simulated `time` [s], in the order given: group
  /// /sources/NNNNNN with the arrays of arrays_of(). Nothing without records. Throws StorageError.
  void add_sources(double time, const std::vector<SourceRecord>& records);

  /// Closes the open segment; false if there is none. Throws StorageError.
  bool close();

  /// Everything that later segments depend on, and the mark of the index. The disk has every line of it.
  void save(TableMarks& marks, ByteWriter& archive) const;
  /// Goes on from there: the index is cut off at its mark, later segments are superseded, see
  /// supersede_segments_after. @pre check_marks; nothing was added. Throws StorageError and
  /// Error(checkpoint_unusable).
  void resume(const TableMarks& marks, ByteReader& archive);

  /// Bytes of arrays from which on a segment is closed.
  static constexpr std::uint64_t largest_segment = 64 << 20;

  /// All reports in closed segments.
  [[nodiscard]] const ReportCatalogue& closed() const { return closed_; }

 private:
  /// The file of the open segment and its line of the index.
  void write_segment();
  void append_to_index(const std::string& file_hash, std::uintmax_t file_size);
  void write_mesh(std::uint64_t geometry, const Message& fields);
  void write_network(const FractureNetwork& network);
  StoredArray write(const std::string& dataset, const std::string& shown_name, const Array& array);
  [[nodiscard]] const StoredMesh* find_mesh(std::uint64_t geometry) const;
  /// Nodes and elements of the mesh, from the catalogue or else from the message.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> mesh_extent(std::uint64_t geometry,
                                                                    const Message& fields) const;
  [[nodiscard]] std::filesystem::path folder() const { return run_directory_ / "segments"; }

  std::filesystem::path run_directory_;
  std::uint64_t reports_per_segment_;
  std::uint64_t segment_ = 1;  ///< number of the open segment
  std::uint64_t reports_ = 0;  ///< in all segments
  std::uint64_t sources_ = 0;  ///< groups of source records in all segments
  SegmentJournal journal_;     ///< the open segment
  std::optional<CheckedFile> index_;
  ReportCatalogue closed_;  ///< everything up to the last closed segment
  ReportCatalogue open_;    ///< what the open segment adds
};

}  // namespace fissura::coupler
