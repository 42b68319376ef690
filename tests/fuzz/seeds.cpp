// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_seeds DIRECTORY: writes DIRECTORY/TARGET/NAME, sound inputs in the formats of this build, but for the structure.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "common/case/case_json.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/checkpoint/manifest.hpp"
#include "coupler/checkpoint/neutral_network.hpp"
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"
#include "coupler/seismicity/extraction.hpp"
#include "structure/joints/network_topology.hpp"
#include "tests/coupler/seismicity/sample_sources.hpp"
#include "tests/coupler/record/scripted_run.hpp"
#include "tests/fuzz/folder.hpp"
#include "tests/fuzz/judged.hpp"
#include "tests/fuzz/raw_frames.hpp"
#include "tests/fuzz/sample_network.hpp"
#include "tests/network/messaged_network.hpp"

using namespace fissura;

namespace fs = std::filesystem;

namespace {

fs::path out;

void write(const std::string& target, const std::string& name, std::span<const std::byte> bytes) {
  fs::create_directories(out / target);
  std::ofstream(out / target / name, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write(const std::string& target, const std::string& name, const std::string& text) {
  write(target, name, std::as_bytes(std::span(text)));
}

void write_message(const std::string& name, const Message& message) {
  write("message", name, fuzz::bytes_of(fuzz::frames_of(encode(message, {{1, 2, 3}, 0, 7}))));
}

void write_messages() {
  const FractureNetwork network = fuzz::network_of(fuzz::first_insertion(3));
  write_message("pressure", fuzz::pressure_message(network));
  write_message("response", fuzz::response_message(network));
  write_message("advance", fuzz::advance_message(network, 0, 0.1));
  Message insert(MessageType::insert);
  insert.body["insertion"] = insertion_to_json(fuzz::growth(3));
  write_message("insert", insert);
  Message fail(MessageType::fail);
  fail.body = {{"role", "network"}, {"phase", "newton"}, {"reason", "no convergence"}, {"exit_code", 24}};
  write_message("fail", fail);
}

/// A blob, and what is inside it.
void write_state(const char* target, const std::string& name, const StateOwner& owner, const std::vector<std::byte>& blob) {
  write(target, name, blob);
  const auto inside = state_inside(blob, owner);
  write(target, name + "_inside", std::vector<std::byte>(inside.begin(), inside.end()));
}

void write_network() {
  const Insertion first = fuzz::first_insertion(5), second = fuzz::growth(5);
  write("insertions", "two", nlohmann::json{insertion_to_json(first), insertion_to_json(second)}.dump());
  network::test::MessagedNetwork solver;
  solver.join({case_to_json(fuzz::water_case()), 1, false});
  (void)solver.insert(first);
  const StateOwner owner = solver.owner();
  write_state("network_state", "dry", owner, solver.save());
  FractureNetwork network = fuzz::network_of(first);
  (void)solver.advance(fuzz::advance_message(network, 0, 0.1));
  (void)solver.insert(second);
  write_state("network_state", "grown", owner, solver.save());
}

void write_seismicity() {
  using namespace coupler;
  Extraction extraction(test::shale_controls());
  const std::vector<SourceRecord> records = test::random_records(1, 3);
  const std::vector<SeismicEvent> events = test::events_of(test::shale_controls(), records);
  (void)extraction.advance(0.03, test::random_records(1, 3));
  write("seismic_state", "open", extraction.save());
  const CatalogueContext context{"12ab", "fuzz", "2026-01-01T00:00:00Z", test::shale_controls(), {}};
  std::string table = csv_header();
  for (std::size_t i = 0; i < std::min<std::size_t>(events.size(), 3); ++i)
    table += csv_line(events[i], context);
  write("run_tables", "catalogue", "=== catalogue.csv\n" + table);
}

/// The run of the target, saved where a segment is open.
void write_record() {
  const fuzz::Folder folder;
  coupler::RunRecord record(folder.path(), coupler::sample::reports_per_segment);
  record.begin(coupler::sample::description());
  coupler::sample::record_intervals(record, 1, 3);
  write("record_state", "open", record.save());
  coupler::sample::record_intervals(record, 4, 6);
  write("record_state", "closed", record.save());
}

void write_manifest() {
  coupler::Manifest manifest;
  manifest.provenance = {
      "00ff", "ab12", "0.1.0 1234567", {{"structure", "t3 1"}, {"network", "newton 1"}}, 2};
  manifest.interval = 42;
  manifest.time = 1.0 / 3;
  manifest.topology_hash = std::string(64, '7');
  manifest.files = {{"structure", {123, std::string(64, 'a')}}, {"scheme", {0, std::string(64, 'b')}}};
  write("manifest", "two_states", coupler::manifest_text(manifest));
  manifest.files[coupler::neutral_network] = {321, std::string(64, 'c')};
  write("manifest", "neutral_network", coupler::manifest_text(manifest));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "fuzz_seeds DIRECTORY\n";
    return 2;
  }
  out = argv[1];
  write_messages();
  write_network();
  write_seismicity();
  write_record();
  write_manifest();
  return 0;
}
