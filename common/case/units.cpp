// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/units.hpp"

#include <locale.h>
#include <charconv>
#include <clocale>
#include <cmath>
#include <memory>
#include <optional>
#include <regex>

#include <fmt/format.h>
#include <udunits2.h>

#include "common/errors.hpp"

namespace fissura::input {

namespace {

/// UDUNITS reads numbers with strtod, which follows the locale of the thread.
class PlainNumbers {
 public:
  PlainNumbers() : plain_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(plain_)) {}
  ~PlainNumbers() {
    uselocale(before_);
    freelocale(plain_);
  }
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

 private:
  locale_t plain_, before_;
};

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;
using System = std::unique_ptr<ut_system, decltype(&ut_free_system)>;

Unit parse(ut_system* system, const std::string& text) {
  return {ut_parse(system, text.c_str(), UT_UTF8), &ut_free};
}

System read_system() {
  ut_set_error_message_handler(ut_ignore);
  System system(ut_read_xml(nullptr), &ut_free_system);
  if (!system)
    throw Error(ExitCode::precondition, "the unit database of UDUNITS-2 cannot be read (udunits2.xml)");
  ut_map_symbol_to_unit("cP", UT_ASCII, parse(system.get(), "mPa s").get());
  ut_map_symbol_to_unit("deg", UT_ASCII, parse(system.get(), "degree").get());
  return system;
}

ut_system* unit_system() {
  static const System system = read_system();
  return system.get();
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A bare factor, as in "2 m" or "GPa 5", is a slip of the pen here.
bool has_factor(const std::string& unit) {
  static const std::regex factor(R"((^|[\s*/(.])[-+]?[0-9])");
  return std::regex_search(unit, factor);
}

bool names_an_angle(const std::string& unit) {
  static const std::regex angle("deg|rad|°");
  return std::regex_search(unit, angle);
}

/// Factor from `unit` to `si`; empty if the two do not measure the same. UDUNITS also converts reciprocals,
/// logarithms and scales with an offset: those are not proportional.
std::optional<double> factor_between(const std::string& unit, const std::string& si) {
  const PlainNumbers plain_numbers;
  if (unit.empty() || has_factor(unit)) return {};
  const Unit from = parse(unit_system(), unit);
  const Unit to = parse(unit_system(), si);
  if (!from || !to || ut_are_convertible(from.get(), to.get()) == 0) return {};
  const Converter converter(ut_get_converter(from.get(), to.get()), &cv_free);
  if (!converter) return {};
  const double factor = cv_convert_double(converter.get(), 1);
  const bool proportional = cv_convert_double(converter.get(), 0) == 0 &&
                            std::abs(cv_convert_double(converter.get(), 2) - 2 * factor) <= 1e-12 * factor;
  if (!proportional || !std::isfinite(factor) || factor <= 0) return {};
  return factor;
}

/// A unit of time under a fractional power, split off a unit: "m/s^0.5" is "m" and s to the -0.5.
struct FractionalTime {
  std::string rest, time;
  double exponent = 0;
};

std::optional<FractionalTime> split_fractional_time(const std::string& unit, double power_index) {
  static const std::regex pattern(
      R"((\s*[*/.]?\s*)(?:sqrt\(\s*([A-Za-z]+)\s*\)|([A-Za-z]+)\^(n|-?[0-9]*\.[0-9]+)))");
  std::smatch match;
  if (!std::regex_search(unit, match, pattern)) return {};
  FractionalTime split{match.prefix().str() + match.suffix().str(), match[2].str() + match[3].str(), 0.5};
  if (match[4] == "n") {
    split.exponent = power_index;
  } else if (match[4].matched) {
    const std::string digits = match[4].str();
    std::from_chars(digits.data(), digits.data() + digits.size(), split.exponent);
  }
  if (match[1].str().find('/') != std::string::npos) split.exponent = -split.exponent;
  return split;
}

std::optional<double> factor_to_si(const std::string& unit, const Dimension& dimension) {
  const std::string si(dimension.unit);
  const double exponent = dimension.second_exponent;
  if (exponent == 0) {
    const bool is_angle = si == dimension::angle.unit || si == dimension::arc.unit;
    if (is_angle && !names_an_angle(unit)) return {};
    return factor_between(unit, si);
  }
  if (const auto split = split_fractional_time(unit, exponent)) {
    const auto rest = factor_between(split->rest, si);
    const auto time = factor_between(split->time, "s");
    if (!rest || !time || std::abs(split->exponent - exponent) > 1e-12) return {};
    return *rest * std::pow(*time, exponent);
  }
  if (exponent == 1) return factor_between(unit, si + " s");
  return {};
}

/// A unit that is a whole part of the SI one divides, which rounds once: "10 um" is exactly the literal 1e-5.
double scaled(double number, double factor) {
  const double parts = std::round(1 / factor);
  const bool is_whole_part = factor < 1 && std::abs(parts * factor - 1) < 1e-14;
  return is_whole_part ? number / parts : number * factor;
}

InputError expected(const Dimension& dimension, const std::string& trouble) {
  return InputError(
      fmt::format("{} with its unit such as \"{}\" ({})", dimension.name, dimension.example, trouble));
}

}  // namespace

double in_si(std::string_view text, const Dimension& dimension) {
  std::string_view digits = trimmed(text);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double number = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status == std::errc::result_out_of_range)
    throw expected(dimension, "the number is beyond the range of double precision");
  if (status != std::errc{}) throw expected(dimension, "it does not begin with a number");
  if (!std::isfinite(number)) throw expected(dimension, "the number is not finite");
  const std::string_view unit = trimmed(digits.substr(static_cast<std::size_t>(end - digits.data())));
  const double value = scaled(number, unit_in_si(unit, dimension));
  if (!std::isfinite(value))
    throw expected(dimension, "the value in SI is beyond the range of double precision");
  return value;
}

double unit_in_si(std::string_view unit, const Dimension& dimension) {
  if (unit.empty()) throw expected(dimension, "the unit is missing");
  const auto factor = factor_to_si(std::string(unit), dimension);
  if (!factor) throw expected(dimension, fmt::format("\"{}\" is no unit of that dimension", unit));
  return *factor;
}

}  // namespace fissura::input
