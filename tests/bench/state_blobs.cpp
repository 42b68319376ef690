// SPDX-License-Identifier: GPL-3.0-or-later
// Gives the states that a case saves at its coupling times to fresh participants and compares what follows,
// bit for bit; prints what differs, and what blobs cost.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "common/case/read_case.hpp"
#include "common/exchange/participant.hpp"
#include "common/log.hpp"
#include "tests/fakes/in_process/resume_sweep.hpp"

using namespace fissura;

namespace {

std::string milliseconds(const fakes::Cost& cost) {
  return fmt::format("{:.2f} (at most {:.2f}) ms", 1e3 * cost.mean, 1e3 * cost.greatest);
}

void print(const std::string& title, const fakes::SweepReport& report) {
  constexpr std::size_t most = 20;
  fmt::print(
      "{}: {} intervals, {} insertions, {} restored, {} answers and {} blobs compared, {} differences\n",
      title, report.intervals, report.insertions, report.restored, report.answers, report.blobs,
      report.differences.size());
  for (std::size_t k = 0; k < std::min(most, report.differences.size()); ++k)
    fmt::print("  {:.400}\n", report.differences[k]);
  for (const Role role : {Role::structure, Role::network}) {
    const fakes::BlobFigures& figures = report.participant[static_cast<std::size_t>(role)];
    fmt::print("  {}: {} bytes, save {}, restore {}, join {}, join to resume and restore {}\n", name(role),
               figures.bytes, milliseconds(figures.save), milliseconds(figures.restore),
               milliseconds(figures.join), milliseconds(figures.resume));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Restores the states of a case at its coupling times and compares what follows.");
  CaseSource source;
  fakes::SweepOptions options;
  bool short_form = false;
  program.add_option("CASE", source.path, "case folder")->required();
  program.add_option("--variant", source.variants, "variant of the case");
  program.add_option("--set", source.overrides, "KEY.PATH=VALUE");
  program.add_flag("--short", short_form, "its short form");
  program.add_option("--every", options.every, "restore at every so many coupling times");
  program.add_option("--ahead", options.ahead,
                     "intervals a restored pair runs at least, and past the next insertion");
  program.add_option("--at-most", options.at_most, "intervals a restored pair runs at most");
  program.add_option("--intervals", options.intervals, "intervals of the case");
  program.add_option("--threads", options.threads, "of the structure");
  CLI11_PARSE(program, argc, argv);
  if (short_form) source.variants.emplace_back("short");
  try {
    log::start("state_blobs", "error");
    const Case run_case = read_case(source).value;
    const fakes::SweepReport report = fakes::sweep(run_case, options);
    print(run_case.title, report);
    return report.differences.empty() ? 0 : 1;
  } catch (const Error& fault) {
    fmt::print(stderr, "state_blobs: {}\n", fault.what());
    return static_cast<int>(fault.code());
  }
}
