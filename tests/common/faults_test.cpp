// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <new>

#include "common/case/toml_document.hpp"
#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"

using namespace fissura;

namespace {

/// An environment variable for the length of one test.
class Variable {
 public:
  Variable(const char* name, const char* text) : name_(name) { ::setenv(name, text, 1); }
  ~Variable() {
    ::unsetenv(name_);
    arm_faults({});
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

ProcessFault fault_at(FaultPhase phase, FaultAction action) {
  ProcessFault fault;
  fault.role = "network";
  fault.interval = 7;
  fault.phase = phase;
  fault.action = action;
  return fault;
}

std::vector<ProcessFault> read(const char* text, FaultList& wrong) {
  const input::SourceValue document = input::parse_toml(text, "plan.toml", wrong);
  input::TableReader reader(document, "", wrong);
  return read_process_faults(reader);
}

/// How a child ends that enters `advance` of interval 7 with this fault, as wait() tells; 99 if it goes on.
int end_of_child(const ProcessFault& fault) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int number : {SIGABRT, SIGSEGV}) std::signal(number, SIG_DFL);
    arm_faults({fault});
    fault_point(FaultPhase::advance, 7);
    ::_exit(99);
  }
  int status = 0;
  ::waitpid(child, &status, WUNTRACED);
  if (!WIFSTOPPED(status)) return status;
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  return status;
}

}  // namespace

TEST_CASE("one fault is spelled in short by role, interval, phase and what to do", "[common][faults]") {
  const ProcessFault fault = parse_process_fault("structure@40=spin");
  CHECK(fault.role == "structure");
  CHECK(fault.interval == 40);
  CHECK(fault.phase == FaultPhase::advance);
  CHECK(fault.action == FaultAction::spin);
  CHECK(fault.epoch == 0);
  CHECK(parse_process_fault("network@3=nan").phase == FaultPhase::answer);
  CHECK(parse_process_fault("coupler@3=kill").phase == FaultPhase::network);
  CHECK(parse_process_fault("coupler@3:checkpoint-commit=kill").phase == FaultPhase::checkpoint_commit);
  CHECK(parse_process_fault("coupler@18446744073709551615=exit").interval == UINT64_MAX);
}

TEST_CASE("a short fault that cannot be meant is refused with itself and what was expected",
          "[common][faults]") {
  const char* text =
      GENERATE("", "structure", "structure@40", "structure=spin", "structure=40@spin", "rock@40=spin",
               "structure@=spin", "structure@-1=spin", "structure@4x=spin", "structure@40=explode",
               "structure@40=", "structure@18446744073709551616=spin", " structure@40=spin",
               "structure@40:segment=kill", "structure@40:advance=nan", "network@1=sleep");
  CAPTURE(text);
  CHECK_THROWS_AS(parse_process_fault(text), InputError);
  CHECK_THROWS_WITH(parse_process_fault(text), Catch::Contains(std::string("\"") + text + "\""));
}

TEST_CASE("a fault plan is read with every key, and what is left out has its fallback", "[common][faults]") {
  FaultList wrong;
  const auto faults = read(R"(
[[fault]]
role = "network"
phase = "answer"
interval = 17
epoch = "every"
occurrence = 2
do = "negative"
field = "pressure"
index = 5
[[fault]]
role = "coupler"
phase = "checkpoint-prepare"
do = "disk_full"
)",
                           wrong);
  REQUIRE(wrong.empty());
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].interval == 17);
  CHECK_FALSE(faults[0].epoch.has_value());
  CHECK(faults[0].occurrence == 2);
  CHECK(faults[0].action == FaultAction::negative);
  CHECK(faults[0].field == "pressure");
  CHECK(faults[0].index == 5);
  CHECK_FALSE(faults[1].interval.has_value());
  CHECK(faults[1].epoch == 0);
  CHECK(faults[1].occurrence == 1);
  CHECK(faults[1].phase == FaultPhase::checkpoint_prepare);
}

TEST_CASE("everything wrong with a fault plan is told at once with line, key and what is allowed",
          "[common][faults]") {
  FaultList wrong;
  (void)read(R"([[fault]]
role = "rock"
phase = "advance"
do = "kill"
[[fault]]
role = "structure"
phase = "segment"
do = "kill"
[[fault]]
role = "structure"
phase = "advance"
do = "nan"
[[fault]]
role = "network"
phase = "advance"
do = "disk_full"
[[fault]]
role = "network"
phase = "advance"
do = "sleep"
[[fault]]
role = "network"
phase = "advance"
do = "kill"
seconds = 3
interval = -1
occurrence = 0
epoch = "never"
)",
             wrong);
  std::vector<std::string> told;
  for (const Fault& fault : wrong) told.push_back(describe(fault));
  const auto is_told = [&](int line, const char* key, const char* expected) {
    for (const Fault& fault : wrong)
      if (fault.where.line == line && fault.key == key && fault.expected.find(expected) != std::string::npos)
        return true;
    return false;
  };
  CAPTURE(told);
  CHECK(is_told(2, "fault[0].role", "structure, network, coupler"));
  CHECK(is_told(7, "fault[1].phase", "hello, join, insert, advance"));
  CHECK(is_told(12, "fault[2].do", "kill, stop"));
  CHECK(is_told(16, "fault[3].do", "kill, stop"));
  CHECK(is_told(17, "fault[4].seconds", "greater than 0"));
  CHECK(is_told(25, "fault[5].seconds", "role, phase, interval"));
  CHECK(is_told(26, "fault[5].interval", "at least 0"));
  CHECK(is_told(27, "fault[5].occurrence", "at least 1"));
  CHECK(is_told(28, "fault[5].epoch", "\"every\""));
  CHECK(wrong.size() == 9);
}

TEST_CASE("a fault of the environment strikes its own role in its own epoch only", "[common][faults]") {
  const Variable fault("FISSURA_FAULT", "network@7=nan");
  arm_planned_faults("structure");
  CHECK_FALSE(fault_point(FaultPhase::answer, 7).has_value());
  arm_planned_faults("network");
  CHECK(fault_point(FaultPhase::answer, 7).has_value());
  const Variable epoch("FISSURA_EPOCH", "1");
  arm_planned_faults("network");
  CHECK_FALSE(fault_point(FaultPhase::answer, 7).has_value());
}

TEST_CASE("a fault strikes once: in its interval, its phase, the n-th time it is entered",
          "[common][faults]") {
  ProcessFault fault = fault_at(FaultPhase::answer, FaultAction::nan);
  fault.occurrence = 2;
  arm_faults({fault});
  CHECK_FALSE(fault_point(FaultPhase::answer, 6).has_value());
  CHECK_FALSE(fault_point(FaultPhase::answer, 6).has_value());
  CHECK_FALSE(fault_point(FaultPhase::advance, 7).has_value());
  CHECK_FALSE(fault_point(FaultPhase::answer, 7).has_value());
  CHECK(fault_point(FaultPhase::answer, 7).has_value());
  CHECK_FALSE(fault_point(FaultPhase::answer, 7).has_value());
  arm_faults({});
  CHECK_FALSE(fault_point(FaultPhase::answer, 7).has_value());
}

TEST_CASE("a point without an interval is in that of the last one", "[common][faults]") {
  arm_faults({fault_at(FaultPhase::segment, FaultAction::fail)});
  fault_point(FaultPhase::report, 6);
  CHECK_NOTHROW(fault_point(FaultPhase::segment));
  fault_point(FaultPhase::report, 7);
  CHECK_THROWS_AS(fault_point(FaultPhase::segment), SolverError);
  arm_faults({});
}

TEST_CASE("each fault ends the process in its own way", "[common][faults]") {
  const auto end = [](FaultAction action) { return end_of_child(fault_at(FaultPhase::advance, action)); };
  CHECK(WTERMSIG(end(FaultAction::kill)) == SIGKILL);
  CHECK(WTERMSIG(end(FaultAction::abort)) == SIGABRT);
  CHECK(WTERMSIG(end(FaultAction::segfault)) == SIGSEGV);
  CHECK(WIFSTOPPED(end(FaultAction::stop)));
  ProcessFault leaving = fault_at(FaultPhase::advance, FaultAction::exit);
  leaving.code = 3;
  CHECK(WEXITSTATUS(end_of_child(leaving)) == 3);
  ProcessFault resting = fault_at(FaultPhase::advance, FaultAction::sleep);
  resting.seconds = 0.01;
  CHECK(WEXITSTATUS(end_of_child(resting)) == 99);
}

TEST_CASE("a process that is stopped for a while goes on", "[common][faults]") {
  ProcessFault fault = fault_at(FaultPhase::advance, FaultAction::stop_for);
  fault.seconds = 0.01;
  const pid_t child = ::fork();
  if (child == 0) {
    arm_faults({fault});
    fault_point(FaultPhase::advance, 7);
    ::_exit(99);
  }
  int status = 0;
  ::waitpid(child, &status, WUNTRACED);
  CHECK(WIFSTOPPED(status));
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 99);
}

TEST_CASE("failures and lost memory are exceptions of their kinds", "[common][faults]") {
  const auto strike = [](FaultAction action) {
    arm_faults({fault_at(FaultPhase::advance, action)});
    fault_point(FaultPhase::advance, 7);
  };
  CHECK_THROWS_AS(strike(FaultAction::fail), SolverError);
  CHECK_THROWS_AS(strike(FaultAction::throw_exception), std::runtime_error);
#ifndef __SANITIZE_ADDRESS__
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      strike(FaultAction::exhaust);
    } catch (const std::bad_alloc&) {
      ::_exit(26);
    }
    ::_exit(99);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 26);
#endif
  arm_faults({});
}

TEST_CASE("files fail once, but a full disk stays full", "[common][faults]") {
  const auto strike = [](FaultAction action) {
    ProcessFault fault = fault_at(FaultPhase::segment, action);
    fault.role = "coupler";
    arm_faults({fault});
    CHECK(injected_error(StorageCall::write) == 0);
    fault_point(FaultPhase::segment, 7);
  };
  strike(FaultAction::write_error);
  CHECK(injected_error(StorageCall::sync) == 0);
  CHECK(injected_error(StorageCall::write) == EIO);
  CHECK(injected_error(StorageCall::write) == 0);
  strike(FaultAction::sync_error);
  CHECK(injected_error(StorageCall::sync) == EIO);
  CHECK(injected_error(StorageCall::sync) == 0);
  strike(FaultAction::rename_error);
  CHECK(injected_error(StorageCall::rename) == EIO);
  strike(FaultAction::disk_full);
  CHECK(injected_error(StorageCall::write) == ENOSPC);
  CHECK(injected_error(StorageCall::write) == ENOSPC);
  arm_faults({});
  CHECK(injected_error(StorageCall::write) == 0);
}
