// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/check_case.hpp"

namespace fissura::input {

void check_case(const Case& value, const SourceValue& document, FaultList& faults) {
  check_geometry(value, document, faults);
  check_in_situ(value, document, faults);
  check_schedule(value, document, faults);
  check_growth(value, document, faults);
  check_motion(value, document, faults);
}

}  // namespace fissura::input
