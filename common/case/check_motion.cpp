// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/case/check_case.hpp"

namespace fissura::input {

namespace {

class MotionCheck {
 public:
  MotionCheck(const Case& value, const SourceValue& document, FaultList& faults)
      : case_(value), document_(document), faults_(faults) {}

  void velocity(std::size_t index) const {
    const InitialVelocity& part = case_.initial_velocities[index];
    const std::string key = fmt::format("initial_velocity[{}]", index);
    if (part.west >= part.east)
      refuse(key + ".east", fmt::format("{} m", part.east), fmt::format("east of west, {} m", part.west));
    if (part.south >= part.north)
      refuse(key + ".north", fmt::format("{} m", part.north),
             fmt::format("north of south, {} m", part.south));
    if (part.west > half_width() || part.east < -half_width() || part.south > half_height() ||
        part.north < -half_height())
      refuse(
          key,
          fmt::format("x from {} to {} m, y from {} to {} m", part.west, part.east, part.south, part.north),
          fmt::format("a rectangle that overlaps the domain, |x| <= {} m and |y| <= {} m", half_width(),
                      half_height()));
  }

  void probe(std::size_t index) const {
    const std::vector<Probe>& probes = case_.output.probes;
    const Probe& probe = probes[index];
    const std::string key = fmt::format("output.probe[{}]", index);
    if (std::abs(probe.position[0]) > half_width() || std::abs(probe.position[1]) > half_height())
      refuse(
          key + ".position", fmt::format("({:.6g}, {:.6g}) m", probe.position[0], probe.position[1]),
          fmt::format("a point inside the domain, |x| <= {} m and |y| <= {} m", half_width(), half_height()));
    const auto end = probes.begin() + static_cast<std::ptrdiff_t>(index);
    const auto same_name = [&](const Probe& other) { return other.name == probe.name; };
    if (!probe.name.empty() && std::any_of(probes.begin(), end, same_name))
      refuse(key + ".name", fmt::format("\"{}\" once more", probe.name), "a name that no other probe has");
  }

 private:
  [[nodiscard]] double half_width() const { return case_.domain.width / 2; }
  [[nodiscard]] double half_height() const { return case_.domain.height / 2; }

  void refuse(const std::string& key, const std::string& found, const std::string& expected) const {
    faults_.push_back({position_of(document_, key), key, found, expected, ""});
  }

  const Case& case_;
  const SourceValue& document_;
  FaultList& faults_;
};

}  // namespace

void check_motion(const Case& value, const SourceValue& document, FaultList& faults) {
  const MotionCheck check(value, document, faults);
  for (std::size_t i = 0; i < value.initial_velocities.size(); ++i) check.velocity(i);
  for (std::size_t i = 0; i < value.output.probes.size(); ++i) check.probe(i);
}

}  // namespace fissura::input
