// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/explicit/explicit_solver.hpp"

int main(int argc, char** argv) {
  fissura::explicit_flow::ExplicitSolver solver;
  return fissura::flow_solver_main(argc, argv, "fissura-explicit", FISSURA_VERSION, solver);
}
