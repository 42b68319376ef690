// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/meetings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "common/errors.hpp"
#include "coupler/record/csv_cell.hpp"

namespace fissura::coupler {

namespace {

constexpr const char* table_name = "meetings.csv";
constexpr const char* header =
    "revision,time,x,y,hydraulic,natural,angle,stress_xx,stress_yy,stress_xy,friction,cohesion,strength,"
    "criterion,"
    "critical_friction,crosses\n";

double number(const nlohmann::json& object, const char* key) {
  const double value = object.at(key).get<double>();
  if (!std::isfinite(value)) throw ProtocolError(fmt::format("meetings.{} is {}", key, value));
  return value;
}

}  // namespace

Meeting meeting_from_json(const nlohmann::json& object) {
  try {
    Meeting meeting;
    meeting.time = number(object, "time");
    meeting.x = number(object, "x");
    meeting.y = number(object, "y");
    meeting.hydraulic = object.at("hydraulic").get<std::string>();
    meeting.natural = object.at("natural").get<std::string>();
    meeting.angle = number(object, "angle");
    meeting.stress_xx = number(object, "stress_xx");
    meeting.stress_yy = number(object, "stress_yy");
    meeting.stress_xy = number(object, "stress_xy");
    meeting.friction = number(object, "friction");
    meeting.cohesion = number(object, "cohesion");
    meeting.strength = number(object, "strength");
    meeting.criterion = object.at("criterion").get<std::string>();
    if (!object.at("critical_friction").is_null())
      meeting.critical_friction = number(object, "critical_friction");
    meeting.crosses = object.at("crosses").get<bool>();
    return meeting;
  } catch (const nlohmann::json::exception& error) {
    throw ProtocolError(fmt::format("an entry of meetings is not complete: {}", error.what()));
  }
}

std::string sentence(const Meeting& meeting) {
  const std::string needed = meeting.critical_friction ? fmt::format("would cross from a friction of {:.3g}",
                                                                     *meeting.critical_friction)
                                                       : "would cross at no friction";
  return fmt::format(
      "\"{}\" meets \"{}\" at ({:.4g}, {:.4g}) m at {:.3g} degrees and {}: friction {:.3g}, {} by {}",
      meeting.hydraulic, meeting.natural, meeting.x, meeting.y, meeting.angle * 180 / std::numbers::pi,
      meeting.crosses ? "may cross" : "is arrested", meeting.friction, needed, meeting.criterion);
}

MeetingLedger::MeetingLedger(std::filesystem::path directory) : directory_(std::move(directory)) {}

void MeetingLedger::add(std::uint64_t revision, const Meeting& meeting) {
  if (!table_) {
    table_.emplace(directory_ / table_name);
    table_->append(header);
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  table_->append(fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", revision, meeting.time, meeting.x, meeting.y,
      csv_cell(meeting.hydraulic), csv_cell(meeting.natural), meeting.angle, meeting.stress_xx,
      meeting.stress_yy, meeting.stress_xy, meeting.friction, meeting.cohesion, meeting.strength,
      csv_cell(meeting.criterion), meeting.critical_friction.value_or(none), meeting.crosses ? 1 : 0));
  ++totals_.met;
  if (meeting.crosses) ++totals_.crossed;
}

void MeetingLedger::flush() {
  if (table_) table_->flush();
}

void MeetingLedger::save(TableMarks& marks, ByteWriter& archive) {
  if (table_) {
    table_->sync();
    marks[table_name] = table_->mark();
  }
  archive.put(totals_);
}

void MeetingLedger::resume(const TableMarks& marks, ByteReader& archive) {
  table_ = at_mark(directory_, table_name, marks);
  archive.get(totals_);
}

}  // namespace fissura::coupler
