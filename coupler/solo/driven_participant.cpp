// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/solo/driven_participant.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>

#include "common/errors.hpp"
#include "common/exchange/codec.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

constexpr Seconds between_signs{1.0};
constexpr double last_words =
    0.1;  // wall seconds in which a message of a process that ended may still arrive

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

DecodedMessage decoded(const Frames& frames) {
  std::vector<std::span<const std::byte>> views(frames.begin(), frames.end());
  return decode(views);
}

}  // namespace

std::string in_words(const ProcessEnd& end) {
  // A program that knows nothing of our codes ends with 1 when it breaks down.
  return !end.signal && end.exit_code == 1 ? "ended with exit code 1" : end.sentence();
}

std::string in_words(const Heard& heard) {
  return std::visit(
      Overloaded{[](const Message& message) { return std::string(name(message.type)); },
                 [](const ToldFailure& failure) {
                   return fmt::format("FAIL {}: {}", failure.exit_code(), failure.reason());
                 },
                 [](const Nonsense& nonsense) { return "a message that is no good: " + nonsense.reason; },
                 [](const Silence&) { return std::string("nothing within the time"); },
                 [](const ConnectionLost&) { return std::string("the end of its connection"); },
                 [](const ProcessEnd& end) { return "its process " + in_words(end); }},
      heard);
}

// ---- the process ------------------------------------------------------------------------------------

DrivenParticipant::Place::Place() {
  std::string pattern = (std::filesystem::temp_directory_path() / "fissura-solo-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw Error(ExitCode::precondition, "cannot create " + pattern);
  folder_ = pattern;
}

DrivenParticipant::Place::~Place() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

DrivenParticipant::DrivenParticipant(const DrivenOptions& options)
    : options_(options),
      link_(FrameLink::listening("ipc://" + (place_ / "socket").string())),
      process_(command_line(options)) {}

DrivenParticipant::~DrivenParticipant() {
  link_.cut();
}

std::vector<std::string> DrivenParticipant::command_line(const DrivenOptions& options) const {
  std::string line =
      fmt::format("exec {} --connect 'ipc://{}'", options.command, (place_ / "socket").string());
  if (options.printed == Printed::kept) line += fmt::format(" >'{}' 2>&1", (place_ / "printed").string());
  return {"/bin/sh", "-c", line};
}

std::optional<ProcessEnd> DrivenParticipant::wait_for_end(Seconds patience) {
  process_.wait(patience.count());
  return process_.end();
}

std::string DrivenParticipant::printed() const {
  std::ifstream stream(place_ / "printed");
  return {std::istreambuf_iterator<char>(stream), {}};
}

// ---- what is said -----------------------------------------------------------------------------------

Frames DrivenParticipant::stamped(Message message) {
  EncodedMessage encoded = encode(std::move(message), {options_.run, options_.epoch, sent_++});
  Frames frames;
  frames.emplace_back(encoded.envelope.begin(), encoded.envelope.end());
  const auto body = std::as_bytes(std::span(encoded.body));
  frames.emplace_back(body.begin(), body.end());
  std::move(encoded.arrays.begin(), encoded.arrays.end(), std::back_inserter(frames));
  return frames;
}

bool DrivenParticipant::say(Message message) {
  return say_frames(stamped(std::move(message)));
}

bool DrivenParticipant::say_again(Frames message) {
  Envelope envelope = decode_envelope(message.at(0));
  envelope.sequence = sent_++;
  EnvelopeBytes bytes = encode(envelope);
  std::uint32_t sum = crc32(std::span(bytes).first(envelope_size - sizeof(envelope.checksum)));
  for (std::size_t i = 1; i < message.size(); ++i) sum = crc32(message[i], sum);
  envelope.checksum = sum;
  bytes = encode(envelope);
  message[0].assign(bytes.begin(), bytes.end());
  return say_frames(message);
}

bool DrivenParticipant::say_frames(const Frames& frames) {
  progress_.clear();
  last_said_ = last_sign_ = Clock::now();
  return link_.send(frames);
}

void DrivenParticipant::keep_alive() {
  if (!keeps_alive_ || !greeted_ || Clock::now() - last_sign_ < between_signs) return;
  last_sign_ = Clock::now();
  Message sign(MessageType::progress);
  sign.body = {{"phase", "waiting"}, {"count", 0}};
  link_.send(stamped(std::move(sign)));
}

// ---- what is heard ----------------------------------------------------------------------------------

Heard DrivenParticipant::ask(Message command, Seconds patience) {
  say(std::move(command));
  return hear(patience);
}

Heard DrivenParticipant::hear(Seconds patience) {
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::min(patience, Seconds(1e6)));
  for (;;) {
    if (std::optional<Heard> word = next_word()) return std::move(*word);
    if (process_.end()) {
      const Clock::time_point ended = Clock::now();
      while (!link_.lost() && Seconds(Clock::now() - ended).count() < last_words) {
        if (std::optional<Heard> word = next_word()) return std::move(*word);
        wait_for(link_, -1, std::chrono::milliseconds(5));
      }
      if (std::optional<Heard> word = next_word()) return std::move(*word);
      return *process_.end();
    }
    if (link_.lost()) {
      // What came before the loss is heard first; a process that ends takes its connection with it.
      if (std::optional<Heard> word = next_word()) return std::move(*word);
      if (process_.wait(last_words)) return *process_.end();
      return ConnectionLost{};
    }
    const Clock::time_point now = Clock::now();
    if (now >= deadline) return Silence{};
    keep_alive();
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        std::min<Clock::duration>(deadline - now, std::chrono::milliseconds(100)));
    wait_for(link_, process_.descriptor(), left + std::chrono::milliseconds(1));
  }
}

std::optional<Heard> DrivenParticipant::next_word() {
  while (std::optional<Frames> frames = link_.receive())
    if (std::optional<Heard> word = accept(std::move(*frames))) return word;
  return std::nullopt;
}

std::optional<Heard> DrivenParticipant::accept(Frames&& frames) {
  try {
    last_frames_ = std::move(frames);
    DecodedMessage heard = decoded(last_frames_);
    last_stamp_ = heard.stamp;
    check_.check(heard.stamp, heard.message, greeted_ ? options_.run : RunId{},
                 greeted_ ? options_.epoch : 0);
    greeted_ = true;
    if (heard.message.type == MessageType::progress) {
      note_progress_of(heard.message);
      return std::nullopt;
    }
    if (heard.message.type == MessageType::fail) return ToldFailure{std::move(heard.message)};
    return std::move(heard.message);
  } catch (const Error& fault) {
    return Nonsense{fault.what()};
  }
}

void DrivenParticipant::note_progress_of(const Message& message) {
  HeardProgress progress{.time = Seconds(Clock::now() - last_said_).count(), .phase = {}, .stop_signal = {}};
  if (const auto phase = message.body.find("phase"); phase != message.body.end() && phase->is_string())
    progress.phase = *phase;
  if (const auto signal = message.body.find("stop_signal");
      signal != message.body.end() && signal->is_number_integer())
    progress.stop_signal = signal->get<int>();
  progress_.push_back(std::move(progress));
}

}  // namespace fissura::coupler
