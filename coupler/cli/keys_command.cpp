// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/keys_command.hpp"

#include <cstdio>

#include "common/exchange/curve_keys.hpp"

namespace fissura::coupler {

int new_keys_command(const std::filesystem::path& directory) {
  (void)write_new_keys(directory);
  std::printf(
      "keys written to %s. Each host needs these files in a directory of its own, copied by a safe way "
      "(scp):\n"
      "  coupler    coupler.secret coupler.public structure.public network.public\n"
      "             and ROLE.secret of a participant that `coupler run` starts itself\n"
      "  structure  structure.secret coupler.public\n"
      "  network    network.secret coupler.public\n"
      "Secrets stay with mode 0600; whoever has one can play that role. Then:\n"
      "  coupler run CASE --keys DIR --await structure\n"
      "  structure --connect tcp://COUPLER-HOST:PORT --keys DIR\n",
      directory.c_str());
  return 0;
}

}  // namespace fissura::coupler
