// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/event_columns.hpp"

#include "coupler/seismicity/catalogue/geographic_place.hpp"
#include "coupler/seismicity/catalogue/utc_time.hpp"

namespace fissura::coupler {

namespace {

using Event = SeismicEvent;
using Context = CatalogueContext;

std::optional<GeographicPlace> place_of(const Event& event, const Context& context) {
  if (!context.georeference) return std::nullopt;
  return geographic_place(event.centroid, *context.georeference, context.controls.geography);
}

WordColumn type_column() {
  WordColumn column{[](const Event& e) { return static_cast<std::uint8_t>(e.type); },
                    [](Event& e, std::uint8_t number) { e.type = static_cast<EventType>(number); },
                    {}};
  for (const EventType type : {EventType::shear, EventType::tensile, EventType::closing, EventType::mixed})
    column.words.emplace_back(static_cast<std::uint8_t>(type), name(type));
  return column;
}

WordColumn fracture_column() {
  return {[](const Event& e) { return static_cast<std::uint8_t>(e.fracture); },
          [](Event& e, std::uint8_t number) { e.fracture = static_cast<SourceFracture>(number); },
          {{0, "open"}, {1, "natural"}, {2, "grown"}, {255, "none"}}};
}

std::vector<EventColumn> all_columns() {
  return {
      {"event_id", "", "1", "from 1, in the order in which events closed",
       CountColumn{[](const Event& e) { return e.id; }, [](Event& e, std::uint64_t n) { e.id = n; }}},
      {"t0", "_s", "s", "begin of the first record",
       NumberColumn{[](Event& e) -> double& { return e.origin_time; }}},
      {"tc", "_s", "s", "centroid in time",
       NumberColumn{[](Event& e) -> double& { return e.centroid_time; }}},
      {"utc", "", "1", "t0 as a time of day", DerivedTextColumn{[](const Event& e, const Context& c) {
         return c.georeference ? utc_after(c.georeference->start, e.origin_time) : std::string();
       }}},
      {"x", "_m", "m", "centroid", NumberColumn{[](Event& e) -> double& { return e.centroid[0]; }}},
      {"y", "_m", "m", "centroid", NumberColumn{[](Event& e) -> double& { return e.centroid[1]; }}},
      {"z", "_m", "m", "out of the plane of the model",
       DerivedColumn{[](const Event&, const Context&) { return std::optional(0.0); }}},
      {"lat", "", "degree", "latitude of the centroid", DerivedColumn{[](const Event& e, const Context& c) {
         const auto place = place_of(e, c);
         return place ? std::optional(place->latitude) : std::nullopt;
       }}},
      {"lon", "", "degree", "longitude of the centroid", DerivedColumn{[](const Event& e, const Context& c) {
         const auto place = place_of(e, c);
         return place ? std::optional(place->longitude) : std::nullopt;
       }}},
      {"depth", "_m", "m", "of the centroid, positive down",
       DerivedColumn{[](const Event& e, const Context& c) {
         const auto place = place_of(e, c);
         return place ? std::optional(place->depth) : std::nullopt;
       }}},
      {"M0", "_Nm", "N m", "scalar moment",
       NumberColumn{[](Event& e) -> double& { return e.scalar_moment; }}},
      {"Mw", "", "1", "moment magnitude, none if the records cancel",
       OptionalColumn{[](Event& e) -> std::optional<double>& { return e.magnitude; }}},
      {"Mxx", "", "N m", "moment tensor", NumberColumn{[](Event& e) -> double& { return e.moment[0]; }}},
      {"Myy", "", "N m", "moment tensor", NumberColumn{[](Event& e) -> double& { return e.moment[1]; }}},
      {"Mzz", "", "N m", "moment tensor", NumberColumn{[](Event& e) -> double& { return e.moment[2]; }}},
      {"Mxy", "", "N m", "moment tensor", NumberColumn{[](Event& e) -> double& { return e.moment[3]; }}},
      {"M0_scheme", "", "1", "of all scalar moments",
       DerivedTextColumn{[](const Event&, const Context&) { return std::string("silver-jordan"); }}},
      {"C_iso", "", "1", "isotropic share, signed",
       NumberColumn{[](Event& e) -> double& { return e.shares.iso; }}},
      {"C_clvd", "", "1", "share of the linear vector dipole, signed",
       NumberColumn{[](Event& e) -> double& { return e.shares.clvd; }}},
      {"C_dc", "", "1", "share of the double couple",
       NumberColumn{[](Event& e) -> double& { return e.shares.dc; }}},
      {"decomp", "", "1", "scheme of the shares",
       DerivedTextColumn{[](const Event&, const Context&) { return std::string("vavrycuk"); }}},
      {"u", "", "1", "in Hudson's diamond", NumberColumn{[](Event& e) -> double& { return e.hudson.u; }}},
      {"v", "", "1", "in Hudson's diamond", NumberColumn{[](Event& e) -> double& { return e.hudson.v; }}},
      {"slope", "_deg", "rad", "angle between slip vector and plane",
       AngleColumn{[](Event& e) -> double& { return e.slope; }}},
      {"strike", "", "rad", "of the plane that failed, from north, clockwise",
       AngleColumn{[](Event& e) -> double& { return e.plane.strike; }}},
      {"dip", "", "rad", "of the plane that failed",
       AngleColumn{[](Event& e) -> double& { return e.plane.dip; }}},
      {"rake", "", "rad", "on the plane that failed",
       AngleColumn{[](Event& e) -> double& { return e.plane.rake; }}},
      {"strike2", "", "rad", "of the auxiliary plane",
       AngleColumn{[](Event& e) -> double& { return e.auxiliary_plane.strike; }}},
      {"dip2", "", "rad", "of the auxiliary plane",
       AngleColumn{[](Event& e) -> double& { return e.auxiliary_plane.dip; }}},
      {"rake2", "", "rad", "on the auxiliary plane",
       AngleColumn{[](Event& e) -> double& { return e.auxiliary_plane.rake; }}},
      {"type", "", "1", "of the source", type_column()},
      {"area", "_m2", "m2", "that failed", NumberColumn{[](Event& e) -> double& { return e.area; }}},
      {"slip", "_m", "m", "mean along the plane", NumberColumn{[](Event& e) -> double& { return e.slip; }}},
      {"opening", "_m", "m", "mean across the plane",
       NumberColumn{[](Event& e) -> double& { return e.opening; }}},
      {"stress_drop", "_Pa", "Pa", "loss of shear traction, mean",
       NumberColumn{[](Event& e) -> double& { return e.stress_drop; }}},
      {"radius", "_m", "m", "root of the second moment of place",
       NumberColumn{[](Event& e) -> double& { return e.radius; }}},
      {"duration", "_s", "s", "first begin to last end of its records",
       NumberColumn{[](Event& e) -> double& { return e.duration; }}},
      {"n_rec", "", "1", "records",
       CountColumn{[](const Event& e) { return e.records; },
                   [](Event& e, std::uint64_t n) { e.records = n; }}},
      {"h_elem", "_m", "m", "smallest element size",
       NumberColumn{[](Event& e) -> double& { return e.element_size; }}},
      {"thickness", "_m", "m", "out of the plane, that the moment is formed with",
       NumberColumn{[](Event& e) -> double& { return e.thickness; }}},
      {"pseudo_M0", "_Nm", "N m", "of stress changes: another quantity",
       DerivedColumn{
           [](const Event& e, const Context&) { return std::optional(scalar_moment(e.pseudo_moment)); }}},
      {"p_fluid", "_Pa", "Pa", "fluid pressure, mean",
       NumberColumn{[](Event& e) -> double& { return e.fluid_pressure; }}},
      {"window", "", "1", "coupling interval of the last record",
       CountColumn{[](const Event& e) { return e.interval; },
                   [](Event& e, std::uint64_t n) { e.interval = n; }}},
      {"x0", "_m", "m", "place of the first record",
       NumberColumn{[](Event& e) -> double& { return e.origin[0]; }}},
      {"y0", "_m", "m", "place of the first record",
       NumberColumn{[](Event& e) -> double& { return e.origin[1]; }}},
      {"nx", "", "1", "normal of the plane that failed",
       NumberColumn{[](Event& e) -> double& { return e.normal[0]; }}},
      {"ny", "", "1", "normal of the plane that failed",
       NumberColumn{[](Event& e) -> double& { return e.normal[1]; }}},
      {"M0_sum", "_Nm", "N m", "sum of the scalar moments of the records",
       NumberColumn{[](Event& e) -> double& { return e.scalar_sum; }}},
      {"coherence", "", "1", "M0 over M0_sum", NumberColumn{[](Event& e) -> double& { return e.coherence; }}},
      {"fracture", "", "1", "where most of the moment lies", fracture_column()},
      {"line", "", "1", "number of that fracture in the mesh",
       CountColumn{[](const Event& e) { return std::uint64_t{e.line}; },
                   [](Event& e, std::uint64_t n) { e.line = static_cast<std::uint32_t>(n); }}},
      {"length", "_m", "m", "extent along the plane",
       NumberColumn{[](Event& e) -> double& { return e.length; }}},
      {"peak_rate", "_m_s", "m/s", "greatest of its records",
       NumberColumn{[](Event& e) -> double& { return e.peak_rate; }}},
      {"r_c", "_m", "m", "radius of clustering",
       NumberColumn{[](Event& e) -> double& { return e.radius_of_clustering; }}},
      {"t_c", "_s", "s", "time of clustering",
       NumberColumn{[](Event& e) -> double& { return e.time_of_clustering; }}},
      {"n_sources", "", "1", "elements and contact units",
       CountColumn{[](const Event& e) { return e.sources; },
                   [](Event& e, std::uint64_t n) { e.sources = n; }}},
      {"pseudo_Mxx", "_Nm", "N m", "tensor of stress changes",
       NumberColumn{[](Event& e) -> double& { return e.pseudo_moment[0]; }}},
      {"pseudo_Myy", "_Nm", "N m", "tensor of stress changes",
       NumberColumn{[](Event& e) -> double& { return e.pseudo_moment[1]; }}},
      {"pseudo_Mzz", "_Nm", "N m", "tensor of stress changes",
       NumberColumn{[](Event& e) -> double& { return e.pseudo_moment[2]; }}},
      {"pseudo_Mxy", "_Nm", "N m", "tensor of stress changes",
       NumberColumn{[](Event& e) -> double& { return e.pseudo_moment[3]; }}},
  };
}

}  // namespace

const std::vector<EventColumn>& event_columns() {
  static const std::vector<EventColumn> columns = all_columns();
  return columns;
}

bool is_derived(const EventColumn& column) {
  return std::holds_alternative<DerivedColumn>(column.content) ||
         std::holds_alternative<DerivedTextColumn>(column.content);
}

}  // namespace fissura::coupler
