// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupler/checkpoint/manifest.hpp"

namespace fissura::coupler {

/// One consistent cut of a run at a coupling time, nothing in flight.
struct Checkpoint {
  Manifest manifest;  ///< `files` is filled in by write()
  /// By name: "structure", "network" (opaque blobs of the participants), "scheme", "record", "seismicity".
  std::map<std::string, std::vector<std::byte>> states;
};

/// A checkpoint that could not be used, and why.
struct UnusableCheckpoint {
  std::string name;    ///< of its folder
  std::string reason;  ///< one sentence that names the file
};

/// What a run can go on from.
struct FoundCheckpoint {
  std::optional<Checkpoint> checkpoint;      ///< the newest whole one
  std::vector<UnusableCheckpoint> unusable;  ///< newer ones that are not whole
};

/// The checkpoints of one run: RUN/checkpoints/000042/{NAME.state, MANIFEST.json}, named by interval.
class CheckpointStore {
 public:
  /// @param keep  newest ones kept, at least 2
  CheckpointStore(const std::filesystem::path& run_directory, int keep);

  /// In two phases. First every state is written into a folder with the ending `.part` and synced; then the
  /// manifest, synced; then the folder gets its name and that is synced. Only then older checkpoints beyond
  /// `keep` go. Whatever is there before stays usable until the new one is. Throws StorageError, having
  /// removed what it began.
  void write(Checkpoint checkpoint);

  /// The newest checkpoint of this case and program of which every byte is as written, and what is wrong with
  /// newer ones. Opens no file whose hash does not fit. Never throws for damage.
  [[nodiscard]] FoundCheckpoint newest_whole() const;

  /// Names of all complete folders, oldest first.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path folder_;
  int keep_;
};

}  // namespace fissura::coupler
