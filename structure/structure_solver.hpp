// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "common/exchange/participant.hpp"
#include "structure/fracture/failing_tips.hpp"
#include "structure/fracture/growth.hpp"
#include "structure/initial_motion.hpp"
#include "structure/structure_probes.hpp"
#include "structure/structure_run.hpp"
#include "structure/structure_snapshot.hpp"

namespace fissura::structure {

/// The structure as the coupler sees it: messages in, messages out (docs/protocol.md), no physics of its own.
class StructureSolver : public Solver {
 public:
  void join(const Assignment& assignment) override;
  Insertion first_topology() override;
  void describe_state(Message& reply) override;
  Message advance(const Message& command) override;
  std::string insert(const Insertion& insertion) override;
  Message report(const Message& command) override;
  std::vector<std::byte> save() override;
  std::optional<std::string> restore(const std::vector<std::byte>& state) override;
  nlohmann::json finish() override;

 private:
  void build();
  void begin_motion();
  [[nodiscard]] nlohmann::json natural_fractures_json() const;
  void set_ramps_of(const Message& command);
  void tell_sources(const Message& command, Message& response);
  std::optional<Insertion> propose_growth();
  void renew_run();
  void protect_tips();
  [[nodiscard]] LoopTimes loop_times() const;

  std::optional<StructureModel> model_;
  Geometry geometry_;
  std::optional<StructureState> state_;
  std::unique_ptr<StructureRun> run_;
  std::optional<Probes> probes_;
  LoopTimes earlier_loops_;                      ///< of runs before the last change of the geometry
  std::optional<FailingTips> failing_tips_;      ///< with TipRule::damage
  bool insertion_is_due_ = false;                ///< proposed to the coupler, not yet carried out
  std::optional<GrowthPlan> growth_;             ///< the plan of it, if it changes the mesh
  std::vector<Meeting> meetings_;                ///< of the last insertion, not yet told
  std::vector<RemeshRecord> remeshing_;          ///< of the last insertion, until it is acknowledged
  StructureHistory history_;
  StateOwner owner_;
  double setup_seconds_ = 0;                     ///< wall time of meshing and set-up
};

}  // namespace fissura::structure
