// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <fstream>

#include "common/errors.hpp"
#include "coupler/record/run_description.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("the case hash depends on every value of the case but not on the order of its keys",
          "[coupler][record]") {
  const auto hash = [](const char* text) { return case_hash(nlohmann::json::parse(text)); };
  CHECK(hash(R"({"rock": {"e": 1, "nu": 0.2}})") == hash(R"({"rock": {"nu": 0.2, "e": 1}})"));
  CHECK(hash(R"({"rock": {"e": 1, "nu": 0.2}})") !=
        hash(R"({"rock": {"e": 1, "nu": 0.20000000000000001e1}})"));
}

TEST_CASE("run.json says what ran, with which inputs, and tells no folder", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  std::ofstream(folder.path() / "case.toml") << "abc";
  RunDescription description;
  description.run_id = "00ff";
  description.title = "two wings";
  description.effective_case = {{"title", "two wings"}};
  description.input_files = {folder.path() / "case.toml"};
  description.command_line = {"coupler", "run", "case"};
  description.threads = 2;
  description.participants = {{"network", "fissura-network 0.1.0"}};
  description.libraries = {{"SuiteSparse", "5.12.0"}};

  const nlohmann::json json = run_json(description);
  // SHA-256 of "abc": the first example of FIPS 180-2, appendix B.
  CHECK(json["inputs"]["case.toml"] == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(json["case_hash"] == case_hash(description.effective_case));
  CHECK(json["run_id"] == "00ff");
  CHECK(json["threads"] == 2);
  for (const char* library : {"HDF5", "libzmq", "CGAL", "Eigen", "SuiteSparse"}) {
    INFO(library);
    CHECK_FALSE(json["libraries"].value(library, "").empty());
  }
  for (const char* key : {"version", "git_commit", "compiler", "started"}) {
    INFO(key);
    CHECK_FALSE(json.value(key, "").empty());
  }
  CHECK(json.dump().find(folder.path().string()) == std::string::npos);
}

TEST_CASE("an input file that vanished is a storage error", "[coupler][record]") {
  RunDescription description;
  description.input_files = {"/nonexistent/case.toml"};
  CHECK_THROWS_AS(run_json(description), StorageError);
}

TEST_CASE("run.json closes with its own hash: no flipped bit of it goes unseen", "[coupler][record]") {
  RunDescription description;
  description.run_id = "0123";
  description.title = "sample";
  const nlohmann::json content = run_json(description);
  const std::string text = sealed_run_text(content);
  CHECK(opened_run_text(text) == content);
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string damaged = text;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    INFO("byte " << bit / 8 << " bit " << bit % 8);
    CHECK_THROWS_AS(opened_run_text(damaged), StorageError);
  }
}
