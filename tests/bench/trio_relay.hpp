// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "common/exchange/participant.hpp"
#include "coupler/launch/trio.hpp"
#include "coupler/scheme/exchange.hpp"
#include "tests/bench/relay.hpp"

namespace fissura::bench {

/// The coupler's own step: coupling laws, messages, checks and supervision of the staggered scheme, with
/// participants that answer at once.
class TrioRelay : public Relay {
 public:
  /// @param endpoint  ipc://... to bind;  @param program  run as `program ROLE --connect ENDPOINT`, it must
  /// call play
  TrioRelay(const std::string& endpoint, const std::string& program);
  ~TrioRelay() override;

  void set_values(std::size_t count) override;
  void step() override;

 private:
  coupler::StatusPage status_;
  coupler::Trio trio_;
  FractureNetwork network_;
  std::vector<double> compliance_;
  coupler::StructureResponse structure_;
  std::uint64_t interval_ = 0;
};

/// The whole main() of a participant that answers every ADVANCE with as many values as it brought.
int play(Role role, int argc, char** argv);

}  // namespace fissura::bench
