// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/status_command.hpp"

#include <cstdio>

#include "coupler/cli/run_state.hpp"

namespace fissura::coupler {

int status_command(const std::filesystem::path& run_directory, StatusForm form) {
  const RunState state = read_run_state(run_directory);
  const std::string text =
      form == StatusForm::json ? run_state_json(state).dump(2) + "\n" : run_state_text(state);
  std::fputs(text.c_str(), stdout);
  return 0;
}

}  // namespace fissura::coupler
