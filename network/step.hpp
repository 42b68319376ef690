// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "common/flow_solver/flow_solver.hpp"
#include "network/graph.hpp"
#include "network/laws/fluid_content.hpp"
#include "network/model.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// One coupling interval as the coupler poses it; arrays in the order of the nodes.
struct Interval {
  double begin = 0, end = 0;  ///< [s]
  Carry carry = Carry::content;
  std::vector<double> aperture;            ///< of the structure at `begin` [m], >= 0
  std::vector<double> aperture_rate;       ///< [m/s]; zero with carry = content
  std::vector<double> reference_pressure;  ///< [Pa]
  std::vector<double> compliance;          ///< [m/Pa], >= 0
  std::vector<Faces> faces;
  std::vector<double> arm_aperture_a,
      arm_aperture_b;  ///< of each segment's own arm at its ends [m]; may be empty
};

struct WellTarget {
  WellControl control = WellControl::rate;
  double value = 0;  ///< rate of all perforations, mean of the step [m2/s], or well pressure at its end [Pa]
};

/// Everything that stands still while one backward Euler step (begin, end] is solved.
struct Step {
  double begin = 0, end = 0;             ///< [s]
  std::vector<ContentLaw> storage;       ///< per node
  std::vector<double> demand;            ///< Lambda, per node [m]
  std::vector<double> segment_aperture;  ///< per segment [m]
  std::vector<double> transmissibility;  ///< T, per segment [m2/(s Pa)]
  WellTarget well;

  [[nodiscard]] double duration() const { return end - begin; }
};

/// K_f of the mixture at a node [Pa].
double bulk_modulus(const Model& model, const State& state, std::size_t node);

/// The contact pressures of the joint laws follow what would part the faces, max(reference_pressure, p),
/// while these touch and the pressure is not above. Else they stay, so that no joint opening jumps. A node is
/// open as soon as one of its arms is: at the mouth of a hydraulic fracture the joint's own opening ends with
/// the mouth's.
void follow_contact(const Interval& interval, State& state);

/// Of the joints at a node, a mean over all arms.
JointLaw joint_law(const Graph& graph, const State& state, std::size_t node);

/// Fills `step` for (state.time, end].
///   e_ij = (e_i + e_j) / 2,   e_i = max(e_min, arm + j_i(p_i))     of the segment's own arm, else of the
///   node; a natural arm has the joint opening of its node, which is a mean over all arms, times l_i /
///   l_natural,i Lambda_i = max(0, V_C,i(end) - v_i)          cumulative: what a node could not give before
///   is still asked for
void prepare_step(const Model& model, const Graph& graph, const Interval& interval, const State& state,
                  double end, Step& step);

/// Sets the transmissibilities from the gradients [Pa/m] and fluxes [m2/s] of a solution, both per segment.
/// Of the power law they are secants, so that the flow is linear in the pressures; see secant_viscosity.
void set_transmissibility(const Model& model, const Graph& graph, const State& state,
                          std::span<const double> gradient, std::span<const double> flux, Step& step);

}  // namespace fissura::network
