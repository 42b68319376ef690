// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/verify_command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/errors.hpp"
#include "coupler/cli/verify_run.hpp"

namespace fissura::coupler {

namespace {

const char* word(Soundness soundness) {
  switch (soundness) {
    case Soundness::sound:
      return "ok";
    case Soundness::noted:
      return "note";
    case Soundness::damaged:
      return "DAMAGED";
  }
  return "";
}

bool is_damaged(const Finding& finding) {
  return finding.soundness == Soundness::damaged;
}

}  // namespace

int verify_command(const std::filesystem::path& run_directory) {
  std::vector<Finding> findings = verify_run(run_directory);
  std::stable_partition(findings.begin(), findings.end(),
                        [](const Finding& finding) { return !is_damaged(finding); });
  std::size_t width = 0;
  for (const Finding& finding : findings) width = std::max(width, finding.name.size());
  for (const Finding& finding : findings)
    fmt::print("{:<7}  {:<{}}  {}\n", word(finding.soundness), finding.name, width, finding.text);

  const auto damage = std::count_if(findings.begin(), findings.end(), is_damaged);
  if (damage == 0) {
    fmt::print("everything is as it was written\n");
    return static_cast<int>(ExitCode::done);
  }
  const bool only_checkpoints = std::all_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return !is_damaged(finding) || finding.of_checkpoint;
  });
  const ExitCode code = only_checkpoints ? ExitCode::checkpoint_unusable : ExitCode::storage_failure;
  fmt::print("{}: {} damaged{}\n", name(code), damage, only_checkpoints ? ", no result among them" : "");
  return static_cast<int>(code);
}

}  // namespace fissura::coupler
