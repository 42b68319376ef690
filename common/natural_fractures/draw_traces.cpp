// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/draw_traces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/natural_fractures/planar_segment.hpp"
#include "common/natural_fractures/scatter.hpp"

namespace fissura {

namespace {

constexpr double cut = 3;  // deviations at which a quantity is cut

double greatest(const Scattered& quantity) {
  return quantity.mean + cut * quantity.deviation;
}

// The last bit of a sine differs between mathematical libraries; it must not reach the mesh.
Point on_grid(Point point) {
  return {std::round(point[0] * 0x1p20) * 0x1p-20, std::round(point[1] * 0x1p20) * 0x1p-20};
}

class Drawing {
 public:
  explicit Drawing(const NaturalFractureSet& set)
      : set_(set), scatter_(set.seed, set.name), axes_(strike_axes(set.orientation.mean)) {}

  std::vector<DrawnTrace> draw() {
    const double reach = greatest(set_.length) / 2;
    const auto [first, last] = extent(axes_.across);
    double across = first - reach + scatter_.uniform() * spacing_around_a_point();
    for (std::size_t row = 0; across < last + reach; ++row) {
      draw_row(row, across);
      across += scatter_.draw_positive(set_.spacing);
    }
    return std::move(traces_);
  }

 private:
  /// A trace and the way from its begin to that of the next.
  struct Cycle {
    double length, repeat;
  };

  [[nodiscard]] std::pair<double, double> extent(Point direction) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point& corner : {Point{set_.west, set_.south}, Point{set_.east, set_.south},
                                Point{set_.east, set_.north}, Point{set_.west, set_.north}}) {
      low = std::min(low, dot(corner, direction));
      high = std::max(high, dot(corner, direction));
    }
    return {low, high};
  }

  Cycle cycle() {
    const double length = scatter_.draw_positive(set_.length);
    const double persistence = scatter_.draw_positive(set_.persistence);
    return {length, set_.reading == PersistenceReading::repeat ? persistence : length + persistence};
  }

  Cycle cycle_around_a_point() {
    const double longest =
        greatest(set_.persistence) + (set_.reading == PersistenceReading::repeat ? 0 : greatest(set_.length));
    for (;;)
      if (const Cycle one = cycle(); scatter_.uniform() * longest < one.repeat) return one;
  }

  double spacing_around_a_point() {
    for (;;)
      if (const double one = scatter_.draw_positive(set_.spacing);
          scatter_.uniform() * greatest(set_.spacing) < one)
        return one;
  }

  void draw_row(std::size_t row, double across) {
    const auto [first, last] = extent(axes_.along);
    const double reach = greatest(set_.length);
    Cycle one = cycle_around_a_point();
    double begin = first - reach - scatter_.uniform() * one.repeat;
    while (begin < last + reach) {
      add(row, sum(scaled(axes_.across, across), scaled(axes_.along, begin + one.length / 2)), one.length);
      begin += one.repeat;
      one = cycle();
    }
  }

  void add(std::size_t row, Point centre, double length) {
    DrawnTrace trace{row, centre, scatter_.draw(set_.orientation), length, {}, {}};
    const Point half = scaled(strike_axes(trace.azimuth).along, length / 2);
    const auto inside = clipped({difference(centre, half), sum(centre, half)},
                                {set_.west, set_.east, set_.south, set_.north});
    if (!inside) return;
    trace.begin = on_grid(inside->begin);
    trace.end = on_grid(inside->end);
    if (trace.begin != trace.end) traces_.push_back(trace);
  }

  const NaturalFractureSet& set_;
  Scatter scatter_;
  StrikeAxes axes_;
  std::vector<DrawnTrace> traces_;
};

}  // namespace

StrikeAxes strike_axes(double azimuth) {
  return {{std::sin(azimuth), std::cos(azimuth)}, {std::cos(azimuth), -std::sin(azimuth)}};
}

double mean_repeat(const NaturalFractureSet& set) {
  const double persistence = positive_moments(set.persistence).mean;
  return set.reading == PersistenceReading::repeat ? persistence
                                                   : persistence + positive_moments(set.length).mean;
}

double expected_density(const NaturalFractureSet& set) {
  return 1 / (positive_moments(set.spacing).mean * mean_repeat(set));
}

double expected_intensity(const NaturalFractureSet& set) {
  return positive_moments(set.length).mean * expected_density(set);
}

std::vector<DrawnTrace> draw_traces(const NaturalFractureSet& set) {
  return Drawing(set).draw();
}

}  // namespace fissura
