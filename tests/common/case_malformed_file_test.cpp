// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

using Lines = std::vector<std::string>;

TEST_CASE("the case that the malformed ones are made of is valid", "[common][case]") {
  CHECK(faults_of(valid_case) == Lines{});
}

TEST_CASE("a case that is not there is refused by name", "[common][case][malformed]") {
  const Folder folder;
  CHECK(faults_in(folder) ==
        Lines{"case.toml: found no such file, expected a case folder with a case.toml, or the file itself"});
}

TEST_CASE("malformed case 1: an empty file", "[common][case][malformed]") {
  CHECK(faults_of("") == Lines{"case.toml: found an empty file, expected a TOML file"});
}

TEST_CASE("malformed case 2: not UTF-8", "[common][case][malformed]") {
  CHECK(faults_of("schema = 1\ntitle = \"M\xFCller\"\n") ==
        Lines{"case.toml:2:10: found no valid TOML (Encountered invalid utf-8 sequence), expected TOML 1.0"});
}

TEST_CASE("malformed case 3: a byte order mark", "[common][case][malformed]") {
  CHECK(faults_of("\xEF\xBB\xBF" + valid_case) ==
        Lines{"case.toml:1:1: found a byte order mark, expected UTF-8 text without one"});
}

TEST_CASE("malformed case 4: a binary file", "[common][case][malformed]") {
  CHECK(faults_of(std::string("\x7F"
                              "ELF\0\1\2",
                              7)) ==
        Lines{"case.toml: found bytes that are no text (a binary or UTF-16 file), expected TOML in UTF-8"});
}

TEST_CASE("malformed case 5: a directory instead of the file", "[common][case][malformed]") {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "case.toml");
  CHECK(faults_in(folder) == Lines{"case.toml: found a directory, expected a TOML file"});
}

TEST_CASE("malformed case 6: more than 64 MiB", "[common][case][malformed]") {
  const Folder folder;
  folder.write("case.toml", valid_case);
  std::filesystem::resize_file(folder.path() / "case.toml", 65 * 1024 * 1024);
  CHECK(faults_in(folder) ==
        Lines{"case.toml: found 68157440 bytes, expected at most 1048576 (long polylines go "
              "into the file named by fracture.file)"});
}

TEST_CASE("malformed case 7: a syntax error", "[common][case][malformed]") {
  check_refused("gradation = 0.15", "gradation = @",
                "found no valid TOML (Error while parsing key-value pair: expected value, saw '\\n'), "
                "expected TOML 1.0");
}

TEST_CASE("malformed case 8: a string that is not closed", "[common][case][malformed]") {
  check_refused("\"32 GPa\"", "\"32 GPa@",
                "found no valid TOML (Error while parsing string: unescaped control characters other than "
                "TAB (U+0009) are explicitly prohibited), expected TOML 1.0");
}

TEST_CASE("malformed case 9: a key given twice", "[common][case][malformed]") {
  check_refused(
      "poissons_ratio = 0.2", "poissons_ratio = 0.2\npoissons_ratio = @0.3",
      "found no valid TOML (Error while parsing key-value pair: cannot redefine existing floating-point "
      "'poissons_ratio'), expected TOML 1.0");
}

TEST_CASE("malformed case 43: ten thousand nested arrays", "[common][case][malformed]") {
  const Lines faults = faults_of("a = " + std::string(10000, '[') + std::string(10000, ']'));
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults.front(), Catch::Contains("case.toml:1:"));
  CHECK_THAT(faults.front(), Catch::Contains("found a line of 20004 bytes, expected at most 12000"));
  SECTION("on lines that are short enough") {
    const Lines nested = faults_of("a = " + std::string(5000, '[') + "\n" + std::string(5000, ']'));
    REQUIRE(nested.size() == 1);
    CHECK_THAT(nested.front(), Catch::Contains("exceeded maximum nested value depth"));
  }
  SECTION("as dotted keys, which a parser need not nest to read") {
    std::string key = "a";
    for (int i = 0; i < 5000; ++i) key += ".a";
    const Lines nested = faults_of(key + " = 1");
    REQUIRE(nested.size() == 1);
    CHECK_THAT(nested.front(),
               Catch::Contains("found a value nested deeper than any key of a case, expected at most"));
  }
}
