// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/natural_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace fissura {

NaturalFractureReport add_natural_fractures(Case& to, std::span<const FractureLine> given) {
  NaturalFractureReport report;
  report.given = given.size();
  std::vector<Trace> traces;
  std::map<std::string, FractureLine> faces;  // by name of the set, or of the trace if it has none
  for (const FractureLine& line : given) {
    traces.push_back({line.set, line.name, {line.points.at(0), line.points.at(1)}});
    faces.emplace(line.set.empty() ? line.name : line.set, line);
  }
  for (const NaturalFractureSet& set : to.natural_fracture_sets) {
    const std::vector<DrawnTrace> drawn = draw_traces(set);
    report.sets.push_back(statistics(set, drawn));
    report.drawn += drawn.size();
    for (std::size_t i = 0; i < drawn.size(); ++i)
      traces.push_back({set.name, fmt::format("{} {}", set.name, i + 1), {drawn[i].begin, drawn[i].end}});
    faces.emplace(set.name, set.faces);
  }
  CleanedTraces cleaned = clean_traces(std::move(traces), to);
  for (const Trace& trace : cleaned.traces) {
    FractureLine line = faces.at(trace.set.empty() ? trace.name : trace.set);
    line.name = trace.name;
    line.kind = FractureKind::natural;
    line.set = trace.set;
    line.points = {trace.segment.begin, trace.segment.end};
    to.fractures.push_back(line);
    const double long_by = length(trace.segment);
    report.length += long_by;
    const auto set = std::find_if(to.natural_fracture_sets.begin(), to.natural_fracture_sets.end(),
                                  [&](const NaturalFractureSet& one) { return one.name == trace.set; });
    if (set == to.natural_fracture_sets.end()) continue;
    SetStatistics& numbers = report.sets[static_cast<std::size_t>(set - to.natural_fracture_sets.begin())];
    ++numbers.cleaned_traces;
    numbers.cleaned_intensity += long_by / ((set->east - set->west) * (set->north - set->south));
  }
  report.kept = cleaned.traces.size();
  report.cleaning = std::move(cleaned.records);
  return report;
}

}  // namespace fissura
