// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/bisect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/errors.hpp"
#include "coupler/tape/message_difference.hpp"
#include "coupler/tape/network_places.hpp"
#include "coupler/tape/tape_reader.hpp"

namespace fissura::coupler {

namespace {

/// A tape without PROGRESS.
class Conversation {
 public:
  explicit Conversation(const std::filesystem::path& file) : tape_(file) { advance(); }

  [[nodiscard]] const TapeReader& tape() const { return tape_; }
  [[nodiscard]] const std::optional<TapeRecord>& now() const { return now_; }
  [[nodiscard]] std::optional<MessageType> type() const {
    return now_ ? std::optional(envelope_of(now_->frames).type) : std::nullopt;
  }

  void advance() {
    do {
      now_ = tape_.next();
      if (now_ && now_->damaged)
        throw StorageError(fmt::format("{}: message {} ({}) at byte {} is not what was written",
                                       tape_.file().string(), now_->number, title_of(now_->frames),
                                       now_->offset));
    } while (type() == MessageType::progress);
  }

  /// Past SAVE and STATE.
  void skip_checkpoint() {
    advance();
    if (type() == MessageType::state) advance();
  }

 private:
  TapeReader tape_;
  std::optional<TapeRecord> now_;
};

void skip_checkpoints_of_one(Conversation& a, Conversation& b) {
  for (;;) {
    const bool in_a = a.type() == MessageType::save, in_b = b.type() == MessageType::save;
    const bool same_place =
        in_a && in_b && envelope_of(a.now()->frames).interval == envelope_of(b.now()->frames).interval;
    if (same_place || (!in_a && !in_b)) return;
    if (in_a && in_b && envelope_of(a.now()->frames).interval > envelope_of(b.now()->frames).interval)
      b.skip_checkpoint();
    else
      (in_a ? a : b).skip_checkpoint();
  }
}

Sides sides_of(const Conversation& a, const Conversation& b) {
  return {.first = a.tape().file().string(), .second = b.tape().file().string()};
}

std::string end_of(const Conversation& conversation) {
  return conversation.tape().cut_bytes() > 0 ? "ends in the middle of a message" : "has ended";
}

const char* speaker(Direction direction, Role role) {
  return direction == Direction::to_participant ? "the coupler" : name(role);
}

}  // namespace

TapeComparison compare_tapes(const std::filesystem::path& first, const std::filesystem::path& second) {
  Conversation a(first), b(second);
  if (a.tape().header().role != b.tape().header().role)
    throw Error(ExitCode::precondition,
                fmt::format("{} and {} are tapes of different roles", first.string(), second.string()));
  TapeComparison comparison{a.tape().header().role, 0, 0, {}};
  NetworkPlaces places;
  double last_time = 0;
  for (;; a.advance(), b.advance()) {
    skip_checkpoints_of_one(a, b);
    if (!a.now() && !b.now()) return comparison;
    if (!a.now() || !b.now()) {
      const Conversation &ended = a.now() ? b : a, &other = a.now() ? a : b;
      comparison.parting = {
          Parting::How::ends, other.now()->direction, a.now() ? a.now()->time : last_time,
          fmt::format("  {} {}; {} goes on with {}\n", ended.tape().file().string(), end_of(ended),
                      other.tape().file().string(), title_of(other.now()->frames))};
      return comparison;
    }
    const TapeRecord &x = *a.now(), &y = *b.now();
    places.follow(x.frames);
    if (const auto found = difference(x.frames, y.frames); found || x.direction != y.direction) {
      const MessageDifference what = found
                                         ? *found
                                         : MessageDifference{.where = "speaker",
                                                             .first = speaker(x.direction, comparison.role),
                                                             .second = speaker(y.direction, comparison.role),
                                                             .ulps = {},
                                                             .distance = 0,
                                                             .array = {}};
      comparison.parting = {Parting::How::differs, x.direction, x.time,
                            fmt::format("  {} by {}, messages {} and {} of the tapes:\n", title_of(x.frames),
                                        speaker(x.direction, comparison.role), x.number, y.number) +
                                in_words(what, places.place(x.frames, what.array, what.row), sides_of(a, b))};
      return comparison;
    }
    ++comparison.identical;
    comparison.interval = std::max(comparison.interval, envelope_of(x.frames).interval);
    last_time = x.time;
  }
}

std::string verdict_of(const std::vector<TapeComparison>& comparisons) {
  const TapeComparison* first = nullptr;
  for (const TapeComparison& each : comparisons)
    if (each.parting && (first == nullptr || each.parting->time < first->parting->time)) first = &each;
  if (first == nullptr) return "the tapes say the same\n";
  const char* role = name(first->role);
  if (first->parting->how == Parting::How::ends)
    return fmt::format("one tape of {} ends earlier; up to there all is the same\n", role);
  if (first->parting->direction == Direction::to_coupler)
    return fmt::format("{} said it first: it had been told the same and answers something else\n", role);
  if (comparisons.size() == role_count)
    return fmt::format("the coupler said it first: up to there both participants had said the same\n");
  return fmt::format(
      "{} did not say it first: it was told something else, by the coupler or because of the other "
      "participant "
      "(not compared)\n",
      role);
}

}  // namespace fissura::coupler
