// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Times of day, without leap seconds as everywhere in computing: a day has 86 400 s.
namespace fissura::coupler {

/// Microseconds since 1970-01-01T00:00:00Z of text like "2026-01-31T12:00:00Z" or "...00.25Z" (digits beyond
/// the sixth are dropped). Throws InputError if it is anything else.
std::int64_t microseconds_of_utc(std::string_view text);

/// "2026-01-31T12:00:00.250000Z", always with six digits of the second; `seconds` after `start` (as above),
/// rounded to a microsecond. Throws InputError as above.
std::string utc_after(std::string_view start, double seconds);

}  // namespace fissura::coupler
