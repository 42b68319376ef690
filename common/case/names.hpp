// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/case/case.hpp"

/// The words by which a case names the values of its enumerations, in TOML and in JSON.
namespace fissura {

template <class E>
struct Named {
  std::string_view name;
  E value;
};

inline constexpr std::array boundary_kinds{Named<BoundaryKind>{"fixed", BoundaryKind::fixed},
                                           Named<BoundaryKind>{"roller", BoundaryKind::roller},
                                           Named<BoundaryKind>{"traction", BoundaryKind::traction},
                                           Named<BoundaryKind>{"displacement", BoundaryKind::displacement}};

inline constexpr std::array fracture_kinds{Named<FractureKind>{"open", FractureKind::open},
                                           Named<FractureKind>{"natural", FractureKind::natural},
                                           Named<FractureKind>{"intact", FractureKind::intact}};

inline constexpr std::array stage_controls{Named<StageControl>{"rate", StageControl::rate},
                                           Named<StageControl>{"pressure", StageControl::pressure},
                                           Named<StageControl>{"shut_in", StageControl::shut_in}};

inline constexpr std::array coupling_schemes{Named<CouplingScheme>{"robin", CouplingScheme::robin},
                                             Named<CouplingScheme>{"profit2016", CouplingScheme::profit2016}};

inline constexpr std::array softening_laws{Named<Softening>{"linear", Softening::linear},
                                           Named<Softening>{"exponential", Softening::exponential}};

inline constexpr std::array path_rules{Named<PathRule>{"prescribed", PathRule::prescribed},
                                       Named<PathRule>{"free", PathRule::free}};

inline constexpr std::array crossing_rules{Named<CrossingRule>{"renshaw_pollard", CrossingRule::renshaw_pollard},
                                           Named<CrossingRule>{"gu_weng", CrossingRule::gu_weng},
                                           Named<CrossingRule>{"blanton", CrossingRule::blanton},
                                           Named<CrossingRule>{"always", CrossingRule::always},
                                           Named<CrossingRule>{"never", CrossingRule::never}};

inline constexpr std::array persistence_readings{Named<PersistenceReading>{"repeat", PersistenceReading::repeat},
                                                 Named<PersistenceReading>{"gap", PersistenceReading::gap}};

inline constexpr std::array tip_rules{Named<TipRule>{"insertion", TipRule::insertion},
                                      Named<TipRule>{"damage", TipRule::damage}};

inline constexpr std::array source_thicknesses{
    Named<SourceThickness>{"layer", SourceThickness::layer},
    Named<SourceThickness>{"equidimensional", SourceThickness::equidimensional}};

/// The name of a value; empty if it has none.
template <class E, std::size_t N>
std::string name_of(E value, const std::array<Named<E>, N>& names) {
  for (const Named<E>& entry : names)
    if (entry.value == value) return std::string(entry.name);
  return {};
}

/// The names alone, in order.
template <class E, std::size_t N>
std::vector<std::string> texts_of(const std::array<Named<E>, N>& names) {
  std::vector<std::string> texts;
  for (const Named<E>& entry : names) texts.emplace_back(entry.name);
  return texts;
}

}  // namespace fissura
