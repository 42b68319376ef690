// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "tests/coupler/checkpoint/sample_checkpoint.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

Manifest sample_manifest() {
  Manifest manifest = sample::checkpoint(42).manifest;
  manifest.time = 1.0 / 3;
  manifest.files = {{"structure", {123, std::string(64, 'a')}}, {"network", {0, std::string(64, 'b')}}};
  return manifest;
}

/// `text` with other words in it, and sealed again.
std::string forged(const std::string& text, const std::string& word, const std::string& other) {
  std::string head = text.substr(0, text.rfind("  \"sha256\""));
  head.replace(head.find(word), word.size(), other);
  return head + "  \"sha256\": \"" + sha256(sample::bytes_of(head)) + "\"\n}\n";
}

}  // namespace

TEST_CASE("a manifest comes back with every bit", "[coupler][checkpoint]") {
  const Manifest manifest = sample_manifest();
  CHECK(manifest_from_text(manifest_text(manifest)) == manifest);
}

TEST_CASE("no flipped bit, missing or added byte of a manifest goes unseen", "[coupler][checkpoint]") {
  const std::string sound = manifest_text(sample_manifest());
  for (std::size_t position = 0; position < sound.size(); ++position)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = sound;
      damaged[position] = static_cast<char>(damaged[position] ^ (1 << bit));
      CHECK_THROWS_AS(manifest_from_text(damaged), Error);
    }
  for (std::size_t length = 0; length < sound.size(); ++length)
    CHECK_THROWS_AS(manifest_from_text(sound.substr(0, length)), Error);
  CHECK_THROWS_AS(manifest_from_text(sound + "\n"), Error);
}

TEST_CASE("a sealed manifest of another schema, or with a name that is a path, is refused",
          "[coupler][checkpoint]") {
  const std::string sound = manifest_text(sample_manifest());
  REQUIRE_NOTHROW(manifest_from_text(forged(sound, "\"epoch\": 1", "\"epoch\": 7")));
  CHECK_THROWS_WITH(manifest_from_text(forged(sound, "\"schema\": 1", "\"schema\": 2")),
                    Catch::Contains("schema 2"));
  CHECK_THROWS_WITH(manifest_from_text(forged(sound, "\"structure\": {", "\"../../etc\": {")),
                    Catch::Contains("no name of a state"));
  CHECK_THROWS_WITH(manifest_from_text(forged(sound, "\"interval\"", "\"intervals\"")),
                    Catch::Contains("not complete") && Catch::Contains("interval"));
}

TEST_CASE("a checkpoint is of the same run only if run, case, program and structure are the same",
          "[coupler][checkpoint]") {
  const Provenance wrote = sample::provenance();
  Provenance run = wrote;
  run.threads = 7;
  CHECK_FALSE(mismatch(wrote, run));
  run.participants.clear();
  CHECK_FALSE(mismatch(wrote, run));
  run = wrote;
  run.run_id = "00fe";
  CHECK_THAT(mismatch(wrote, run).value(), Catch::Contains("another run"));
  run = wrote;
  run.case_hash = "0";
  CHECK_THAT(mismatch(wrote, run).value(), Catch::Contains("another case"));
  run = wrote;
  run.program = "0.1.0 7654321";
  CHECK_THAT(mismatch(wrote, run).value(), Catch::Contains("another program"));
  run = wrote;
  run.participants["structure"] = "t3 2";
  CHECK_THAT(mismatch(wrote, run).value(), Catch::Contains("another structure"));
  run = wrote;
  run.participants["network"] = "newton 2";
  CHECK_FALSE(mismatch(wrote, run));
}

TEST_CASE("another flow solver is one of another name or version, or of a newer command",
          "[coupler][checkpoint]") {
  const Manifest wrote = sample_manifest();
  CHECK_FALSE(network_change(wrote, "newton 1", 0));
  CHECK_FALSE(network_change(wrote, "newton 1", wrote.epoch));
  const auto newer = network_change(wrote, "newton 2", 0);
  REQUIRE(newer);
  CHECK(newer->interval == wrote.interval);
  CHECK(newer->time == wrote.time);
  CHECK(newer->from == "newton 1");
  CHECK(newer->to == "newton 2");
  CHECK(network_change(wrote, "newton 1", wrote.epoch + 1));
}
