// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/participant.hpp"
#include "structure/structure_solver.hpp"

int main(int argc, char** argv) {
  fissura::structure::StructureSolver solver;
  return fissura::participant_main(fissura::Role::structure, argc, argv, "fissura structure",
                                   FISSURA_VERSION, solver);
}
