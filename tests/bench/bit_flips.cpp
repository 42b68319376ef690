// SPDX-License-Identifier: GPL-3.0-or-later
// bit_flips RUN [COUNT [SEED]]: how many of COUNT (10 000) single flipped bits in the files of a run go
// unseen.
//
// A copy of the run directory gets one flipped bit at a time, in any of its results and checkpoints (every
// file has the same chance, then every bit of it), is verified as `coupler verify` does it, and gets the bit
// back. Of a flipped checkpoint what resuming would take is read too: it must be another, whole one, or the
// same bytes. Counted by kind of file: flips that were named with their file, and flips that were not;
// apart from those, flips of what docs/faults.md says is not sealed. The exit code is 1 if any other flip was
// not named, or a damaged checkpoint would have been taken.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <set>

#include "coupler/checkpoint/checkpoint_store.hpp"
#include "coupler/cli/verify_run.hpp"
#include "coupler/record/run_record.hpp"
#include "coupler/scheme/seismic_monitor.hpp"

using namespace fissura::coupler;

namespace fs = std::filesystem;

namespace {

/// A copy that goes with the program.
class Copy {
 public:
  explicit Copy(const fs::path& run) {
    std::string pattern =
        ((fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) / "fissura-flips-XXXXXX")
            .string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for a copy");
    path_ = pattern;
    for (const auto& entry : fs::recursive_directory_iterator(run)) {
      const fs::path place = path_ / entry.path().lexically_relative(run);
      if (entry.is_directory()) fs::create_directory(place);
      // A socket may lie there of a run that was killed.
      if (entry.is_regular_file()) fs::copy_file(entry.path(), place);
    }
  }
  ~Copy() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// No result and nothing to go on from: who runs, how it went, what no longer counts.
const std::set<std::string> no_result{"lock", "status", "run.report.json", "epochs.jsonl", "report.html"};

std::vector<std::string> files_of(const fs::path& run) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    const std::string name = entry.path().lexically_relative(run).string();
    const std::string ending = entry.path().extension().string();
    if (entry.is_regular_file() && entry.file_size() > 0 && !no_result.contains(name) && ending != ".part" &&
        ending != ".superseded")
      files.push_back(name);
  }
  std::sort(files.begin(), files.end());
  return files;
}

void flip(const fs::path& file, std::uintmax_t bit) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekg(static_cast<std::streamoff>(bit / 8));
  const int byte = stream.get();
  stream.seekp(static_cast<std::streamoff>(bit / 8));
  stream.put(static_cast<char>(byte ^ (1 << (bit % 8))));
}

bool is_checkpoint(const std::string& file) {
  return file.starts_with("checkpoints/");
}

/// Whether the file, or the folder of its checkpoint, is told of as damaged.
bool is_named(const std::vector<Finding>& findings, const std::string& file) {
  const std::string folder = fs::path(file).parent_path().string();
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
    return finding.soundness == Soundness::damaged &&
           (finding.name == file || (is_checkpoint(file) && finding.name.starts_with(folder)));
  });
}

/// How many bytes at the beginning of a file have a checksum: all, but in a run that has not come to its end.
class Seals {
 public:
  Seals(const fs::path& run, const std::optional<Checkpoint>& newest)
      : run_(run), finished_(fs::exists(run / "SHA256SUMS")) {
    if (!newest) return;
    marks_ = RunRecord::marks(newest->states.at("record"));
    if (const auto mark = SeismicMonitor::mark(newest->states.at("seismicity")))
      marks_["seismicity/catalogue.csv"] = *mark;
  }

  [[nodiscard]] std::uintmax_t bytes(const std::string& file) const {
    const std::uintmax_t all = fs::file_size(run_ / file);
    if (finished_) return all;
    if (file == "log.jsonl" || file.ends_with(".xdmf")) return 0;
    const auto mark = marks_.find(file);
    return mark == marks_.end() ? all : std::min<std::uintmax_t>(all, mark->second.bytes);
  }

 private:
  fs::path run_;
  bool finished_;
  TableMarks marks_;
};

struct Count {
  std::size_t named = 0, unseen = 0, elsewhere = 0, unsealed = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::size_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10'000;
  std::mt19937_64 random(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  const Copy run(argv[1]);
  for (const Finding& finding : verify_run(run.path()))
    if (finding.soundness == Soundness::damaged) {
      fmt::print("{} is damaged before the first flip: {}\n", finding.name, finding.text);
      return 2;
    }
  const std::vector<std::string> files = files_of(run.path());
  const CheckpointStore store(run.path(), 2);
  const std::optional<Checkpoint> newest = store.newest_whole().checkpoint;

  const Seals seals(run.path(), newest);

  std::map<std::string, Count> counts;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& file = files[random() % files.size()];
    const std::uintmax_t bit = random() % (8 * fs::file_size(run.path() / file));
    flip(run.path() / file, bit);
    const std::vector<Finding> findings = verify_run(run.path());
    const bool any = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
      return finding.soundness == Soundness::damaged;
    });
    Count& line = counts[is_checkpoint(file) ? "checkpoints/N/" + fs::path(file).filename().string() : file];
    if (is_named(findings, file)) {
      ++line.named;
    } else {
      const bool sealed = bit / 8 < seals.bytes(file);
      ++(any ? line.elsewhere : sealed ? line.unseen : line.unsealed);
      if (!any && sealed) {
        ++wrong;
        fmt::print("unseen: {} byte {} bit {}\n", file, bit / 8, bit % 8);
      }
    }
    if (is_checkpoint(file) && newest) {
      const auto found = store.newest_whole();
      const bool same = found.checkpoint && found.checkpoint->states == newest->states;
      const bool older = found.checkpoint && found.checkpoint->manifest.interval < newest->manifest.interval;
      if (!same && !(older && !found.unusable.empty())) {
        ++wrong;
        fmt::print("taken: {} byte {} bit {}\n", file, bit / 8, bit % 8);
      }
    }
    flip(run.path() / file, bit);
  }

  fmt::print("{:<36} {:>7} {:>12} {:>10} {:>7}\n", "", "named", "other named", "not sealed", "UNSEEN");
  Count all;
  for (const auto& [file, line] : counts) {
    fmt::print("{:<36} {:>7} {:>12} {:>10} {:>7}\n", file, line.named, line.elsewhere, line.unsealed,
               line.unseen);
    all = {all.named + line.named, all.unseen + line.unseen, all.elsewhere + line.elsewhere,
           all.unsealed + line.unsealed};
  }
  fmt::print("{:<36} {:>7} {:>12} {:>10} {:>7}\n", "all", all.named, all.elsewhere, all.unsealed, all.unseen);
  return wrong == 0 ? 0 : 1;
}
