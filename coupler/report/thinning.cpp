// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/thinning.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace fissura::coupler {

std::vector<std::size_t> rows_to_draw(std::size_t rows, std::span<const std::vector<double>> peaks,
                                      std::size_t parts) {
  if (rows <= parts) return evenly_spread(rows, rows);
  std::set<std::size_t> chosen{rows - 1};
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = part * rows / parts, last = (part + 1) * rows / parts;
    chosen.insert(first);
    for (const std::vector<double>& values : peaks) {
      const auto peak = std::max_element(values.begin() + first, values.begin() + last);
      chosen.insert(static_cast<std::size_t>(peak - values.begin()));
    }
  }
  return {chosen.begin(), chosen.end()};
}

std::vector<std::size_t> evenly_spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen(std::min(count, most));
  if (chosen.size() == count) {
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    return chosen;
  }
  for (std::size_t number = 0; number < most; ++number) chosen[number] = (number + 1) * count / most - 1;
  return chosen;
}

}  // namespace fissura::coupler
