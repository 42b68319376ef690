// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/epochs.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

namespace {

constexpr const char* file_name = "epochs.jsonl";

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::uint32_t epochs_so_far(const std::filesystem::path& run_directory) {
  const std::string text = text_of(run_directory / file_name);
  return static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
}

void note_epoch(const std::filesystem::path& run_directory, std::uint32_t epoch,
                const std::optional<std::uint64_t>& resumed_after) {
  nlohmann::ordered_json line;
  line["epoch"] = epoch;
  line["resumed_after"] = nullptr;
  if (resumed_after) line["resumed_after"] = *resumed_after;
  line["pid"] = ::getpid();
  line["started"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  const std::filesystem::path file = run_directory / file_name;
  write_whole_file(file, text_of(file) + line.dump() + "\n");
}

}  // namespace fissura::coupler
