// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/in_process/resume_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <memory>

#include "common/case/case_json.hpp"
#include "structure/structure_solver.hpp"
#include "tests/fakes/in_process/coupled_run.hpp"
#include "tests/network/messaged_network.hpp"

namespace fissura::fakes {

namespace {

using Blob = std::vector<std::byte>;

struct Participants {
  structure::StructureSolver structure;
  network::test::MessagedNetwork network;

  Pair pair() { return {structure, network}; }
  [[nodiscard]] Solver& of(Role role) {
    return role == Role::structure ? static_cast<Solver&>(structure) : network;
  }
};

constexpr std::array<Role, 2> both{Role::structure, Role::network};

std::size_t index(Role role) {
  return static_cast<std::size_t>(role);
}

template <class Work>
void timed(Cost& cost, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  cost.add(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

struct Restored {
  std::unique_ptr<Participants> participants;
  CoupledRun run;
  std::uint64_t born = 0, revision = 0, beyond_insertion = 0;
  bool differs = false;
};

class Sweep {
 public:
  Sweep(const Case& run_case, const SweepOptions& options)
      : options_(options), json_(case_to_json(run_case)), run_(run_case), unsaved_run_(run_) {}

  SweepReport execute() {
    begin();
    while (!run_.finished() && run_.intervals() < options_.intervals) step();
    report_.intervals = run_.intervals();
    return std::move(report_);
  }

 private:
  [[nodiscard]] BlobFigures& figures(Role role) { return report_.participant[index(role)]; }

  void begin() {
    for (Participants* each : {&original_, &unsaved_, &rolled_back_})
      for (const Role role : both)
        timed(figures(role).join, [&] { each->of(role).join({json_, options_.threads, false}); });
    CoupledRun third = run_;
    const auto answers = run_.begin(original_.pair());
    compare(answers, unsaved_run_.begin(unsaved_.pair()), "never saved", 0);
    compare(answers, third.begin(rolled_back_.pair()), "of its own", 0);
    save();
    restore_a_fresh_pair();
  }

  void step() {
    CoupledRun again = run_;
    const std::uint64_t before = run_.intervals();
    for (const Role role : both)
      timed(figures(role).restore, [&] { rolled_back_.of(role).restore(now_[index(role)]); });
    const std::vector<Message> answers = run_.advance(original_.pair());
    if (answers.back().type == MessageType::acknowledge) ++report_.insertions;
    save();
    compare(answers, unsaved_run_.advance(unsaved_.pair()), "never saved", 0);
    compare(answers, again.advance(rolled_back_.pair()), "rolled back", before);
    compare_blobs(rolled_back_, "rolled back", before);
    for (Restored& each : restored_) follow(each, answers);
    restored_.remove_if([&](const Restored& each) {
      const std::uint64_t age = run_.intervals() - each.born;
      return each.differs || age >= options_.at_most || (age >= options_.ahead && each.beyond_insertion >= 2);
    });
    restore_a_fresh_pair();
  }

  void follow(Restored& each, const std::vector<Message>& answers) {
    const bool same = compare(answers, each.run.advance(each.participants->pair()), "restored", each.born);
    each.differs = !compare_blobs(*each.participants, "restored", each.born) || !same;
    if (each.beyond_insertion > 0 || each.run.revision() > each.revision) ++each.beyond_insertion;
  }

  void save() {
    for (const Role role : both) {
      timed(figures(role).save, [&] { now_[index(role)] = original_.of(role).save(); });
      figures(role).bytes = std::max(figures(role).bytes, now_[index(role)].size());
    }
  }

  void restore_a_fresh_pair() {
    if (run_.intervals() % options_.every != 0 || run_.finished()) return;
    auto fresh = std::make_unique<Participants>();
    for (const Role role : both)
      timed(figures(role).resume, [&] {
        fresh->of(role).join({json_, options_.threads, true});
        fresh->of(role).restore(now_[index(role)]);
      });
    Message before(MessageType::restored), after(MessageType::restored);
    original_.structure.describe_state(before);
    fresh->structure.describe_state(after);
    compare({before}, {after}, "restored", run_.intervals());
    compare_blobs(*fresh, "restored", run_.intervals());
    restored_.push_back({std::move(fresh), run_, run_.intervals(), run_.revision(), 0, false});
    ++report_.restored;
  }

  bool compare(const std::vector<Message>& expected, const std::vector<Message>& found, const char* what,
               std::uint64_t born) {
    ++report_.answers;
    const auto other = difference(expected, found);
    if (other) note(what, born, *other);
    return !other;
  }

  bool compare_blobs(Participants& participants, const char* what, std::uint64_t born) {
    bool same = true;
    for (const Role role : both) {
      ++report_.blobs;
      const Blob &expected = now_[index(role)], found = participants.of(role).save();
      if (expected == found) continue;
      same = false;
      const auto end =
          expected.begin() + static_cast<std::ptrdiff_t>(std::min(expected.size(), found.size()));
      const auto at = std::mismatch(expected.begin(), end, found.begin()).first - expected.begin();
      note(what, born,
           fmt::format("blob of the {}, {} and {} bytes, from byte {}", name(role), expected.size(),
                       found.size(), at));
    }
    return same;
  }

  void note(const char* what, std::uint64_t born, const std::string& other) {
    report_.differences.push_back(
        fmt::format("{} after interval {}, in interval {}: {}", what, born, run_.intervals(), other));
  }

  SweepOptions options_;
  nlohmann::json json_;
  CoupledRun run_, unsaved_run_;
  Participants original_, unsaved_, rolled_back_;
  std::list<Restored> restored_;
  std::array<Blob, 2> now_;
  SweepReport report_;
};

}  // namespace

void Cost::add(double seconds) {
  mean += (seconds - mean) / static_cast<double>(++count);
  greatest = std::max(greatest, seconds);
}

SweepReport sweep(const Case& run_case, const SweepOptions& options) {
  return Sweep(run_case, options).execute();
}

}  // namespace fissura::fakes
