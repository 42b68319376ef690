// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "common/errors.hpp"
#include "common/exchange/codec.hpp"

namespace fissura {

/// Run, epoch and gap-free sequence of one direction.
class StampCheck {
 public:
  /// Throws ProtocolError for a message of another run or epoch, and for one that is not the next. A FAIL may
  /// lack the run: its sender may have failed before WELCOME told it.
  void check(const Stamp& stamp, const Message& message, const RunId& run, std::uint32_t epoch) {
    const auto label = [&] { return fmt::format("{} of interval {}", name(message.type), message.interval); };
    const bool knows_no_run = message.type == MessageType::fail && stamp.run == RunId{};
    if (stamp.run != run && !knows_no_run) throw ProtocolError(label() + " belongs to another run");
    if (stamp.epoch != epoch && !knows_no_run)
      throw ProtocolError(
          fmt::format("{} belongs to epoch {}, this is epoch {}", label(), stamp.epoch, epoch));
    if (stamp.sequence > expected_)
      throw ProtocolError(
          fmt::format("{} message(s) before {} were lost", stamp.sequence - expected_, label()));
    if (stamp.sequence < expected_) throw ProtocolError(label() + " came twice");
    ++expected_;
  }

 private:
  std::uint64_t expected_ = 0;
};

}  // namespace fissura
