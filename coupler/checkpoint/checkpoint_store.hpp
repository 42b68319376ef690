// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
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
  std::vector<UnusableCheckpoint> unusable;  ///< newer ones that cannot be used
};

/// The checkpoints of one run: RUN/checkpoints/000042/{NAME.state, MANIFEST.json}, named by interval.
class CheckpointStore {
 public:
  /// Creates nothing. @param keep  newest ones kept, at least 2
  CheckpointStore(const std::filesystem::path& run_directory, int keep);

  /// In two phases. First every state is written into a folder with the ending `.part` and synced; then the
  /// manifest, synced; then the folder gets its name and that is synced. Only then older checkpoints beyond
  /// `keep` go. Whatever is there before stays usable until the new one is. Throws StorageError, having
  /// removed what it began.
  void write(Checkpoint checkpoint);

  /// The first phase of write(): all of it under the ending `.part`, where nobody looks. Throws as write().
  void prepare(Checkpoint checkpoint);
  /// The second phase: from here on it exists. @pre prepare(). Throws as write().
  void commit();

  /// Why a whole checkpoint cannot be used after all, as a sentence; nothing if it can.
  using Refusal = std::function<std::optional<std::string>(const Checkpoint&)>;

  /// The newest checkpoint of which every byte is as written and that `refusal` lets pass, and what is wrong
  /// with newer ones. Opens no file of another size, and uses none of another hash, than its manifest says.
  /// Never throws for damage, but StorageError if it cannot be known which ones there are.
  [[nodiscard]] FoundCheckpoint newest_usable(const Refusal& refusal) const;
  /// The same without refusal.
  [[nodiscard]] FoundCheckpoint newest_whole() const;

  /// The checkpoint in the complete folder `name`, checked. Throws Error(checkpoint_unusable).
  [[nodiscard]] Checkpoint read(const std::string& name) const;

  /// The run goes on from `interval`, or from its beginning: newer checkpoints belong to a past that did not
  /// happen. They are renamed to NAME.unusable, and go with the next write(). Throws StorageError.
  void set_aside_newer_than(std::optional<std::uint64_t> interval);

  /// Names of all complete folders, oldest first. Throws StorageError if that cannot be known.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  void remove_all_but(const std::vector<std::string>& kept) const;

  std::filesystem::path folder_;
  std::size_t keep_;
  std::string prepared_;  ///< name that commit() will give; empty without any
};

}  // namespace fissura::coupler
