// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/curve_keys.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <functional>

#include "common/errors.hpp"
#include "tests/common/temporary_folder.hpp"

using namespace fissura;
using fissura::test::TemporaryFolder;

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text << "\n";
}

void check_refused(ExitCode code, const std::string& sentence, const std::function<void()>& action) {
  try {
    action();
    FAIL("it was not refused");
  } catch (const Error& error) {
    CHECK(error.code() == code);
    CHECK_THAT(error.what(), Catch::Contains(sentence));
  }
}

struct KeyFiles {
  KeyFiles() { (void)write_new_keys(directory); }
  TemporaryFolder folder;
  std::filesystem::path directory = folder.path() / "keys";
};

}  // namespace

TEST_CASE("the coupler knows the public keys that belong to the participants' secrets, and they its own",
          "[common][security]") {
  const KeyFiles files;
  const CouplerKeys coupler = read_coupler_keys(files.directory);
  REQUIRE(coupler.allowed.size() == 2);
  for (const AllowedKey& each : coupler.allowed) {
    const ParticipantKeys participant = read_participant_keys(files.directory, each.role);
    CHECK(participant.own.public_key == each.public_key);
    CHECK(participant.coupler_public_key == coupler.own.public_key);
  }
}

TEST_CASE("secret keys and their directory are written for their owner only", "[common][security]") {
  const KeyFiles files;
  struct stat status {};
  REQUIRE(::stat(files.directory.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0700);
  for (const std::string holder : key_holders) {
    REQUIRE(::stat((files.directory / (holder + ".secret")).c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0600);
  }
}

TEST_CASE("new keys never replace old ones, not even one of them", "[common][security]") {
  const KeyFiles files;
  for (const auto& entry : std::filesystem::directory_iterator(files.directory))
    if (entry.path().filename() != "network.secret") std::filesystem::remove(entry);
  check_refused(ExitCode::precondition, "network.secret exists",
                [&] { (void)write_new_keys(files.directory); });
  CHECK_FALSE(std::filesystem::exists(files.directory / "coupler.secret"));
}

TEST_CASE("a secret key that others can read is refused", "[common][security]") {
  const KeyFiles files;
  const auto mode = GENERATE(0640, 0604, 0620);
  ::chmod((files.directory / "structure.secret").c_str(), static_cast<mode_t>(mode));
  check_refused(ExitCode::security, "structure.secret: its mode is",
                [&] { (void)read_participant_keys(files.directory, "structure"); });
}

TEST_CASE("the example keys of the manual are refused", "[common][security]") {
  const KeyFiles files;
  write(files.directory / "network.public", "Yne@$w-vo<fVvi]a<NY6T1ed:M$fCG*[IaLV{hID");
  check_refused(ExitCode::security, "network.public: this key is an example published in a manual",
                [&] { (void)read_coupler_keys(files.directory); });
  write(files.directory / "coupler.secret", "JTKVSB%%)wK0E.X)V>+}o?pNmC{O&4W4b!Ni{Lh6");
  check_refused(ExitCode::security, "coupler.secret: this key is an example",
                [&] { (void)read_coupler_keys(files.directory); });
}

TEST_CASE("key files that cannot be used are refused by name", "[common][security]") {
  const KeyFiles files;
  SECTION("missing") {
    std::filesystem::remove(files.directory / "structure.public");
    check_refused(ExitCode::security, "structure.public: No such file",
                  [&] { (void)read_coupler_keys(files.directory); });
  }
  SECTION("not a key") {
    write(files.directory / "structure.public", "hello");
    check_refused(ExitCode::security, "structure.public: expected a key",
                  [&] { (void)read_coupler_keys(files.directory); });
  }
  SECTION("of another pair") {
    write(files.directory / "coupler.public", new_key_pair().public_key);
    check_refused(ExitCode::security, "coupler.public: it does not belong to coupler.secret",
                  [&] { (void)read_coupler_keys(files.directory); });
  }
  SECTION("one key for two roles") {
    std::filesystem::copy_file(files.directory / "structure.public", files.directory / "network.public",
                               std::filesystem::copy_options::overwrite_existing);
    check_refused(ExitCode::security, "each role needs its own",
                  [&] { (void)read_coupler_keys(files.directory); });
  }
}
