// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <stdlib.h>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "common/case/read_case.hpp"

/// A valid case to spoil, and the means to look at what is then said.
namespace fissura::test {

inline const std::string valid_case = R"(schema = 1
title = "a fracture along a given path"

[time]
end = "10 s"

[domain]
width = "400 m"
height = "300 m"
thickness = "1 m"

[mesh]
fracture_size = "0.25 m"
far_size = "40 m"
corridor = "1.5 m"
gradation = 0.15

[rock]
density = "2500 kg/m^3"
youngs_modulus = "32 GPa"
poissons_ratio = 0.2
tensile_strength = "1 MPa"
fracture_energy = "50 N/m"

[in_situ]
sign = "compression_positive"
maximum_horizontal_stress = "15 MPa"
minimum_horizontal_stress = "10 MPa"
vertical_stress = "20 MPa"
maximum_horizontal_azimuth = "40 degree"
pore_pressure = "30 MPa"

[[fracture]]
name = "slit"
kind = "open"
points = [["-1 m", "0 m"], ["1 m", "0 m"]]

[[fracture]]
name = "east wing"
kind = "intact"
points = [["1 m", "0 m"], ["16 m", "0 m"]]

[[fluid]]
name = "slickwater"
viscosity = "1.67e-3 Pa s"
bulk_modulus = "2 GPa"

[leak_off]
coefficient = "5e-5 m/s^0.5"

[[injection.perforation]]
name = "perforation"
position = ["0 m", "0 m"]
aperture = "10 um"

[[injection.stage]]
begin = "0 s"
rate = "1e-3 m^3/s"
fluid = "slickwater"

[[injection.stage]]
begin = "6 s"
shut_in = true

[output]
interval = "0.5 s"
)";

/// A new folder of its own, removed at the end with everything in it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "fissura_case_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::vector<std::string> content() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path path_;
};

/// `text` with its only `old` replaced.
inline std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  const std::size_t place = text.find(old);
  REQUIRE(place != std::string::npos);
  REQUIRE(text.find(old, place + 1) == std::string::npos);
  return text.replace(place, old.size(), fresh);
}

/// Every fault of the case in a folder as `file:line:column: ...`, without the path of the folder.
inline std::vector<std::string> faults_in(const Folder& folder,
                                          const std::vector<std::string>& overrides = {}) {
  const std::vector<std::string> before = folder.content();
  std::vector<std::string> lines;
  try {
    read_case({folder.path(), {}, overrides});
  } catch (const CaseFaults& refusal) {
    CHECK(refusal.code() == ExitCode::case_invalid);
    for (Fault fault : refusal.faults()) {
      fault.where.file = std::filesystem::path(fault.where.file).filename();
      lines.push_back(describe(fault));
    }
  }
  CHECK(folder.content() == before);
  return lines;
}

inline std::vector<std::string> faults_of(const std::string& text) {
  const Folder folder;
  folder.write("case.toml", text);
  return faults_in(folder);
}

/// The valid case with `old` replaced by `fresh` has one fault, `message`, and it is where `@` stands in
/// `fresh`.
inline void check_refused(const std::string& old, const std::string& fresh, const std::string& message) {
  std::string text = replaced(valid_case, old, fresh);
  const std::size_t place = text.find('@');
  REQUIRE(place != std::string::npos);
  text.erase(place, 1);
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
  const std::size_t column = place - (text.rfind('\n', place - 1) + 1) + 1;
  CHECK(faults_of(text) ==
        std::vector<std::string>{fmt::format("case.toml:{}:{}: {}", line, column, message)});
}

/// The valid case with `addition` (with `@` as above) at its end has one fault, `message`.
inline void check_addition_refused(const std::string& addition, const std::string& message) {
  const std::string last = "interval = \"0.5 s\"\n";
  check_refused(last, last + addition, message);
}

}  // namespace fissura::test
