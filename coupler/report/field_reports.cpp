// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/field_reports.hpp"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "coupler/record/segment_index.hpp"

namespace fissura::coupler {

namespace {

template <typename Value>
std::vector<double> converted(const Array& array) {
  std::vector<Value> values(array.bytes.size() / sizeof(Value));
  if (!values.empty()) std::memcpy(values.data(), array.bytes.data(), array.bytes.size());
  return {values.begin(), values.end()};
}

std::vector<double> numbers(const Array& array) {
  if (array.dtype == "float64") return converted<double>(array);
  if (array.dtype == "uint64") return converted<std::uint64_t>(array);
  if (array.dtype == "int64") return converted<std::int64_t>(array);
  return converted<std::uint8_t>(array);
}

const std::string& segment_with(const std::map<std::uint64_t, std::string>& segments, std::uint64_t number,
                                const char* what) {
  const auto found = segments.find(number);
  if (found == segments.end())
    throw StorageError(fmt::format("no segment of segments/index.jsonl holds {} {}", what, number));
  return found->second;
}

}  // namespace

FieldReports::FieldReports(const std::filesystem::path& run_directory) : folder_(run_directory / "segments") {
  const std::filesystem::path index = folder_ / "index.jsonl";
  if (!std::filesystem::exists(index)) return;
  try {
    for (const nlohmann::json& line : segment_index(index)) take_in(line);
  } catch (const nlohmann::json::exception& fault) {
    throw StorageError(fmt::format("{} is damaged: {}", index.string(), fault.what()));
  }
}

void FieldReports::take_in(const nlohmann::json& entry) {
  const std::string segment = entry.at("file");
  index_[segment] = entry;
  for (const std::uint64_t geometry : entry.at("meshes")) segment_of_mesh_[geometry] = segment;
  for (const std::uint64_t revision : entry.at("networks")) segment_of_network_[revision] = segment;
  const std::uint64_t last = entry.at("reports").at(1);
  for (std::uint64_t number = entry.at("reports").at(0); number <= last; ++number) {
    const std::string group = fmt::format("/reports/{:06}", number);
    const Hdf5File& file = opened(segment);
    segment_of_report_[number] = segment;
    reports_.push_back({number, file.read_number(group, "time"),
                        static_cast<std::uint64_t>(file.read_number(group, "geometry")),
                        static_cast<std::uint64_t>(file.read_number(group, "revision"))});
  }
}

bool FieldReports::has(const FieldReport& report, const std::string& array) {
  return opened(segment_with(segment_of_report_, report.number, "report"))
      .has(fmt::format("/reports/{:06}/{}", report.number, array));
}

std::vector<double> FieldReports::of_report(const FieldReport& report, const std::string& array) {
  return read(segment_with(segment_of_report_, report.number, "report"),
              fmt::format("/reports/{:06}/{}", report.number, array));
}

std::vector<double> FieldReports::of_network(std::uint64_t revision, const std::string& array) {
  return read(segment_with(segment_of_network_, revision, "the network of revision"),
              fmt::format("/networks/{:06}/{}", revision, array));
}

std::vector<double> FieldReports::of_mesh(std::uint64_t geometry, const std::string& array) {
  return read(segment_with(segment_of_mesh_, geometry, "mesh"),
              fmt::format("/meshes/{:06}/{}", geometry, array));
}

std::vector<double> FieldReports::read(const std::string& segment, const std::string& dataset) {
  return numbers(opened(segment).read(dataset));
}

Hdf5File& FieldReports::opened(const std::string& segment) {
  const auto found = open_.find(segment);
  if (found != open_.end()) return found->second;
  open_.clear();
  return open_.emplace(segment, open_segment(folder_, index_.at(segment))).first->second;
}

}  // namespace fissura::coupler
