// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/trace_fitting.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fissura {

namespace {

constexpr double furthest_extension = 1;  // of natural_size
constexpr double step_aside = 0.125;      // of natural_size
constexpr int steps_aside = 8;
constexpr double beyond_rounding = 1.001;
constexpr double parallel = 1e-3;  // sine below which lines have no crossing worth a thought
constexpr int most_tries = 2000;   // pairs of ends looked at in one place

/// All pairs of ends of a trace in one place.
class Axis {
 public:
  Axis(const PlanarSegment& trace, const TraceNetwork& network, const std::vector<std::size_t>& lines,
       const Rectangle& within)
      : network_(network),
        limits_(network.limits()),
        lines_(lines),
        origin_(trace.begin),
        along_(direction(trace)),
        length_(length(trace)) {
    const double reach = furthest_extension * limits_.natural_size;
    const auto room = clipped({at(-reach), at(length_ + reach)}, within);
    if (!room) return;
    lowest_ = dot(difference(room->begin, origin_), along_);
    highest_ = dot(difference(room->end, origin_), along_);
    collect_ends();
  }

  /// The pair of ends of least change below `most`.
  [[nodiscard]] std::optional<Fit> best(double most) const {
    std::vector<Fit> pairs;
    for (const double begin : ends_)
      for (const double end : ends_)
        if (end - begin >= limits_.shortest())
          if (const double change = std::abs(begin) + std::abs(end - length_); change < most)
            pairs.push_back({0, begin, end, change});
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Fit& a, const Fit& b) { return a.change < b.change; });
    std::vector<std::array<double, 2>> refused;
    int tries = 0;
    for (const Fit& pair : pairs) {
      const bool hopeless = std::any_of(refused.begin(), refused.end(), [&](const auto& stretch) {
        return pair.begin <= stretch[0] && pair.end >= stretch[1];
      });
      if (hopeless) continue;
      const auto conflict = network_.conflict({at(pair.begin), at(pair.end)}, lines_, origin_);
      if (!conflict) return pair;
      if (++tries == most_tries) break;
      if (conflict->wherever) refused.push_back(*conflict->wherever);
    }
    return {};
  }

 private:
  [[nodiscard]] Point at(double place) const { return sum(origin_, scaled(along_, place)); }

  void add(double place) {
    if (place >= lowest_ && place <= highest_) ends_.push_back(place);
  }

  void add_around(double place, double distance) {
    add(place - beyond_rounding * distance);
    add(place + beyond_rounding * distance);
  }

  void collect_ends() {
    add(std::max(0.0, lowest_));
    add(std::min(length_, highest_));
    for (const std::size_t index : lines_) {
      const TraceNetwork::Line& line = network_.line(index);
      const double clearance = limits_.clearance(std::min(line.size, limits_.natural_size));
      const Point other = direction(line.segment);
      const double sine = cross(along_, other);
      if (std::abs(sine) > parallel) {
        const Point between = difference(line.segment.begin, origin_);
        const double place = cross(between, other) / sine;
        const double on_other = cross(between, along_) / sine;
        if (on_other >= -limits_.same_place() && on_other <= length(line.segment) + limits_.same_place())
          add(place);
        add_around(place, clearance / std::abs(sine));
        add_around(place, limits_.clearance(limits_.natural_size));
      }
      for (const Point vertex : line.places) {
        const Point to = difference(vertex, origin_);
        const double aside = std::abs(cross(along_, to));
        if (aside < clearance) add_around(dot(to, along_), std::sqrt(clearance * clearance - aside * aside));
      }
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
  }

  const TraceNetwork& network_;
  const NetworkLimits& limits_;
  const std::vector<std::size_t>& lines_;
  Point origin_, along_;
  double length_;
  double lowest_ = 0, highest_ = 0;
  std::vector<double> ends_;  // places at which the trace may end
};

PlanarSegment moved(const PlanarSegment& trace, double aside) {
  const Point along = direction(trace);
  const Point by{-along[1] * aside, along[0] * aside};
  return {sum(trace.begin, by), sum(trace.end, by)};
}

// Whether the trace lies so along another that beside it, it would be the same fracture once more.
bool runs_along_another(const PlanarSegment& trace, const TraceNetwork& network,
                        const std::vector<std::size_t>& lines) {
  return std::any_of(lines.begin(), lines.end(), [&](std::size_t index) {
    const TraceNetwork::Line& line = network.line(index);
    const bool flat =
        std::abs(cross(direction(trace), direction(line.segment))) < std::sin(network.limits().angle());
    const double size = std::min(line.size, network.limits().natural_size);
    return flat && distance(trace, line.segment) < network.limits().clearance(size);
  });
}

}  // namespace

std::optional<Fit> fit(const PlanarSegment& trace, const TraceNetwork& network, const Rectangle& within) {
  const NetworkLimits& limits = network.limits();
  const double step = step_aside * limits.natural_size;
  const double reach = (furthest_extension + steps_aside * step_aside) * limits.natural_size +
                       limits.clearance(limits.natural_size);
  const std::vector<std::size_t> lines = network.near(trace, reach);
  const int steps = runs_along_another(trace, network, lines) ? 0 : steps_aside;
  std::optional<Fit> best;
  const double most = 2 * length(trace) + reach;
  for (int i = 0; i <= steps; ++i)
    for (const double aside : {i * step, -i * step}) {
      if (i == 0 && std::signbit(aside)) continue;
      const double left = (best ? best->change : most) - std::abs(aside);
      if (left <= 0) return best;
      const PlanarSegment there = moved(trace, aside);
      if (auto found = Axis(there, network, lines, within).best(left)) {
        found->aside = aside;
        found->change += std::abs(aside);
        best = found;
      }
    }
  return best;
}

PlanarSegment fitted(const PlanarSegment& trace, const Fit& fit) {
  const PlanarSegment there = moved(trace, fit.aside);
  const Point along = direction(trace);
  const bool same_begin = fit.begin == 0, same_end = fit.end == length(trace);
  return {same_begin ? there.begin : sum(there.begin, scaled(along, fit.begin)),
          same_end ? there.end : sum(there.begin, scaled(along, fit.end))};
}

}  // namespace fissura
