// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <regex>

#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

int number_of(const std::ssub_match& digits) {
  return std::stoi(digits.str());
}

bool is_utc_time(const std::string& text) {
  static const std::regex form(R"((\d{4})-(\d{2})-(\d{2})T(\d{2}):(\d{2}):(\d{2})(\.\d+)?Z)");
  std::smatch part;
  if (!std::regex_match(text, part, form)) return false;
  const std::chrono::year_month_day date{std::chrono::year(number_of(part[1])),
                                         std::chrono::month(static_cast<unsigned>(number_of(part[2]))),
                                         std::chrono::day(static_cast<unsigned>(number_of(part[3])))};
  return date.ok() && number_of(part[4]) < 24 && number_of(part[5]) < 60 && number_of(part[6]) < 60;
}

}  // namespace

Seismicity read_seismicity(TableReader& document) {
  TableReader table = document.optional_table("seismicity");
  Seismicity seismicity;
  seismicity.active = table.flag("active", seismicity.active);
  seismicity.slip_rate = table.quantity("slip_rate", dimension::velocity, not_negative, seismicity.slip_rate);
  seismicity.stress_drop =
      table.quantity("stress_drop", dimension::stress, not_negative, seismicity.stress_drop);
  seismicity.failure_rate =
      table.quantity("failure_rate", dimension::velocity, not_negative, seismicity.failure_rate);
  seismicity.cluster_radius =
      table.quantity("cluster_radius", dimension::length, positive, seismicity.cluster_radius);
  seismicity.cluster_time =
      table.quantity("cluster_time", dimension::time, positive, seismicity.cluster_time);
  seismicity.rest_time = table.quantity("rest_time", dimension::time, positive, seismicity.rest_time);
  seismicity.thickness = table.choice("thickness", source_thicknesses, seismicity.thickness);
  seismicity.maximum_records = table.count("maximum_records", at_least(1), seismicity.maximum_records);
  seismicity.voxel_size = table.quantity("voxel_size", dimension::length, positive, seismicity.voxel_size);
  seismicity.voxel_events = table.count("voxel_events", at_least(1), seismicity.voxel_events);
  table.refuse_unknown_keys();
  return seismicity;
}

std::optional<Georeference> read_georeference(TableReader& document) {
  if (!document.has("georeference")) return {};
  TableReader table = document.table("georeference");
  Georeference place;
  place.latitude = table.quantity("latitude", dimension::arc, between(-90, 90));
  place.longitude = table.quantity("longitude", dimension::arc, from_to(-180, 180));
  place.depth = table.quantity("depth", dimension::length, any_value);
  place.start = table.text("start");
  if (!place.start.empty() && !is_utc_time(place.start))
    table.refuse("start", "a time in UTC such as \"2026-01-31T12:00:00Z\"");
  place.azimuth = table.quantity("azimuth", dimension::angle, any_value, place.azimuth);
  if (table.has("section_azimuth")) {
    place.section_azimuth = table.quantity("section_azimuth", dimension::angle, any_value);
    if (table.has("azimuth"))
      table.refuse("azimuth", "no such key with section_azimuth: the y axis of a section points up");
  }
  table.refuse_unknown_keys();
  return place;
}

}  // namespace fissura::input
