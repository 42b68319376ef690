// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/checkpoint/sample_checkpoint.hpp"

#include <span>

namespace fissura::coupler::sample {

Provenance provenance() {
  return {"00ff", "abcdef0123456789", "0.1.0 1234567", {{"structure", "t3 1"}, {"network", "newton 1"}}, 2};
}

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

Checkpoint checkpoint(std::uint64_t interval) {
  Checkpoint result;
  result.manifest.provenance = provenance();
  result.manifest.epoch = 1;
  result.manifest.interval = interval;
  result.manifest.time = 0.1 * static_cast<double>(interval);
  result.manifest.revision = 3;
  result.manifest.topology_hash = "77";
  for (const char* state : {"structure", "network", "record"})
    result.states[state] = bytes_of(std::string(state) + " after " + std::to_string(interval));
  result.states["scheme"] = {};
  return result;
}

}  // namespace fissura::coupler::sample
