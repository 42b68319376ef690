// SPDX-License-Identifier: GPL-3.0-or-later
// The structure's state in a checkpoint, once as it is and once under a right checksum: restored or refused; what
// was restored is saved as the same bytes, and can be computed with.
#include "structure/structure_run.hpp"
#include "tests/fuzz/judged.hpp"
#include "tests/fuzz/sample_network.hpp"
#include "tests/fuzz/small_rock.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

std::vector<std::byte> saved(const Snapshot& snapshot, const StateOwner& owner) {
  return save_snapshot(owner, snapshot.history, snapshot.geometry, snapshot.state, snapshot.wet);
}

void restore(const std::vector<std::byte>& bytes, const StateOwner& owner, const StructureModel& model) {
  Snapshot snapshot = restore_snapshot(bytes, owner, model);
  MUST_HOLD(saved(snapshot, owner) == bytes);
  const double step = stable_step(model, snapshot.geometry, snapshot.state);
  fuzz::take_or_refuse([&] { StructureRun(model, snapshot.geometry).advance(0, step, snapshot.state); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const StructureModel model = fuzz::small_rock_model();
  static const StateOwner owner = structure_owner(model.run_case);
  fuzz::take_or_refuse([&] { restore(fuzz::copied(data, size), owner, model); });
  fuzz::take_or_refuse([&] { restore(fuzz::as_state_of(owner, fuzz::bytes_of(data, size)), owner, model); });
  return 0;
}
