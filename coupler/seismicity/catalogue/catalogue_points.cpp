// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/catalogue_points.hpp"

#include <fmt/format.h>

#include <cstring>
#include <numeric>

#include "coupler/seismicity/catalogue/column_values.hpp"

namespace fissura::coupler {

namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// RFC 4648.
std::string base64(const std::vector<unsigned char>& bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const auto byte = [&](std::size_t i) { return at + i < bytes.size() ? unsigned{bytes[at + i]} : 0u; };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (unsigned i = 0; i < 4; ++i)
      text += at + i <= bytes.size() ? letters[group >> (18 - 6 * i) & 63u] : '=';
  }
  return text;
}

template <class Value>
std::string encoded(const std::vector<Value>& values) {
  const std::uint64_t count = values.size() * sizeof(Value);
  std::vector<unsigned char> bytes(sizeof count + count);
  std::memcpy(bytes.data(), &count, sizeof count);
  if (count > 0) std::memcpy(bytes.data() + sizeof count, values.data(), count);
  return base64(bytes);
}

template <class Value>
constexpr const char* type_name = "Float64";
template <>
constexpr const char* type_name<std::int64_t> = "Int64";
template <>
constexpr const char* type_name<std::uint64_t> = "UInt64";
template <>
constexpr const char* type_name<std::uint8_t> = "UInt8";

template <class Value>
void append_array(std::string& xml, std::string_view name, int components, const std::vector<Value>& values) {
  xml += fmt::format(
      R"(        <DataArray type="{}" Name="{}" NumberOfComponents="{}" format="binary">{}</DataArray>
)",
      type_name<Value>, name, components, encoded(values));
}

std::vector<double> positions(const std::vector<SeismicEvent>& events) {
  std::vector<double> values;
  for (const SeismicEvent& e : events) values.insert(values.end(), {e.centroid[0], e.centroid[1], 0.0});
  return values;
}

std::vector<double> normals(const std::vector<SeismicEvent>& events) {
  std::vector<double> values;
  for (const SeismicEvent& e : events) values.insert(values.end(), {e.normal[0], e.normal[1], 0.0});
  return values;
}

std::vector<double> tensors(const std::vector<SeismicEvent>& events) {
  std::vector<double> values;
  for (const SeismicEvent& e : events) {
    const auto& [xx, yy, zz, xy] = e.moment;
    values.insert(values.end(), {xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, zz});
  }
  return values;
}

/// Each event is a vertex of its own, without which nothing would be drawn.
std::string vertices(std::size_t count) {
  std::vector<std::int64_t> connectivity(count), offsets(count);
  std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
  std::iota(offsets.begin(), offsets.end(), std::int64_t{1});
  std::string xml = "      <Verts>\n";
  append_array(xml, "connectivity", 1, connectivity);
  append_array(xml, "offsets", 1, offsets);
  return xml + "      </Verts>\n";
}

}  // namespace

std::string catalogue_points(const std::vector<SeismicEvent>& events, const CatalogueContext& context) {
  std::string xml = fmt::format(R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <PolyData>
    <Piece NumberOfPoints="{0}" NumberOfVerts="{0}" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
      <Points>
)",
                                events.size());
  append_array(xml, "Points", 3, positions(events));
  xml += "      </Points>\n" + vertices(events.size());
  xml += R"(      <PointData Scalars="Mw" Tensors="moment_tensor" Normals="normal">
)";
  for (const EventColumn& column : event_columns())
    std::visit(
        [&](const auto& values) {
          using Values = std::decay_t<decltype(values)>;
          if constexpr (!std::is_same_v<Values, std::monostate>) append_array(xml, column.name, 1, values);
        },
        column_values(column, events, context));
  append_array(xml, "normal", 3, normals(events));
  append_array(xml, "moment_tensor", 9, tensors(events));
  return xml + R"(      </PointData>
    </Piece>
  </PolyData>
</VTKFile>
)";
}

}  // namespace fissura::coupler
