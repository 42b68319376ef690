// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/status_page.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <new>
#include <type_traits>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

constexpr std::uint64_t layout = 0x31'53'49'46'00'00'00'02;
constexpr int attempts_to_read = 1000;

[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw StorageError(fmt::format("cannot create {}: {}", file.string(), std::strerror(errno)));
}

}  // namespace

static_assert(std::is_trivially_copyable_v<RunStatus> && std::is_trivially_copyable_v<RunFailure>);
static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

StatusPage::StatusPage() {
  map(-1, MAP_SHARED | MAP_ANONYMOUS);
}

StatusPage::StatusPage(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) refuse(file);
  // A page without room behind it would end the process at the first write.
  errno = ::posix_fallocate(descriptor, 0, sizeof(Content));
  if (errno != 0) {
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    refuse(file);
  }
  map(descriptor, MAP_SHARED);
  ::close(descriptor);
}

void StatusPage::map(int descriptor, int flags) {
  void* page = ::mmap(nullptr, sizeof(Content), PROT_READ | PROT_WRITE, flags, descriptor, 0);
  if (page == MAP_FAILED) throw Error(ExitCode::precondition, "cannot map the status page");
  content_ = new (page) Content;
  content_->magic = layout;
}

StatusPage::~StatusPage() {
  ::munmap(content_, sizeof(Content));
}

void StatusPage::show(std::uint64_t interval, const char* phase) {
  change([&](RunStatus& status) {
    status.interval = interval;
    status.phase = phase;
    status.phase_since = monotonic_seconds();
  });
  beat();
}

void StatusPage::fail(const RunFailure& failure) {
  content_->failure = failure;
  beat();
}

void StatusPage::begin_life() {
  clear_failure();
  content_->conclusion.store(-1);
  if (content_->changes.load() % 2 != 0) end_change();
}

std::optional<int> StatusPage::conclusion() const {
  const int code = content_->conclusion.load(std::memory_order_acquire);
  return code < 0 ? std::nullopt : std::optional(code);
}

RunStatus StatusPage::read() const {
  return consistent(*content_);
}

void StatusPage::begin_change() {
  content_->changes.fetch_add(1, std::memory_order_acq_rel);
}

void StatusPage::end_change() {
  content_->changes.fetch_add(1, std::memory_order_release);
}

RunStatus StatusPage::consistent(const Content& content) {
  RunStatus copy;
  for (int attempt = 0; attempt < attempts_to_read; ++attempt) {
    const std::uint64_t before = content.changes.load(std::memory_order_acquire);
    copy = content.status;
    std::atomic_thread_fence(std::memory_order_acquire);
    if (before % 2 == 0 && content.changes.load(std::memory_order_relaxed) == before) break;
  }
  return copy;
}

std::optional<RunStatus> read_status(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  struct stat information {};
  std::optional<RunStatus> status;
  if (::fstat(descriptor, &information) == 0 &&
      static_cast<std::size_t>(information.st_size) >= sizeof(StatusPage::Content)) {
    void* page = ::mmap(nullptr, sizeof(StatusPage::Content), PROT_READ, MAP_SHARED, descriptor, 0);
    if (page != MAP_FAILED) {
      const auto* content = static_cast<const StatusPage::Content*>(page);
      if (content->magic == layout) status = StatusPage::consistent(*content);
      ::munmap(page, sizeof(StatusPage::Content));
    }
  }
  ::close(descriptor);
  return status;
}

double monotonic_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace fissura::coupler
