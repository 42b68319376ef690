// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

using Lines = std::vector<std::string>;

TEST_CASE("malformed case 10: an unknown key is answered with the one that was meant",
          "[common][case][malformed]") {
  check_refused(
      "gradation = 0.15", "@gradatoin = 0.15\ngradation = 0.15",
      "mesh.gradatoin: found an unknown key, expected one of fracture_size, natural_size, far_size, corridor, gradation, "
      "seed, tip_size, tip_radius, tip_gradation, lattice_angle, refinement; did you mean \"gradation\"?");
}

TEST_CASE("malformed case 11: a missing key", "[common][case][malformed]") {
  check_refused(
      "[rock]\ndensity = \"2500 kg/m^3\"\n", "@[rock]\n",
      "rock.density: found nothing, expected a density with its unit such as \"2500 kg/m^3\", greater than "
      "0 kg/m^3");
}

TEST_CASE("malformed case 11: a missing table is one fault, not one for each of its keys",
          "[common][case][malformed]") {
  const std::size_t rock = valid_case.find("[rock]"), in_situ = valid_case.find("[in_situ]");
  CHECK(faults_of(std::string(valid_case).erase(rock, in_situ - rock)) ==
        Lines{"case.toml:1:1: rock: found nothing, expected a table [rock]"});
}

TEST_CASE("malformed case 11: an empty list where at least one table belongs", "[common][case][malformed]") {
  const std::size_t fluid = valid_case.find("[[fluid]]"), leak_off = valid_case.find("[leak_off]");
  const std::string without_fluids = std::string(valid_case).erase(fluid, leak_off - fluid);
  CHECK(faults_of(without_fluids) == Lines{"case.toml:54:9: injection.stage[0].fluid: found \"slickwater\", "
                                           "expected the name of a [[fluid]]; the "
                                           "case has none"});
  CHECK(faults_of("fluid = []\n" + without_fluids) ==
        Lines{"case.toml:1:9: fluid: found an array, expected at least one table [[fluid]]"});
}

TEST_CASE("malformed case 12: a value of the wrong type", "[common][case][malformed]") {
  SECTION("an array where text belongs")
  check_refused("end = \"10 s\"", "end = @[10]",
                "time.end: found an array, expected a time with its unit such as \"10 s\", greater than 0 s");
  SECTION("a number where a table belongs")
  check_addition_refused("[boundary]\nwest = @1\n",
                         "boundary.west: found 1, expected a table [boundary.west]");
  SECTION("a date")
  check_refused(
      "end = \"10 s\"", "end = @1979-05-27",
      "time.end: found a date or time, expected a time with its unit such as \"10 s\", greater than 0 s");
}

TEST_CASE("malformed case 13: a number as text", "[common][case][malformed]") {
  check_refused("poissons_ratio = 0.2", "poissons_ratio = @\"0.2\"",
                "rock.poissons_ratio: found \"0.2\", expected a number greater than -1 and less than 0.5");
}

TEST_CASE("malformed case 14: not a number, or infinite", "[common][case][malformed]") {
  SECTION("as a bare number")
  check_refused("poissons_ratio = 0.2", "poissons_ratio = @nan",
                "rock.poissons_ratio: found nan, expected a number greater than -1 and less than 0.5");
  SECTION("within text")
  check_refused(
      "\"32 GPa\"", "@\"inf GPa\"",
      "rock.youngs_modulus: found \"inf GPa\", expected a stress or pressure with its unit such as \"10 "
      "MPa\" (the number is not finite)");
}

TEST_CASE("malformed case 15: a number beyond double precision", "[common][case][malformed]") {
  SECTION("as a bare number")
  check_refused(
      "poissons_ratio = 0.2", "poissons_ratio = 1e999@",
      "found no valid TOML (Error while parsing floating-point: '1e999' could not be interpreted as a "
      "value), expected TOML 1.0");
  SECTION("within text")
  check_refused(
      "\"32 GPa\"", "@\"1e999 GPa\"",
      "rock.youngs_modulus: found \"1e999 GPa\", expected a stress or pressure with its unit such as \"10 "
      "MPa\" (the number is beyond the range of double precision)");
  SECTION("only after conversion")
  check_refused(
      "\"32 GPa\"", "@\"1e305 GPa\"",
      "rock.youngs_modulus: found \"1e305 GPa\", expected a stress or pressure with its unit such as \"10 "
      "MPa\" (the value in SI is beyond the range of double precision)");
}

TEST_CASE("malformed case 16: a negative value where only a positive one has a meaning",
          "[common][case][malformed]") {
  SECTION("viscosity")
  check_refused(
      "\"1.67e-3 Pa s\"", "@\"-1.67e-3 Pa s\"",
      "fluid[0].viscosity: found \"-1.67e-3 Pa s\", expected a viscosity with its unit such as \"1.67e-3 Pa "
      "s\", greater than 0 Pa s");
  SECTION("Young's modulus")
  check_refused(
      "\"32 GPa\"", "@\"-32 GPa\"",
      "rock.youngs_modulus: found \"-32 GPa\", expected a stress or pressure with its unit such as \"10 "
      "MPa\", greater than 0 Pa");
  SECTION("aperture")
  check_refused(
      "\"10 um\"", "@\"-10 um\"",
      "injection.perforation[0].aperture: found \"-10 um\", expected a length with its unit such as \"0.25 "
      "m\", greater than 0 m");
  SECTION("thickness")
  check_refused(
      "thickness = \"1 m\"", "thickness = @\"0 m\"",
      "domain.thickness: found \"0 m\", expected a length with its unit such as \"0.25 m\", greater than 0 "
      "m");
  SECTION("coupling interval")
  check_addition_refused(
      "[coupling]\nmaximum_interval = @\"-1 ms\"\n",
      "coupling.maximum_interval: found \"-1 ms\", expected a time with its unit such as \"10 s\", "
      "greater than 0 s");
}

TEST_CASE("malformed case 17: a Poisson's ratio outside (-1, 0.5)", "[common][case][malformed]") {
  check_refused("poissons_ratio = 0.2", "poissons_ratio = @0.5",
                "rock.poissons_ratio: found 0.5, expected a number greater than -1 and less than 0.5");
}

TEST_CASE("malformed case 18: no fracture energy or no tensile strength", "[common][case][malformed]") {
  SECTION("of the rock")
  check_refused(
      "\"50 N/m\"", "@\"0 N/m\"",
      "rock.fracture_energy: found \"0 N/m\", expected an energy per area with its unit such as \"50 N/m\", "
      "greater than 0 J/m^2");
  SECTION("of one path")
  check_refused(
      "kind = \"intact\"", "kind = \"intact\"\ntensile_strength = @\"0 Pa\"",
      "fracture[1].tensile_strength: found \"0 Pa\", expected tensile_strength and fracture_energy both "
      "greater than zero, or both zero");
}

TEST_CASE("malformed case 19: a unit that is missing or measures something else",
          "[common][case][malformed]") {
  SECTION("no unit")
  check_refused(
      "\"32 GPa\"", "@\"32\"",
      "rock.youngs_modulus: found \"32\", expected a stress or pressure with its unit such as \"10 MPa\" "
      "(the unit is missing)");
  SECTION("a bare number")
  check_refused(
      "\"32 GPa\"", "@32e9",
      "rock.youngs_modulus: found 32000000000, expected a stress or pressure with its unit such as \"10 "
      "MPa\", greater than 0 Pa");
  SECTION("viscosity in MPa")
  check_refused(
      "\"1.67e-3 Pa s\"", "@\"1.67e-3 MPa\"",
      "fluid[0].viscosity: found \"1.67e-3 MPa\", expected a viscosity with its unit such as \"1.67e-3 Pa "
      "s\" (\"MPa\" is no unit of that dimension)");
  SECTION("a unit that nobody knows")
  check_refused(
      "\"32 GPa\"", "@\"32 GPaa\"",
      "rock.youngs_modulus: found \"32 GPaa\", expected a stress or pressure with its unit such as \"10 "
      "MPa\" (\"GPaa\" is no unit of that dimension)");
}

TEST_CASE("malformed case 20: a value off by a million runs, with a warning", "[common][case][malformed]") {
  const auto warnings_of = [](const std::string& text) {
    const Folder folder;
    folder.write("case.toml", text);
    Lines lines;
    for (Fault warning : read_case({folder.path(), {}, {}}).warnings) {
      warning.where.file = std::filesystem::path(warning.where.file).filename();
      lines.push_back(describe(warning));
    }
    return lines;
  };
  CHECK(warnings_of(valid_case) == Lines{});
  CHECK(warnings_of(replaced(valid_case, "\"1.67e-3 Pa s\"", "\"1.67e-3 MPa s\"")) ==
        Lines{"case.toml:45:13: fluid[0].viscosity: found 1670 Pa s, expected usually 1e-06 to 100 Pa s (is "
              "the unit "
              "right?)"});
  CHECK(warnings_of(replaced(valid_case, "\"32 GPa\"", "\"32 Pa\"")) ==
        Lines{"case.toml:20:18: rock.youngs_modulus: found 32 Pa, expected usually 1e+08 to 3e+11 Pa (is the "
              "unit "
              "right?)"});
}

TEST_CASE("every fault of a case is told at once, in the order of the file", "[common][case]") {
  std::string text = replaced(valid_case, "height = \"300 m\"", "height = \"300 kg\"");
  text = replaced(text, "poissons_ratio = 0.2", "poissons_ratio = 0.7");
  text = replaced(text, "kind = \"intact\"", "kind = \"intakt\"");
  text = replaced(text, "begin = \"6 s\"", "begin = \"16 s\"");
  text = replaced(text, "[output]", "[outptu]");
  const Lines faults = faults_of(text);
  REQUIRE(faults.size() == 6);
  CHECK_THAT(faults[0], Catch::Contains("case.toml:1:1: output: found nothing, expected a table [output]"));
  CHECK_THAT(faults[1], Catch::Contains("case.toml:9:10: domain.height: found \"300 kg\""));
  CHECK_THAT(faults[2], Catch::Contains("case.toml:21:18: rock.poissons_ratio: found 0.7"));
  CHECK_THAT(faults[3],
             Catch::Contains("fracture[1].kind: found \"intakt\", expected one of open, natural, intact; "
                             "did you mean \"intact\"?"));
  CHECK_THAT(faults[4],
             Catch::Contains("injection.stage[1].begin: found 16 s, expected earlier than the end of the "
                             "run, time.end = 10 s"));
  CHECK_THAT(faults[5], Catch::Contains("outptu: found an unknown key"));
  CHECK_THAT(faults[5], Catch::Contains("did you mean \"output\"?"));
}

TEST_CASE("a misspelt kind is one fault: the keys that belong to the kind meant are not held against it",
          "[common][case]") {
  check_refused("kind = \"intact\"", "kind = @\"naturel\"\nfriction_coefficient = 0.6",
                "fracture[1].kind: found \"naturel\", expected one of open, natural, intact; did you mean "
                "\"natural\"?");
}
