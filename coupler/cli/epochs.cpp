// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/epochs.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
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

void note_network_change(const std::filesystem::path& run_directory, const NetworkChange& change) {
  const std::filesystem::path file = run_directory / file_name;
  const std::string text = text_of(file);
  if (text.size() < 2) throw StorageError(fmt::format("{} has lost its lines", file.string()));
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  auto line = nlohmann::ordered_json::parse(text.substr(last), nullptr, false);
  if (!line.is_object()) throw StorageError(fmt::format("the last line of {} cannot be read", file.string()));
  line["network"] = {{"from", change.from}, {"to", change.to}};
  write_whole_file(file, text.substr(0, last) + line.dump() + "\n");
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
