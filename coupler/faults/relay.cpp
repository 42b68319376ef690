// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/relay.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/errors.hpp"
#include "common/exchange/envelope.hpp"
#include "coupler/faults/forgery.hpp"

namespace fissura::coupler {

namespace {

std::optional<Envelope> envelope_of(const Frames& message) {
  try {
    return message.empty() ? std::nullopt : std::optional(decode_envelope(message[0]));
  } catch (const ProtocolError&) {
    return std::nullopt;
  }
}

bool fits(const MessageFault& fault, Direction direction, const std::optional<Envelope>& envelope) {
  if (fault.direction != direction || !envelope) return false;
  if (fault.type ? envelope->type != *fault.type : envelope->type == MessageType::progress) return false;
  return !fault.interval || envelope->interval == *fault.interval;
}

double size_of(const Frames& message) {
  double bytes = 0;
  for (const auto& frame : message) bytes += static_cast<double>(frame.size());
  return bytes;
}

}  // namespace

Relay::Relay(std::vector<MessageFault> faults, MessageNote note) : note_(std::move(note)) {
  for (MessageFault& fault : faults) {
    if (fault.action == MessageAction::replay) remembered_ = std::max<std::size_t>(remembered_, fault.back);
    faults_.push_back({std::move(fault), 0});
  }
}

void Relay::take(Direction direction, Frames message, double now) {
  if (cut_) return;
  Line& here = line(direction);
  std::string did;
  std::vector<Frames> outgoing{message};
  std::optional<Frames> late = std::exchange(here.held_back, std::nullopt);
  for (const MessageFault* fault : due(direction, message)) {
    if (!did.empty()) did += ", ";
    did += strike(*fault, direction, outgoing, now);
  }
  if (here.deaf && did.empty()) did = "lost: half open";
  note_(direction, message, did);
  if (remembered_ > 0) {
    here.past.push_back(std::move(message));
    if (here.past.size() > remembered_) here.past.pop_front();
  }
  if (here.deaf) return;
  for (Frames& each : outgoing) enqueue(here, std::move(each), now);
  if (late) enqueue(here, std::move(*late), now);
}

std::optional<Frames> Relay::next(Direction direction, double now) {
  Line& here = line(direction);
  if (here.waiting.empty() || here.waiting.front().ready > now) return std::nullopt;
  Frames message = std::move(here.waiting.front().message);
  here.waiting.pop_front();
  return message;
}

std::optional<double> Relay::next_time() const {
  std::optional<double> earliest;
  for (const Line& each : lines_)
    if (!each.waiting.empty())
      earliest = std::min(earliest.value_or(each.waiting.front().ready), each.waiting.front().ready);
  return earliest;
}

std::vector<const MessageFault*> Relay::due(Direction direction, const Frames& message) {
  const std::optional<Envelope> envelope = envelope_of(message);
  std::vector<const MessageFault*> struck;
  for (CountedFault& each : faults_)
    if (fits(each.fault, direction, envelope) && ++each.fitting == each.fault.occurrence)
      struck.push_back(&each.fault);
  return struck;
}

std::string Relay::strike(const MessageFault& fault, Direction direction, std::vector<Frames>& outgoing,
                          double now) {
  Line& here = line(direction);
  std::string done = name_of(fault.action, message_actions);
  if (fault.action == MessageAction::restamp)
    done = fmt::format("{} {}", done, name_of(fault.stamp, stamp_fields));
  if (outgoing.empty()) return done + ": nothing left";
  switch (fault.action) {
    case MessageAction::drop:
      outgoing.clear();
      return done;
    case MessageAction::duplicate:
      outgoing.push_back(outgoing.back());
      return done;
    case MessageAction::swap:
      here.held_back = std::move(outgoing.back());
      outgoing.pop_back();
      return done;
    case MessageAction::delay:
      here.blocked_until = now + fault.seconds;
      return done;
    case MessageAction::clog:
      for (Line& each : lines_) each.blocked_until = now + fault.seconds;
      return done;
    case MessageAction::slow:
      here.bytes_per_second = fault.bytes_per_second;
      return done;
    case MessageAction::half_open:
      here.deaf = true;
      return done;
    case MessageAction::cut:
      cut_ = true;
      outgoing.clear();
      return done;
    case MessageAction::nonsense:
      outgoing.insert(outgoing.begin(), nonsense(fault.bytes.value_or(0)));
      return done;
    default:
      return forge(fault, here, outgoing.back()) ? done : done + ": the message has no such thing";
  }
}

bool Relay::forge(const MessageFault& fault, const Line& line, Frames& message) const {
  switch (fault.action) {
    case MessageAction::truncate:
      return truncate(message, fault.frame, fault.bytes);
    case MessageAction::flip:
      return flip(message, fault.frame, fault.bit);
    case MessageAction::resize:
      return resize(message, fault.field, fault.length);
    case MessageAction::restamp:
      return restamp(message, fault.stamp, fault.stamp_value, fault.shift);
    case MessageAction::relabel:
      return relabel(message, fault.field, fault.unit);
    case MessageAction::oversize:
      return oversize(message, fault.bytes.value_or(0));
    case MessageAction::poison:
      return fault.entry.empty() ? poison(message, fault.field, fault.index, fault.value)
                                 : poison(message, fault.entry, fault.value);
    case MessageAction::replay: {
      if (line.past.size() < fault.back) return false;
      const std::optional<Envelope> current = envelope_of(message);
      message = line.past[line.past.size() - fault.back];
      return fault.as == ReplayAs::old ||
             (current && restamp(message, StampField::sequence, current->sequence, 0));
    }
    default:
      return false;
  }
}

void Relay::enqueue(Line& line, Frames message, double now) {
  double ready = std::max(now, line.blocked_until);
  if (!line.waiting.empty()) ready = std::max(ready, line.waiting.back().ready);
  if (line.bytes_per_second > 0) {
    ready += size_of(message) / line.bytes_per_second;
    line.blocked_until = ready;
  }
  line.waiting.push_back({std::move(message), ready});
}

}  // namespace fissura::coupler
