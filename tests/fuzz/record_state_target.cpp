// SPDX-License-Identifier: GPL-3.0-or-later
// The record's state in a checkpoint, beside the tables and segments of a short run: taken up and gone on with, or refused before
// anything is changed.
#include <system_error>

#include "tests/coupler/record/scripted_run.hpp"
#include "tests/fuzz/folder.hpp"
#include "tests/fuzz/judged.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t last = 8;

const fs::path& short_run() {
  static const fuzz::Folder folder;
  static const fs::path run = [] {
    fs::create_directories(folder.path() / "sound");
    sample::record_run(folder.path() / "sound", last);
    return folder.path() / "sound";
  }();
  return run;
}

/// The fuzzer's alarm clock may interrupt it.
void copy_afresh(const fs::path& from, const fs::path& to) {
  std::error_code failure;
  do {
    fs::remove_all(to);
    fs::copy(from, to, fs::copy_options::recursive, failure);
  } while (failure == std::errc::interrupted);
  MUST_HOLD(!failure);
}

void resume(const std::vector<std::byte>& bytes) {
  RunRecord::check(short_run(), bytes);
  const fs::path copy = short_run().parent_path() / "copy";
  copy_afresh(short_run(), copy);
  RunRecord record(copy, sample::reports_per_segment);
  record.resume(sample::description(), bytes);
  sample::record_interval(record, last + 1);
  record.close();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::take_or_refuse([&] { resume(fuzz::copied(data, size)); });
  return 0;
}
