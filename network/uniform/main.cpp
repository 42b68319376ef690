// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/uniform/uniform_solver.hpp"

int main(int argc, char** argv) {
  fissura::uniform_flow::UniformSolver solver;
  return fissura::flow_solver_main(argc, argv, "fissura-uniform", FISSURA_VERSION, solver);
}
