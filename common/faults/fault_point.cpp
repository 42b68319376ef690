// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/faults/fault_point.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cfenv>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "common/case/toml_document.hpp"
#include "common/errors.hpp"

namespace fissura {

namespace {

struct ArmedFault {
  ProcessFault fault;
  std::uint64_t entries = 0;  ///< how often its point was entered
};

std::vector<ArmedFault> armed_faults;
std::uint64_t current_interval = 0;
std::array<int, 3> pending_errors{};  ///< by StorageCall
bool disk_is_full = false;

void pause(double seconds) {
  timespec left{static_cast<time_t>(seconds),
                static_cast<long>((seconds - static_cast<double>(static_cast<time_t>(seconds))) * 1e9)};
  while (::nanosleep(&left, &left) != 0 && errno == EINTR) {
  }
}

/// A stopped process cannot wake itself: a child does, which ends with it.
void stop_for(double seconds) {
  const pid_t stopped = ::getpid(), waker = ::fork();
  if (waker == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    pause(seconds);
    ::kill(stopped, SIGCONT);
    ::_exit(0);
  }
  if (waker < 0) throw std::runtime_error("injected stop: cannot fork who wakes this process");
  ::raise(SIGSTOP);
  ::waitpid(waker, nullptr, 0);
}

/// So that the machine does not suffer, the address space is first limited to a little more than is in use.
void exhaust_memory() {
  constexpr std::size_t spare = std::size_t{64} << 20, piece = std::size_t{1} << 20;
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + spare;
  ::setrlimit(RLIMIT_AS, &limit);
  std::vector<std::vector<char>> taken;
  for (;;) taken.emplace_back(piece);
}

void flush_denormals() {
#if defined(__x86_64__)
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | flush_to_zero | denormals_are_zero);
#elif defined(__aarch64__)
  constexpr unsigned long flush_to_zero = 1UL << 24;
  __builtin_aarch64_set_fpcr64(__builtin_aarch64_get_fpcr64() | flush_to_zero);
#else
  throw std::runtime_error("injected flush of denormal numbers: not known of this processor");
#endif
}

void act(const ProcessFault& fault, std::uint64_t interval) {
  switch (fault.action) {
    case FaultAction::kill:
      ::raise(SIGKILL);
      return;
    case FaultAction::stop:
      ::raise(SIGSTOP);
      return;
    case FaultAction::stop_for:
      stop_for(fault.seconds);
      return;
    case FaultAction::sleep:
      pause(fault.seconds);
      return;
    case FaultAction::spin:
      for (volatile unsigned long turns = 0;;) turns = turns + 1;
    case FaultAction::fail:
      throw SolverError(fmt::format("injected failure in interval {}", interval));
    case FaultAction::throw_exception:
      throw std::runtime_error(fmt::format("injected exception in interval {}", interval));
    case FaultAction::exit:
      ::_exit(fault.code);
    case FaultAction::abort:
      std::abort();
    case FaultAction::segfault: {
      volatile int* volatile nowhere = nullptr;
      *nowhere = 0;
      return;
    }
    case FaultAction::exhaust:
      exhaust_memory();
      return;
    case FaultAction::round_up:
      std::fesetround(FE_UPWARD);
      return;
    case FaultAction::flush_denormals:
      flush_denormals();
      return;
    case FaultAction::disk_full:
      disk_is_full = true;
      return;
    case FaultAction::write_error:
      pending_errors[static_cast<std::size_t>(StorageCall::write)] = EIO;
      return;
    case FaultAction::sync_error:
      pending_errors[static_cast<std::size_t>(StorageCall::sync)] = EIO;
      return;
    case FaultAction::rename_error:
      pending_errors[static_cast<std::size_t>(StorageCall::rename)] = EIO;
      return;
    case FaultAction::nan:
    case FaultAction::negative:
      return;
  }
}

std::uint64_t epoch_of_environment() {
  const char* text = std::getenv("FISSURA_EPOCH");
  std::uint64_t epoch = 0;
  if (text != nullptr) std::from_chars(text, text + std::strlen(text), epoch);
  return epoch;
}

std::vector<ProcessFault> faults_of_environment() {
  std::vector<ProcessFault> faults;
  if (const char* file = std::getenv("FISSURA_FAULT_PLAN")) {
    FaultList wrong;
    const input::SourceValue document = input::read_toml(file, wrong);
    if (wrong.empty()) {
      input::TableReader reader(document, "", wrong);
      faults = read_process_faults(reader);
    }
    if (!wrong.empty()) throw InputError("fault plan: " + describe(wrong.front()));
  }
  if (const char* text = std::getenv("FISSURA_FAULT")) faults.push_back(parse_process_fault(text));
  return faults;
}

}  // namespace

namespace armed {

bool any = false;

std::optional<Spoil> strike(FaultPhase phase, std::uint64_t interval) {
  current_interval = interval;
  std::optional<Spoil> spoil;
  for (ArmedFault& each : armed_faults) {
    const ProcessFault& fault = each.fault;
    if (fault.phase != phase || (fault.interval && *fault.interval != interval)) continue;
    if (++each.entries != fault.occurrence) continue;
    act(fault, interval);
    if (fault.action == FaultAction::nan || fault.action == FaultAction::negative)
      spoil = Spoil{fault.field, fault.index, fault.action};
  }
  return spoil;
}

std::optional<Spoil> strike(const char* phase, std::uint64_t interval) {
  for (const Named<FaultPhase>& each : fault_phases)
    if (each.name == phase) return strike(each.value, interval);
  return std::nullopt;
}

std::optional<Spoil> strike(FaultPhase phase) {
  return strike(phase, current_interval);
}

}  // namespace armed

void arm_planned_faults(std::string_view role) {
  const std::uint64_t epoch = epoch_of_environment();
  std::vector<ProcessFault> faults = faults_of_environment();
  std::erase_if(faults, [&](const ProcessFault& fault) {
    return fault.role != role || (fault.epoch && *fault.epoch != epoch);
  });
  arm_faults(std::move(faults));
}

void arm_faults(std::vector<ProcessFault> faults) {
  armed_faults.clear();
  for (ProcessFault& fault : faults) armed_faults.push_back({std::move(fault), 0});
  armed::any = !armed_faults.empty();
  current_interval = 0;
  pending_errors = {};
  disk_is_full = false;
}

int injected_error(StorageCall call) {
  if (!armed::any) return 0;
  if (call == StorageCall::write && disk_is_full) return ENOSPC;
  return std::exchange(pending_errors[static_cast<std::size_t>(call)], 0);
}

}  // namespace fissura
