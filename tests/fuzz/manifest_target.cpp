// SPDX-License-Identifier: GPL-3.0-or-later
// A manifest as it stands in a file, and the same text under a right seal.
#include "common/hash.hpp"
#include "coupler/checkpoint/manifest.hpp"
#include "tests/fuzz/judged.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

void read(const std::string& text) {
  const Manifest manifest = manifest_from_text(text);
  for (const auto& [state, file] : manifest.files) MUST_HOLD(state.find_first_of("./") == std::string::npos);
  MUST_HOLD(manifest_from_text(manifest_text(manifest)) == manifest);
}

std::string sealed(const std::string& head) {
  return head + "  \"sha256\": \"" + sha256(std::as_bytes(std::span(head))) + "\"\n}\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  fuzz::take_or_refuse([&] { read(text); });
  fuzz::take_or_refuse([&] { read(sealed(text.substr(0, text.rfind("  \"sha256\"")))); });
  return 0;
}
