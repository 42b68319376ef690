// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/check_command.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "coupler/cli/derived_numbers.hpp"
#include "coupler/cli/run_command.hpp"

namespace fissura::coupler {

int check_command(const CaseSource& source) {
  RunOptions options;
  options.source = source;
  const PreparedRun run = prepare_run(options);
  fmt::print("{}\n", run.reading.value.title);
  for (const Fault& warning : run.reading.warnings) fmt::print("warning: {}\n", describe(warning));
  for (const DerivedNumber& number : derived_numbers(run.reading.value))
    fmt::print("{:<36} {:>12.5g} {:<9} {}\n", number.name, number.value, number.unit, number.remark);
  fmt::print("no fault; {} expected quantities\n", run.expectations.quantities.size());
  return static_cast<int>(ExitCode::done);
}

}  // namespace fissura::coupler
