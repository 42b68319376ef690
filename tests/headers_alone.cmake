# cmake -D ROOT=... -D COMPILER=... -D LIST_FILE=... -P headers_alone.cmake : each header compiles by itself. One that its own source includes
# first has been shown to by the build; the others are compiled here.
file(GLOB_RECURSE headers RELATIVE "${ROOT}" "${ROOT}/common/*.hpp" "${ROOT}/structure/*.hpp" "${ROOT}/network/*.hpp"
     "${ROOT}/coupler/*.hpp")
list(LENGTH headers count)
if(count LESS 50)
  message(FATAL_ERROR "only ${count} headers found below ${ROOT}")
endif()
set(alone "")
foreach(header IN LISTS headers)
  string(REGEX REPLACE "\\.hpp$" ".cpp" source "${ROOT}/${header}")
  set(first "")
  if(EXISTS "${source}")
    file(STRINGS "${source}" first REGEX "^#include" LIMIT_COUNT 1)
  endif()
  if(NOT first STREQUAL "#include \"${header}\"")
    list(APPEND alone "${header}")
  endif()
endforeach()
string(REPLACE ";" "\n" lines "${alone}")
file(WRITE "${LIST_FILE}" "${lines}\n")
execute_process(
  COMMAND xargs -P 2 -I HEADER -a "${LIST_FILE}"
          ${COMPILER} -std=c++20 -fsyntax-only -DFISSURA_VERSION="" -I "${ROOT}" -include HEADER -x c++ /dev/null
  WORKING_DIRECTORY "${ROOT}" RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result)
  message(FATAL_ERROR "headers that do not compile alone:\n${errors}")
endif()
