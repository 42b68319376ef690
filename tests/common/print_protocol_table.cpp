// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <fstream>
#include <iostream>

#include "tests/common/protocol_text.hpp"

/// print_protocol_table docs/protocol.md: writes the tables of the protocol into the page.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "expected: print_protocol_table docs/protocol.md\n";
    return 2;
  }
  try {
    const std::string page = fissura::test::with_protocol_text(fissura::test::content_of(argv[1]));
    std::ofstream(argv[1], std::ios::binary) << page;
    return 0;
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << '\n';
    return 1;
  }
}
