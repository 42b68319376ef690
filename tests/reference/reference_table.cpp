// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>

#include "tests/reference/case_table.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: reference_table CASE   prints cases/CASE/reference.csv; CASE is one of\n", stderr);
    for (const auto& name : fissura::reference::cases_with_reference())
      std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  try {
    std::fputs(fissura::reference::as_csv(fissura::reference::case_table(argv[1])).c_str(), stdout);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "reference_table: %s\n", error.what());
    return 1;
  }
  return 0;
}
