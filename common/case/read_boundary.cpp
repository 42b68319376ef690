// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

Boundary read_side(TableReader& boundaries, std::string_view side) {
  Boundary boundary;
  if (!boundaries.has(side)) return boundary;
  TableReader table = boundaries.table(side);
  const std::optional<BoundaryKind> kind = table.choice("kind", boundary_kinds);
  if (!kind) return boundary;
  boundary.kind = *kind;
  switch (boundary.kind) {
    case BoundaryKind::fixed:
    case BoundaryKind::roller:
      for (const char* key : {"value", "ramp"})
        if (table.has(key)) table.refuse(key, "no such key with this kind, which moves nothing");
      break;
    case BoundaryKind::traction:
      boundary.value = table.vector("value", dimension::stress, boundary.value);
      if (table.has("ramp")) table.refuse("ramp", "no such key with kind = \"traction\"");
      break;
    case BoundaryKind::displacement:
      boundary.value = table.vector("value", dimension::length);
      boundary.ramp = table.quantity("ramp", dimension::time, not_negative, boundary.ramp);
      break;
  }
  table.refuse_unknown_keys();
  return boundary;
}

}  // namespace

Boundaries read_boundary(TableReader& document) {
  TableReader table = document.optional_table("boundary");
  Boundaries boundaries{read_side(table, "west"), read_side(table, "east"), read_side(table, "south"),
                        read_side(table, "north")};
  table.refuse_unknown_keys();
  return boundaries;
}

}  // namespace fissura::input
