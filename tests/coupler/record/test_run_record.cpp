// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "coupler/record/run_directory.hpp"
#include "coupler/record/run_record.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

RunDescription description(const std::filesystem::path& input) {
  RunDescription result;
  result.run_id = "0123";
  result.title = "sample";
  result.effective_case = {{"title", "sample"}};
  result.input_files = {input};
  return result;
}

}  // namespace

TEST_CASE("a run leaves exactly the files that docs/results.md lists", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  std::ofstream(folder.path() / "case.toml") << "schema = 1\n";
  const FractureNetwork network = sample::network();
  {
    const RunDirectory directory(folder.path() / "run");
    RunRecord record(directory.path(), 20);
    record.begin(description(folder.path() / "case.toml"));
    record.topology(network);
    record.interval(sample::interval(1, 0.5), {});
    record.fields(0.5, sample::structure_fields(0.5, 0, 0), sample::network_fields(network), network,
                  sample::node_fields(network, 0.5));
    record.event(EventLevel::info, "network", "halving", "once");
    CHECK(record.history().size() == 1);
    record.finish({{"verdict", "none"}});
  }

  std::set<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "run"))
    if (entry.is_regular_file()) found.insert(std::filesystem::relative(entry.path(), folder.path() / "run"));
  CHECK(found == std::set<std::string>{"SHA256SUMS", "columns.json", "effective_case.json", "fields.xdmf",
                                       "fractures.xdmf", "history.csv", "input/case.toml", "ledger.csv",
                                       "lock", "log.jsonl", "run.json", "segments/000001.h5",
                                       "segments/index.jsonl", "summary.json"});
  CHECK(sample::lines(folder.path() / "run" / "history.csv").size() == 2);
  CHECK(nlohmann::json::parse(sample::content(folder.path() / "run" / "summary.json"))["verdict"] == "none");
  const auto events = sample::lines(folder.path() / "run" / "log.jsonl");
  REQUIRE(events.size() == 2);
  CHECK(nlohmann::json::parse(events[1])["interval"] == 1);
  CHECK(nlohmann::json::parse(events[1])["time"] == 0.5);
}

TEST_CASE("a finished run may be replaced by a new one in the same directory", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  std::ofstream(folder.path() / "case.toml") << "schema = 1\n";
  for (int run = 0; run < 2; ++run) {
    const RunDirectory directory(folder.path() / "run");
    RunRecord record(directory.path(), 20);
    record.begin(description(folder.path() / "case.toml"));
    record.finish({{"verdict", "pass"}});
  }
  CHECK(sample::lines(folder.path() / "run" / "history.csv").size() == 1);
}
