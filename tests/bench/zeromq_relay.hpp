// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "tests/bench/relay.hpp"

namespace fissura::bench {

/// Bare ZeroMQ: one ROUTER, two DEALERs in processes of their own, one frame per array. The sender copies its
/// values into the frame, the receiver reads them where they arrive. No envelope, no JSON, no checksum, no
/// deadline.
class ZeromqRelay : public Relay {
 public:
  /// @param endpoint  ipc://... to bind
  explicit ZeromqRelay(const std::string& endpoint);
  ~ZeromqRelay() override;

  void set_values(std::size_t count) override;
  void step() override;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fissura::bench
