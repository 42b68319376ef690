// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/report_page.hpp"

#include "common/errors.hpp"
#include "coupler/report/page_files.hpp"

namespace fissura::coupler {

namespace {

void replace_all(std::string& text, std::string_view old, std::string_view replacement) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + replacement.size()))
    text.replace(at, old.size(), replacement);
}

std::string in_markup(std::string text) {
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  return text;
}

/// JSON that cannot end the script element it stands in.
std::string in_script(const nlohmann::json& data) {
  std::string text = data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  replace_all(text, "</", "<\\/");
  replace_all(text, "<!--", "<\\u0021--");
  return text;
}

void fill(std::string& page, std::string_view place, std::string_view content) {
  const std::size_t at = page.find(place);
  ENSURE(at != std::string::npos);
  page.replace(at, place.size(), content);
}

}  // namespace

std::string report_page(const nlohmann::json& data) {
  std::string page(page_files::page_html), scripts;
  for (const std::string_view script : page_files::scripts) scripts += std::string(script) + "\n";
  // From the end to the beginning, so that no filled-in text is searched for a place.
  fill(page, "{{scripts}}", scripts);
  fill(page, "{{data}}", in_script(data));
  fill(page, "{{library}}", page_files::chart_library);
  fill(page, "{{style}}", page_files::page_css);
  fill(page, "{{title}}", in_markup(data.at("run").value("title", "Fissura")));
  return page;
}

}  // namespace fissura::coupler
