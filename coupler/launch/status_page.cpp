// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/status_page.hpp"

#include <sys/mman.h>

#include <new>

#include "common/errors.hpp"

namespace fissura::coupler {

StatusPage::StatusPage() {
  void* page = ::mmap(nullptr, sizeof(Content), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) throw Error(ExitCode::precondition, "cannot map the status page");
  content_ = new (page) Content;
}

StatusPage::~StatusPage() { ::munmap(content_, sizeof(Content)); }

void StatusPage::show(std::uint64_t interval, const char* phase) {
  content_->interval.store(interval, std::memory_order_relaxed);
  content_->phase.store(phase, std::memory_order_relaxed);
  beat();
}

}  // namespace fissura::coupler
