// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura::cells {

/// What the contract says of one node (docs/flow_solvers.md, 3.1 and 3.6), with the aperture as it stands:
///   e(p) = max(0, aperture + compliance (p - reference_pressure)),  only above reference_pressure if closed
///   m(p) = e(p) (1 + p / K_f)  where p > 0
struct CellLaw {
  double aperture = 0;            ///< [m], >= 0
  double compliance = 0;          ///< C_R [m/Pa], >= 0
  double reference_pressure = 0;  ///< [Pa]
  double bulk_modulus = 0;        ///< K_f [Pa], > 0
  bool closed = false;
};

/// e(p) [m]. @param pressure  >= 0 [Pa]
double cell_aperture(const CellLaw& law, double pressure);

/// m(p) of a filled cell [m]. @param pressure  >= 0 [Pa]
double cell_content(const CellLaw& law, double pressure);

/// The pressure of a content [Pa]: the p > 0 with m(p) = content, 0 if the content does not fill the cell.
/// @param content  [m]
double cell_pressure(const CellLaw& law, double content);

/// filled: 1 where p > 0, else content / e(0), below 1.
double cell_filled(const CellLaw& law, double pressure, double content);

/// The pressure from which on the compliance counts [Pa]: below it a content changes by orders of magnitude
/// less with pressure, or not at all. 0 if there is no such pressure; infinite in a cell that can never hold
/// anything.
double opening_pressure(const CellLaw& law);

/// The p >= 0 at which what a cell stores balances what comes in:
///   length (m(p) - content) = supply - conductance p                                      [Pa]
/// @param conductance  dt sum_j T_ij [m2/Pa], > 0
/// @param supply       dt (sum_j T_ij p_j + q) [m2]
double balanced_pressure(const CellLaw& law, double length, double content, double conductance,
                         double supply);

}  // namespace fissura::cells
