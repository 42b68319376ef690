// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <csignal>

#include "common/log.hpp"
#include "coupler/launch/process_tree.hpp"
#include "coupler/launch/trio.hpp"

namespace fissura::coupler {

namespace {

constexpr double patience_for_others =
    600;  // wall seconds until a participant that somebody else starts has to be there
constexpr Seconds tick{0.05};
constexpr Seconds keep_alive_interval{1.0};
constexpr double stop_tolerance = 1.5;  // wall seconds a participant may be stopped
constexpr double last_words =
    0.1;                          // wall seconds in which a message of a process that ended may still arrive
constexpr double parting = 0.15;  // wall seconds between the end of a connection and that of its process

double since(std::chrono::steady_clock::time_point start) {
  return Seconds(std::chrono::steady_clock::now() - start).count();
}

double monotonic_seconds_of(std::chrono::steady_clock::time_point time) {
  return Seconds(time.time_since_epoch()).count();
}

/// Codes with which a participant that cannot speak yet says why it ends.
bool explains_itself(int exit_code) {
  const auto code = static_cast<ExitCode>(exit_code);
  return (code >= ExitCode::case_invalid && code <= ExitCode::security) ||
         (code >= ExitCode::protocol_violation && code <= ExitCode::checkpoint_unusable) ||
         code == ExitCode::internal;
}

/// What a participant found out about this end of the connection before it ended; nothing if it ended for
/// another reason.
const char* finding_about_the_coupler(int exit_code) {
  switch (static_cast<ExitCode>(exit_code)) {
    case ExitCode::participant_died: return "lost its connection to the coupler and ended";
    case ExitCode::participant_unresponsive: return "heard nothing of the coupler for too long and ended";
    default: return nullptr;
  }
}

}  // namespace

// ---- ends and stops ---------------------------------------------------------------------------------

void Trio::watch_processes() {
  for (const std::size_t number : deaths_.ended()) process_ended(participants_[number]);
  const Clock::time_point now = Clock::now();
  if (now < next_stop_watch_) return;
  next_stop_watch_ = now + std::chrono::duration_cast<Clock::duration>(tick);
  for (Participant& each : participants_) watch_stop(each);
}

void Trio::process_ended(Participant& each) {
  hear_last_words(each);
  const ProcessEnd end = each.process->wait_or_kill(0);
  std::string sentence = end.sentence();
  ExitCode code = ExitCode::participant_died;
  if (end.signal == SIGKILL && each.memory && each.memory->has_seen_one()) {
    code = ExitCode::out_of_memory;
    sentence += " by the kernel: out of memory";
  } else if (end.signal == SIGILL) {
    sentence += ": it was built for another processor";
  } else if (!end.signal && end.exit_code == static_cast<int>(ExitCode::out_of_memory)) {
    code = ExitCode::out_of_memory;
    sentence = "ran out of memory and ended with exit code 26";
  } else if (!end.signal && each.view == CouplerView::absent && each.refusal) {
    code = each.refusal->code();
    sentence += " before it introduced itself" + refusal_in_words(each);
  } else if (const char* finding = end.signal ? nullptr : finding_about_the_coupler(end.exit_code)) {
    code = ExitCode::participant_unresponsive;
    sentence = finding;
  } else if (!end.signal && end.exit_code == 0 && each.view == CouplerView::finishing) {
    sentence = "has ended, but its BYE did not come: its connection was closed before";
  } else if (!end.signal && each.view == CouplerView::absent) {
    const bool not_executed = end.exit_code == 126 || end.exit_code == 127;
    if (not_executed)
      code = ExitCode::precondition;
    else if (explains_itself(end.exit_code))
      code = static_cast<ExitCode>(end.exit_code);
    sentence += " before it introduced itself";
  }
  fail(code, each, sentence);
}

void Trio::peer_lost(Participant& each, Loss how) {
  if (each.view == CouplerView::leaving || each.view == CouplerView::gone) return;
  if (how == Loss::broke_framing)
    fail(ExitCode::protocol_violation, each,
         fmt::format("sent more than {} bytes in one frame or broke the framing of its connection",
                     options_.listening.largest_frame));
  if (!each.process && how == Loss::fell_silent)
    fail(ExitCode::participant_unresponsive, each,
         fmt::format("has not answered for {} s: it is stopped or cannot be reached",
                     transport_silence.count()));
  if (!each.process) fail(ExitCode::participant_died, each, "is gone: its connection broke");
  // First: one that was killed while it was stopped still looks stopped for a moment.
  if (each.process->wait(parting)) process_ended(each);
  if (each.process->stopped()) {
    if (options_.debug_attach)
      fail(ExitCode::participant_unresponsive, each, "was held for too long for the transport");
    fail(ExitCode::participant_unresponsive, each, "is stopped by a signal");
  }
  fail(ExitCode::participant_unresponsive, each, "lives, but its connection was cut");
}

void Trio::watch_stop(Participant& each) {
  if (!each.process || each.view == CouplerView::leaving) return;
  if (!each.process->stopped()) {
    if (each.stopped_since)
      warn(each, "stopped",
           fmt::format("was stopped by a signal for {:.1f} s and goes on", since(*each.stopped_since)));
    each.stopped_since.reset();
  } else if (!each.stopped_since) {
    each.stopped_since = Clock::now();
  } else if (since(*each.stopped_since) > stop_tolerance && !options_.debug_attach) {
    fail(ExitCode::participant_unresponsive, each, "is stopped by a signal");
  }
}

// What a participant still managed to say goes before how it ended. What the other one says now comes after
// the first fault.
void Trio::hear_last_words(const Participant& dead) {
  const Clock::time_point start = Clock::now();
  while (since(start) < last_words) {
    CouplerChannel::Event event = channel_.wait(tick, {});
    if (const auto* received = std::get_if<CouplerChannel::Received>(&event)) {
      const bool of_another = dead.peer && received->peer != *dead.peer;
      if (!of_another) (void)handle(std::move(event));
    } else if (const auto* lost = std::get_if<CouplerChannel::PeerLost>(&event)) {
      if (dead.peer == lost->peer) return;
    }
  }
}

void Trio::wait_for_end(Participant& each) {
  if (!each.process) return;
  const Clock::time_point start = Clock::now();
  while (!each.process->wait(tick.count()) && since(start) < options_.deadlines.finish) status_.beat();
  const bool late = !each.process->end();
  const ProcessEnd end = each.process->wait_or_kill(0);
  if (late)
    fail(ExitCode::participant_unresponsive, each,
         fmt::format("said BYE, but did not end in {} s", options_.deadlines.finish));
  if (end.signal || end.exit_code != 0)
    fail(ExitCode::participant_died, each, "said BYE, then " + end.sentence());
}

// ---- silence ----------------------------------------------------------------------------------------

void Trio::watch_silence(Participant& each) {
  if (options_.debug_attach) return;
  const double silent = since(each.last_word);
  const bool awaited = each.view == CouplerView::absent && !each.process;
  const double join = awaited ? patience_for_others : options_.deadlines.join;
  switch (each.view) {
    case CouplerView::absent:
      if (silent > join)
        fail(each.refusal ? each.refusal->code() : ExitCode::participant_unresponsive, each,
             fmt::format("did not introduce itself in {} s{}", join, refusal_in_words(each)));
      break;
    case CouplerView::joining:
    case CouplerView::restoring:  // meshing comes first
      if (silent > join)
        fail(ExitCode::participant_unresponsive, each,
             fmt::format("is alive but made no progress for {} s", join));
      break;
    case CouplerView::inserting:
    case CouplerView::advancing:
    case CouplerView::reporting:
    case CouplerView::reporting_proposed:
    case CouplerView::saving:
    case CouplerView::finishing:
      climb_ladder(each, silent);
      break;
    case CouplerView::empty:
    case CouplerView::resuming:
    case CouplerView::idle:
    case CouplerView::proposed:
    case CouplerView::leaving:
    case CouplerView::failed:
    case CouplerView::gone:
      break;
  }
}

void Trio::climb_ladder(Participant& each, double silent_seconds) {
  const std::optional<Rung> rung = each.ladder.climb(silent_seconds);
  if (!rung) return;
  switch (*rung) {
    case Rung::warning:
      if (each.process) each.activity_when_warned = activity_of(each.process->pid());
      each.warned_at = Clock::now();
      warn(each, "no progress", fmt::format("has made no progress for {:.1f} s", silent_seconds));
      break;
    case Rung::diagnosis:
      warn(each, "diagnosis",
           fmt::format("has made no progress for {:.1f} s; its process {}{}", silent_seconds, activity(each),
                       dump_stack(each) ? "; it was asked for its call stack" : ""));
      break;
    case Rung::end:
      fail(ExitCode::participant_unresponsive, each,
           fmt::format("is alive but made no progress for {} s; its process {}", options_.deadlines.progress,
                       activity(each)));
  }
}

/// What the process has done since the warning.
std::string Trio::activity(const Participant& each) const {
  if (!each.process) return "is not on this machine";
  const std::optional<ProcessActivity> now = activity_of(each.process->pid());
  if (!now || !each.activity_when_warned) return "cannot be looked at";
  return describe(*now, *each.activity_when_warned, since(each.warned_at));
}

std::string Trio::refusal_in_words(const Participant& each) {
  return each.refusal ? fmt::format("; somebody was refused: {}", each.refusal->what()) : "";
}

// Only a process of ours that has said that it knows the signal: others would end of it.
bool Trio::dump_stack(const Participant& each) const {
  if (!each.process || !each.identity.capabilities.contains("stack")) return false;
  const auto pid = static_cast<pid_t>(each.identity.pid);
  if (pid != each.process->pid() && !descendants().contains(pid)) return false;
  return ::kill(pid, SIGUSR2) == 0;
}

// ---- what others know -------------------------------------------------------------------------------

void Trio::keep_alive() {
  const Clock::time_point now = Clock::now();
  if (now < next_keep_alive_) return;
  next_keep_alive_ = now + std::chrono::duration_cast<Clock::duration>(keep_alive_interval);
  for (const Participant& each : participants_) {
    if (std::holds_alternative<ProtocolFault>(move(each.role, each.view, Word::progress))) continue;
    Message progress(MessageType::progress);
    progress.body = {{"phase", status_.phase()}, {"count", status_.beats()}};
    try {
      channel_.send(*each.peer, std::move(progress));
    } catch (const ProtocolError&) {
      // A stopped participant does not empty its queue; watch_stop tells.
    }
  }
}

void Trio::show(const Participant& each) {
  status_.change([&](RunStatus& status) {
    ParticipantStatus& shown = status.participants[static_cast<std::size_t>(each.role)];
    const bool introduced = each.view != CouplerView::absent;
    shown.asked = introduced ? each.asked : "";
    shown.phase = each.phase;
    shown.interval = each.interval;
    shown.count = each.count;
    shown.asked_at = monotonic_seconds_of(each.asked_at);
    shown.last_word = monotonic_seconds_of(each.last_word);
    shown.pid = each.process ? each.process->pid() : 0;
    shown.is_waited_for = !introduced || is_waited_for(each.view);
  });
}

void Trio::warn(const Participant& each, const char* event, const std::string& text) const {
  const std::string whole = fmt::format("{} {} ({})", name(each.role), text, situation(each));
  if (options_.on_warning)
    options_.on_warning(each.role, event, whole);
  else
    log::warn(whole);
}

}  // namespace fissura::coupler
