// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/remesh_ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "common/exact_json.hpp"
#include "coupler/record/csv_cell.hpp"

namespace fissura::coupler {

namespace {

constexpr const char *table_name = "remeshing.csv", *wall_times_name = "remeshing_wall.csv";
constexpr const char* header =
    "revision,time,fracture,x,y,elements_removed,elements_made,elements_untouched,hash_before,hash_after,"
    "smallest_angle,"
    "smallest_altitude,stable_step_before,stable_step_after,strain_energy_before,strain_energy_after,"
    "kinetic_energy_before,kinetic_energy_after,mass_error,momentum_error\n";

double number(const nlohmann::json& object, const char* key) {
  const double value = object.at(key).get<double>();
  if (!std::isfinite(value)) throw ProtocolError(fmt::format("remeshing.{} is {}", key, value));
  return value;
}

double median(std::vector<std::uint64_t> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  if (values.size() % 2 == 1) return static_cast<double>(values[middle]);
  return (static_cast<double>(values[middle - 1]) + static_cast<double>(values[middle])) / 2;
}

}  // namespace

std::uint64_t Remeshing::touched() const {
  return std::max(elements_removed, elements_made);
}

Remeshing remeshing_from_json(const nlohmann::json& object) {
  try {
    Remeshing entry;
    entry.fracture = object.at("fracture").get<std::string>();
    entry.x = number(object, "x");
    entry.y = number(object, "y");
    entry.elements_removed = exactly<std::uint64_t>(object.at("elements_removed"));
    entry.elements_made = exactly<std::uint64_t>(object.at("elements_made"));
    entry.elements_untouched = exactly<std::uint64_t>(object.at("elements_untouched"));
    entry.hash_before = object.at("hash_before").get<std::string>();
    entry.hash_after = object.at("hash_after").get<std::string>();
    entry.smallest_angle = number(object, "smallest_angle");
    entry.smallest_altitude = number(object, "smallest_altitude");
    entry.stable_step_before = number(object, "stable_step_before");
    entry.stable_step_after = number(object, "stable_step_after");
    entry.strain_energy_before = number(object, "strain_energy_before");
    entry.strain_energy_after = number(object, "strain_energy_after");
    entry.kinetic_energy_before = number(object, "kinetic_energy_before");
    entry.kinetic_energy_after = number(object, "kinetic_energy_after");
    entry.mass_error = number(object, "mass_error");
    entry.momentum_error = number(object, "momentum_error");
    entry.wall_seconds = number(object, "wall_seconds");
    return entry;
  } catch (const nlohmann::json::exception& error) {
    throw ProtocolError(fmt::format("an entry of remeshing is not complete: {}", error.what()));
  }
}

RemeshLedger::RemeshLedger(std::filesystem::path directory) : directory_(std::move(directory)) {}

void RemeshLedger::add(std::uint64_t revision, double time, const Remeshing& entry) {
  if (!table_) {
    table_.emplace(directory_ / table_name);
    table_->append(header);
    wall_times_.emplace(directory_ / wall_times_name);
    wall_times_->append("revision,wall_seconds\n");
  }
  table_->append(fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", revision, time,
                             csv_cell(entry.fracture), entry.x, entry.y, entry.elements_removed,
                             entry.elements_made, entry.elements_untouched, entry.hash_before,
                             entry.hash_after, entry.smallest_angle, entry.smallest_altitude,
                             entry.stable_step_before, entry.stable_step_after, entry.strain_energy_before,
                             entry.strain_energy_after, entry.kinetic_energy_before,
                             entry.kinetic_energy_after, entry.mass_error, entry.momentum_error));
  wall_times_->append(fmt::format("{},{}\n", revision, entry.wall_seconds));
  touched_.push_back(entry.touched());
  const bool first = totals_.insertions == 0;
  ++totals_.insertions;
  totals_.largest_touched = std::max(totals_.largest_touched, entry.touched());
  totals_.untouched_identical = totals_.untouched_identical && entry.hash_before == entry.hash_after;
  totals_.smallest_angle =
      first ? entry.smallest_angle : std::min(totals_.smallest_angle, entry.smallest_angle);
  totals_.wall += entry.wall_seconds;
  totals_.largest_mass_error = std::max(totals_.largest_mass_error, std::abs(entry.mass_error));
  totals_.largest_momentum_error = std::max(totals_.largest_momentum_error, std::abs(entry.momentum_error));
  if (entry.stable_step_before > 0)
    totals_.smallest_step_ratio =
        std::min(totals_.smallest_step_ratio, entry.stable_step_after / entry.stable_step_before);
  // Segments inserted at once carry the same energies: those of all their patches together.
  if (revision != last_revision_)
    totals_.strain_energy_jump += entry.strain_energy_after - entry.strain_energy_before;
  last_revision_ = revision;
}

void RemeshLedger::flush() {
  if (table_) table_->flush();
  if (wall_times_) wall_times_->flush();
}

void RemeshLedger::save(TableMarks& marks, ByteWriter& archive) {
  if (table_) {
    table_->sync();
    wall_times_->sync();
    marks[table_name] = table_->mark();
    marks[wall_times_name] = wall_times_->mark();
  }
  archive.put(touched_);
  archive.put(totals_);
  archive.put(last_revision_);
}

void RemeshLedger::resume(const TableMarks& marks, ByteReader& archive) {
  table_ = at_mark(directory_, table_name, marks);
  wall_times_ = at_mark(directory_, wall_times_name, marks);
  if (table_.has_value() != wall_times_.has_value())
    throw Error(ExitCode::checkpoint_unusable, "the checkpoint knows only one of the tables of remeshing");
  archive.get(touched_);
  archive.get(totals_);
  archive.get(last_revision_);
}

RemeshTotals RemeshLedger::totals() const {
  RemeshTotals totals = totals_;
  totals.median_touched = median(touched_);
  return totals;
}

}  // namespace fissura::coupler
