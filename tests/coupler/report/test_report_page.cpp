// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "coupler/report/report_data.hpp"
#include "coupler/report/report_page.hpp"
#include "tests/coupler/record/sample_run.hpp"
#include "tests/coupler/report/small_run.hpp"

using namespace fissura::coupler;

namespace {

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  REQUIRE(from != std::string::npos);
  return text.substr(from + begin.size(), text.find(end, from + begin.size()) - from - begin.size());
}

}  // namespace

TEST_CASE("the data of the page come back as the JSON they were", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::reference);
  const nlohmann::json data = report_data(folder.path() / "run");
  const std::string page = report_page(data);
  const std::string block = between(page, "<script type=\"application/json\" id=\"data\">", "</script>");
  CHECK(nlohmann::json::parse(block) == nlohmann::json::parse(data.dump()));
}

TEST_CASE("a title cannot end an element of the page", "[coupler][report]") {
  nlohmann::json data{{"run", {{"title", "</title></script><!-- & x"}}}};
  const std::string page = report_page(data);
  CHECK(between(page, "<title>", "</title>") == "&lt;/title>&lt;/script>&lt;!-- &amp; x");
  const std::string block = between(page, "id=\"data\">", "</script>");
  CHECK(block.find("<!--") == std::string::npos);
  CHECK(nlohmann::json::parse(block) == data);
}

TEST_CASE("the page holds the whole charting library and asks nobody for anything", "[coupler][report]") {
  std::string page = report_page({{"run", {{"title", "t"}}}});
  const std::string library = sample::content(CHART_LIBRARY);
  const std::size_t at = page.find(library);
  REQUIRE(at != std::string::npos);
  page.erase(at, library.size());
  for (const char* outside : {"src=", "http:", "https:", "@import", "url(", "fetch(", "{{"}) {
    INFO(outside);
    CHECK(page.find(outside) == std::string::npos);
  }
}
