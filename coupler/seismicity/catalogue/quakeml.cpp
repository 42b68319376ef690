// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/quakeml.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <pugixml.hpp>

#include "common/errors.hpp"
#include "coupler/seismicity/catalogue/event_columns.hpp"
#include "coupler/seismicity/catalogue/geographic_place.hpp"
#include "coupler/seismicity/catalogue/utc_time.hpp"

namespace fissura::coupler {

namespace {

using pugi::xml_node;

constexpr std::array columns_with_a_place{"event_id", "utc", "lat",  "lon",     "depth", "M0",   "Mw",
                                          "strike",   "dip", "rake", "strike2", "dip2",  "rake2"};

std::string number(double value) {
  return fmt::format("{}", value);
}

void text(xml_node parent, const char* element, const std::string& content) {
  parent.append_child(element).text().set(content.c_str());
}

void quantity(xml_node parent, const char* element, const std::string& value) {
  text(parent.append_child(element), "value", value);
}

/// Writes the events of one catalogue.
class EventWriter {
 public:
  explicit EventWriter(const CatalogueContext& context)
      : context_(context),
        prefix_(fmt::format("smi:local/fissura/{}/{}", context.run_id, controls_id(context.controls))) {
    for (const EventColumn& column : event_columns()) {
      bool has_a_place = false;
      for (const std::string_view name : columns_with_a_place) has_a_place |= name == column.name;
      if (!has_a_place) own_.push_back({&column, "fissura:" + column.text_name()});
    }
  }

  [[nodiscard]] const std::string& prefix() const { return prefix_; }

  void write(xml_node parent, const SeismicEvent& event) const {
    const std::string id = fmt::format("{}/event/{}", prefix_, event.id);
    xml_node node = parent.append_child("event");
    node.append_attribute("publicID") = id.c_str();
    text(node, "preferredOriginID", id + "/origin");
    if (event.magnitude) text(node, "preferredMagnitudeID", id + "/magnitude");
    text(node, "preferredFocalMechanismID", id + "/mechanism");
    text(node, "type", "fluid injection");
    text(node, "typeCertainty", "known");
    write_origin(node, event, id);
    if (event.magnitude) write_magnitude(node, event, id);
    write_mechanism(node, event, id);
    for (const OwnElement& element : own_)
      text(node, element.name.c_str(), cell_text(*element.column, event, context_));
  }

 private:
  void write_origin(xml_node parent, const SeismicEvent& event, const std::string& id) const {
    const Georeference& georeference = *context_.georeference;
    const GeographicPlace place = geographic_place(event.centroid, georeference, context_.controls.geography);
    xml_node node = parent.append_child("origin");
    node.append_attribute("publicID") = (id + "/origin").c_str();
    quantity(node, "time", utc_after(georeference.start, event.centroid_time));
    quantity(node, "longitude", number(place.longitude));
    quantity(node, "latitude", number(place.latitude));
    quantity(node, "depth", number(place.depth));
    text(node, "depthType", "operator assigned");
    text(node, "methodID", "smi:local/fissura/explicit-finite-elements");
    text(node, "type", "centroid");
    text(node, "evaluationMode", "automatic");
  }

  void write_magnitude(xml_node parent, const SeismicEvent& event, const std::string& id) const {
    xml_node node = parent.append_child("magnitude");
    node.append_attribute("publicID") = (id + "/magnitude").c_str();
    quantity(node, "mag", number(*event.magnitude));
    text(node, "type", "Mw");
    text(node, "originID", id + "/origin");
    text(node, "methodID", "smi:local/fissura/silver-jordan-iaspei");
    text(node, "evaluationMode", "automatic");
  }

  void write_mechanism(xml_node parent, const SeismicEvent& event, const std::string& id) const {
    xml_node node = parent.append_child("focalMechanism");
    node.append_attribute("publicID") = (id + "/mechanism").c_str();
    if (event.magnitude) {
      write_planes(node, event);
      write_axes(node, event);
    }
    write_tensor(node, event, id);
    text(node, "methodID", "smi:local/fissura/stress-glut");
    text(node, "evaluationMode", "automatic");
  }

  static void write_planes(xml_node parent, const SeismicEvent& event) {
    xml_node node = parent.append_child("nodalPlanes");
    node.append_attribute("preferredPlane") = 1;
    const auto write_plane = [&](const char* element, const NodalPlane& plane) {
      xml_node child = node.append_child(element);
      quantity(child, "strike", degrees_text(plane.strike));
      quantity(child, "dip", degrees_text(plane.dip));
      quantity(child, "rake", degrees_text(plane.rake));
    };
    write_plane("nodalPlane1", event.plane);
    write_plane("nodalPlane2", event.auxiliary_plane);
  }

  void write_axes(xml_node parent, const SeismicEvent& event) const {
    const PrincipalMoments moments = principal_moments(event.moment);
    xml_node node = parent.append_child("principalAxes");
    const auto write_axis = [&](const char* element, std::size_t i) {
      const AxisDirection direction = axis_direction(moments.axis[i], context_.controls.geography);
      xml_node child = node.append_child(element);
      quantity(child, "azimuth", degrees_text(direction.azimuth));
      quantity(child, "plunge", degrees_text(direction.plunge));
      quantity(child, "length", number(moments.value[i]));
    };
    write_axis("tAxis", 0);
    write_axis("pAxis", 2);
    write_axis("nAxis", 1);
  }

  void write_tensor(xml_node parent, const SeismicEvent& event, const std::string& id) const {
    xml_node node = parent.append_child("momentTensor");
    node.append_attribute("publicID") = (id + "/tensor").c_str();
    text(node, "derivedOriginID", id + "/origin");
    if (event.magnitude) text(node, "momentMagnitudeID", id + "/magnitude");
    quantity(node, "scalarMoment", number(event.scalar_moment));
    xml_node tensor = node.append_child("tensor");
    const std::array<double, 6> components = up_south_east(event.moment, context_.controls.geography);
    constexpr std::array names{"Mrr", "Mtt", "Mpp", "Mrt", "Mrp", "Mtp"};
    for (std::size_t i = 0; i < names.size(); ++i) quantity(tensor, names[i], number(components[i]));
    text(node, "doubleCouple", number(event.shares.dc));
    text(node, "clvd", number(std::abs(event.shares.clvd)));
    text(node, "iso", number(std::abs(event.shares.iso)));
    text(node, "methodID", "smi:local/fissura/vavrycuk");
    xml_node function = node.append_child("sourceTimeFunction");
    text(function, "type", "unknown");
    text(function, "duration", number(event.duration));
    text(node, "inversionType", "general");
  }

  struct OwnElement {
    const EventColumn* column;
    std::string name;
  };

  const CatalogueContext& context_;
  std::string prefix_;
  std::vector<OwnElement> own_;
};

void write_creation(xml_node parent, const CatalogueContext& context) {
  xml_node node = parent.append_child("creationInfo");
  text(node, "agencyID", "fissura");
  text(node, "author", "Fissura " FISSURA_VERSION);
  if (!context.started.empty()) text(node, "creationTime", context.started);
}

struct StringWriter : pugi::xml_writer {
  std::string content;
  void write(const void* data, std::size_t size) override {
    content.append(static_cast<const char*>(data), size);
  }
};

}  // namespace

std::string quakeml(const std::vector<SeismicEvent>& events, const CatalogueContext& context) {
  if (!context.georeference)
    throw Error(ExitCode::precondition,
                "QuakeML needs to know where on Earth and when: the case has no [georeference] with the keys "
                "latitude, longitude, depth and start; the other formats of the catalogue do without");
  pugi::xml_document document;
  xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  xml_node root = document.append_child("q:quakeml");
  root.append_attribute("xmlns") = "http://quakeml.org/xmlns/bed/1.2";
  root.append_attribute("xmlns:q") = "http://quakeml.org/xmlns/quakeml/1.2";
  root.append_attribute("xmlns:fissura") = "urn:fissura:catalogue:1";

  const EventWriter writer(context);
  xml_node parameters = root.append_child("eventParameters");
  parameters.append_attribute("publicID") = writer.prefix().c_str();
  text(parameters, "description",
       fmt::format("{}: computed events of a numerical model, not observed ones", context.title));
  write_creation(parameters, context);
  for (const SeismicEvent& event : events) writer.write(parameters, event);

  StringWriter output;
  document.save(output, " ", pugi::format_indent, pugi::encoding_utf8);
  return std::move(output.content);
}

}  // namespace fissura::coupler
