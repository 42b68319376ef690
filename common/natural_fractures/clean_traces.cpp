// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/clean_traces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/natural_fractures/trace_fitting.hpp"

namespace fissura {

namespace {

constexpr double beyond_rounding = 1e-9;  // of a size, below which nothing has changed

bool is_meshed(const FractureLine& line, const Case& given) {
  return line.kind != FractureKind::intact || given.growth.path != PathRule::free;
}

TraceNetwork network_of(const Case& given) {
  TraceNetwork network({given.mesh.fracture_size, given.mesh.natural_size});
  for (const FractureLine& line : given.fractures) {
    if (!is_meshed(line, given)) continue;
    const double size =
        line.kind == FractureKind::natural ? given.mesh.natural_size : given.mesh.fracture_size;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const PlanarSegment segment{line.points[i - 1], line.points[i]};
      std::vector<Point> perforations;
      for (const Perforation& perforation : given.injection.perforations)
        if (distance(perforation.position, segment) < network.limits().clearance(size))
          perforations.push_back(perforation.position);
      network.add(segment, size, line.name, perforations);
    }
  }
  return network;
}

class Cleaning {
 public:
  explicit Cleaning(const Case& given) : network_(network_of(given)) {
    const double x = given.domain.width / 2, y = given.domain.height / 2;
    domain_ = {-x, x, -y, y};
    const double margin = network_.limits().margin();
    inside_ = {-x + margin, x - margin, -y + margin, y - margin};
  }

  void take(Trace trace) {
    const double whole = length(trace.segment);
    if (whole == 0) return remove(trace, "without length");
    if (!keep_inside(trace)) return;
    if (!(length(trace.segment) >= network_.limits().shortest()))
      return remove(trace, fmt::format("{:.4g} m long, shorter than two edges", length(trace.segment)));
    const std::string cause = why(trace);
    const auto change = fit(trace.segment, network_, inside_);
    if (!change)
      return remove(trace, cause.empty() ? fmt::format("no place for it, {:.4g} m", whole) : cause);
    record(trace, *change, cause);
    trace.segment = fitted(trace.segment, *change);
    network_.add(trace.segment, network_.limits().natural_size, trace.name, {});
    result_.traces.push_back(std::move(trace));
  }

  CleanedTraces result() && { return std::move(result_); }

 private:
  void remove(const Trace& trace, const std::string& cause) {
    const Point middle = scaled(sum(trace.segment.begin, trace.segment.end), 0.5);
    result_.records.push_back(
        {trace.set, trace.name, CleaningAction::removed, middle, length(trace.segment), cause});
  }

  /// Whether anything of the trace is left.
  bool keep_inside(Trace& trace) {
    const auto kept = clipped(trace.segment, inside_);
    if (!kept) {
      const bool outside = !clipped(trace.segment, domain_);
      remove(trace, outside ? "outside the domain" : "along a side of the domain");
      return false;
    }
    const auto record_end = [&](Point old, Point fresh) {
      const double cut = length(difference(old, fresh));
      if (cut > beyond_rounding * network_.limits().natural_size)
        result_.records.push_back(
            {trace.set, trace.name, CleaningAction::kept_inside, old, cut, "a side of the domain"});
    };
    record_end(trace.segment.begin, kept->begin);
    record_end(trace.segment.end, kept->end);
    trace.segment = *kept;
    return true;
  }

  /// What is wrong with a trace as it is; empty if nothing is.
  [[nodiscard]] std::string why(const Trace& trace) const {
    const auto lines =
        network_.near(trace.segment, network_.limits().clearance(network_.limits().natural_size));
    const auto conflict = network_.conflict(trace.segment, lines, trace.segment.begin);
    if (!conflict) return {};
    const std::string& other = network_.line(conflict->line).name;
    const std::string where = fmt::format("at ({:.6g}, {:.6g}) m", conflict->at[0], conflict->at[1]);
    switch (conflict->kind) {
      case Conflict::Kind::near:
        return fmt::format("within {:.3g} m of '{}' {}", conflict->amount, other, where);
      case Conflict::Kind::angle:
        return conflict->amount > 0 ? fmt::format("meets '{}' at {:.3g} degrees {}", other,
                                                  conflict->amount * 180 / std::numbers::pi, where)
                                    : fmt::format("lies on '{}' {}", other, where);
      case Conflict::Kind::crowded:
        return fmt::format("meets '{}' {} within {:.3g} m of another end or meeting", other, where,
                           conflict->amount);
    }
    return {};
  }

  void record(const Trace& trace, const Fit& change, const std::string& cause) {
    const double least = beyond_rounding * network_.limits().natural_size, whole = length(trace.segment);
    const auto add = [&](CleaningAction action, Point at, double amount) {
      if (amount > least) result_.records.push_back({trace.set, trace.name, action, at, amount, cause});
    };
    add(CleaningAction::moved, scaled(sum(trace.segment.begin, trace.segment.end), 0.5),
        std::abs(change.aside));
    add(CleaningAction::shortened, trace.segment.begin, change.begin);
    add(CleaningAction::extended, trace.segment.begin, -change.begin);
    add(CleaningAction::shortened, trace.segment.end, whole - change.end);
    add(CleaningAction::extended, trace.segment.end, change.end - whole);
  }

  TraceNetwork network_;
  Rectangle domain_, inside_;
  CleanedTraces result_;
};

}  // namespace

std::string name(CleaningAction action) {
  switch (action) {
    case CleaningAction::kept_inside:
      return "kept inside";
    case CleaningAction::shortened:
      return "shortened";
    case CleaningAction::extended:
      return "extended";
    case CleaningAction::moved:
      return "moved";
    case CleaningAction::removed:
      return "removed";
  }
  return {};
}

CleanedTraces clean_traces(std::vector<Trace> traces, const Case& given) {
  Cleaning cleaning(given);
  for (Trace& trace : traces) cleaning.take(std::move(trace));
  return std::move(cleaning).result();
}

}  // namespace fissura
