// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/check_command.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "coupler/cli/case_picture.hpp"
#include "coupler/cli/derived_numbers.hpp"
#include "coupler/cli/natural_fracture_files.hpp"
#include "coupler/cli/run_command.hpp"
#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

int check_command(const CaseSource& source, const std::optional<std::filesystem::path>& picture) {
  RunOptions options;
  options.source = source;
  const PreparedRun run = prepare_run(options);
  fmt::print("{}\n", run.reading.value.title);
  for (const Fault& warning : run.reading.warnings) fmt::print("warning: {}\n", describe(warning));
  const NaturalFractureReport& natural = run.reading.natural_fractures;
  if (natural.given + natural.drawn > 0)
    for (const std::string& line : lines_of(natural)) fmt::print("{}\n", line);
  for (const DerivedNumber& number : derived_numbers(run.reading.value))
    fmt::print("{:<36} {:>12.5g} {:<9} {}\n", number.name, number.value, number.unit, number.remark);
  if (picture) write_whole_file(*picture, case_picture(run.reading));
  fmt::print("no fault; {} expected quantities\n", run.expectations.quantities.size());
  return static_cast<int>(ExitCode::done);
}

}  // namespace fissura::coupler
