# cmake -D ROOT=... -D COMPILER=... -D FLAGS=... -P headers_alone.cmake : each header compiles by itself.
file(GLOB_RECURSE headers RELATIVE "${ROOT}" "${ROOT}/common/*.hpp" "${ROOT}/structure/*.hpp" "${ROOT}/network/*.hpp"
     "${ROOT}/coupler/*.hpp")
list(LENGTH headers count)
if(count LESS 50)
  message(FATAL_ERROR "only ${count} headers found below ${ROOT}")
endif()
string(REPLACE ";" "\n" lines "${headers}")
file(WRITE "${LIST_FILE}" "${lines}\n")
execute_process(
  COMMAND xargs -P 2 -I HEADER -a "${LIST_FILE}"
          ${COMPILER} -std=c++20 -fsyntax-only -DFISSURA_VERSION="" -I "${ROOT}" -include HEADER -x c++ /dev/null
  WORKING_DIRECTORY "${ROOT}" RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result)
  message(FATAL_ERROR "headers that do not compile alone:\n${errors}")
endif()
