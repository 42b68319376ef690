// SPDX-License-Identifier: GPL-3.0-or-later
// The structure's state in a checkpoint: restored, or refused with the geometry as it was; what was restored
// is saved as the same bytes.
#include "tests/fuzz/judged.hpp"
#include "tests/fuzz/small_rock.hpp"

using namespace fissura;
using namespace fissura::structure;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const StructureModel model = fuzz::small_rock_model();
  static const Geometry of_the_case = build_geometry(model);
  const std::vector<std::byte> bytes = fuzz::copied(data, size);
  fuzz::take_or_refuse([&] {
    Geometry geometry = of_the_case;
    const Snapshot snapshot = restore_snapshot(bytes, model, geometry);
    const std::vector<std::byte> saved = save_snapshot(snapshot, geometry);
    Geometry again = of_the_case;
    MUST_HOLD(save_snapshot(restore_snapshot(saved, model, again), again) == saved);
  });
  return 0;
}
