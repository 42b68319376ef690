// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/toml_document.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace fissura::input {

namespace {

constexpr std::uintmax_t largest_file = 1024 * 1024;
// A line bounds the depth of a dotted key, and so the recursion below and in toml++.
constexpr std::size_t longest_line = 12000;
constexpr int deepest_nesting = 32;

class Converter {
 public:
  Converter(std::string file, FaultList& faults) : file_(std::move(file)), faults_(faults) {}

  SourceValue convert(const toml::node& node, const std::string& path, int depth) const {
    SourceValue value{position(node.source()), SourceTable{}};
    if (depth > deepest_nesting) {
      faults_.push_back({value.where, "", "a value nested deeper than any key of a case",
                         fmt::format("at most {} levels", deepest_nesting), ""});
    } else if (const auto* table = node.as_table()) {
      value.content = convert_table(*table, path, depth);
    } else if (const auto* array = node.as_array()) {
      value.content = convert_array(*array, path, depth);
    } else if (const auto* text = node.as_string()) {
      value.content = with_environment(text->get(), value.where, path);
    } else if (const auto* integer = node.as_integer()) {
      value.content = integer->get();
    } else if (const auto* real = node.as_floating_point()) {
      value.content = real->get();
    } else if (const auto* flag = node.as_boolean()) {
      value.content = flag->get();
    } else {
      value.content = SourceDate{};
    }
    return value;
  }

 private:
  [[nodiscard]] SourcePosition position(const toml::source_region& source) const {
    return {file_, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
  }

  [[nodiscard]] SourceTable convert_table(const toml::table& table, const std::string& path,
                                          int depth) const {
    SourceTable result;
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      const std::string below = path.empty() ? name : path + "." + name;
      result.members.push_back({name, position(key.source()), convert(node, below, depth + 1)});
    }
    return result;
  }

  [[nodiscard]] SourceArray convert_array(const toml::array& array, const std::string& path,
                                          int depth) const {
    SourceArray result;
    for (const toml::node& node : array)
      result.elements.push_back(
          convert(node, fmt::format("{}[{}]", path, result.elements.size()), depth + 1));
    return result;
  }

  [[nodiscard]] std::string with_environment(std::string text, const SourcePosition& where,
                                             const std::string& path) const {
    std::string result;
    for (std::size_t begin = text.find("${"); begin != std::string::npos; begin = text.find("${")) {
      const std::size_t end = text.find('}', begin);
      const std::string name = text.substr(begin + 2, std::min(end, text.size()) - begin - 2);
      const char* value = end == std::string::npos ? nullptr : std::getenv(name.c_str());
      if (value == nullptr) {
        faults_.push_back({where, path, fmt::format("${{{}}}", name),
                           "an environment variable that is set (it is not)", ""});
        return text;
      }
      result += text.substr(0, begin) + value;
      text.erase(0, end + 1);
    }
    return result + text;
  }

  std::string file_;
  FaultList& faults_;
};

/// Whether the bytes may be TOML, before its grammar is looked at.
bool is_text(std::string_view text, const std::string& name, FaultList& faults) {
  const auto refuse = [&](int line, const std::string& found, const std::string& expected) {
    faults.push_back({{name, line, line > 0 ? 1 : 0}, "", found, expected, ""});
    return false;
  };
  if (text.starts_with("\xEF\xBB\xBF")) return refuse(1, "a byte order mark", "UTF-8 text without one");
  if (text.find('\0') != std::string_view::npos)
    return refuse(0, "bytes that are no text (a binary or UTF-16 file)", "TOML in UTF-8");
  int line = 1;
  for (std::size_t begin = 0; begin <= text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > longest_line)
      return refuse(line, fmt::format("a line of {} bytes", end - begin),
                    fmt::format("at most {}; an array may go on over several lines", longest_line));
    begin = end + 1;
  }
  return true;
}

}  // namespace

SourceValue parse_toml(std::string_view text, const std::string& name, FaultList& faults) {
  const SourceValue nothing{whole(name), SourceTable{}};
  if (!is_text(text, name, faults)) return nothing;
  try {
    const toml::table table = toml::parse(text, std::string_view(name));
    return Converter(name, faults).convert(table, "", 0);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    faults.push_back({{name, static_cast<int>(at.line), static_cast<int>(at.column)},
                      "",
                      fmt::format("no valid TOML ({})", error.description()),
                      "TOML 1.0",
                      ""});
    return nothing;
  }
}

SourceValue read_toml(const std::filesystem::path& file, FaultList& faults) {
  const std::string name = file.string();
  const auto refuse = [&](std::string found, std::string expected) {
    faults.push_back({whole(name), "", std::move(found), std::move(expected), ""});
    return SourceValue{whole(name), SourceTable{}};
  };
  std::error_code trouble;
  const auto status = std::filesystem::status(file, trouble);
  if (!std::filesystem::exists(status)) return refuse("no such file", "a TOML file");
  if (std::filesystem::is_directory(status)) return refuse("a directory", "a TOML file");
  if (!std::filesystem::is_regular_file(status)) return refuse("a special file", "a TOML file");
  const std::uintmax_t size = std::filesystem::file_size(file, trouble);
  if (size > largest_file)
    return refuse(
        fmt::format("{} bytes", size),
        fmt::format("at most {} (long polylines go into the file named by fracture.file)", largest_file));
  if (size == 0) return refuse("an empty file", "a TOML file");
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return refuse("a file that cannot be read", "a TOML file open to this user");
  return parse_toml(text, name, faults);
}

void apply_override(SourceValue& document, const std::string& assignment, FaultList& faults) {
  const std::string name = "--set";
  const std::size_t equals = assignment.find('=');
  const std::string path = assignment.substr(0, equals);
  if (equals == std::string::npos) {
    faults.push_back({whole(name), path, "no value", "KEY.PATH=VALUE", ""});
    return;
  }
  const std::string text = assignment.substr(equals + 1);
  FaultList not_toml;
  SourceValue parsed = parse_toml("value = " + text, name, not_toml);
  SourceValue value{whole(name), text};
  const bool is_toml = not_toml.empty() && std::get<SourceTable>(parsed.content).members.size() == 1;
  if (is_toml) value.content = std::move(member_of(parsed, "value")->value.content);
  try {
    put(document, path, std::move(value));
  } catch (const InputError& error) {
    faults.push_back({whole(name), path, assignment, error.what(), ""});
  }
}

}  // namespace fissura::input
