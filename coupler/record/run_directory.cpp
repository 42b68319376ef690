// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/run_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = "lock";
constexpr std::array our_entries{"run.json",
                                 "effective_case.json",
                                 "input",
                                 "columns.json",
                                 "history.csv",
                                 "ledger.csv",
                                 "log.jsonl",
                                 "segments",
                                 "fields.xdmf",
                                 "summary.json",
                                 "report.html",
                                 "joints.xdmf",
                                 "meetings.csv",
                                 "remeshing.csv",
                                 "remeshing_wall.csv",
                                 "fractures.xdmf",
                                 "probes.csv",
                                 "seismicity",
                                 "natural_fractures.csv",
                                 "natural_fractures.json",
                                 "checkpoints",
                                 "tape",
                                 "status",
                                 "resume.json",
                                 "epochs.jsonl",
                                 "run.report.json",
                                 "SHA256SUMS"};

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(ExitCode::precondition, sentence);
}

long pid_in(const fs::path& lock) {
  std::ifstream stream(lock);
  long pid = 0;
  stream >> pid;
  return pid;
}

std::string holder_of(const fs::path& lock) {
  const long pid = pid_in(lock);
  return pid > 0 ? fmt::format("pid {}", pid) : "another process";
}

[[noreturn]] void refuse_taken(const fs::path& directory) {
  throw Error(ExitCode::role_taken,
              fmt::format("the run directory {} is in use by {}: wait for that run or choose another --out",
                          directory.string(), holder_of(directory / lock_name)));
}

bool is_finished_run(const fs::path& directory) {
  return fs::exists(directory / "run.json") && fs::exists(directory / "summary.json");
}

bool holds_only_our_lock(const fs::path& directory) {
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().filename() != lock_name) return false;
  return true;
}

void check_content(const fs::path& directory) {
  if (holds_only_our_lock(directory) || is_finished_run(directory)) return;
  if (fs::exists(directory / "run.json") || fs::exists(directory / lock_name))
    refuse(fmt::format(
        "{} holds a run that did not finish: choose another --out, or delete the directory if its "
        "results are not wanted",
        directory.string()));
  refuse(fmt::format("{} is not empty and not a run directory: choose another --out", directory.string()));
}

void check_kind(const fs::path& directory) {
  if (fs::exists(directory) && !fs::is_directory(directory))
    refuse(fmt::format("{} is not a directory: choose another --out", directory.string()));
}

int try_lock(const fs::path& directory) {
  const fs::path lock = directory / lock_name;
  const int descriptor = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0)
    refuse(fmt::format("cannot write in the run directory {}: {}", directory.string(), std::strerror(errno)));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  const int reason = errno;
  ::close(descriptor);
  if (reason == EWOULDBLOCK) refuse_taken(directory);
  refuse(fmt::format("cannot lock the run directory {}: {}", directory.string(), std::strerror(reason)));
}

bool is_locked(const fs::path& directory) {
  const int descriptor = ::open((directory / lock_name).c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return taken;
}

void write_pid(int lock, const fs::path& directory) {
  const std::string text = fmt::format("{}\n", ::getpid());
  if (::ftruncate(lock, 0) != 0 ||
      ::pwrite(lock, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    throw StorageError(
        fmt::format("cannot write {}: {}", (directory / lock_name).string(), std::strerror(errno)));
}

void check_run_to_resume(const fs::path& directory) {
  try {
    check_kind(directory);
    const bool holds_run = fs::exists(directory / "run.json") || fs::exists(directory / lock_name);
    if (!holds_run) refuse(fmt::format("{} holds no run to go on with", directory.string()));
  } catch (const fs::filesystem_error& error) {
    refuse(fmt::format("cannot read the run directory {}: {}", directory.string(), error.code().message()));
  }
}

}  // namespace

void RunDirectory::check(const fs::path& directory) {
  try {
    check_kind(directory);
    if (!fs::exists(directory)) return;
    if (is_locked(directory)) refuse_taken(directory);
    check_content(directory);
  } catch (const fs::filesystem_error& error) {
    refuse(fmt::format("cannot read the run directory {}: {}", directory.string(), error.code().message()));
  }
}

std::optional<long> RunDirectory::holder(const fs::path& directory) {
  const fs::path lock = directory / lock_name;
  const int descriptor = ::open(lock.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0 && errno == ENOENT)
    refuse(fmt::format("{} is not a run directory: {}", directory.string(),
                       fs::exists(directory) ? "it has no file named lock" : "it does not exist"));
  if (descriptor < 0) refuse(fmt::format("cannot read {}: {}", lock.string(), std::strerror(errno)));
  const bool taken = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return taken ? std::optional(pid_in(lock)) : std::nullopt;
}

RunDirectory::RunDirectory(const fs::path& directory) : RunDirectory(directory, Use::new_run) {}

RunDirectory::RunDirectory(const fs::path& directory, Use use) {
  if (use == Use::new_run)
    check(directory);
  else
    check_run_to_resume(directory);
  try {
    fs::create_directories(directory);
    path_ = fs::canonical(directory);
    fs::permissions(path_, fs::perms::owner_all);
  } catch (const fs::filesystem_error& error) {
    refuse(fmt::format("cannot create the run directory {}: {}", directory.string(), error.code().message()));
  }
  lock_ = try_lock(path_);
  try {
    if (use == Use::new_run) check_content(path_);
    write_pid(lock_, path_);
    if (use == Use::new_run) clear();
  } catch (const fs::filesystem_error& error) {
    ::close(lock_);
    refuse(fmt::format("cannot clear the run directory {}: {}", directory.string(), error.code().message()));
  } catch (const Error&) {
    ::close(lock_);
    throw;
  }
}

void RunDirectory::clear() {
  // summary.json is what says "finished": it goes first, so that an end between two removals is seen as
  // unfinished.
  fs::remove(path_ / "summary.json");
  for (const char* entry : our_entries) fs::remove_all(path_ / entry);
}

RunDirectory::~RunDirectory() {
  ::close(lock_);
}

}  // namespace fissura::coupler
