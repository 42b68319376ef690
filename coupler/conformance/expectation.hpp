// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// What a check requires; each throws Deviation naming `what`, or returns.
namespace fissura::coupler::conformance {

/// |obtained - expected| <= tolerance, which has the unit of both.
void require_close(const std::string& what, double obtained, double expected, double tolerance);
/// The same relative to |expected|.
void require_ratio(const std::string& what, double obtained, double expected, double relative_tolerance);
/// minimum <= obtained <= maximum, and finite.
void require_within(const std::string& what, double obtained, double minimum, double maximum);
/// Every value, naming the first that is not: "WHAT 3".
void require_all_close(const std::string& what, const std::vector<double>& obtained,
                       const std::vector<double>& expected, double tolerance);
void require_all_within(const std::string& what, const std::vector<double>& obtained, double minimum,
                        double maximum);
/// Bit for bit.
void require_same(const std::string& what, const std::string& obtained, const std::string& expected);
void require_same_bits(const std::string& what, const std::vector<double>& obtained,
                       const std::vector<double>& expected);
void require(bool holds, const std::string& expected, const std::string& obtained);

}  // namespace fissura::coupler::conformance
