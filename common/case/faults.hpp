// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/errors.hpp"

/// What is wrong with a case file, said so that its author can mend it.
namespace fissura {

/// Where something was written. `line` and `column` count from 1; line 0 stands for the whole file or for a
/// value given on the command line.
struct SourcePosition {
  std::string file;
  int line = 0;
  int column = 0;
};

/// The position of a whole file, or of the command line.
SourcePosition whole(const std::string& file);

struct Fault {
  SourcePosition where;
  std::string key;         ///< path of the key, e.g. "injection.stage[1].rate"; empty for the whole file
  std::string found;       ///< as written, e.g. "\"32 GPaa\"", or "nothing"
  std::string expected;    ///< what would be right, with the allowed range
  std::string suggestion;  ///< of the most similar allowed word; empty if none is similar
};

/// One line: `file:line:column: key: found F, expected E; did you mean "S"?`
std::string describe(const Fault& fault);

using FaultList = std::vector<Fault>;

/// Every fault of a case. what() counts them and lists them, one per line, in the order of the files.
class CaseFaults : public InputError {
 public:
  /// @pre `faults` is not empty
  explicit CaseFaults(FaultList faults);
  [[nodiscard]] const FaultList& faults() const { return faults_; }

 private:
  FaultList faults_;
};

/// The word of `allowed` that begins with `word`, or else the one with the least number of edits (Levenshtein
/// 1966) to it, if that number is at most a third of the length of `word` (but one edit always is); otherwise
/// empty.
std::string closest_word(std::string_view word, std::span<const std::string> allowed);

/// "a, b, c" for a sentence.
std::string listed(std::span<const std::string> words);

}  // namespace fissura
