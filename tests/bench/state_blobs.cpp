// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a case and, at its coupling times, gives the saved states of both participants to fresh ones, which go
// on beside those that were never saved, until the next insertion and beyond it. Every answer and every later
// state must be the same to the last bit.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <list>
#include <memory>

#include "common/case/case_json.hpp"
#include "common/case/read_case.hpp"
#include "common/log.hpp"
#include "network/network_solver.hpp"
#include "structure/structure_solver.hpp"
#include "tests/fakes/in_process/coupled_run.hpp"

using namespace fissura;

namespace {

using Clock = std::chrono::steady_clock;
using Blob = std::vector<std::byte>;

struct Options {
  CaseSource source;
  bool short_form = false;
  std::uint64_t every = 1, ahead = 5, at_most = 60, intervals = 1000000;
  int threads = 1;
};

struct Participants {
  structure::StructureSolver structure;
  network::NetworkSolver network;

  fakes::Pair pair() { return {structure, network}; }
};

struct Blobs {
  Blob structure, network;
};

/// Sum and greatest of wall times [s].
struct Cost {
  double sum = 0, greatest = 0;
  std::uint64_t count = 0;

  template <class Work>
  auto of(const Work& work) {
    const Clock::time_point start = Clock::now();
    struct Note {
      Cost& cost;
      Clock::time_point start;
      ~Note() {
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        cost.sum += seconds;
        cost.greatest = std::max(cost.greatest, seconds);
        ++cost.count;
      }
    } note{*this, start};
    return work();
  }
  [[nodiscard]] double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
};

struct Copy {
  std::unique_ptr<Participants> participants;
  fakes::CoupledRun run;
  std::uint64_t born = 0, revision = 0;
  std::uint64_t after_insertion = 0;  ///< intervals since the first insertion after its birth
  bool different = false;
};

class Sweep {
 public:
  explicit Sweep(const Options& options)
      : options_(options), case_(read_case(options.source).value), json_(case_to_json(case_)), run_(case_) {}

  int execute() {
    const Assignment anew{json_, options_.threads, false};
    join_.of([&] {
      for (Participants* each : {&original_, &unsaved_, &rolled_back_}) each->structure.join(anew);
      return 0;
    });
    for (Participants* each : {&original_, &unsaved_, &rolled_back_}) each->network.join(anew);
    fakes::CoupledRun other = run_, third = run_;
    const auto answers = run_.begin(original_.pair());
    note(fakes::difference(answers, other.begin(unsaved_.pair())), "never saved", 0, 0);
    note(fakes::difference(answers, third.begin(rolled_back_.pair())), "never saved", 0, 0);
    save();
    bear();
    while (!run_.finished() && run_.intervals() < options_.intervals) step(other);
    summary();
    return differences_ == 0 ? 0 : 1;
  }

 private:
  void step(fakes::CoupledRun& unsaved) {
    fakes::CoupledRun again = run_;
    restore(rolled_back_, now_);
    const std::vector<Message> answers = run_.advance(original_.pair());
    if (answers.back().type == MessageType::acknowledge) ++insertions_;
    save();
    note(fakes::difference(answers, unsaved.advance(unsaved_.pair())), "never saved", 0, run_.intervals());
    note(fakes::difference(answers, again.advance(rolled_back_.pair())), "rolled back", run_.intervals() - 1,
         run_.intervals());
    compare_blobs(rolled_back_, "rolled back", run_.intervals() - 1);
    for (Copy& copy : copies_) {
      const auto found = fakes::difference(answers, copy.run.advance(copy.participants->pair()));
      note(found, "restored", copy.born, run_.intervals());
      copy.different = found.has_value() || !compare_blobs(*copy.participants, "restored", copy.born);
      if (copy.after_insertion > 0 || copy.run.revision() > copy.revision) ++copy.after_insertion;
    }
    copies_.remove_if([&](const Copy& copy) {
      const std::uint64_t age = run_.intervals() - copy.born;
      return copy.different || age >= options_.at_most ||
             (age >= options_.ahead && copy.after_insertion >= 2);
    });
    bear();
  }

  void save() {
    now_.structure = save_.of([&] { return original_.structure.save(); });
    now_.network = save_network_.of([&] { return original_.network.save(); });
    largest_ = {std::max(largest_[0], now_.structure.size()), std::max(largest_[1], now_.network.size())};
  }

  void restore(Participants& participants, const Blobs& blobs) {
    restore_.of([&] {
      participants.structure.restore(blobs.structure);
      return 0;
    });
    restore_network_.of([&] {
      participants.network.restore(blobs.network);
      return 0;
    });
  }

  void bear() {
    if (run_.intervals() % options_.every != 0 || run_.finished()) return;
    auto fresh = std::make_unique<Participants>();
    const Assignment resumed{json_, options_.threads, true};
    resume_.of([&] {
      fresh->structure.join(resumed);
      fresh->structure.restore(now_.structure);
      return 0;
    });
    fresh->network.join(resumed);
    fresh->network.restore(now_.network);
    Message before(MessageType::restored), after(MessageType::restored);
    original_.structure.describe_state(before);
    fresh->structure.describe_state(after);
    note(fakes::difference(before, after), "restored", run_.intervals(), run_.intervals());
    compare_blobs(*fresh, "restored", run_.intervals());
    copies_.push_back({std::move(fresh), run_, run_.intervals(), run_.revision(), 0, false});
    ++births_;
  }

  bool compare_blobs(Participants& participants, const char* what, std::uint64_t born) {
    bool same = true;
    const auto compare = [&](const Blob& saved, const Blob& other, const char* who) {
      ++blobs_;
      if (saved == other) return;
      same = false;
      const auto at =
          std::mismatch(saved.begin(), saved.begin() + std::min(saved.size(), other.size()), other.begin());
      note(fmt::format("blob of the {} ({} and {} bytes) from byte {}", who, saved.size(), other.size(),
                       at.first - saved.begin()),
           what, born, run_.intervals());
    };
    compare(now_.structure, participants.structure.save(), "structure");
    compare(now_.network, participants.network.save(), "network");
    return same;
  }

  void note(const std::optional<std::string>& found, const char* what, std::uint64_t born,
            std::uint64_t interval) {
    ++comparisons_;
    if (!found) return;
    if (++differences_ <= 20)
      fmt::print("  {} after interval {}, in interval {}: {:.400}\n", what, born, interval, *found);
  }

  void summary() const {
    fmt::print(
        "{}: {} intervals, {} insertions, {} restored, {} answers and {} blobs compared, {} differences\n",
        case_.title, run_.intervals(), insertions_, births_, comparisons_, blobs_, differences_);
    fmt::print("  structure: {} bytes, save {:.2f} ms (at most {:.2f}), restore {:.2f} ms (at most {:.2f})\n",
               largest_[0], 1e3 * save_.mean(), 1e3 * save_.greatest, 1e3 * restore_.mean(),
               1e3 * restore_.greatest);
    fmt::print("  network: {} bytes, save {:.2f} ms (at most {:.2f}), restore {:.2f} ms (at most {:.2f})\n",
               largest_[1], 1e3 * save_network_.mean(), 1e3 * save_network_.greatest,
               1e3 * restore_network_.mean(), 1e3 * restore_network_.greatest);
    fmt::print("  structure: join anew {:.0f} ms, join to resume and restore {:.0f} ms (at most {:.0f})\n",
               1e3 * join_.sum / 3, 1e3 * resume_.mean(), 1e3 * resume_.greatest);
  }

  const Options& options_;
  Case case_;
  nlohmann::json json_;
  fakes::CoupledRun run_;
  Participants original_, unsaved_, rolled_back_;
  std::list<Copy> copies_;
  Blobs now_;
  Cost save_, restore_, save_network_, restore_network_, join_, resume_;
  std::array<std::size_t, 2> largest_{};
  std::uint64_t insertions_ = 0, births_ = 0, comparisons_ = 0, blobs_ = 0, differences_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Restores the states of a case at its coupling times and compares what follows.");
  Options options;
  program.add_option("CASE", options.source.path, "case folder")->required();
  program.add_option("--variant", options.source.variants, "variant of the case");
  program.add_option("--set", options.source.overrides, "KEY.PATH=VALUE");
  program.add_flag("--short", options.short_form, "its short form");
  program.add_option("--every", options.every, "restore at every so many intervals");
  program.add_option("--ahead", options.ahead,
                     "intervals a restored pair runs at least, and past the next insertion");
  program.add_option("--at-most", options.at_most, "intervals a restored pair runs at most");
  program.add_option("--intervals", options.intervals, "intervals of the case");
  program.add_option("--threads", options.threads, "of the structure");
  CLI11_PARSE(program, argc, argv);
  if (options.short_form) options.source.variants.emplace_back("short");
  try {
    log::start("state_blobs", "error");
    return Sweep(options).execute();
  } catch (const Error& fault) {
    fmt::print(stderr, "state_blobs: {}\n", fault.what());
    return static_cast<int>(fault.code());
  }
}
