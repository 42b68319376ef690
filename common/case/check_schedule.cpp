// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/case/check_case.hpp"

namespace fissura::input {

namespace {

class ScheduleCheck {
 public:
  ScheduleCheck(const Case& value, const SourceValue& document, FaultList& faults)
      : case_(value), document_(document), faults_(faults) {}

  void stage(std::size_t index) const {
    const std::vector<Stage>& stages = case_.injection.stages;
    const Stage& stage = stages[index];
    if (index == 0 && stage.begin > 0)
      refuse(
          index, "begin", seconds(stage.begin),
          "0 s for the first stage: the schedule has a gap before it (a first stage may be shut_in = true)");
    if (index > 0 && stage.begin <= stages[index - 1].begin)
      refuse(
          index, "begin", seconds(stage.begin),
          fmt::format("later than the stage before, which begins at {}", seconds(stages[index - 1].begin)));
    if (stage.begin >= case_.time.end)
      refuse(index, "begin", seconds(stage.begin),
             fmt::format("earlier than the end of the run, time.end = {}", seconds(case_.time.end)));
    if (duration(index) > 0 && stage.ramp > duration(index))
      refuse(index, "ramp", seconds(stage.ramp),
             fmt::format("at most the {} until the next stage or the end of the run, which it would overlap",
                         seconds(duration(index))));
    if (stage.pressure < case_.pressure_range.minimum || stage.pressure > case_.pressure_range.maximum)
      refuse(index, "pressure", fmt::format("{} Pa", stage.pressure),
             fmt::format("within pressure_range, {} to {} Pa", case_.pressure_range.minimum,
                         case_.pressure_range.maximum));
    fluid(index);
  }

  void intervals() const {
    const double interval = case_.coupling.maximum_interval;
    if (interval > 0) coupling_interval(interval);
    at_most_the_run("output.interval", case_.output.interval);
  }

 private:
  static std::string seconds(double time) { return fmt::format("{:.6g} s", time); }

  /// Until the next stage or the end of the run.
  [[nodiscard]] double duration(std::size_t index) const {
    const std::vector<Stage>& stages = case_.injection.stages;
    const double end = index + 1 < stages.size() ? stages[index + 1].begin : case_.time.end;
    return end - stages[index].begin;
  }

  void fluid(std::size_t index) const {
    const std::string& name = case_.injection.stages[index].fluid;
    std::vector<std::string> known;
    for (const Fluid& candidate : case_.fluids) known.push_back(candidate.name);
    const bool readable = !known.empty() || member_of(document_, "fluid") == nullptr;
    if (name.empty() || !readable || std::find(known.begin(), known.end(), name) != known.end()) return;
    const std::string key = fmt::format("injection.stage[{}].fluid", index);
    faults_.push_back({position_of(document_, key), key, fmt::format("\"{}\"", name),
                       known.empty() ? "the name of a [[fluid]]; the case has none"
                                     : "the name of a [[fluid]]: " + listed(known),
                       closest_word(name, known)});
  }

  void coupling_interval(double interval) const {
    const Rock& rock = case_.rock;
    const double nu = rock.poissons_ratio;
    const double wave_modulus = rock.youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const double explicit_step = 0.5 * case_.mesh.fracture_size / std::sqrt(wave_modulus / rock.density);
    const std::string key = "coupling.maximum_interval";
    if (interval < explicit_step)
      refuse(key, seconds(interval),
             fmt::format("at least an explicit step of the structure, about {}", seconds(explicit_step)));
    for (std::size_t i = 0; i < case_.injection.stages.size(); ++i)
      if (duration(i) > 0 && interval > duration(i)) {
        refuse(key, seconds(interval),
               fmt::format("at most the duration of every stage; injection.stage[{}] lasts {}", i,
                           seconds(duration(i))));
        return;
      }
  }

  void at_most_the_run(const std::string& key, double interval) const {
    if (interval > case_.time.end)
      refuse(key, seconds(interval), fmt::format("at most the run, time.end = {}", seconds(case_.time.end)));
  }

  void refuse(std::size_t stage, const char* key, const std::string& found,
              const std::string& expected) const {
    refuse(fmt::format("injection.stage[{}].{}", stage, key), found, expected);
  }

  void refuse(const std::string& key, const std::string& found, const std::string& expected) const {
    faults_.push_back({position_of(document_, key), key, found, expected, ""});
  }

  const Case& case_;
  const SourceValue& document_;
  FaultList& faults_;
};

}  // namespace

void check_schedule(const Case& value, const SourceValue& document, FaultList& faults) {
  const ScheduleCheck check(value, document, faults);
  for (std::size_t i = 0; i < value.injection.stages.size(); ++i) check.stage(i);
  check.intervals();
}

}  // namespace fissura::input
