// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/read_case.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include <fmt/format.h>

#include "common/case/check_case.hpp"
#include "common/case/plausibility.hpp"
#include "common/case/sections.hpp"
#include "common/case/toml_document.hpp"

namespace fissura {

namespace {

namespace fs = std::filesystem;

constexpr int known_schema = 1;

void throw_if_any(const FaultList& faults) {
  if (!faults.empty()) throw CaseFaults(faults);
}

/// case.toml of the folder or the file itself, and the folder.
std::pair<fs::path, fs::path> locate(const fs::path& path) {
  std::error_code trouble;
  const bool is_folder = fs::is_directory(path, trouble) && path.extension() != ".toml";
  const fs::path file = is_folder ? path / "case.toml" : path;
  if (!fs::exists(file, trouble))
    throw CaseFaults({Fault{whole(file.string()), "", "no such file",
                            "a case folder with a case.toml, or the file itself", ""}});
  return {file, file.has_parent_path() ? file.parent_path() : fs::path(".")};
}

/// A variant is named by the file beside case.toml, so its name can lead nowhere else.
fs::path variant_file(const fs::path& folder, const std::string& variant) {
  const bool plain =
      !variant.empty() && std::all_of(variant.begin(), variant.end(), [](unsigned char letter) {
        return std::isalnum(letter) != 0 || letter == '_';
      });
  if (!plain || variant == "case" || variant.starts_with("expected"))
    throw CaseFaults(
        {Fault{whole("--variant"), "", fmt::format("\"{}\"", variant),
               "the name of a file NAME.toml beside case.toml, of letters, digits and underscores", ""}});
  return folder / (variant + ".toml");
}

/// Another schema has other keys: nothing more can be said about such a case.
void require_known_schema(const input::SourceValue& document) {
  const input::SourceMember* member = input::member_of(document, "schema");
  const auto* schema = member == nullptr ? nullptr : std::get_if<std::int64_t>(&member->value.content);
  if (schema != nullptr && *schema == known_schema) return;
  const bool newer = schema != nullptr && *schema > known_schema;
  throw CaseFaults(
      {{member == nullptr ? document.where : member->value.where, "schema",
        member == nullptr ? "nothing" : written(member->value),
        fmt::format("{}{}", known_schema, newer ? " (the case needs a newer version of Fissura)" : ""), ""}});
}

struct Sections {
  Case value;
  std::vector<FractureLine> traces;  ///< of natural fractures, given one by one
};

Sections read_sections(input::TableReader& document, input::CaseFiles& files) {
  Sections sections;
  Case& result = sections.value;
  result.schema = document.count("schema", input::from_to(known_schema, known_schema), known_schema);
  result.title = document.text("title");
  result.time = input::read_time(document);
  result.domain = input::read_domain(document);
  result.mesh = input::read_mesh(document);
  result.rock = input::read_rock(document);
  result.bulk_failure = input::read_failure(document);
  result.growth = input::read_growth(document);
  result.in_situ = input::read_in_situ(document);
  result.boundary = input::read_boundary(document);
  result.fractures = input::read_fractures(document, result.rock, files);
  input::NaturalFractures natural =
      input::read_natural_fractures(document, result.domain, result.fractures, files);
  result.natural_fracture_sets = std::move(natural.sets);
  sections.traces = std::move(natural.traces);
  result.fluids = input::read_fluids(document);
  result.leak_off = input::read_leak_off(document);
  result.injection = input::read_injection(document);
  result.coupling = input::read_coupling(document);
  result.dynamics = input::read_dynamics(document);
  result.network = input::read_network(document);
  result.output = input::read_output(document);
  result.seismicity = input::read_seismicity(document);
  result.georeference = input::read_georeference(document);
  result.initial_velocities = input::read_initial_velocities(document);
  result.deadlines = input::read_deadlines(document);
  result.checkpoint = input::read_checkpoint(document);
  result.pressure_range = input::read_pressure_range(document);
  result.exchange = input::read_exchange(document);
  result.participants = input::read_participants(document);
  document.refuse_unknown_keys();
  return sections;
}

}  // namespace

CaseReading read_case(const CaseSource& source) {
  const auto [file, folder] = locate(source.path);
  input::CaseFiles files{folder, {file}};
  FaultList faults;
  input::SourceValue document = input::read_toml(file, faults);
  for (const std::string& variant : source.variants) {
    files.read.push_back(variant_file(folder, variant));
    merge(document, input::read_toml(files.read.back(), faults));
  }
  throw_if_any(faults);
  for (const std::string& assignment : source.overrides) input::apply_override(document, assignment, faults);
  require_known_schema(document);

  CaseReading reading;
  input::TableReader reader(document, "", faults);
  Sections sections = read_sections(reader, files);
  reading.value = std::move(sections.value);
  input::check_case(reading.value, document, faults);
  throw_if_any(faults);
  reading.natural_fractures = add_natural_fractures(reading.value, sections.traces);
  reading.warnings = input::implausible_values(reading.value, document);
  reading.folder = folder;
  reading.files = files.read;
  return reading;
}

}  // namespace fissura
