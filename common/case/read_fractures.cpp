// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "common/case/polyline_file.hpp"
#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

constexpr double friction_of_a_fresh_break = 0.6;
constexpr const char* only_natural = "no such key unless kind = \"natural\"";

std::vector<Point> read_points(TableReader& table, CaseFiles& files) {
  const bool in_file = table.has("file");
  if (table.has("points") == in_file) {
    table.refuse("points", in_file ? "points and file" : "nothing", "either points or file");
    return {};
  }
  if (!in_file) return table.points("points");
  const std::string name = table.text("file");
  if (name.empty()) return {};
  try {
    const std::filesystem::path file = inside(files.folder, name);
    std::vector<Point> points = read_polyline(file);
    files.read.push_back(file);
    return points;
  } catch (const InputError& error) {
    table.refuse("file", error.what());
    return {};
  }
}

void refuse_if_given(TableReader& table, std::initializer_list<const char*> keys,
                     const std::string& expected) {
  for (const char* key : keys)
    if (table.has(key)) table.refuse(key, expected);
}

FractureLine natural_line(TableReader& table, const FractureLine& geometry) {
  FractureLine line = read_natural_faces(table, unspecified_natural_faces(), Friction::required).line;
  line.name = geometry.name;
  line.points = geometry.points;
  line.kind = FractureKind::natural;
  return line;
}

FractureLine read_line(TableReader& table, const Rock& rock, CaseFiles& files) {
  FractureLine line;
  line.name = table.text("name");
  line.points = read_points(table, files);
  const std::optional<FractureKind> kind = table.choice("kind", fracture_kinds);
  if (!kind) return line;
  line.kind = *kind;
  switch (line.kind) {
    case FractureKind::open:
      refuse_if_given(table, {"tensile_strength", "fracture_energy", "friction_coefficient", "cohesion"},
                      "no such key with kind = \"open\", which has no strength");
      refuse_natural_faces(table, only_natural);
      break;
    case FractureKind::natural:
      line = natural_line(table, line);
      break;
    case FractureKind::intact:
      line.tensile_strength = rock.tensile_strength;
      line.fracture_energy = rock.fracture_energy;
      read_strength(table, line);
      if (line.tensile_strength == 0 && line.fracture_energy == 0)
        table.refuse("tensile_strength", "greater than 0 Pa with kind = \"intact\"");
      line.friction_coefficient =
          table.number("friction_coefficient", not_negative, friction_of_a_fresh_break);
      line.cohesion = table.quantity("cohesion", dimension::stress, not_negative, line.cohesion);
      refuse_natural_faces(table, only_natural);
      break;
  }
  table.refuse_unknown_keys();
  return line;
}

}  // namespace

std::vector<FractureLine> read_fractures(TableReader& document, const Rock& rock, CaseFiles& files) {
  std::vector<FractureLine> lines;
  for (TableReader& table : document.optional_tables("fracture")) {
    lines.push_back(read_line(table, rock, files));
    const auto same_name = [&](const FractureLine& line) { return line.name == lines.back().name; };
    if (!lines.back().name.empty() && std::any_of(lines.begin(), lines.end() - 1, same_name))
      table.refuse("name", "a name that no other fracture has");
  }
  return lines;
}

}  // namespace fissura::input
