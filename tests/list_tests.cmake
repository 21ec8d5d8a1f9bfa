# cmake -D PROGRAM=… -D FOLDER=… -D SLOW=pattern:pattern -D TOGETHER=Suite:Suite -D OUTPUT=… -P list_tests.cmake
# Writes the cases of a GoogleTest program for ctest, as FOLDER.Suite.Case with the labels FOLDER and fast or slow. CMake's
# own gtest_discover_tests cannot: it puts the C++ type into the names of typed tests, and its labels are one at a time.
# Suites that make a costly result once for all their cases are TOGETHER: one slow test each, FOLDER.Suite.
cmake_minimum_required(VERSION 3.25)
cmake_path(GET OUTPUT PARENT_PATH folder)
function(write_test name filter speed)
  file(APPEND ${OUTPUT} "add_test([=[${FOLDER}.${name}]=] ${PROGRAM} --gtest_filter=${filter})\n"
    "set_tests_properties([=[${FOLDER}.${name}]=] PROPERTIES LABELS \"${FOLDER};${speed}\" WORKING_DIRECTORY ${folder}"
    " SKIP_REGULAR_EXPRESSION [=[\\[  SKIPPED \\]]=])\n")
endfunction()

function(write_cases filter speed)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${filter} OUTPUT_VARIABLE listed
    TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE " +#[^\n]*" "" listed "${listed}") # parameters, spelled out
  string(REPLACE "\n" ";" listed "${listed}")
  foreach(line IN LISTS listed)
    if(line MATCHES "^  (.+)$")
      if(NOT suite IN_LIST TOGETHER)
        write_test("${suite}.${CMAKE_MATCH_1}" "${suite}.${CMAKE_MATCH_1}" ${speed})
      endif()
    elseif(line MATCHES "^([A-Za-z_0-9/]+)\\.$")
      set(suite ${CMAKE_MATCH_1})
    endif()
  endforeach()
endfunction()

file(WRITE ${OUTPUT} "")
string(REPLACE ":" ";" TOGETHER "${TOGETHER}")
foreach(suite IN LISTS TOGETHER)
  write_test(${suite} "${suite}.*" slow)
endforeach()
write_cases("-${SLOW}" fast)
if(SLOW)
  write_cases("${SLOW}" slow)
endif()
