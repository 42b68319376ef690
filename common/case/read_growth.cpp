// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

constexpr Range below_right_angle{0, std::numbers::pi / 2, true, false};
constexpr Range turn{0, std::numbers::pi / 2, false, true};

void read_shear_failure(TableReader& table, BulkFailure& failure) {
  if (!table.has("cohesion")) {
    for (const char* key : {"friction_angle", "dilation_angle"})
      if (table.has(key))
        table.refuse(key, "no such key without cohesion: the rock then fails in tension only");
    return;
  }
  failure.cohesion = table.quantity("cohesion", dimension::stress, positive);
  failure.friction_angle = table.quantity("friction_angle", dimension::angle, below_right_angle);
  failure.dilation_angle =
      table.quantity("dilation_angle", dimension::angle, below_right_angle, failure.dilation_angle);
  if (failure.dilation_angle > failure.friction_angle)
    table.refuse("dilation_angle", "at most friction_angle: more would make energy out of sliding");
}

void read_bedding(TableReader& table, BulkFailure& failure) {
  if (table.has("strength_across_bedding") != table.has("bedding_azimuth")) {
    table.refuse("strength_across_bedding", "strength_across_bedding and bedding_azimuth, or neither");
    return;
  }
  if (!table.has("strength_across_bedding")) return;
  failure.strength_across_bedding = table.quantity("strength_across_bedding", dimension::stress, positive);
  const double azimuth = table.quantity("bedding_azimuth", dimension::angle, any_value);
  failure.bedding_angle = std::numbers::pi / 2 - azimuth;
}

}  // namespace

BulkFailure read_failure(TableReader& document) {
  BulkFailure failure;
  if (!document.has("failure")) return failure;
  TableReader table = document.table("failure");
  failure.active = true;
  failure.softening = table.choice("softening", softening_laws, failure.softening);
  read_shear_failure(table, failure);
  read_bedding(table, failure);
  failure.tip_exclusion = table.number("tip_exclusion", not_negative, failure.tip_exclusion);
  table.refuse_unknown_keys();
  return failure;
}

Growth read_growth(TableReader& document) {
  TableReader table = document.optional_table("growth");
  Growth growth;
  growth.path = table.choice("path", path_rules, growth.path);
  growth.tip = table.choice("tip", tip_rules, growth.tip);
  growth.trigger = table.number("trigger", positive, growth.trigger);
  growth.segment_length = table.number("segment_length", positive, growth.segment_length);
  growth.turn_limit = table.quantity("turn_limit", dimension::angle, turn, growth.turn_limit);
  growth.nucleation = table.flag("nucleation", growth.nucleation);
  growth.failure_damage = table.number("failure_damage", fraction, growth.failure_damage);
  growth.failure_length = table.number("failure_length", positive, growth.failure_length);
  growth.wet_zone = table.number("wet_zone", not_negative, growth.wet_zone);
  growth.crossing = table.choice("crossing", crossing_rules, growth.crossing);
  table.refuse_unknown_keys();
  return growth;
}

}  // namespace fissura::input
