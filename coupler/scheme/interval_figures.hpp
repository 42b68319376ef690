// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"
#include "common/coupling/coupling_clock.hpp"
#include "coupler/record/interval_record.hpp"
#include "coupler/scheme/exchange.hpp"

namespace fissura::coupler {

/// Where the fluid enters, and what the record needs to know of it.
struct Inlet {
  std::size_t node = 0;          ///< of the first perforation, index into the network's nodes
  double stored_aperture = 0;    ///< e_0, not part of the mechanical opening [m]
  double closure = 0;            ///< total in-situ stress normal to the fracture there, compression positive [Pa]
};

/// The first perforation of the case. @pre the network has its revision 0
Inlet find_inlet(const FractureNetwork& network, const Case& run_case);

/// The scalars of one interval: the network was asked with its topology, the structure has answered.
IntervalRecord interval_figures(const CouplingInterval& interval, const FractureNetwork& network, const Inlet& inlet,
                                const StructureResponse& structure, const NetworkAnswer& answer);

/// sum l |e - e^| / sum l e over filled nodes: how far the structure went from the prediction [-].
double drift(const FractureNetwork& network, const StructureResponse& structure, const NetworkAnswer& answer);

}  // namespace fissura::coupler
