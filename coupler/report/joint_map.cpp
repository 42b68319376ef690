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

/// The stroke that stands for a contact unit, along its fracture from its place.
struct Stroke {
  double back = 0, ahead = 0;  ///< [m]
  double rank = 0;             ///< 1 for the second of two units at one place, the arms of a junction
};

/// Of two units at one place the one whose slip is nearer to that of the unit before comes first: the message
/// does not tell the arms.
void order_arms(const Units& units, const std::vector<double>& along, std::vector<std::size_t>& members) {
  for (std::size_t place = 1; place + 2 < members.size(); ++place) {
    const std::size_t first = members[place], second = members[place + 1];
    if (along[first] != along[second]) continue;
    const double before = units.slip[members[place - 1]], after = units.slip[members[place + 2]];
    const double as_it_is = std::abs(units.slip[first] - before) + std::abs(units.slip[second] - after);
    const double swapped = std::abs(units.slip[second] - before) + std::abs(units.slip[first] - after);
    if (swapped < as_it_is) std::swap(members[place], members[place + 1]);
  }
}

/// Every unit reaches half way to its neighbours on the line, the last ones as far outward as inward.
std::vector<Stroke> strokes(const Units& units) {
  std::map<double, std::vector<std::size_t>> of_line;
  for (std::size_t unit = 0; unit < units.size(); ++unit)
    if (units.kind[unit] == natural) of_line[units.line[unit]].push_back(unit);
  std::vector<Stroke> made(units.size());
  std::vector<double> along(units.size(), 0);
  for (auto& [line, members] : of_line) {
    const double across = std::cos(units.direction(members.front())),
                 up = std::sin(units.direction(members.front()));
    for (const std::size_t unit : members)
      along[unit] = across * units.position[2 * unit] + up * units.position[2 * unit + 1];
    std::stable_sort(members.begin(), members.end(),
                     [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
    order_arms(units, along, members);
    for (std::size_t place = 0; place + 1 < members.size(); ++place) {
      const double half = (along[members[place + 1]] - along[members[place]]) / 2;
      made[members[place]].ahead = made[members[place + 1]].back = half;
      if (half == 0) made[members[place + 1]].rank = 1;
    }
    made[members.front()].back = made[members.front()].ahead;
    made[members.back()].ahead = made[members.back()].back;
  }
  return made;
}

/// Units of all reports, each once.
class Pool {
 public:
  std::size_t number(const Units& units, std::size_t unit, const Stroke& stroke) {
    const std::array<double, 4> key{units.line[unit], units.position[2 * unit], units.position[2 * unit + 1],
                                    stroke.rank};
    const auto [found, is_new] = number_.try_emplace(key, x_.size());
    if (is_new) {
      x_.push_back(key[1]);
      y_.push_back(key[2]);
      angle_.push_back(units.direction(unit));
      back_.push_back(stroke.back);
      ahead_.push_back(stroke.ahead);
    }
    return found->second;
  }
  [[nodiscard]] json list() const {
    return {{"x", for_drawing(x_)},
            {"y", for_drawing(y_)},
            {"angle", for_drawing(angle_)},
            {"back", for_drawing(back_)},
            {"ahead", for_drawing(ahead_)}};
  }

 private:
  std::map<std::array<double, 4>, std::size_t> number_;
  std::vector<double> x_, y_, angle_, back_, ahead_;
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
    const std::vector<Stroke> stroke = strokes(units);
    json number = json::array(), slip = json::array(), wetted = json::array(), open = json::array();
    for (std::size_t unit = 0; unit < units.size(); ++unit) {
      if (!units.has_changed(unit)) continue;
      number.push_back(pool.number(units, unit, stroke[unit]));
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
