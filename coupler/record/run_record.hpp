// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "coupler/record/event_log.hpp"
#include "coupler/record/history.hpp"
#include "coupler/record/interval_record.hpp"
#include "coupler/record/meetings.hpp"
#include "coupler/record/probes.hpp"
#include "coupler/record/remesh_ledger.hpp"
#include "coupler/record/run_description.hpp"
#include "coupler/record/segments.hpp"
#include "coupler/record/table_marks.hpp"

/// Everything a run leaves behind (docs/results.md): the one thing the scheme talks to.
/// Call order: constructor; begin or resume; then any number of topology, interval, fields, event, save;
/// close; finish. close may be left out. After an exception the files written so far are readable; the object
/// may then only be asked for history() and directory(), or be destroyed.
namespace fissura::coupler {

class RunRecord {
 public:
  /// Writes into `directory`, which exists and is claimed (RunDirectory), and ignores SIGXFSZ in this
  /// process, so that a limit on the file size is an error and not a death. `reports_per_segment` > 0: see
  /// case.toml, [output].
  RunRecord(const std::filesystem::path& directory, int reports_per_segment);

  /// Writes run.json, effective_case.json and copies of the input files; opens the tables and the event log.
  /// What an earlier life of the same run left in the directory is begun anew, but its log is gone on with,
  /// its segments are superseded, and run.json stays. Throws StorageError.
  void begin(const RunDescription& description);

  /// Flushes the tables, waits until the disk has them, and returns everything that the rest of the record
  /// depends on, for a checkpoint: the marks of the tables, the open segment, what is in closed ones, sources
  /// not yet in a segment, totals. Throws StorageError.
  [[nodiscard]] std::vector<std::byte> save();

  /// Whether a run can go on in `directory` from `bytes` of save(): throws Error(checkpoint_unusable), naming
  /// the file, if a table is shorter than it was or is another up to there. Changes nothing, and reads the
  /// tables but no segment.
  static void check(const std::filesystem::path& directory, const std::vector<std::byte>& bytes);

  /// The marks in `bytes` of save(). Throws Error(checkpoint_unusable).
  static TableMarks marks(const std::vector<std::byte>& bytes);

  /// In place of begin(): takes the record back to where save() found it, and goes on from there. Tables are
  /// cut off, the index forgets later segments, which are superseded, the series are read from the tables
  /// again; the log is gone on with. Whenever this is interrupted it can be done again. `description` as for
  /// begin(). Throws as check(), before anything is changed, and StorageError.
  void resume(const RunDescription& description, const std::vector<std::byte>& bytes);

  /// Another flow solver has taken up the run: adds an entry to `network_changes` of run.json. Throws
  /// StorageError.
  void network_changed(const nlohmann::json& entry);

  /// Notes a new topology revision in the event log. The network itself is written with the next field
  /// report.
  void topology(const FractureNetwork& network);

  /// Notes what an insertion did to the mesh (buffered). Throws StorageError.
  void remeshing(const FractureNetwork& network, const std::vector<Remeshing>& entries);

  /// Notes which natural fractures an insertion met (buffered). Throws StorageError.
  void meetings(const FractureNetwork& network, const std::vector<Meeting>& meetings);

  /// Appends one line to history.csv and ledger.csv, and to probes.csv if there are probes (buffered).
  /// `probes` has one entry for each probe of the run, or none from a structure that tells nothing of them.
  /// Throws StorageError, and ProtocolError if there are more or fewer.
  void interval(const IntervalRecord& record, const std::vector<ProbeValues>& probes);

  /// Keeps the records of an interval that ends at simulated `time` [s] for the next field report or close(),
  /// which write them to the segment.
  void sources(double time, const std::vector<SourceRecord>& records);

  /// One field report at simulated `time` [s]: see Segments::add for the arrays of both FIELDS messages.
  /// Flushes the tables; closes the segment when it is full, and then the XDMF files name it
  /// too. `node_fields` hold one value per network node, in the order of network.nodes(). Throws
  /// StorageError, and ProtocolError if an array does not fit the mesh or the network.
  void fields(double time, const Message& structure_fields, const Message& network_fields,
              const FractureNetwork& network, const std::vector<NodeField>& node_fields);

  /// Appends one event to log.jsonl, at the coupling time of the last interval(). `participant` is "coupler",
  /// "structure" or "network"; `event` a fixed word that scripts may look for. Throws StorageError.
  void event(EventLevel level, const std::string& participant, const std::string& event,
             const std::string& text);

  /// The series of all intervals so far, for the verdict.
  [[nodiscard]] const History& history() const { return history_; }
  [[nodiscard]] const MeetingTotals& meeting_totals() const { return meeting_ledger_.totals(); }
  /// When the run began, UTC, as run.json says. @pre begin
  [[nodiscard]] const std::string& started() const { return started_; }
  [[nodiscard]] RemeshTotals remesh_totals() const { return remesh_ledger_.totals(); }
  [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

  /// Closes the segment that is open, if any, and flushes the tables. Throws StorageError.
  void close();

  /// Closes, writes summary.json and thereby marks the run as finished, compares the tables with what was
  /// written, and last writes SHA256SUMS over all result files. Throws StorageError.
  void finish(const nlohmann::ordered_json& summary);

 private:
  void write_sources();
  void save_parts(TableMarks& marks, ByteWriter& archive);

  std::filesystem::path directory_;
  History history_;
  RemeshLedger remesh_ledger_;
  MeetingLedger meeting_ledger_;
  Segments segments_;
  std::vector<SourceRecord> sources_;  ///< not yet in a segment
  double sources_time_ = 0;            ///< to which they are complete [s]
  std::optional<EventLog> events_;
  std::string run_json_, started_;
  std::uint64_t interval_ = 0;  ///< of the last interval()
  double time_ = 0;             ///< of the last interval() [s]
};

}  // namespace fissura::coupler
