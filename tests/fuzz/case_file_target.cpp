// SPDX-License-Identifier: GPL-3.0-or-later
// A case folder: case.toml and, behind lines "=== NAME", short.toml, traces.csv, reference.csv and
// expected.toml. A case that is read must survive the way to the participants.
#include <nlohmann/json.hpp>

#include "common/case/case_json.hpp"
#include "common/case/expected.hpp"
#include "common/case/read_case.hpp"
#include "coupler/verdict/reference_table.hpp"
#include "tests/fuzz/folder.hpp"
#include "tests/fuzz/judged.hpp"

using namespace fissura;

namespace {

constexpr std::size_t largest_input = 16384;

void read(const CaseSource& source) {
  const CaseReading reading = read_case(source);
  const nlohmann::json json = case_to_json(reading.value);
  MUST_HOLD(case_to_json(case_from_json(json)).dump() == json.dump());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::Folder folder;
  if (size > largest_input) return 0;
  folder.fill({reinterpret_cast<const char*>(data), size}, "case.toml",
              {"short.toml", "traces.csv", "reference.csv", "expected.toml"});
  fuzz::take_or_refuse([&] { read({folder.path(), {}, {}}); });
  if (std::filesystem::exists(folder.path() / "short.toml"))
    fuzz::take_or_refuse([&] { read({folder.path(), {"short"}, {}}); });
  const HistoryColumn columns[] = {{"half_length", "m"}, {"inlet_net_pressure", "Pa"}, {"mismatch", "1"}};
  if (std::filesystem::exists(folder.path() / "expected.toml"))
    fuzz::take_or_refuse([&] { (void)read_expectations(folder.path() / "expected.toml", 10, columns); });
  if (std::filesystem::exists(folder.path() / "reference.csv"))
    fuzz::take_or_refuse(
        [&] { (void)coupler::ReferenceTable(folder.path() / "reference.csv").series("half_length"); });
  return 0;
}
