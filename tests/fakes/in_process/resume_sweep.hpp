// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/case/case.hpp"

namespace fissura::fakes {

struct SweepOptions {
  std::uint64_t every = 1;  ///< restore at every so many coupling times
  std::uint64_t ahead = 5;  ///< intervals that a restored pair runs at least, and beyond the next insertion
  std::uint64_t at_most = 60;         ///< intervals that it runs at most
  std::uint64_t intervals = 1000000;  ///< of the case
  int threads = 1;                    ///< of the structure
};

/// Mean and greatest wall time [s].
struct Cost {
  double mean = 0, greatest = 0;
  std::uint64_t count = 0;

  void add(double seconds);
};

/// Of one participant.
struct BlobFigures {
  std::size_t bytes = 0;             ///< of the largest blob
  Cost save, restore, join, resume;  ///< resume: to join with Assignment::resumes and restore
};

struct SweepReport {
  std::uint64_t intervals = 0, insertions = 0, restored = 0, answers = 0, blobs = 0;
  std::vector<std::string> differences;    ///< each: which pair, restored when, found when, what
  std::array<BlobFigures, 2> participant;  ///< by Role
};

/// Runs a case with a pair that is saved at every coupling time, beside one that never is, one that is
/// restored at every coupling time over what it has become, and fresh ones that are restored and go on until
/// the next insertion and beyond it. Every answer of all, their description of the state, and every later
/// blob must be the same to the last bit.
SweepReport sweep(const Case& run_case, const SweepOptions& options);

}  // namespace fissura::fakes
