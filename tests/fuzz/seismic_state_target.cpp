// SPDX-License-Identifier: GPL-3.0-or-later
// Open seismic clusters in a checkpoint: restored or refused; what was restored goes on, ends and is saved.
#include "coupler/seismicity/extraction.hpp"
#include "tests/coupler/seismicity/sample_sources.hpp"
#include "tests/fuzz/judged.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

void restore(const std::vector<std::byte>& bytes) {
  Extraction extraction(test::shale_controls());
  extraction.restore(bytes);
  (void)extraction.open_moment();
  Extraction again(test::shale_controls());
  again.restore(extraction.save());
  MUST_HOLD(again.save() == extraction.save());
  (void)extraction.advance(1, {test::slip_record(1, 0.99, {0, 0})});
  (void)extraction.finish();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::take_or_refuse([&] { restore(fuzz::copied(data, size)); });
  return 0;
}
