// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/seismic_events.hpp"

#include <algorithm>
#include <numeric>

#include "coupler/report/drawn_numbers.hpp"
#include "coupler/report/thinning.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;

const char* name_of(SourceFracture fracture) {
  switch (fracture) {
    case SourceFracture::open:
      return "open";
    case SourceFracture::natural:
      return "natural";
    case SourceFracture::grown:
      return "grown";
    case SourceFracture::none:
      break;
  }
  return "none";
}

}  // namespace

std::vector<std::size_t> events_to_draw(const std::vector<SeismicEvent>& events, std::size_t most) {
  std::vector<std::size_t> order(events.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (events.size() <= most) return order;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return events[a].scalar_moment > events[b].scalar_moment;
  });
  const auto greatest_end = order.begin() + static_cast<std::ptrdiff_t>(most / 2);
  std::vector<std::size_t> shown(order.begin(), greatest_end), rest(greatest_end, order.end());
  std::sort(rest.begin(), rest.end());
  for (const std::size_t place : evenly_spread(rest.size(), most - shown.size()))
    shown.push_back(rest[place]);
  std::sort(shown.begin(), shown.end());
  return shown;
}

json event_columns_json(const std::vector<SeismicEvent>& events, const std::vector<std::size_t>& shown) {
  json columns = json::object();
  const auto add = [&](const char* name, const auto& value) {
    json list = json::array();
    for (const std::size_t number : shown) list.push_back(value(events[number]));
    columns[name] = std::move(list);
  };
  const auto draw = [&](const char* name, const auto& value) {
    add(name, [&](const SeismicEvent& event) { return for_drawing(value(event)); });
  };
  add("id", [](const SeismicEvent& event) { return event.id; });
  add("t0", [](const SeismicEvent& event) { return event.origin_time; });
  add("tc", [](const SeismicEvent& event) { return event.centroid_time; });
  draw("x", [](const SeismicEvent& event) { return event.centroid[0]; });
  draw("y", [](const SeismicEvent& event) { return event.centroid[1]; });
  draw("M0", [](const SeismicEvent& event) { return event.scalar_moment; });
  add("Mw", [](const SeismicEvent& event) {
    return event.magnitude ? json(for_drawing(*event.magnitude)) : json();
  });
  const char* const components[]{"Mxx", "Myy", "Mzz", "Mxy"};
  for (std::size_t i = 0; i < 4; ++i)
    draw(components[i], [i](const SeismicEvent& event) { return event.moment[i]; });
  draw("iso", [](const SeismicEvent& event) { return event.shares.iso; });
  draw("clvd", [](const SeismicEvent& event) { return event.shares.clvd; });
  draw("dc", [](const SeismicEvent& event) { return event.shares.dc; });
  draw("u", [](const SeismicEvent& event) { return event.hudson.u; });
  draw("v", [](const SeismicEvent& event) { return event.hudson.v; });
  add("type", [](const SeismicEvent& event) { return name(event.type); });
  draw("nx", [](const SeismicEvent& event) { return event.normal[0]; });
  draw("ny", [](const SeismicEvent& event) { return event.normal[1]; });
  add("fracture", [](const SeismicEvent& event) { return name_of(event.fracture); });
  draw("length", [](const SeismicEvent& event) { return event.length; });
  draw("radius", [](const SeismicEvent& event) { return event.radius; });
  draw("slip", [](const SeismicEvent& event) { return event.slip; });
  draw("opening", [](const SeismicEvent& event) { return event.opening; });
  draw("duration", [](const SeismicEvent& event) { return event.duration; });
  return columns;
}

}  // namespace fissura::coupler
