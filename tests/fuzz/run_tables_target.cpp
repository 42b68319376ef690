// SPDX-License-Identifier: GPL-3.0-or-later
// What a run directory may hold when its run died or its disk is bad: a table, and behind lines "=== NAME"
// catalogue.csv and index.jsonl.
#include "coupler/record/hdf5_file.hpp"
#include "coupler/report/csv_columns.hpp"
#include "coupler/report/field_reports.hpp"
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"
#include "coupler/seismicity/catalogue/raw_records.hpp"
#include "tests/fuzz/folder.hpp"
#include "tests/fuzz/judged.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

void read_table(const std::filesystem::path& file) {
  const CsvColumns table(file);
  for (const std::string& column : table.names()) {
    MUST_HOLD(table.texts(column).size() == table.rows());
    fuzz::take_or_refuse([&] { MUST_HOLD(table.numbers(column).size() == table.rows()); });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::Folder folder;
  folder.fill({reinterpret_cast<const char*>(data), size}, "history.csv", {"catalogue.csv", "index.jsonl"});
  const auto& path = folder.path();
  if (std::filesystem::exists(path / "history.csv"))
    fuzz::take_or_refuse([&] { read_table(path / "history.csv"); });
  if (std::filesystem::exists(path / "catalogue.csv"))
    fuzz::take_or_refuse([&] { (void)read_catalogue_csv(path / "catalogue.csv"); });
  if (std::filesystem::exists(path / "index.jsonl")) {
    std::filesystem::create_directory(path / "segments");
    std::filesystem::rename(path / "index.jsonl", path / "segments" / "index.jsonl");
    fuzz::take_or_refuse([&] {
      FieldReports reports(path);
      for (const FieldReport& report : reports.all())
        fuzz::take_or_refuse([&] { (void)reports.of_report(report, "network/aperture"); });
    });
    fuzz::take_or_refuse(
        [&] { (void)for_each_source_group(path, [](double, const std::vector<SourceRecord>&) {}); });
  }
  return 0;
}
