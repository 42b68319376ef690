// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/checkpoint/unsynced_disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace fissura::coupler::sample {

namespace {

namespace fs = std::filesystem;

/// One file or folder, whatever it is called: numbers of inodes alone are used again.
using Identity = std::string;

Identity identity_of(const fs::path& path) {
  struct statx status {};
  ::statx(AT_FDCWD, path.c_str(), AT_SYMLINK_NOFOLLOW, STATX_INO | STATX_BTIME, &status);
  return std::to_string(status.stx_ino) + "." + std::to_string(status.stx_btime.tv_sec) + "." +
         std::to_string(status.stx_btime.tv_nsec);
}

std::string content_of(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

struct Account {
  fs::path root;
  std::function<void()> power_fails;
  bool is_listening = false;
  std::map<Identity, std::string> contents;
  std::map<Identity, std::map<std::string, Identity>> names;

  void sync(const fs::path& path) {
    if (!fs::is_directory(path)) {
      contents[identity_of(path)] = content_of(path);
      return;
    }
    auto& entries = names[identity_of(path)];
    entries.clear();
    for (const auto& entry : fs::directory_iterator(path))
      entries[entry.path().filename()] = identity_of(entry.path());
  }

  /// Everything that is there before the account begins.
  void sync_all(const fs::path& path) {
    sync(path);
    if (fs::is_directory(path))
      for (const auto& entry : fs::directory_iterator(path)) sync_all(entry.path());
  }

  void ask() {
    if (!is_listening) return;
    is_listening = false;
    power_fails();
    is_listening = true;
  }

  void copy_file(const Identity& identity, const fs::path& copy) const {
    const auto content = contents.find(identity);
    std::ofstream(copy, std::ios::binary) << (content == contents.end() ? std::string() : content->second);
  }

  void leave_synced(const Identity& folder, const fs::path& copy) const {
    fs::create_directory(copy);
    const auto entries = names.find(folder);
    if (entries == names.end()) return;
    for (const auto& [name, identity] : entries->second) {
      if (names.contains(identity) || !contents.contains(identity))
        leave_synced(identity, copy / name);
      else
        copy_file(identity, copy / name);
    }
  }

  void leave_named(const fs::path& folder, const fs::path& copy) const {
    fs::create_directory(copy);
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_directory())
        leave_named(entry.path(), copy / entry.path().filename());
      else
        copy_file(identity_of(entry.path()), copy / entry.path().filename());
    }
  }
};

Account account;

}  // namespace

UnsyncedDisk::UnsyncedDisk(fs::path root, std::function<void()> power_fails) {
  account = {std::move(root), std::move(power_fails), false, {}, {}};
  account.sync_all(account.root);
  account.is_listening = true;
}

UnsyncedDisk::~UnsyncedDisk() {
  account = {};
}

void UnsyncedDisk::leave_behind(Loss loss, const fs::path& copy) const {
  if (loss == Loss::everything)
    account.leave_synced(identity_of(account.root), copy);
  else
    account.leave_named(account.root, copy);
}

}  // namespace fissura::coupler::sample

using fissura::coupler::sample::account;

extern "C" {

int __real_fsync(int descriptor);
int __real_rename(const char* from, const char* to);
int __real_renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags);

int __wrap_fsync(int descriptor) {
  account.ask();
  const int result = __real_fsync(descriptor);
  if (account.is_listening)
    account.sync(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor)));
  account.ask();
  return result;
}

int __wrap_rename(const char* from, const char* to) {
  account.ask();
  const int result = __real_rename(from, to);
  account.ask();
  return result;
}

int __wrap_renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  account.ask();
  const int result = __real_renameat2(from_folder, from, to_folder, to, flags);
  account.ask();
  return result;
}
}
