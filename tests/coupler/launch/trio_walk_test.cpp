// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/exchange/channel.hpp"
#include "coupler/launch/trio.hpp"
#include "tests/common/some_words.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;
using fissura::coupler::sample::TemporaryDirectory;
using fissura::test::message_of;

namespace {

RunId some_run() {
  RunId run;
  run.fill(5);
  return run;
}

TrioOptions awaiting(const std::string& endpoint) {
  TrioOptions options;
  options.listening.endpoint = endpoint;
  options.deadlines = {20, 20, 20};
  return options;
}

/// A real Trio, and both participants played by the test: sending does not wait, so that all are on one
/// thread.
class PlayedTrio {
 public:
  explicit PlayedTrio(Start start)
      : trio_(awaiting("ipc://" + (folder_.path() / "socket").string()), some_run(), 0, status_) {
    for (ParticipantChannel& participant : participants_) {
      Message hello(MessageType::hello);
      hello.body = {{"role", &participant == &participants_[0] ? "structure" : "network"},
                    {"solver", "played"},
                    {"version", "1"},
                    {"pid", 0},
                    {"capabilities", {"restore"}}};
      participant.send(std::move(hello));
    }
    trio_.start(nlohmann::json::object(), start);
    for (ParticipantChannel& participant : participants_) (void)participant.receive(Seconds(5));
  }

  Trio& trio() { return trio_; }
  void says(Role role, Word word) { participants_[static_cast<std::size_t>(role)].send(message_of(word)); }
  void asked(Role role, Word command, Word answer) {
    trio_.send(role, message_of(command));
    says(role, answer);
    (void)trio_.await(role, message_of(answer).type);
  }

 private:
  static std::string endpoint_of(const TemporaryDirectory& folder) {
    return "ipc://" + (folder.path() / "socket").string();
  }

  TemporaryDirectory folder_;
  StatusPage status_;
  Trio trio_;
  std::array<ParticipantChannel, 2> participants_{ParticipantChannel(endpoint_of(folder_)),
                                                  ParticipantChannel(endpoint_of(folder_))};
};

Start start_of(CouplerView view) {
  return view == CouplerView::resuming || view == CouplerView::restoring ? Start::resuming : Start::fresh;
}

/// Brings the participant to where the coupler sees it as `view`.
void bring(PlayedTrio& stage, Role role, CouplerView view) {
  if (view == CouplerView::joining || view == CouplerView::resuming) return;
  if (view == CouplerView::restoring) return stage.trio().send(role, message_of(Word::restore));
  if (role == Role::structure) {
    stage.says(role, Word::topology);
    (void)stage.trio().await(role, MessageType::topology);
  }
  if (view == CouplerView::empty) return;
  if (view == CouplerView::inserting) return stage.trio().send(role, message_of(Word::insert));
  stage.asked(role, Word::insert, Word::acknowledge);
  if (view == CouplerView::proposed || view == CouplerView::reporting_proposed)
    stage.asked(role, Word::advance, Word::proposal);
  if (view == CouplerView::advancing) stage.trio().send(role, message_of(Word::advance));
  if (view == CouplerView::reporting || view == CouplerView::reporting_proposed)
    stage.trio().send(role, message_of(Word::report));
  if (view == CouplerView::saving) stage.trio().send(role, message_of(Word::save));
  if (view == CouplerView::finishing || view == CouplerView::leaving)
    stage.trio().send(role, message_of(Word::finish));
  if (view == CouplerView::leaving) {
    stage.says(role, Word::bye);
    (void)stage.trio().await(role, MessageType::bye);
  }
}

/// What the coupler says of `role` while it waits for the other participant, which never answers.
std::string failure_of(PlayedTrio& stage, Role role, Start start) {
  const Role other = role == Role::structure ? Role::network : Role::structure;
  try {
    if (start == Start::resuming)
      (void)stage.trio().request(other, message_of(Word::restore), MessageType::restored);
    else if (other == Role::structure)
      (void)stage.trio().await(other, MessageType::topology);
    else
      (void)stage.trio().request(other, message_of(Word::insert), MessageType::acknowledge);
  } catch (const ParticipantFailure& failure) {
    CHECK(failure.role == role);
    return failure.what();
  }
  return "nothing came";
}

constexpr CouplerView views[] = {
    CouplerView::joining,  CouplerView::empty,     CouplerView::resuming,           CouplerView::idle,
    CouplerView::proposed, CouplerView::inserting, CouplerView::advancing,          CouplerView::reporting,
    CouplerView::saving,   CouplerView::restoring, CouplerView::reporting_proposed, CouplerView::finishing,
    CouplerView::leaving};

bool exists(Role role, CouplerView view) {
  const bool only_structure = view == CouplerView::joining || view == CouplerView::proposed ||
                              view == CouplerView::reporting_proposed;
  return role == Role::structure || !only_structure;
}

std::string fault_in(CouplerView view, ProtocolFault fault) {
  return std::string("view ") + name(view) + ", fault " + name(fault);
}

void walk_what_is_heard(Role role) {
  for (const CouplerView view : views)
    for (std::size_t number = 0; number < word_count; ++number) {
      const auto word = static_cast<Word>(number);
      if (!exists(role, view)) continue;
      CAPTURE(name(role), name(view), name(word));
      PlayedTrio stage(start_of(view));
      bring(stage, role, view);
      stage.says(role, word);
      const CouplerReaction& rule = reaction(role, view, word);
      if (const auto* fault = std::get_if<ProtocolFault>(&rule)) {
        CHECK_THAT(failure_of(stage, role, start_of(view)), Catch::Contains(fault_in(view, *fault)));
        continue;
      }
      const auto& step = std::get<CouplerStep>(rule);
      // What no participant says makes the coupler tell how it sees this one now.
      if (step.action != CouplerAction::hear_failure) stage.says(role, Word::welcome);
      CHECK_THAT(failure_of(stage, role, start_of(view)),
                 Catch::Contains(step.action == CouplerAction::hear_failure
                                     ? "reports: as a test"
                                     : fault_in(step.next, ProtocolFault::wrong_direction)));
    }
}

}  // namespace

TEST_CASE("the coupler does with every message of a structure what the table says",
          "[coupler][launch][table]") {
  walk_what_is_heard(Role::structure);
}

TEST_CASE("the coupler does with every message of a network what the table says",
          "[coupler][launch][table]") {
  walk_what_is_heard(Role::network);
}

TEST_CASE("the coupler says nothing that the table does not allow", "[coupler][launch][table]") {
  const Word commands[] = {Word::insert, Word::advance, Word::report,
                           Word::save,   Word::restore, Word::finish};
  for (const Role role : {Role::structure, Role::network})
    for (const CouplerView view : views) {
      if (!exists(role, view)) continue;
      PlayedTrio stage(start_of(view));
      bring(stage, role, view);
      for (const Word word : commands) {
        CAPTURE(name(role), name(view), name(word));
        const auto* fault = std::get_if<ProtocolFault>(&move(role, view, word));
        if (fault == nullptr) continue;
        try {
          stage.trio().send(role, message_of(word));
          FAIL("it was said");
        } catch (const Error& refusal) {
          CHECK(refusal.code() == ExitCode::internal);
          CHECK_THAT(refusal.what(), Catch::Contains(fault_in(view, *fault)));
        }
      }
    }
}
