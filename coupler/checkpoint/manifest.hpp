// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace fissura::coupler {

/// What wrote a checkpoint: a run goes on bit for bit only with the same.
struct Provenance {
  std::string run_id;                               ///< hexadecimal
  std::string case_hash;                            ///< of run.json
  std::string program;                              ///< version and commit of the coupler
  std::map<std::string, std::string> participants;  ///< role -> solver name and version
  int threads = 1;  ///< of the structure; for the reader only: the bits do not depend on it

  bool operator==(const Provenance&) const = default;
};

/// Why a run of `run` cannot go on from what `wrote` has written, in words to follow "it is"; nothing if it
/// can. Threads may differ, and so may the network: see network_change. Participants that `run` does not name
/// are not compared: before the handshake nobody knows them.
std::optional<std::string> mismatch(const Provenance& wrote, const Provenance& run);

/// One file of a checkpoint.
struct StateFile {
  std::uint64_t bytes = 0;
  std::string sha256;

  bool operator==(const StateFile&) const = default;
};

/// MANIFEST.json: a checkpoint exists once its manifest does.
struct Manifest {
  Provenance provenance;
  std::uint32_t epoch = 0;     ///< in which it was written
  std::uint64_t interval = 0;  ///< last complete coupling interval
  double time = 0;             ///< simulated [s]
  std::uint64_t revision = 0;  ///< of the topology
  std::string topology_hash;
  std::map<std::string, StateFile> files;  ///< name of the state -> file NAME.state

  bool operator==(const Manifest&) const = default;
};

/// Another flow solver goes on with a run.
struct NetworkChange {
  std::uint64_t interval = 0;  ///< last complete one of the solver before
  double time = 0;             ///< its end [s]
  std::string from, to;        ///< solver name and version
};

/// The change that it is to go on from a checkpoint with the flow solver `network` (name and version);
/// nothing if that solver wrote it. @param commanded_since  epoch since which the command of that solver is
/// in force: checkpoints of earlier ones were written by another program, whatever it called itself
std::optional<NetworkChange> network_change(const Manifest& wrote, const std::string& network,
                                            std::uint32_t commanded_since);

/// The text of MANIFEST.json, closed by the SHA-256 of what stands before it: a changed bit anywhere is
/// found.
std::string manifest_text(const Manifest& manifest);

/// The inverse. Throws Error(checkpoint_unusable) saying
/// what is wrong: a hash that does not fit, another schema, a missing key, a name of a state that is no plain
/// word.
Manifest manifest_from_text(const std::string& text);

}  // namespace fissura::coupler
