// SPDX-License-Identifier: GPL-3.0-or-later
// The record's state in a checkpoint, beside the tables and segments of a short run: taken up and gone on with, or refused before
// anything is changed.
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

void resume(const std::vector<std::byte>& bytes) {
  RunRecord::check(short_run(), bytes);
  const fs::path copy = short_run().parent_path() / "copy";
  fs::remove_all(copy);
  fs::copy(short_run(), copy, fs::copy_options::recursive);
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
