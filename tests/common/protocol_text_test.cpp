// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/common/protocol_text.hpp"

using namespace fissura::test;

TEST_CASE("docs/protocol.md shows the tables that the programs follow", "[common][exchange][table]") {
  const std::string page = content_of(FISSURA_SOURCE_DIR "/docs/protocol.md");
  INFO("the tables have changed: write them anew with BUILD/tests/print_protocol_table docs/protocol.md");
  CHECK((page == with_protocol_text(page)));
}
