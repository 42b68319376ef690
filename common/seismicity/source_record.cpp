// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/seismicity/source_record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <span>
#include <tuple>

#include "common/errors.hpp"

namespace fissura {

namespace {

/// Where the values of one array stand in a record.
template <class Value>
struct Column {
  const char* name;
  const char* unit;
  std::vector<std::function<Value&(SourceRecord&)>> entries;
};

using Record = SourceRecord;

const std::vector<Column<double>>& number_columns() {
  static const std::vector<Column<double>> columns{
      {"source_time",
       "s",
       {[](Record& r) -> double& { return r.begin; }, [](Record& r) -> double& { return r.end; },
        [](Record& r) -> double& { return r.centroid_time; }}},
      {"source_position",
       "m",
       {[](Record& r) -> double& { return r.position[0]; },
        [](Record& r) -> double& { return r.position[1]; }}},
      {"source_extent", "m2 or m3", {[](Record& r) -> double& { return r.extent; }}},
      {"source_element_size", "m", {[](Record& r) -> double& { return r.element_size; }}},
      {"source_normal",
       "1",
       {[](Record& r) -> double& { return r.normal[0]; }, [](Record& r) -> double& { return r.normal[1]; }}},
      {"source_jump",
       "m",
       {[](Record& r) -> double& { return r.jump[0]; }, [](Record& r) -> double& { return r.jump[1]; }}},
      {"source_moment",
       "N m",
       {[](Record& r) -> double& { return r.moment[0]; }, [](Record& r) -> double& { return r.moment[1]; },
        [](Record& r) -> double& { return r.moment[2]; }, [](Record& r) -> double& { return r.moment[3]; }}},
      {"source_pseudo_moment",
       "N m",
       {[](Record& r) -> double& { return r.pseudo_moment[0]; },
        [](Record& r) -> double& { return r.pseudo_moment[1]; },
        [](Record& r) -> double& { return r.pseudo_moment[2]; },
        [](Record& r) -> double& { return r.pseudo_moment[3]; }}},
      {"source_measure", "1 or m", {[](Record& r) -> double& { return r.measure; }}},
      {"source_peak_rate", "m/s", {[](Record& r) -> double& { return r.peak_rate; }}},
      {"source_traction",
       "Pa",
       {[](Record& r) -> double& { return r.normal_before; },
        [](Record& r) -> double& { return r.normal_after; },
        [](Record& r) -> double& { return r.shear_before; },
        [](Record& r) -> double& { return r.shear_after; }}},
      {"source_fluid_pressure", "Pa", {[](Record& r) -> double& { return r.fluid_pressure; }}},
      {"source_mass_scale", "1", {[](Record& r) -> double& { return r.mass_scale; }}}};
  return columns;
}

constexpr std::size_t flags = 3;     // kind, fracture, failing
constexpr std::size_t numerals = 4;  // line, entity, interval, geometry

template <class Value>
Array array_of(const char* name, const char* dtype, const char* unit, const std::vector<Value>& values,
               std::size_t columns) {
  Array array;
  array.name = name;
  array.dtype = dtype;
  array.unit = unit;
  array.shape = {values.size() / columns};
  if (columns > 1) array.shape.push_back(columns);
  array.bytes.resize(values.size() * sizeof(Value));
  std::memcpy(array.bytes.data(), values.data(), array.bytes.size());
  return array;
}

const Array* find(const std::vector<Array>& arrays, const std::string& name) {
  for (const Array& array : arrays)
    if (array.name == name) return &array;
  return nullptr;
}

template <class Value>
std::vector<Value> values_in(const std::vector<Array>& arrays, const char* name, const char* dtype,
                             std::size_t rows, std::size_t columns) {
  const Array* array = find(arrays, name);
  if (array == nullptr)
    throw ProtocolError(fmt::format("records of sources come without the array {}", name));
  std::vector<std::uint64_t> shape{rows};
  if (columns > 1) shape.push_back(columns);
  if (array->dtype != dtype || array->shape != shape || array->bytes.size() != rows * columns * sizeof(Value))
    throw ProtocolError(fmt::format("{} is no {} array of {} x {} values", name, dtype, rows, columns));
  std::vector<Value> values(rows * columns);
  std::memcpy(values.data(), array->bytes.data(), array->bytes.size());
  return values;
}

SourceKind kind_of(std::uint8_t number) {
  if (number < 1 || number > 6) throw ProtocolError(fmt::format("source_kind {} is unknown", number));
  return static_cast<SourceKind>(number);
}

SourceFracture fracture_of(std::uint8_t number) {
  if (number > 2 && number != 255) throw ProtocolError(fmt::format("source_fracture {} is unknown", number));
  return static_cast<SourceFracture>(number);
}

}  // namespace

bool comes_before(const SourceRecord& a, const SourceRecord& b) {
  const auto key = [](const SourceRecord& r) {
    return std::tuple(r.end, !in_bulk(r.kind), r.entity, static_cast<std::uint8_t>(r.kind), r.begin);
  };
  return key(a) < key(b);
}

std::vector<Array> arrays_of(const std::vector<SourceRecord>& records) {
  if (records.empty()) return {};
  std::vector<std::uint8_t> kinds;
  std::vector<std::uint64_t> numbers;
  for (const SourceRecord& r : records) {
    kinds.insert(kinds.end(), {static_cast<std::uint8_t>(r.kind), static_cast<std::uint8_t>(r.fracture),
                               static_cast<std::uint8_t>(r.failing ? 1 : 0)});
    numbers.insert(numbers.end(), {r.line, r.entity, r.interval, r.geometry});
  }
  std::vector<Array> arrays{array_of("source_kind", "uint8", "1", kinds, flags),
                            array_of("source_number", "uint64", "1", numbers, numerals)};
  for (const Column<double>& column : number_columns()) {
    std::vector<double> values;
    values.reserve(records.size() * column.entries.size());
    for (SourceRecord record : records)
      for (const auto& entry : column.entries) values.push_back(entry(record));
    arrays.push_back(array_of(column.name, "float64", column.unit, values, column.entries.size()));
  }
  return arrays;
}

std::vector<SourceRecord> records_of(const std::vector<Array>& arrays) {
  const Array* first = find(arrays, "source_kind");
  if (first == nullptr) {
    for (const Array& array : arrays)
      if (array.name.starts_with("source_"))
        throw ProtocolError(fmt::format("{} came without source_kind", array.name));
    return {};
  }
  if (first->shape.empty()) throw ProtocolError("source_kind has no rows");
  const std::size_t rows = first->shape.front();
  const auto kinds = values_in<std::uint8_t>(arrays, "source_kind", "uint8", rows, flags);
  const auto numbers = values_in<std::uint64_t>(arrays, "source_number", "uint64", rows, numerals);
  std::vector<SourceRecord> records(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    SourceRecord& r = records[i];
    r.kind = kind_of(kinds[flags * i]);
    r.fracture = fracture_of(kinds[flags * i + 1]);
    r.failing = kinds[flags * i + 2] != 0;
    r.line = static_cast<std::uint32_t>(numbers[numerals * i]);
    r.entity = numbers[numerals * i + 1];
    r.interval = numbers[numerals * i + 2];
    r.geometry = numbers[numerals * i + 3];
  }
  for (const Column<double>& column : number_columns()) {
    const std::size_t width = column.entries.size();
    const auto values = values_in<double>(arrays, column.name, "float64", rows, width);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t k = 0; k < width; ++k) {
        const double value = values[width * i + k];
        if (!std::isfinite(value))
          throw ValueError(fmt::format("{} of source {} is not finite", column.name, i));
        column.entries[k](records[i]) = value;
      }
  }
  return records;
}

}  // namespace fissura
