// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/socket_place.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <system_error>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "common/log.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

constexpr const char* socket_name = "coupler.ipc";

/// In a directory that everybody can write in, others may have been first.
void make_private(const fs::path& directory) {
  if (::mkdir(directory.c_str(), 0700) == 0) return;
  if (errno != EEXIST)
    throw Error(ExitCode::precondition,
                fmt::format("cannot create {}: {}", directory.string(), std::strerror(errno)));
  struct stat status {};
  if (::lstat(directory.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != ::geteuid() ||
      (status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    throw Error(ExitCode::security,
                fmt::format("{} is in the way of the socket of this run and not private to this user: "
                            "remove it, or give --out a shorter path",
                            directory.string()));
}

}  // namespace

SocketPlace::SocketPlace(const fs::path& run_directory) {
  constexpr std::size_t longest_address = 100;
  constexpr std::size_t name_length = 16;
  path_ = fs::absolute(run_directory / socket_name);
  if (path_.string().size() > longest_address) {
    temporary_ = fs::temp_directory_path() /
                 ("fissura-" + sha256(std::as_bytes(std::span(path_.native()))).substr(0, name_length));
    make_private(temporary_);
    path_ = temporary_ / socket_name;
  }
  std::error_code none;
  if (fs::remove(path_, none))
    log::info(fmt::format("the socket {} of a run that was killed is taken over", path_.string()));
}

SocketPlace::~SocketPlace() {
  std::error_code ignored;
  fs::remove(path_, ignored);
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

}  // namespace fissura::coupler
