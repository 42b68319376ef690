// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "common/case/polyline_file.hpp"
#include "common/case/sections.hpp"
#include "common/natural_fractures/draw_traces.hpp"

namespace fissura::input {

namespace {

constexpr double most_traces = 20000;  // of one set

class NaturalFracturesReader {
 public:
  NaturalFracturesReader(TableReader& table, const Domain& domain, const std::vector<FractureLine>& others,
                         CaseFiles& files)
      : table_(table),
        domain_(domain),
        files_(files),
        faces_(read_natural_faces(table, unspecified_natural_faces(),
                                  table.has("file") ? Friction::required : Friction::optional)) {
    for (const FractureLine& line : others) names_.insert(line.name);
  }

  NaturalFractures read() {
    for (TableReader& trace : table_.optional_tables("trace")) read_trace(trace);
    if (table_.has("file")) read_file();
    for (TableReader& set : table_.optional_tables("set")) read_set(set);
    table_.refuse_unknown_keys();
    return std::move(result_);
  }

 private:
  void refuse_taken_name(TableReader& table, const std::string& name) {
    if (!name.empty() && !names_.insert(name).second)
      table.refuse("name", "a name that no other fracture and no other set has");
  }

  void read_trace(TableReader& table) {
    FractureLine trace = read_natural_faces(table, faces_, Friction::required).line;
    trace.name = table.text("name");
    refuse_taken_name(table, trace.name);
    trace.points = table.has("points") ? read_ends(table) : ends_about_centre(table);
    table.refuse_unknown_keys();
    result_.traces.push_back(std::move(trace));
  }

  static std::vector<Point> read_ends(TableReader& table) {
    for (const char* key : {"centre", "azimuth", "length"})
      if (table.has(key)) table.refuse(key, "either points, or centre, azimuth and length");
    std::vector<Point> points = table.points("points");
    if (points.size() > 2)
      table.refuse("points", fmt::format("{} points", points.size()),
                   "two points: a trace is straight (a bent line is a [[fracture]] of kind natural)");
    points.resize(2);
    return points;
  }

  static std::vector<Point> ends_about_centre(TableReader& table) {
    const Point centre = table.vector("centre", dimension::length);
    const double azimuth = table.quantity("azimuth", dimension::angle, any_value);
    const double half = table.quantity("length", dimension::length, positive) / 2;
    const Point along = strike_axes(azimuth).along;
    return {{centre[0] - half * along[0], centre[1] - half * along[1]},
            {centre[0] + half * along[0], centre[1] + half * along[1]}};
  }

  void read_file() {
    const std::string name = table_.text("file");
    if (name.empty()) return;
    try {
      const std::filesystem::path file = inside(files_.folder, name);
      const auto traces = read_trace_ends(file);
      files_.read.push_back(file);
      FractureLine trace = faces_.line;
      trace.set = file.stem().string();
      if (!names_.insert(trace.set).second)
        table_.refuse("file", "a file named as no other fracture and no set is");
      for (std::size_t i = 0; i < traces.size(); ++i) {
        trace.name = fmt::format("{} {}", trace.set, i + 1);
        trace.points = {traces[i][0], traces[i][1]};
        result_.traces.push_back(trace);
      }
    } catch (const InputError& error) {
      table_.refuse("file", error.what());
    }
  }

  static Scattered scattered(TableReader& table, const std::string& key, const Dimension& dimension,
                             const Range& range) {
    return {table.quantity(key, dimension, range),
            table.quantity(key + "_deviation", dimension, not_negative, 0)};
  }

  void read_set(TableReader& table) {
    NaturalFractureSet set;
    set.faces = read_natural_faces(table, faces_, Friction::required).line;
    set.name = table.text("name");
    refuse_taken_name(table, set.name);
    set.orientation = scattered(table, "orientation", dimension::angle, any_value);
    set.spacing = scattered(table, "spacing", dimension::length, positive);
    set.length = scattered(table, "length", dimension::length, positive);
    set.persistence = scattered(table, "persistence", dimension::length, positive);
    set.reading = table.choice("persistence_reading", persistence_readings, set.reading);
    set.seed = table.natural_number("seed", set.seed);
    read_region(table, set);
    table.refuse_unknown_keys();
    result_.sets.push_back(std::move(set));
  }

  void read_region(TableReader& table, NaturalFractureSet& set) const {
    const double x = domain_.width / 2, y = domain_.height / 2;
    set.west = table.quantity("west", dimension::length, from_to(-x, x), -x);
    set.east = table.quantity("east", dimension::length, from_to(-x, x), x);
    set.south = table.quantity("south", dimension::length, from_to(-y, y), -y);
    set.north = table.quantity("north", dimension::length, from_to(-y, y), y);
    if (set.west >= set.east)
      table.refuse("east", fmt::format("{} m", set.east), fmt::format("greater than west, {} m", set.west));
    if (set.south >= set.north)
      table.refuse("north", fmt::format("{} m", set.north),
                   fmt::format("greater than south, {} m", set.south));
    const double traces = expected_density(set) * (set.east - set.west) * (set.north - set.south);
    if (traces > most_traces)
      table.refuse("spacing", fmt::format("about {:.0f} traces", traces),
                   fmt::format("at most {:.0f} in the region, by spacing and persistence", most_traces));
  }

  TableReader& table_;
  Domain domain_;
  CaseFiles& files_;
  NaturalFaces faces_;
  std::set<std::string> names_;
  NaturalFractures result_;
};

}  // namespace

NaturalFractures read_natural_fractures(TableReader& document, const Domain& domain,
                                        const std::vector<FractureLine>& others, CaseFiles& files) {
  if (!document.has("natural_fractures")) return {};
  TableReader table = document.table("natural_fractures");
  return NaturalFracturesReader(table, domain, others, files).read();
}

}  // namespace fissura::input
