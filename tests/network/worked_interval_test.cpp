// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "network/content_ledger.hpp"
#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;

namespace {

/// Six digits are printed, so the seventh may be off by one half.
constexpr double printed_digits = 1e-6;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line.substr(1));
  for (std::string cell; std::getline(text, cell, '|');) {
    const auto begin = cell.find_first_not_of(" `"), end = cell.find_last_not_of(" `");
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

/// A table of the page, by the words of its first row.
using Table = std::map<std::string, std::vector<std::string>>;

/// The table that follows the line "Table `number`:" of docs/flow_solvers.md.
Table printed_table(const std::string& number) {
  std::ifstream page(FISSURA_SOURCE_DIR "/docs/flow_solvers.md");
  std::string line;
  while (std::getline(page, line) && line.rfind("Table " + number + ":", 0) != 0) {
  }
  while (std::getline(page, line) && line.rfind("|", 0) != 0) {
  }
  REQUIRE(page);
  const std::vector<std::string> names = cells_of(line);
  std::getline(page, line);
  Table table;
  while (std::getline(page, line) && line.rfind("|", 0) == 0) {
    const std::vector<std::string> cells = cells_of(line);
    for (std::size_t k = 0; k < names.size(); ++k) table[names[k]].push_back(cells.at(k));
  }
  return table;
}

std::vector<double> numbers(const Table& table, const std::string& column) {
  std::vector<double> values;
  for (const std::string& cell : table.at(column)) values.push_back(std::stod(cell));
  return values;
}

double entry(const Table& table, const std::string& key) {
  for (std::size_t k = 0; k < table.at("what").size(); ++k)
    if (table.at("what")[k] == key) return std::stod(table.at("value")[k]);
  FAIL("the page does not say " << key);
  return 0;
}

Model model_of(const Table& table) {
  Model model;
  model.fluids.push_back({"fluid", {entry(table, "mu"), 1}, entry(table, "K_f")});
  model.leak_off = {entry(table, "C_l"), 0};
  model.thickness = entry(table, "H");
  model.well_index = entry(table, "WI");
  model.minimum_aperture = entry(table, "e_min");
  model.schedule = test::constant_rate(entry(table, "rate") / model.thickness);
  model.tolerance = 1e-12;
  model.maximum_iterations = 100;
  return model;
}

Insertion first_topology() {
  Insertion slit;
  slit.new_nodes = {{.id = 30, .x = 0, .lumped_length = 0.5, .fracture = 1, .role = NodeRole::perforation},
                    {.id = 20, .x = 1, .lumped_length = 1, .fracture = 1},
                    {.id = 10, .x = 2, .lumped_length = 0.5, .fracture = 1, .role = NodeRole::tip}};
  slit.new_segments = {{.id = 7, .node_a = 30, .node_b = 20, .fracture = 1, .length = 1},
                       {.id = 8, .node_a = 10, .node_b = 20, .fracture = 1, .length = 1}};
  slit.new_perforations = {{"well", 30}};
  return slit;
}

Insertion growth() {
  Insertion growth;
  growth.revision = 1;
  growth.updated_nodes = {{.id = 10, .x = 2, .lumped_length = 1, .fracture = 1}};
  growth.new_nodes = {
      {.id = 40, .x = 3, .lumped_length = 0.5, .fracture = 1, .role = NodeRole::tip, .exposure_time = 0.1}};
  growth.parents = {{40, 10}};
  growth.new_segments = {{.id = 9, .node_a = 10, .node_b = 40, .fracture = 1, .length = 1}};
  return growth;
}

void set_interval(const Table& table, Interval& interval) {
  interval.aperture = numbers(table, "aperture");
  interval.reference_pressure = numbers(table, "reference_pressure");
  interval.compliance = numbers(table, "compliance");
}

void require_printed(const std::vector<double>& values, const Table& table, const std::string& column) {
  const std::vector<double> printed = numbers(table, column);
  REQUIRE(values.size() == printed.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    INFO(column << ", row " << k + 1);
    CHECK(values[k] == Approx(printed[k]).epsilon(printed_digits).margin(1e-30));
  }
}

void require_answer(const test::FlowSetup& flow, const Table& segments, const Table& nodes,
                    const Table& ledger) {
  require_printed(flow.workspace.step.transmissibility, segments, "T");
  require_printed(flow.state.flux, segments, "flux");
  std::vector<double> predicted;
  for (std::size_t i = 0; i < flow.graph.node_count(); ++i)
    predicted.push_back(predicted_aperture(flow.workspace.step.storage[i], flow.state.pressure[i]));
  require_printed(flow.state.pressure, nodes, "pressure");
  require_printed(predicted, nodes, "aperture_predicted");
  require_printed(flow.state.filled, nodes, "filled");
  require_printed(flow.workspace.step.demand, nodes, "demand");
  require_printed(flow.state.content, nodes, "content");
  require_printed(flow.state.leaked, nodes, "leaked");

  const FluidLedger report = ledger_report(flow.model, flow.graph, flow.state);
  require_printed({report.injected, report.in_place, report.in_fractures, report.leaked, report.found,
                   report.reset, flow.state.well_pressure},
                  ledger, "value");
  CHECK(std::abs(report.residual()) < 1e-15);
}

}  // namespace

TEST_CASE("the worked intervals of docs/flow_solvers.md are what the solver answers", "[network]") {
  test::FlowSetup flow(model_of(printed_table("7a")), first_topology());
  CHECK(printed_table("7b").at("hash")[0] == flow.graph.network().topology_hash());

  set_interval(printed_table("7c"), flow.interval);
  (void)flow.advance(0.1);
  require_answer(flow, printed_table("7d"), printed_table("7e"), printed_table("7f"));

  flow.insert(growth());
  CHECK(printed_table("7b").at("hash")[1] == flow.graph.network().topology_hash());
  require_printed(flow.state.content, printed_table("7g"), "content");
  require_printed(flow.state.leaked, printed_table("7g"), "leaked");

  set_interval(printed_table("7h"), flow.interval);
  (void)flow.advance(0.1);
  require_answer(flow, printed_table("7i"), printed_table("7j"), printed_table("7k"));
}
