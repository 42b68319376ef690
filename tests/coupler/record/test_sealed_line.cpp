// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/errors.hpp"
#include "coupler/record/sealed_line.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("a sealed line is JSON with its checksum, and no flipped bit goes unseen", "[coupler][record]") {
  const nlohmann::ordered_json object{{"file", "000001.h5"}, {"bytes", 1234}};
  const std::string line = sealed_line(object);
  CHECK(line.starts_with(R"({"file":"000001.h5","bytes":1234,"crc32":")"));
  CHECK(opened_line(line).at("bytes") == 1234);
  for (std::size_t position = 0; position < line.size(); ++position)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = line;
      damaged[position] = static_cast<char>(damaged[position] ^ (1 << bit));
      CHECK_THROWS_AS(opened_line(damaged), StorageError);
    }
  for (std::size_t length = 0; length < line.size(); ++length)
    CHECK_THROWS_AS(opened_line(line.substr(0, length)), StorageError);
}
