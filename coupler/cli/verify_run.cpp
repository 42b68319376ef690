// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/verify_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "coupler/checkpoint/checkpoint_store.hpp"
#include "coupler/checkpoint/neutral_network.hpp"
#include "coupler/cli/apart.hpp"
#include "coupler/cli/prepared_run.hpp"
#include "coupler/cli/verify_tables.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/checksums.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/run_description.hpp"
#include "coupler/record/run_record.hpp"
#include "coupler/record/sealed_line.hpp"
#include "coupler/scheme/seismic_monitor.hpp"
#include "coupler/tape/tape.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

constexpr int fewest_checkpoints = 2;

std::string hash_or_nothing(const fs::path& file) {
  try {
    return fs::is_regular_file(file) ? sha256_of_file(file) : std::string();
  } catch (const std::exception&) {
    return {};
  }
}

/// The arrays of a damaged HDF5 file that can no longer be read.
std::string lost_arrays(const fs::path& path) {
  if (!fs::exists(path)) return "it is missing";
  std::vector<std::string> lost;
  try {
    const Hdf5File file = Hdf5File::open(path);
    const std::vector<std::string> names = file.datasets();
    for (const std::string& name : names) {
      try {
        (void)file.read(name);
      } catch (const StorageError&) {
        lost.push_back(name);
      }
    }
    if (names.empty()) return "none of its arrays can be reached";
  } catch (const StorageError&) {
    return "it cannot be opened";
  }
  if (lost.empty()) return "every array that can be reached can be read";
  return fmt::format("cannot be read any more: {}", fmt::join(lost, ", "));
}

class Verification {
 public:
  explicit Verification(fs::path run_directory) : directory_(std::move(run_directory)) {}

  std::vector<Finding> run() {
    verify_description();
    verify_resume_file();
    verify_index();
    verify_segments();
    verify_checksums();
    verify_checkpoints();
    verify_tapes();
    verify_readable("ledger.csv", [&](const fs::path& file) { return check_ledger(file); });
    verify_readable("history.csv", [&](const fs::path& file) { return check_history(file); });
    verify_readable("log.jsonl", check_log);
    verify_readable("seismicity/catalogue.csv", check_catalogue);
    verify_readable("seismicity/catalogue.h5", [](const fs::path& file) {
      const auto found = look_apart([&] { return check_arrays(file); });
      if (!found) throw StorageError("its arrays cannot be read");
      return *found;
    });
    return findings_;
  }

 private:
  void sound(const std::string& name, const std::string& text) {
    findings_.push_back({name, Soundness::sound, text, false});
  }
  void damaged(const std::string& name, const std::string& text) {
    if (damaged_.insert(name).second) findings_.push_back({name, Soundness::damaged, text, false});
  }

  /// The case is that of the run, and so are the copies of its files.
  void verify_description() {
    try {
      const nlohmann::json run = opened_run_text(read_whole_file(directory_ / "run.json"));
      const auto run_case = nlohmann::json::parse(read_whole_file(directory_ / "effective_case.json"));
      if (case_hash(run_case) != run.at("case_hash"))
        damaged("effective_case.json", "it is not the case of run.json");
      for (const auto& [name, hash] : run.at("inputs").items())
        if (hash_of("input/" + name) != hash) damaged("input/" + name, "its SHA-256 is not that of run.json");
      // It is there before the first line of the history.
      if (fs::exists(directory_ / "history.csv") && hash_of("columns.json") != run.at("columns"))
        damaged("columns.json", "its SHA-256 is not that of run.json");
      sound("run.json", "closed by its hash");
      sound("effective_case.json, columns.json, input/", "their hashes are those of run.json");
    } catch (const StorageError& fault) {
      damaged("run.json", fault.what());
    } catch (const nlohmann::json::exception& fault) {
      damaged("run.json", fmt::format("run.json or effective_case.json cannot be read: {}", fault.what()));
    }
  }

  /// What the run is taken up with, beside its checkpoints.
  void verify_resume_file() {
    const std::string name = "resume.json";
    if (!fs::exists(directory_ / name)) return;
    try {
      (void)read_resume_file(directory_);
      sound(name, "closed by its hash");
    } catch (const Error& fault) {
      damaged(name, fault.what());
    }
  }

  void verify_index() {
    const std::string name = "segments/index.jsonl";
    if (!fs::exists(directory_ / name)) return;
    std::istringstream lines(read_whole_file(directory_ / name));
    std::size_t number = 0;
    // A last line without its end is still being written.
    for (std::string line; std::getline(lines, line) && !lines.eof();) {
      ++number;
      try {
        const nlohmann::json entry = opened_line(line);
        const std::string file = entry.at("file");
        segments_["segments/" + file] = {entry.at("sha256"), entry.at("bytes")};
      } catch (const std::exception& fault) {
        damaged(name, fmt::format("line {}: {}", number, fault.what()));
      }
    }
    if (!damaged_.contains(name)) sound(name, fmt::format("{} lines, each with its checksum", number));
  }

  void verify_segments() {
    std::size_t whole = 0;
    std::uintmax_t bytes = 0;
    for (const auto& [name, segment] : segments_) {
      if (hash_of(name) == segment.sha256) {
        ++whole;
        bytes += segment.bytes;
        continue;
      }
      const auto lost = look_apart([&] { return lost_arrays(directory_ / name); });
      damaged(name, fmt::format("its SHA-256 is not that of the index; {}",
                                lost.value_or("HDF5 itself fails over it: no array of it can be had")));
    }
    if (!segments_.empty())
      sound("segments/", fmt::format("{} of {} segments as written, {:.1f} MB", whole, segments_.size(),
                                     static_cast<double>(bytes) / 1e6));
    note_other_segments();
  }

  void note_other_segments() {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(directory_ / "segments", missing)) {
      const std::string name = "segments/" + entry.path().filename().string();
      if (name.ends_with(".superseded") || name.ends_with(".part"))
        findings_.push_back({name, Soundness::noted, "is no result, see docs/results.md", false});
      else if (name.ends_with(".h5") && !segments_.contains(name) &&
               !damaged_.contains("segments/index.jsonl"))
        findings_.push_back(
            {name, Soundness::noted, "no line of the index names it: it is no result", false});
    }
  }

  void verify_checksums() {
    const std::string name = "SHA256SUMS";
    if (!fs::exists(directory_ / name)) {
      findings_.push_back(
          {name, Soundness::noted, "none: the run goes on, or did not come to its end", false});
      return;
    }
    try {
      const Checksums sums = read_checksums(directory_ / name);
      std::size_t fitting = 0;
      for (const auto& [file, hash] : sums) {
        if (hash_of(file) == hash)
          ++fitting;
        else
          damaged(file, "its SHA-256 is not that of SHA256SUMS");
      }
      sound(name, fmt::format("{} of {} files fit", fitting, sums.size()));
    } catch (const StorageError& fault) {
      damaged(name, fault.what());
    }
  }

  void verify_checkpoints() {
    const CheckpointStore store(directory_, fewest_checkpoints);
    std::optional<Checkpoint> newest;
    for (const std::string& name : store.names()) {
      try {
        newest = store.read(name);
        findings_.push_back(
            {"checkpoints/" + name, Soundness::sound,
             fmt::format("{} states and their manifest, after {:.6g} s{}", newest->states.size(),
                         newest->manifest.time,
                         newest->states.contains(neutral_network) ? "; any flow solver can go on" : ""),
             true});
      } catch (const Error& fault) {
        // A run that is going on removes old ones.
        if (fs::exists(directory_ / "checkpoints" / name))
          findings_.push_back({"checkpoints/" + name, Soundness::damaged, fault.what(), true});
      }
    }
    if (newest) verify_marks(*newest);
  }

  void verify_marks(const Checkpoint& checkpoint) {
    const auto record = checkpoint.states.find("record"), seismicity = checkpoint.states.find("seismicity");
    const std::string when = fmt::format("checkpoint {:06}", checkpoint.manifest.interval);
    try {
      const TableMarks marks =
          record == checkpoint.states.end() ? TableMarks() : RunRecord::marks(record->second);
      for (const auto& [name, mark] : marks) compare_with_mark(name, mark, when);
      if (seismicity != checkpoint.states.end()) {
        const auto mark = SeismicMonitor::mark(seismicity->second);
        if (mark) compare_with_mark("seismicity/catalogue.csv", *mark, when);
      }
    } catch (const Error& fault) {
      findings_.push_back({"checkpoints/", Soundness::damaged, fault.what(), true});
    }
  }

  void compare_with_mark(const std::string& name, const FileMark& mark, const std::string& when) {
    try {
      check_mark(directory_ / name, mark);
      sound(name, fmt::format("its first {} bytes are those of {}", mark.bytes, when));
    } catch (const Error& fault) {
      damaged(name, fmt::format("{} ({})", fault.what(), when));
    }
  }

  /// Of a run that goes on or was killed, the last message may not be whole.
  void verify_tapes() {
    for (const Role role : {Role::structure, Role::network})
      for (const std::uint32_t epoch : taped_epochs(directory_, role)) {
        const fs::path file = tape_file(directory_, role, epoch);
        verify_readable(file.lexically_relative(directory_).string(), check_tape);
      }
  }

  template <typename Check>
  void verify_readable(const std::string& name, const Check& check) {
    if (!fs::exists(directory_ / name)) return;
    try {
      sound(name, check(directory_ / name));
    } catch (const std::exception& fault) {
      damaged(name, fault.what());
    }
  }

  const std::string& hash_of(const std::string& name) {
    const auto known = hashes_.find(name);
    if (known != hashes_.end()) return known->second;
    return hashes_[name] = hash_or_nothing(directory_ / name);
  }

  struct Segment {
    std::string sha256;
    std::uintmax_t bytes = 0;
  };
  fs::path directory_;
  std::map<std::string, Segment> segments_;
  std::map<std::string, std::string> hashes_;
  std::set<std::string> damaged_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> verify_run(const fs::path& run_directory) {
  if (!fs::exists(run_directory / "lock") && !fs::exists(run_directory / "run.json"))
    throw Error(ExitCode::precondition, fmt::format("{} holds no run", run_directory.string()));
  return Verification(run_directory).run();
}

}  // namespace fissura::coupler
