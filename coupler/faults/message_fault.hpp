// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/case/names.hpp"
#include "common/case/table_reader.hpp"
#include "common/exchange/message.hpp"

/// What a fault plan makes of the messages between the coupler and one participant (docs/operation.md,
/// "Injecting faults").
namespace fissura::coupler {

enum class Direction { to_participant, to_coupler };

enum class MessageAction {
  drop,
  duplicate,  ///< sent twice
  swap,       ///< goes after the next message of its direction
  delay,      ///< held for `seconds`, and what comes behind it
  clog,       ///< the same in both directions
  truncate,   ///< frame `frame` keeps its first `bytes` bytes, or half of them
  flip,       ///< bit `bit` of frame `frame` is inverted
  resize,     ///< array `field` gets `length` values, zeros if there were fewer; the checksum is made to fit
  restamp,    ///< envelope field `stamp` becomes `value`, or changes by `shift`; the checksum is made to fit
  poison,   ///< value `index` of array `field`, or body entry `entry`, becomes `value`; the checksum is made
            ///< to fit
  relabel,  ///< array `field` is declared in `unit`; the checksum is made to fit
  replay,   ///< the message `back` messages before it in its direction goes instead, as `as` says
  cut,      ///< both connections end; the message is lost
  half_open,  ///< nothing more gets through in this direction
  oversize,   ///< the last frame grows to `bytes` bytes; the checksum is made to fit
  slow,       ///< from now on this direction carries `bytes_per_second`
  nonsense    ///< before it comes one frame of `bytes` bytes that mean nothing
};

/// The fields of the envelope that can be forged.
enum class StampField { major, minor, type, run, epoch, sequence, interval, revision };

/// How an old message comes again: byte for byte, or with the sequence number of the one it replaces.
enum class ReplayAs { old, current };

inline constexpr std::array directions{Named<Direction>{"to_participant", Direction::to_participant},
                                       Named<Direction>{"to_coupler", Direction::to_coupler}};

inline constexpr std::array message_actions{Named<MessageAction>{"drop", MessageAction::drop},
                                            Named<MessageAction>{"duplicate", MessageAction::duplicate},
                                            Named<MessageAction>{"swap", MessageAction::swap},
                                            Named<MessageAction>{"delay", MessageAction::delay},
                                            Named<MessageAction>{"clog", MessageAction::clog},
                                            Named<MessageAction>{"truncate", MessageAction::truncate},
                                            Named<MessageAction>{"flip", MessageAction::flip},
                                            Named<MessageAction>{"resize", MessageAction::resize},
                                            Named<MessageAction>{"restamp", MessageAction::restamp},
                                            Named<MessageAction>{"poison", MessageAction::poison},
                                            Named<MessageAction>{"relabel", MessageAction::relabel},
                                            Named<MessageAction>{"replay", MessageAction::replay},
                                            Named<MessageAction>{"cut", MessageAction::cut},
                                            Named<MessageAction>{"half_open", MessageAction::half_open},
                                            Named<MessageAction>{"oversize", MessageAction::oversize},
                                            Named<MessageAction>{"slow", MessageAction::slow},
                                            Named<MessageAction>{"nonsense", MessageAction::nonsense}};

inline constexpr std::array stamp_fields{
    Named<StampField>{"major", StampField::major},       Named<StampField>{"minor", StampField::minor},
    Named<StampField>{"type", StampField::type},         Named<StampField>{"run", StampField::run},
    Named<StampField>{"epoch", StampField::epoch},       Named<StampField>{"sequence", StampField::sequence},
    Named<StampField>{"interval", StampField::interval}, Named<StampField>{"revision", StampField::revision}};

inline constexpr std::array replay_kinds{Named<ReplayAs>{"old", ReplayAs::old},
                                         Named<ReplayAs>{"current", ReplayAs::current}};

struct MessageFault {
  std::string role;  ///< "structure" or "network": whose messages
  Direction direction = Direction::to_coupler;
  std::optional<MessageType> type;         ///< any but PROGRESS without a value
  std::optional<std::uint64_t> interval;   ///< as its envelope says; any without a value
  std::optional<std::uint64_t> epoch = 0;  ///< how often the run has been resumed; any without a value
  std::uint64_t occurrence = 1;            ///< strikes the n-th message that fits
  MessageAction action = MessageAction::drop;

  double seconds = 0;                  ///< wall, of delay and clog [s]
  std::optional<std::uint64_t> frame;  ///< 0 envelope, 1 body, then arrays; the last one without a value
  std::optional<std::uint64_t> bytes;
  std::uint64_t bit = 0;
  std::uint64_t length = 0;
  std::string field;  ///< name of an array
  std::string unit;
  std::string entry;  ///< of the body, as a JSON pointer: "/ledger/injected"
  std::uint64_t index = 0;
  double value = 0;
  StampField stamp = StampField::sequence;
  std::optional<std::uint64_t> stamp_value;
  std::int64_t shift = 0;
  std::uint64_t back = 1;
  ReplayAs as = ReplayAs::old;
  double bytes_per_second = 0;
};

/// The tables [[message]] of a fault plan; what is wrong with them goes to the list of `document`.
std::vector<MessageFault> read_message_faults(input::TableReader& document);

}  // namespace fissura::coupler
