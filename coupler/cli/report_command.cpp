// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/report_command.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "common/errors.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/report/report_data.hpp"
#include "coupler/report/report_page.hpp"

namespace fissura::coupler {

int report_command(const std::filesystem::path& run_directory,
                   const std::optional<std::filesystem::path>& page) {
  const std::filesystem::path file = page.value_or(run_directory / "report.html");
  write_whole_file(file, report_page(report_data(run_directory)));
  fmt::print("{}\n", file.string());
  return static_cast<int>(ExitCode::done);
}

}  // namespace fissura::coupler
