// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/healing.hpp"

#include <catch2/catch.hpp>

#include "tests/coupler/launch/failure.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

Death death(std::uint32_t epoch, const std::optional<std::uint64_t>& checkpoint,
            ExitCode code = ExitCode::participant_died) {
  return {epoch, sample::failure(code, "structure", 17, "structure was killed"), checkpoint};
}

bool goes_on(Healer& healer, Death each) {
  return healer.goes_on_after(each);
}

}  // namespace

TEST_CASE("a run that is not to be healed ends with its first death", "[coupler][launch]") {
  Healer healer(Healing{false, 3});
  CHECK_FALSE(goes_on(healer, death(0, 10)));
  CHECK(healer.deaths().size() == 1);
}

TEST_CASE("deaths without a checkpoint between them end the healing, and the sentence says so",
          "[coupler][launch]") {
  Healer healer(Healing{true, 3});
  CHECK(goes_on(healer, death(0, 10)));
  CHECK(goes_on(healer, death(1, 10)));
  Death third = death(2, 10);
  CHECK_FALSE(healer.goes_on_after(third));
  CHECK(third.failure.sentence.text() ==
        "structure was killed; healing ends after 3 deaths without a checkpoint between them");
}

TEST_CASE("a new checkpoint, also the first, gives a run new lives", "[coupler][launch]") {
  Healer healer(Healing{true, 3});
  CHECK(goes_on(healer, death(0, std::nullopt)));
  CHECK(goes_on(healer, death(1, std::nullopt)));
  CHECK(goes_on(healer, death(2, 5)));
  CHECK(goes_on(healer, death(3, 5)));
  CHECK(goes_on(healer, death(4, 6)));
}

TEST_CASE("what would happen again is not healed", "[coupler][launch]") {
  for (const ExitCode code :
       {ExitCode::case_invalid, ExitCode::precondition, ExitCode::mismatch, ExitCode::numerical_failure,
        ExitCode::storage_failure, ExitCode::checkpoint_unusable, ExitCode::terminated}) {
    Healer healer(Healing{true, 3});
    CHECK_FALSE(goes_on(healer, death(0, 10, code)));
  }
}

TEST_CASE("a healing is told with who died where and from where the run goes on", "[coupler][launch]") {
  CHECK(healing_line(death(1, 12)) ==
        "coupler: healing: PARTICIPANT-DIED structure interval=17 phase=network: structure was killed. The "
        "run goes "
        "on from interval 12 (epoch 2)");
}
