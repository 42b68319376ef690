// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/participant.hpp"
#include "network/network_solver.hpp"

int main(int argc, char** argv) {
  fissura::network::NetworkSolver solver([] { fissura::note_progress("newton"); });
  return fissura::flow_solver_main(argc, argv, "fissura", FISSURA_VERSION, solver);
}
