// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/fracture_network/insertion_archive.hpp"

#include "common/errors.hpp"

namespace fissura {

FractureNetwork network_after(const std::vector<Insertion>& insertions) {
  ByteReader::require(!insertions.empty());
  FractureNetwork network;
  try {
    for (const Insertion& insertion : insertions) network.apply(insertion);
  } catch (const ProtocolError& fault) {
    throw Error(ExitCode::checkpoint_unusable,
                std::string("the saved history of the fracture network is broken: ") + fault.what());
  }
  return network;
}

}  // namespace fissura
