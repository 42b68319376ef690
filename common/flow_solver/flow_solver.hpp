// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "common/flow_solver/flow_case.hpp"
#include "common/fracture_network/fracture_network.hpp"

/// What a flow solver in C++ implements to play the network (docs/flow_solvers.md): plain numbers, no
/// message. Arrays are in the order of network.nodes() or network.segments() at the revision in force.
namespace fissura {

/// Which fluid content an interval begins with.
enum class Carry {
  content,  ///< that of the interval before: fluid is conserved
  pressure  ///< made anew from aperture and the last pressure, the difference booked as reset (scheme
            ///< "profit2016")
};

/// ADVANCE. The law of a node in it, with m its fluid content [m3 of fluid at zero pressure per m2 of face]:
///   e(p) = max(0, aperture + compliance (p - reference_pressure)),  only p > reference_pressure counts where
///   closed m = e(p) (1 + p / K_f)  if p > 0,   m = filled e(0), 0 <= filled < 1, if p = 0
struct CouplingInterval {
  double begin = 0, end = 0;  ///< [s], begin < end; begin is the end of the interval before
  Carry carry = Carry::content;
  std::vector<double> aperture;            ///< measured by the structure at begin [m], >= 0
  std::vector<double> aperture_rate;       ///< expected besides e(p); 0 under the scheme robin [m/s]
  std::vector<double> reference_pressure;  ///< carried by the structure when it measured `aperture` [Pa]
  std::vector<double> compliance;          ///< C_R of the rock around a node [m/Pa], >= 0
  std::vector<unsigned char> closed;       ///< 1 where the faces touch
  /// Of each segment's own arm at node_a and node_b [m]; both empty if the structure does not tell.
  std::vector<double> arm_aperture_a, arm_aperture_b;
};

/// Volumes of the whole thickness, cumulative [m3].
struct FluidLedger {
  double injected = 0;      ///< net of what was produced
  double in_place = 0;      ///< content at the start
  double found = 0;         ///< pore fluid of nodes that joined saturated later
  double in_fractures = 0;  ///< now
  double leaked = 0;
  double reset = 0;  ///< created by Carry::pressure

  /// What is missing: injected + in_place + found + reset - in_fractures - leaked [m3].
  [[nodiscard]] double residual() const {
    return injected + in_place + found + reset - in_fractures - leaked;
  }
};

/// PRESSURE: the state at the end of the interval.
struct FlowAnswer {
  std::vector<double> pressure;            ///< [Pa], >= 0
  std::vector<double> aperture_predicted;  ///< e(p) of the law above, without joint_compliance [m]
  std::vector<double> filled;              ///< [-], 1 where p > 0, else in [0, 1]
  FluidLedger ledger;
  double well_pressure = 0;  ///< [Pa]
  double rate = 0;           ///< of the well at the end, whole thickness [m3/s]
  bool converged = true;
  int iterations = 0, halvings = 0;
  double residual = 0;  ///< of an iterative solution, relative to the content moved [-]
};

/// A field for the record: one value, or one row of `columns` values, per node or segment.
struct FlowField {
  std::string name;
  std::string unit;  ///< SI, "1" without dimension
  std::vector<double> values;
  std::optional<std::size_t> columns = {};  ///< of a row; nothing: one value each
};

/// What another flow solver needs to go on from here: no discretisation of time, no scheme, no history of
/// Newton. Everything of one revision.
struct NeutralFlowState {
  double time = 0;                       ///< [s]
  bool started = false;                  ///< an interval has been solved
  std::vector<double> content;           ///< m [m], >= 0 but for rounding
  std::vector<double> pressure;          ///< [Pa], >= 0: where to begin an iteration; not part of the book
  std::vector<double> leaked;            ///< taken by both faces so far, per area of trace [m]
  std::vector<double> exposure_time;     ///< when the fluid reached the faces [s]; infinite if it has not
  std::vector<double> contact_pressure;  ///< p_c of joints [Pa]
  std::vector<double> fluid_fraction;    ///< [n_nodes x n_fluids], by volume, rows sum to 1 [-]
  std::vector<unsigned char> joining;  ///< 1: joined saturated, its pore fluid not yet taken into the content
  double well_pressure = 0;            ///< [Pa]
  double rate = 0;                     ///< of the well, whole thickness [m3/s]
  double entry_rate = 0;  ///< what the well did when the stage in force began, where its ramp starts [m3/s]
  double entry_pressure = 0;  ///< the same [Pa]
  FluidLedger ledger;
};

/// Physics beyond the flow of one fluid by the cubic law that a solver may claim; a run that needs what its
/// solver does not claim is refused at the handshake.
namespace claims {
inline constexpr const char* viscous_flow = "viscous_flow";            ///< the cubic law itself
inline constexpr const char* leak_off = "leak_off";                    ///< Carter
inline constexpr const char* power_law = "power_law";                  ///< fluids with n != 1
inline constexpr const char* several_fluids = "several_fluids";        ///< more than one fluid pumped
inline constexpr const char* pressure_control = "pressure_control";    ///< stages of a given well pressure
inline constexpr const char* natural_fractures = "natural_fractures";  ///< saturated nodes, joint compliance
inline constexpr const char* carry_pressure = "carry_pressure";        ///< Carry::pressure
}  // namespace claims

/// What a solver can save and go on from.
enum class StateKept {
  none,            ///< runs with it keep no checkpoints
  own,             ///< save and restore
  own_and_neutral  ///< neutral_state and take_up, too: a run may change to or from another solver
};

/// A flow solver: join, insert and advance are needed, the rest is as it claims. Calls come in this order: join; insert (revision 0), or take_up or restore after it in a
/// run that resumes; then any number of advance, insert, report, save; finish. Any of them may throw: the
/// failure is sent to the coupler with the code of the Error, and the process ends. Arguments have been
/// checked: lengths, finite numbers, signs, order of intervals, topology.
class FlowSolver {
 public:
  virtual ~FlowSolver() = default;

  /// Of `claims`.
  [[nodiscard]] virtual std::set<std::string> physics() const = 0;
  [[nodiscard]] virtual StateKept state_kept() const { return StateKept::none; }
  virtual void join(const FlowCase& flow_case) = 0;
  /// `network` is the topology after `insertion`. Here, in restore and in take_up it stays where it is and as
  /// it is until the next call of one of these.
  virtual void insert(const Insertion& insertion, const FractureNetwork& network) = 0;
  virtual FlowAnswer advance(const CouplingInterval& interval) = 0;
  /// What the coupler records; names are free, but "pressure", "aperture", "filled" and "content" per node
  /// and "flux" per segment are what reports draw.
  [[nodiscard]] virtual std::vector<FlowField> report() const { return {}; }

  // As state_kept() says; each throws Error(internal) here.

  /// Everything that later answers depend on, bit for bit. Opaque to all others; who it belongs to (program,
  /// case, topology) and a checksum are put around it.
  [[nodiscard]] virtual std::vector<std::byte> save() const;
  /// Bytes of save() of the same program and case, with the topology they belong to. Throws
  /// Error(checkpoint_unusable) if they cannot be its own.
  virtual void restore(std::span<const std::byte> state, const FractureNetwork& network);
  /// The state as any solver understands it.
  [[nodiscard]] virtual NeutralFlowState neutral_state() const;
  /// Goes on from another solver's neutral state. Content, leaked volume and ledger must stay what they are.
  virtual void take_up(const NeutralFlowState& state, const FractureNetwork& network);

  /// Last figures for summary.json.
  [[nodiscard]] virtual nlohmann::json finish() const { return nlohmann::json::object(); }
};

/// The whole main() of a flow solver: reads `--connect ENDPOINT` and `--keys DIR`, plays the network until
/// FINISH, and turns exceptions into exit codes (docs/operation.md). Call note_progress (participant.hpp) in
/// loops that may take seconds.
int flow_solver_main(int argc, char** argv, const char* name, const char* version, FlowSolver& solver);

}  // namespace fissura
