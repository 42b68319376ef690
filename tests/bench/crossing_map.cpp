// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "structure/fracture/crossing_criterion.hpp"

/// Prints which criteria let a fracture cross a natural one, over angle and friction
/// (docs/natural_fractures.md).
using namespace fissura;
using namespace fissura::structure;

namespace {

struct Remote {
  double greatest = 0, least = 0;  // compression [Pa]
};

struct Criterion {
  CrossingRule rule = CrossingRule::gu_weng;
  char letter = 0;
};

constexpr std::array remotes{Remote{15e6, 10e6}, Remote{12e6, 10e6}};
constexpr std::array criteria{Criterion{CrossingRule::renshaw_pollard, 'R'},
                              Criterion{CrossingRule::gu_weng, 'G'}, Criterion{CrossingRule::blanton, 'B'}};
constexpr double strength = 1e6;

CrossingVerdict verdict(const Criterion& criterion, const Remote& remote, int degrees, double friction) {
  const double angle = degrees * std::numbers::pi / 180;
  return crossing_verdict(criterion.rule, {{1, 0},
                                           {std::cos(angle), std::sin(angle)},
                                           {-remote.greatest, -remote.least, 0},
                                           friction,
                                           0,
                                           strength});
}

std::string least_friction(const Criterion& criterion, const Remote& remote, int degrees) {
  const auto critical = verdict(criterion, remote, degrees, 0).critical_friction;
  return critical ? fmt::format("{:.3f}", *critical) : "-";
}

std::string crossing(const Remote& remote, int degrees, double friction) {
  std::string letters;
  for (const Criterion& criterion : criteria)
    if (verdict(criterion, remote, degrees, friction).crosses) letters += criterion.letter;
  return letters.empty() ? "." : letters;
}

}  // namespace

int main() {
  for (const Remote& remote : remotes) {
    fmt::print("\nLeast friction with which it crosses, {:g}/{:g} MPa\n\n", remote.greatest / 1e6,
               remote.least / 1e6);
    fmt::print("| angle | renshaw_pollard | gu_weng | blanton |\n|---|---|---|---|\n");
    for (int degrees = 90; degrees >= 30; degrees -= 10) {
      fmt::print("| {} |", degrees);
      for (const Criterion& criterion : criteria)
        fmt::print(" {} |", least_friction(criterion, remote, degrees));
      fmt::print("\n");
    }
    fmt::print("\nThe same as a map: R, G, B where it crosses by that criterion\n\n| angle |");
    for (int tenth = 1; tenth <= 10; ++tenth) fmt::print(" {:.1f} |", tenth / 10.0);
    fmt::print("\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int degrees = 90; degrees >= 30; degrees -= 10) {
      fmt::print("| {} |", degrees);
      for (int tenth = 1; tenth <= 10; ++tenth) fmt::print(" {} |", crossing(remote, degrees, tenth / 10.0));
      fmt::print("\n");
    }
  }
}
