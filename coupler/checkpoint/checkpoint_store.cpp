// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/checkpoint/checkpoint_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"
#include "common/hash.hpp"
#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = "MANIFEST.json";
constexpr std::uintmax_t largest_manifest = 1 << 20;

std::string name_of(std::uint64_t interval) {
  return fmt::format("{:06}", interval);
}

/// The interval that a folder is named by; nothing of any other name.
std::optional<std::uint64_t> interval_of(const std::string& name) {
  std::uint64_t interval = 0;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), interval);
  if (failure != std::errc() || end != name.data() + name.size() || name_of(interval) != name)
    return std::nullopt;
  return interval;
}

[[noreturn]] void fail(const char* doing, const fs::path& path, const std::string& reason) {
  throw StorageError(fmt::format("cannot {} {}: {}", doing, path.string(), reason));
}

void create_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directory(folder, failure);
  if (failure) fail("create", folder, failure.message());
}

void remove_folder(const fs::path& folder) {
  std::error_code failure;
  fs::remove_all(folder, failure);
  if (failure) fail("remove", folder, failure.message());
}

void rename_folder(const fs::path& from, const fs::path& to) {
  if (const int error = injected_error(StorageCall::rename)) fail("rename", from, std::strerror(error));
  if (::rename(from.c_str(), to.c_str()) != 0) fail("rename", from, std::strerror(errno));
}

/// Whether both have changed places; nothing has happened if the file system cannot do that.
bool exchange(const fs::path& one, const fs::path& other) {
  if (const int error = injected_error(StorageCall::rename)) fail("rename", one, std::strerror(error));
  if (::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0) return true;
  if (errno == EINVAL || errno == ENOSYS) return false;
  fail("rename", one, std::strerror(errno));
}

void write_file(const fs::path& file, std::span<const std::byte> bytes) {
  CheckedFile output(file);
  output.append({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  output.sync();
}

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(ExitCode::checkpoint_unusable, sentence);
}

/// The size is looked at first, so that nothing large or endless is read.
std::string read_file(const fs::path& file, const std::function<bool(std::uintmax_t)>& is_expected) {
  std::error_code failure;
  if (fs::symlink_status(file, failure).type() != fs::file_type::regular)
    refuse(fmt::format("{} is missing", file.string()));
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure) refuse(fmt::format("{} cannot be read: {}", file.string(), failure.message()));
  if (!is_expected(size)) refuse(fmt::format("{} has {} bytes, which is not its size", file.string(), size));
  try {
    return read_whole_file(file);
  } catch (const StorageError& fault) {
    refuse(fault.what());
  }
}

std::string suffixed(const fs::path& folder, const std::string& name, const char* ending) {
  std::string free = name + ending;
  for (int number = 2; fs::exists(folder / free); ++number)
    free = fmt::format("{}.{}{}", name, number, ending);
  return free;
}

}  // namespace

CheckpointStore::CheckpointStore(const fs::path& run_directory, int keep)
    : folder_(run_directory / "checkpoints"), keep_(static_cast<std::size_t>(keep)) {
  ENSURE(keep >= 2);
}

void CheckpointStore::write(Checkpoint checkpoint) {
  prepare(std::move(checkpoint));
  commit();
}

void CheckpointStore::prepare(Checkpoint checkpoint) {
  const std::string name = name_of(checkpoint.manifest.interval);
  const fs::path part = folder_ / (name + ".part");
  try {
    const bool is_first = !fs::exists(folder_);
    create_folder(folder_);
    if (is_first) sync_to_disk(folder_.parent_path());
    remove_all_but(names());
    create_folder(part);
    checkpoint.manifest.files.clear();
    for (const auto& [state, bytes] : checkpoint.states) {
      fault_point(FaultPhase::checkpoint_prepare, checkpoint.manifest.interval);
      write_file(part / (state + ".state"), bytes);
      checkpoint.manifest.files[state] = {bytes.size(), sha256(bytes)};
    }
    sync_to_disk(part);
    const std::string manifest = manifest_text(checkpoint.manifest);
    fault_point(FaultPhase::checkpoint_prepare, checkpoint.manifest.interval);
    write_file(part / manifest_name, std::as_bytes(std::span(manifest)));
    sync_to_disk(part);
    prepared_ = name;
  } catch (const std::exception& failure) {
    std::error_code ignored;
    fs::remove_all(part, ignored);
    if (dynamic_cast<const fs::filesystem_error*>(&failure) != nullptr) throw StorageError(failure.what());
    throw;
  }
}

void CheckpointStore::commit() {
  ENSURE(!prepared_.empty());
  const std::string name = std::exchange(prepared_, {});
  const fs::path part = folder_ / (name + ".part"), place = folder_ / name;
  try {
    fault_point(FaultPhase::checkpoint_commit);
    // The same interval again, after the run went on from an older checkpoint or has stopped twice.
    if (fs::exists(place) && !exchange(part, place)) {
      rename_folder(place, folder_ / suffixed(folder_, name, ".unusable"));
      rename_folder(part, place);
    } else if (!fs::exists(place)) {
      rename_folder(part, place);
    }
    sync_to_disk(folder_);
    fault_point(FaultPhase::checkpoint_commit);
  } catch (const StorageError&) {
    std::error_code ignored;
    fs::remove_all(part, ignored);
    throw;
  }
  std::vector<std::string> kept = names();
  if (kept.size() > keep_) kept.erase(kept.begin(), kept.end() - static_cast<std::ptrdiff_t>(keep_));
  remove_all_but(kept);
}

FoundCheckpoint CheckpointStore::newest_usable(const Refusal& refusal) const {
  FoundCheckpoint found;
  std::vector<std::string> candidates = names();
  std::reverse(candidates.begin(), candidates.end());
  for (const std::string& name : candidates) {
    try {
      Checkpoint checkpoint = read(name);
      if (const std::optional<std::string> reason = refusal(checkpoint)) refuse(*reason);
      found.checkpoint = std::move(checkpoint);
      return found;
    } catch (const Error& fault) {
      found.unusable.push_back({name, fault.what()});
    }
  }
  return found;
}

FoundCheckpoint CheckpointStore::newest_whole() const {
  return newest_usable([](const Checkpoint&) { return std::optional<std::string>(); });
}

Checkpoint CheckpointStore::read(const std::string& name) const {
  const fs::path place = folder_ / name, manifest_file = place / manifest_name;
  Checkpoint checkpoint;
  const std::string text =
      read_file(manifest_file, [](std::uintmax_t size) { return size > 0 && size <= largest_manifest; });
  try {
    checkpoint.manifest = manifest_from_text(text);
  } catch (const Error& fault) {
    refuse(fmt::format("{} is damaged: {}", manifest_file.string(), fault.what()));
  }
  if (name_of(checkpoint.manifest.interval) != name)
    refuse(fmt::format("{} is of interval {}: the folder was renamed", manifest_file.string(),
                       checkpoint.manifest.interval));
  for (const auto& [state, file] : checkpoint.manifest.files) {
    const fs::path path = place / (state + ".state");
    const std::string content =
        read_file(path, [bytes = file.bytes](std::uintmax_t size) { return size == bytes; });
    const auto bytes = std::as_bytes(std::span(content));
    if (sha256(bytes) != file.sha256) refuse(fmt::format("{} is not what was written", path.string()));
    checkpoint.states[state].assign(bytes.begin(), bytes.end());
  }
  return checkpoint;
}

void CheckpointStore::set_aside_newer_than(std::optional<std::uint64_t> interval) {
  for (const std::string& name : names())
    if (!interval || *interval_of(name) > *interval)
      rename_folder(folder_ / name, folder_ / suffixed(folder_, name, ".unusable"));
  if (fs::exists(folder_)) sync_to_disk(folder_);
}

std::vector<std::string> CheckpointStore::names() const {
  std::vector<std::string> found;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder_, failure))
    if (const std::string name = entry.path().filename().string(); interval_of(name)) found.push_back(name);
  // Whoever removes superfluous ones must not take a folder that cannot be read for an empty one.
  if (failure && failure != std::errc::no_such_file_or_directory && failure != std::errc::not_a_directory)
    fail("read", folder_, failure.message());
  std::sort(found.begin(), found.end(),
            [](const std::string& a, const std::string& b) { return *interval_of(a) < *interval_of(b); });
  return found;
}

void CheckpointStore::remove_all_but(const std::vector<std::string>& kept) const {
  std::vector<fs::path> superfluous;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder_, failure)) {
    const std::string name = entry.path().filename().string();
    const bool is_ours = interval_of(name) || name.ends_with(".part") || name.ends_with(".unusable");
    if (is_ours && std::find(kept.begin(), kept.end(), name) == kept.end())
      superfluous.push_back(entry.path());
  }
  if (failure) fail("read", folder_, failure.message());
  for (const fs::path& folder : superfluous) remove_folder(folder);
}

}  // namespace fissura::coupler
