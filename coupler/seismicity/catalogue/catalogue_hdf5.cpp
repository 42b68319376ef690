// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/catalogue_hdf5.hpp"

#include <fmt/format.h>

#include <cstring>

#include "common/errors.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/seismicity/catalogue/column_values.hpp"
#include "coupler/seismicity/catalogue/controls_text.hpp"

namespace fissura::coupler {

namespace {

constexpr std::uint64_t schema = 1;

template <class Value>
constexpr const char* type_name = "float64";
template <>
constexpr const char* type_name<std::uint64_t> = "uint64";
template <>
constexpr const char* type_name<std::uint8_t> = "uint8";

template <class Value>
Array array_of(std::string_view unit, const std::vector<Value>& values) {
  Array array;
  array.dtype = type_name<Value>;
  array.unit = unit;
  array.shape = {values.size()};
  array.bytes.resize(values.size() * sizeof(Value));
  if (!values.empty()) std::memcpy(array.bytes.data(), values.data(), array.bytes.size());
  return array;
}

template <class Value>
std::vector<Value> values_in(const Array& array) {
  std::vector<Value> values(array.bytes.size() / sizeof(Value));
  if (!values.empty()) std::memcpy(values.data(), array.bytes.data(), array.bytes.size());
  return values;
}

std::string dataset_of(const EventColumn& column) {
  return fmt::format("/events/{}", column.name);
}

void write_column(Hdf5File& file, const EventColumn& column, const ColumnValues& all) {
  std::visit(
      [&](const auto& values) {
        using Values = std::decay_t<decltype(values)>;
        if constexpr (!std::is_same_v<Values, std::monostate>) {
          file.write(dataset_of(column), array_of(column.unit, values));
          file.write_attribute(dataset_of(column), "meaning", std::string(column.meaning));
        }
      },
      all);
  const std::string words = listed_words(column);
  if (!words.empty()) file.write_attribute(dataset_of(column), "words", words);
}

void write_sums(Hdf5File& file, const SeismicSums& sums) {
  const auto tensor = [&](const char* name, const PlaneTensor& moment) {
    file.write(fmt::format("/sums/{}", name),
               array_of("N m", std::vector<double>(moment.begin(), moment.end())));
  };
  tensor("raw", sums.raw);
  tensor("aseismic", sums.aseismic);
  tensor("events", sums.events);
  file.write_attribute("/sums", "event_moment", sums.event_moment);
  file.write_attribute("/sums", "seismic_sum", sums.seismic_sum);
  file.write_attribute("/sums", "aseismic_sum", sums.aseismic_sum);
  file.write_attribute("/sums", "greatest_moment", sums.greatest_moment);
  file.write_attribute("/sums", "records", sums.records);
  file.write_attribute("/sums", "event_count", sums.event_count);
}

void write_context(Hdf5File& file, const CatalogueContext& context) {
  for (const Control& control : controls_of(context.controls))
    file.write(fmt::format("/parameters/{}", control.name),
               array_of(control.unit, std::vector<double>{control.value}));
  file.write_attribute("/", "schema", schema);
  file.write_attribute("/", "run_id", context.run_id);
  file.write_attribute("/", "title", context.title);
  file.write_attribute("/", "controls", controls_id(context.controls));
  file.write_attribute("/", "scalar_moments", std::string("silver-jordan"));
  file.write_attribute("/", "shares", std::string("vavrycuk"));
  if (!context.started.empty()) file.write_attribute("/", "started", context.started);
  if (context.georeference) file.write_attribute("/", "time_zero", context.georeference->start);
}

ColumnValues read_column(const Hdf5File& file, const EventColumn& column) {
  const Array array = file.read(dataset_of(column));
  if (array.shape.size() != 1) return std::monostate();
  if (array.dtype == type_name<double>) return values_in<double>(array);
  if (array.dtype == type_name<std::uint64_t>) return values_in<std::uint64_t>(array);
  if (array.dtype == type_name<std::uint8_t>) return values_in<std::uint8_t>(array);
  return std::monostate();
}

}  // namespace

void write_catalogue_hdf5(const std::filesystem::path& file, const std::vector<SeismicEvent>& events,
                          const SeismicSums& sums, const CatalogueContext& context) {
  const std::filesystem::path part = file.string() + ".part";
  Hdf5File output = Hdf5File::create(part);
  for (const char* group : {"/events", "/sums", "/parameters"}) output.create_group(group);
  for (const EventColumn& column : event_columns())
    write_column(output, column, column_values(column, events, context));
  write_sums(output, sums);
  write_context(output, context);
  output.close();
  publish(part, file);
}

std::vector<SeismicEvent> read_catalogue_hdf5(const std::filesystem::path& file) {
  const Hdf5File input = Hdf5File::open(file);
  const Array first = input.describe(dataset_of(event_columns().front()));
  if (first.shape.size() != 1) throw InputError(fmt::format("{}: event_id is no column", file.string()));
  std::vector<SeismicEvent> events(first.shape[0]);
  try {
    for (const EventColumn& column : event_columns())
      if (!is_derived(column)) take_values(column, read_column(input, column), events);
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", file.string(), fault.what()));
  }
  return events;
}

}  // namespace fissura::coupler
