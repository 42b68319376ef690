// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/utc_time.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

constexpr std::int64_t second = 1000000;

[[noreturn]] void refuse(std::string_view text) {
  throw InputError(
      fmt::format("georeference.start is \"{}\": expected a time like \"2026-01-31T12:00:00Z\"", text));
}

int number_in(std::string_view text, std::size_t begin, std::size_t length) {
  int number = 0;
  for (const char digit : text.substr(begin, length)) {
    if (digit < '0' || digit > '9') refuse(text);
    number = 10 * number + (digit - '0');
  }
  return number;
}

std::int64_t fraction_in(std::string_view text, std::string_view digits) {
  if (digits.empty()) refuse(text);
  std::int64_t fraction = 0, unit = second;
  for (const char digit : digits) {
    if (digit < '0' || digit > '9') refuse(text);
    unit /= 10;
    fraction += unit * (digit - '0');
  }
  return fraction;
}

}  // namespace

std::int64_t microseconds_of_utc(std::string_view text) {
  const std::string_view pattern = "0000-00-00T00:00:00";
  if (text.size() <= pattern.size() || text.back() != 'Z') refuse(text);
  for (std::size_t at = 0; at < pattern.size(); ++at)
    if (pattern[at] != '0' && text[at] != pattern[at]) refuse(text);
  const std::chrono::year_month_day date{std::chrono::year(number_in(text, 0, 4)),
                                         std::chrono::month(static_cast<unsigned>(number_in(text, 5, 2))),
                                         std::chrono::day(static_cast<unsigned>(number_in(text, 8, 2)))};
  const int hour = number_in(text, 11, 2), minute = number_in(text, 14, 2), whole = number_in(text, 17, 2);
  if (!date.ok() || hour > 23 || minute > 59 || whole > 59) refuse(text);
  const std::string_view rest = text.substr(pattern.size(), text.size() - pattern.size() - 1);
  if (!rest.empty() && rest.front() != '.') refuse(text);
  const std::int64_t fraction = rest.empty() ? 0 : fraction_in(text, rest.substr(1));
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return (((days * 24 + hour) * 60 + minute) * 60 + whole) * second + fraction;
}

std::string utc_after(std::string_view start, double seconds) {
  using std::chrono::microseconds;
  const microseconds time(microseconds_of_utc(start) + std::llround(seconds * 1e6));
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date{std::chrono::sys_days(day)};
  const std::int64_t of_day = (time - day).count(), whole = of_day / second;
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:06}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), whole / 3600,
                     whole / 60 % 60, whole % 60, of_day % second);
}

}  // namespace fissura::coupler
