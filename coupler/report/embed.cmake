# cmake -D OUTPUT=page_files.cpp -D PAGE=folder -D LIBRARY=chart.min.js -D SCRIPTS=a.js;b.js -P embed.cmake : the files of the report as
# string literals. The delimiter of the literals does not occur in any of them.
set(delimiter "page_of_report")

function(literal file variable)
  file(READ "${file}" text)
  string(FIND "${text}" ")${delimiter}\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${file} holds the delimiter of the literals")
  endif()
  set(${variable} "R\"${delimiter}(${text})${delimiter}\"" PARENT_SCOPE)
endfunction()

literal("${PAGE}/page.html" html)
literal("${PAGE}/page.css" css)
literal("${LIBRARY}" library)
set(scripts "")
foreach(file ${SCRIPTS})
  literal("${file}" script)
  string(APPEND scripts "    ${script},\n")
endforeach()

file(WRITE "${OUTPUT}" "#include \"coupler/report/page_files.hpp\"

namespace fissura::coupler::page_files {

const std::string_view page_html = ${html};
const std::string_view page_css = ${css};
const std::string_view chart_library = ${library};
namespace {

constexpr std::string_view script_texts[]{
${scripts}};

}  // namespace

const std::span<const std::string_view> scripts(script_texts);

}  // namespace fissura::coupler::page_files
")
