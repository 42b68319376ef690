// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/material.hpp"

/// Limits of a plane-strain (KGD) hydraulic fracture of two wings, injected at a constant rate from its
/// middle.
///   w(x) = w(0) (1 + x/L)^a (1 - x/L)^b,  the rate Q_0 of both wings, mu', K', C' as in material.hpp.
/// M, storage and viscosity:   J. I. Adachi and E. Detournay, Int. J. Numer. Anal. Meth. Geomech. 26 (2002)
/// 579;
///                             D. I. Garagash and E. Detournay, J. Appl. Mech. 72 (2005) 916.
/// K, storage and toughness:   D. I. Garagash, Int. J. Solids Struct. 43 (2006) 5811.
/// M~, K~, leak-off:           J. I. Adachi and E. Detournay, Eng. Fract. Mech. 75 (2008) 4666; Dontsov
/// (2017).
namespace fissura::reference::kgd_vertices {

/// L = 0.6159 (Q^3 E' t^4 / mu')^(1/6), w = 1.1265 (mu' Q^3 t^2 / E')^(1/6) (1+xi)^0.588 (1-xi)^(2/3),
/// p = 0.5469 E' (mu' / (E' t))^(1/3)
KgdState m(const ScaledParameters& p, double time);

/// L = 0.9324 (E' Q t / K')^(2/3), w = 0.6828 (K'^2 Q t / E'^2)^(1/3) sqrt(1 - xi^2), p = K_Ic / sqrt(pi L)
KgdState k(const ScaledParameters& p, double time);

/// L = Q sqrt(t) / (pi C'), w = 0.8165 (mu' Q^3 t / (E' C'^2))^(1/4) (1+xi)^0.520 (1-xi)^(5/8); the pressure
/// is left at zero. Efficiency 0.
KgdState m_tilde(const ScaledParameters& p, double time);

/// L = Q sqrt(t) / (pi C'), w = 0.3989 (K'^4 Q^2 t / (E'^4 C'^2))^(1/4) sqrt(1 - xi^2), p = K_Ic / sqrt(pi L)
KgdState k_tilde(const ScaledParameters& p, double time);

}  // namespace fissura::reference::kgd_vertices
