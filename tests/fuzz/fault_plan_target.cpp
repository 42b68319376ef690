// SPDX-License-Identifier: GPL-3.0-or-later
// A fault plan of the user.
#include "coupler/faults/fault_plan.hpp"
#include "tests/fuzz/folder.hpp"
#include "tests/fuzz/judged.hpp"

using namespace fissura;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::Folder folder;
  folder.fill({reinterpret_cast<const char*>(data), size}, "plan.toml", {});
  fuzz::take_or_refuse([&] {
    const coupler::FaultPlan plan = coupler::read_fault_plan(folder.path() / "plan.toml");
    (void)plan.relays("network");
  });
  return 0;
}
