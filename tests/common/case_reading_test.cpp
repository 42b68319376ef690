// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

Case read(const std::string& text) {
  const Folder folder;
  folder.write("case.toml", text);
  return read_case({folder.path(), {}, {}}).value;
}

}  // namespace

TEST_CASE("a case is read in SI with tension positive", "[common][case]") {
  const Case value = read(valid_case);
  CHECK(value.title == "a fracture along a given path");
  CHECK(value.time.end == 10);
  CHECK(value.domain.height == 300);
  CHECK(value.mesh.fracture_size == 0.25);
  CHECK(value.rock.youngs_modulus == 32e9);
  CHECK(value.rock.biot_coefficient == 1);
  CHECK(value.in_situ.stress[3] == -20e6);
  CHECK(value.in_situ.pore_pressure == 30e6);
  CHECK(value.fractures.at(0).points.at(1) == Point{1, 0});
  CHECK(value.fluids.at(0).power_index == 1);
  CHECK(value.injection.perforations.at(0).aperture == 10e-6);
  CHECK(value.injection.stages.at(1).control == StageControl::shut_in);
  CHECK(value.coupling.scheme == CouplingScheme::robin);
}

TEST_CASE("in situ: the maximum horizontal stress acts along its azimuth from north", "[common][case]") {
  const std::string azimuth = "\"40 degree\"";
  const auto stress_with = [&](const std::string& angle) {
    return read(replaced(valid_case, azimuth, "\"" + angle + "\"")).in_situ.stress;
  };
  SECTION("north: the maximum is s_yy") {
    CHECK(stress_with("0 degree") == std::array<double, 4>{-10e6, -15e6, 0, -20e6});
  }
  SECTION("east: the maximum is s_xx; the shear vanishes up to the rounding of pi") {
    const std::array<double, 4> stress = stress_with("90 degree");
    CHECK(stress[0] == -15e6);
    CHECK(stress[1] == -10e6);
    CHECK(std::abs(stress[2]) < 1e-15 * 15e6);
  }
  SECTION("north-east: pressed along x = y, so s_xy is negative with tension positive") {
    const std::array<double, 4> stress = stress_with("45 degree");
    CHECK(stress[0] == Approx(-12.5e6));
    CHECK(stress[1] == Approx(-12.5e6));
    CHECK(stress[2] == Approx(-2.5e6));
  }
  SECTION("the sign of the case decides nothing but the reading") {
    std::string text = replaced(valid_case, "compression_positive", "tension_positive");
    for (const char* stress : {"15", "10", "20"})
      text = replaced(text, fmt::format("stress = \"{} MPa\"", stress),
                      fmt::format("stress = \"-{} MPa\"", stress));
    CHECK(read(text).in_situ.stress == stress_with("40 degree"));
  }
}

TEST_CASE("a path through intact rock has the strength of the rock unless it says otherwise",
          "[common][case]") {
  const FractureLine plain = read(valid_case).fractures.at(1);
  CHECK(plain.tensile_strength == 1e6);
  CHECK(plain.fracture_energy == 50);
  CHECK(plain.friction_coefficient == 0.6);
  const FractureLine weak =
      read(replaced(valid_case, "kind = \"intact\"", "kind = \"intact\"\ntensile_strength = \"0.5 MPa\""))
          .fractures.at(1);
  CHECK(weak.tensile_strength == 0.5e6);
  CHECK(weak.fracture_energy == 50);
}

TEST_CASE("a power-law fluid is read with its index", "[common][case]") {
  const Fluid gel = read(replaced(valid_case, "viscosity = \"1.67e-3 Pa s\"",
                                  "consistency_index = \"0.5 Pa s^n\"\npower_index = 0.6"))
                        .fluids.at(0);
  CHECK(gel.consistency_index == 0.5);
  CHECK(gel.power_index == 0.6);
}

TEST_CASE("the short form lays short.toml over the case: tables key by key, arrays whole", "[common][case]") {
  const Folder folder;
  folder.write("case.toml", valid_case);
  folder.write("short.toml", R"(
[mesh]
fracture_size = "0.5 m"
[[injection.stage]]
begin = "0 s"
rate = "2e-3 m^3/s"
fluid = "slickwater"
)");
  const CaseReading reading = read_case({folder.path(), {"short"}, {}});
  CHECK(reading.value.mesh.fracture_size == 0.5);
  CHECK(reading.value.mesh.far_size == 40);
  REQUIRE(reading.value.injection.stages.size() == 1);
  CHECK(reading.value.injection.stages[0].rate == 2e-3);
  CHECK(reading.value.injection.perforations.size() == 1);
  CHECK(reading.files.size() == 2);
  CHECK(read_case({folder.path(), {}, {}}).value.mesh.fracture_size == 0.25);
}

TEST_CASE("variants are laid over the case one after the other", "[common][case]") {
  const Folder folder;
  folder.write("case.toml", valid_case);
  folder.write("free.toml", "[growth]\npath = \"free\"\n[mesh]\nfracture_size = \"0.2 m\"\n");
  folder.write("short.toml", "[mesh]\nfracture_size = \"0.5 m\"\n");
  const Case free = read_case({folder.path(), {"free"}, {}}).value;
  CHECK(free.growth.path == PathRule::free);
  CHECK(free.mesh.fracture_size == 0.2);
  const Case both = read_case({folder.path(), {"free", "short"}, {}}).value;
  CHECK(both.growth.path == PathRule::free);
  CHECK(both.mesh.fracture_size == 0.5);
}

TEST_CASE("a variant is a file beside case.toml, and none of the others there", "[common][case]") {
  const Folder folder;
  folder.write("case.toml", valid_case);
  for (const char* name : {"", "../case", "case", "expected", "expected_short", "short.toml"}) {
    CAPTURE(name);
    CHECK_THROWS_WITH(read_case({folder.path(), {name}, {}}), Catch::Contains("--variant"));
  }
  CHECK_THROWS_WITH(read_case({folder.path(), {"missing"}, {}}),
                    Catch::Contains("missing.toml: found no such file"));
}

TEST_CASE("a fault of short.toml is told with the place in short.toml", "[common][case]") {
  const Folder folder;
  folder.write("case.toml", valid_case);
  folder.write("short.toml", "[rock]\npoissons_ratio = 0.6\n");
  CHECK_THROWS_WITH(read_case({folder.path(), {"short"}, {}}),
                    Catch::Contains("short.toml:2:18: rock.poissons_ratio: found 0.6"));
}

TEST_CASE("values set on the command line come last, as TOML or as plain text", "[common][case]") {
  const Folder folder;
  folder.write("case.toml", valid_case);
  const std::vector<std::string> overrides{
      "mesh.fracture_size=0.5 m",   "mesh.far_size=\"30 m\"",
      "rock.poissons_ratio=0.25",   "injection.stage[0].rate=2 l/s",
      "coupling.scheme=profit2016", "fracture[1].points[1]=[\"9 m\", \"0 m\"]"};
  const Case value = read_case({folder.path(), {}, overrides}).value;
  CHECK(value.mesh.fracture_size == 0.5);
  CHECK(value.mesh.far_size == 30);
  CHECK(value.rock.poissons_ratio == 0.25);
  CHECK(value.injection.stages.at(0).rate == 2e-3);
  CHECK(value.coupling.scheme == CouplingScheme::profit2016);
  CHECK(value.fractures.at(1).points.at(1) == Point{9, 0});
}

TEST_CASE("a value set on the command line that cannot be is a fault like any other", "[common][case]") {
  const Folder folder;
  folder.write("case.toml", valid_case);
  CHECK(faults_in(folder,
                  {"rock.poissons_ratio=0.6", "injection.stage[2].rate=1 l/s", "rock", "rock.youngs=1 Pa"}) ==
        std::vector<std::string>{
            "--set: injection.stage[2].rate: found injection.stage[2].rate=1 l/s, expected an array with an "
            "element [2] "
            "there (counted from 0)",
            "--set: rock: found no value, expected KEY.PATH=VALUE",
            "--set: rock.poissons_ratio: found 0.6, expected a number greater than -1 and less than 0.5",
            "--set: rock.youngs: found an unknown key, expected one of density, youngs_modulus, "
            "poissons_ratio, "
            "tensile_strength, fracture_energy, biot_coefficient, friction_coefficient; did you mean "
            "\"youngs_modulus\"?"});
}
