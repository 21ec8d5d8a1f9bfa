# cmake -D PROGRAM=… -D FOLDER=… -D SLOW=pattern:pattern -D OUTPUT=… -P list_tests.cmake
# Writes the cases of a GoogleTest program for ctest, as FOLDER.Suite.Case with the labels FOLDER and fast or slow. CMake's
# own gtest_discover_tests cannot: it puts the C++ type into the names of typed tests, and its labels are one at a time.
function(write_cases filter speed)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${filter} OUTPUT_VARIABLE listed
    TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE " +#[^\n]*" "" listed "${listed}") # parameters, spelled out
  string(REPLACE "\n" ";" listed "${listed}")
  cmake_path(GET OUTPUT PARENT_PATH folder)
  foreach(line IN LISTS listed)
    if(line MATCHES "^  (.+)$")
      set(name "${suite}${CMAKE_MATCH_1}")
      string(APPEND text "add_test([=[${FOLDER}.${name}]=] ${PROGRAM} --gtest_filter=${name})\n"
        "set_tests_properties([=[${FOLDER}.${name}]=] PROPERTIES LABELS \"${FOLDER};${speed}\" WORKING_DIRECTORY ${folder}"
        " SKIP_REGULAR_EXPRESSION [=[\\[  SKIPPED \\]]=])\n")
    elseif(line MATCHES "^[A-Za-z_0-9/]+\\.$")
      set(suite ${line})
    endif()
  endforeach()
  file(APPEND ${OUTPUT} "${text}")
endfunction()

file(WRITE ${OUTPUT} "")
write_cases("-${SLOW}" fast)
if(SLOW)
  write_cases("${SLOW}" slow)
endif()
