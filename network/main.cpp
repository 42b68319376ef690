// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/network_solver.hpp"

int main(int argc, char** argv) {
  fissura::network::NetworkSolver solver;
  return fissura::participant_main(fissura::Role::network, argc, argv, "fissura", solver);
}
