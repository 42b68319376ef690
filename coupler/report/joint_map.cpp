// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/joint_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "coupler/report/drawn_numbers.hpp"
#include "coupler/report/thinning.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;

constexpr double natural = 1;           // joint_kind, docs/protocol.md
constexpr double least_slip = 1e-7;     // below it a contact unit is at rest [m]
constexpr double least_opening = 1e-6;  // below it the faces touch [m]

/// The contact units of one report.
struct Units {
  std::vector<double> position, normal, kind, line, slip, opening, wetted;

  Units(FieldReports& reports, const FieldReport& report) {
    const auto read = [&](const char* name) {
      return reports.of_report(report, std::string("joints/") + name);
    };
    position = read("position");
    normal = read("normal");
    kind = read("kind");
    line = read("line");
    slip = read("slip");
    opening = read("opening");
    wetted = read("wetted");
  }
  [[nodiscard]] std::size_t size() const { return kind.size(); }
  [[nodiscard]] bool is_open(std::size_t unit) const { return opening[unit] > least_opening; }
  [[nodiscard]] bool has_changed(std::size_t unit) const {
    return kind[unit] == natural && (std::abs(slip[unit]) > least_slip || is_open(unit) || wetted[unit] > 0);
  }
  [[nodiscard]] double direction(std::size_t unit) const {
    // Normals are stored with a third component of zero.
    return std::atan2(normal[3 * unit + 1], normal[3 * unit]) - std::numbers::pi / 2;
  }
};

/// Half the distance from each natural unit to the next one of its line; 0 for a single one.
std::vector<double> half_lengths(const Units& units) {
  std::map<double, std::vector<std::size_t>> of_line;
  for (std::size_t unit = 0; unit < units.size(); ++unit)
    if (units.kind[unit] == natural) of_line[units.line[unit]].push_back(unit);
  std::vector<double> half(units.size(), 0);
  for (auto& [line, members] : of_line) {
    const double across = std::cos(units.direction(members.front())),
                 up = std::sin(units.direction(members.front()));
    const auto along = [&](std::size_t unit) {
      return across * units.position[2 * unit] + up * units.position[2 * unit + 1];
    };
    std::sort(members.begin(), members.end(),
              [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
    for (std::size_t place = 0; place < members.size(); ++place) {
      double widest = 0;
      if (place > 0) widest = along(members[place]) - along(members[place - 1]);
      if (place + 1 < members.size())
        widest = std::max(widest, along(members[place + 1]) - along(members[place]));
      half[members[place]] = widest / 2;
    }
  }
  return half;
}

/// Units of all reports, each once.
class Pool {
 public:
  std::size_t number(const Units& units, std::size_t unit, double half) {
    const std::array<double, 3> key{units.line[unit], units.position[2 * unit], units.position[2 * unit + 1]};
    const auto [found, is_new] = number_.try_emplace(key, x_.size());
    if (is_new) {
      x_.push_back(key[1]);
      y_.push_back(key[2]);
      angle_.push_back(units.direction(unit));
      half_.push_back(half);
    }
    return found->second;
  }
  [[nodiscard]] json list() const {
    return {{"x", for_drawing(x_)},
            {"y", for_drawing(y_)},
            {"angle", for_drawing(angle_)},
            {"half", for_drawing(half_)}};
  }

 private:
  std::map<std::array<double, 3>, std::size_t> number_;
  std::vector<double> x_, y_, angle_, half_;
};

bool has_joints(FieldReports& reports, const FieldReport& report) {
  for (const char* name : {"position", "normal", "kind", "line", "slip", "opening", "wetted"})
    if (!reports.has(report, std::string("joints/") + name)) return false;
  return true;
}

}  // namespace

json joint_map(FieldReports& reports, std::size_t most_reports) {
  Pool pool;
  json shown = json::array();
  for (const std::size_t index : evenly_spread(reports.all().size(), most_reports)) {
    const FieldReport& report = reports.all()[index];
    if (!has_joints(reports, report)) continue;
    const Units units(reports, report);
    const std::vector<double> half = half_lengths(units);
    json number = json::array(), slip = json::array(), wetted = json::array(), open = json::array();
    for (std::size_t unit = 0; unit < units.size(); ++unit) {
      if (!units.has_changed(unit)) continue;
      number.push_back(pool.number(units, unit, half[unit]));
      slip.push_back(for_drawing(units.slip[unit]));
      wetted.push_back(units.wetted[unit] > 0 ? 1 : 0);
      open.push_back(units.is_open(unit) ? 1 : 0);
    }
    shown.push_back(
        {{"time", report.time}, {"unit", number}, {"slip", slip}, {"wetted", wetted}, {"open", open}});
  }
  if (shown.empty()) return nullptr;
  return {{"units", pool.list()}, {"reports", shown}};
}

}  // namespace fissura::coupler
