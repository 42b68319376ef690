// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "common/case/case.hpp"
#include "common/coupling/coupling_clock.hpp"
#include "coupler/record/interval_record.hpp"
#include "coupler/scheme/exchange.hpp"
#include "coupler/scheme/fracture_path.hpp"

namespace fissura::coupler {

/// Where the fluid enters, and what the record needs to know of it.
struct Inlet {
  std::size_t node = 0;          ///< of the first perforation, index into the network's nodes
  double stored_aperture = 0;    ///< e_0, not part of the mechanical opening [m]
  double closure = 0;            ///< total in-situ stress normal to the fracture there, compression positive [Pa]
};

/// The first perforation of the case; nothing in a dry case. @pre the network has its revision 0
std::optional<Inlet> find_inlet(const FractureNetwork& network, const Case& run_case);

/// The scalars of one interval: the network was asked with its topology, the structure has answered. Those of the inlet
/// are zero without one.
IntervalRecord interval_figures(const ClockInterval& interval, const FractureNetwork& network,
                                const std::optional<Inlet>& inlet,
                                const StructureResponse& structure, const NetworkAnswer& answer);

/// Adds where the fracture went, what was spent on it, and the size of the mesh. The cohesive share compares the work with
/// G_f times thickness times grown_length, which is what the joints need; it is 0 before anything has grown.
void add_growth_figures(const FractureNetwork& network, const FracturePath& path, const StructureResponse& structure,
                        const Case& run_case, IntervalRecord& record);

/// sum l |e - e^| / sum l e over filled nodes: how far the structure went from the prediction [-].
double drift(const FractureNetwork& network, const StructureResponse& structure, const NetworkAnswer& answer);

}  // namespace fissura::coupler
