# cmake -D PROGRAM=… -D FOLDER=… -D SLOW=pattern:pattern -D TOGETHER=Suite:Suite -D SHARDS=N -D OUTPUT=… -P list_tests.cmake
# Writes the cases of a GoogleTest program for ctest, as FOLDER.Suite.Case with the labels FOLDER and fast or slow. CMake's
# own gtest_discover_tests cannot: it puts the C++ type into the names of typed tests, and its labels are one at a time.
# A case that says so is skipped, and so is one whose program is built without VTK (meshes/formats/vtu_writer.cpp), however it ends.
# The cases of a test with parameters, of which there may be hundreds, are one test, FOLDER.Suite.Test: a process takes
# longer to start than most of them take. It is slow where a pattern selects any of them, and fails where any fails; some
# of its cases may skip themselves.
# Suites that make a costly result once for all their cases are TOGETHER: one slow test each, FOLDER.Suite.
# With N > 0 there are N tests of the fast cases instead, FOLDER.fast_K, and N of the slow ones, FOLDER.slow_K, of an N-th
# of them each: under a sanitizer a process takes longer to start than most cases take. GTEST_FILTER chooses other cases.
cmake_minimum_required(VERSION 3.25)
cmake_path(GET OUTPUT PARENT_PATH folder)
function(write_test name filter speed)
  # What skips itself must not hide that another case of the same test fails.
  set(skips "this build is without VTK")
  if(NOT filter MATCHES "\\*$")
    set(skips "\\[  SKIPPED \\];${skips}")
  endif()
  file(APPEND ${OUTPUT} "add_test([=[${FOLDER}.${name}]=] ${PROGRAM} --gtest_filter=${filter})\n"
    "set_tests_properties([=[${FOLDER}.${name}]=] PROPERTIES LABELS \"${FOLDER};${speed}\" WORKING_DIRECTORY ${folder}"
    " SKIP_REGULAR_EXPRESSION [=[${skips}]=])\n")
endfunction()

# Writes the cases that a pattern of GoogleTest selects; found: whether there are any. Patterns may overlap.
set(written "")
function(write_cases filter speed found)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${filter} OUTPUT_VARIABLE listed
    TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE " +#[^\n]*" "" listed "${listed}") # parameters, spelled out
  string(REPLACE "\n" ";" listed "${listed}")
  set(any FALSE)
  foreach(line IN LISTS listed)
    if(line MATCHES "^  (.+)$")
      set(any TRUE)
      set(name "${suite}.${CMAKE_MATCH_1}")
      set(selects "${name}")
      if(CMAKE_MATCH_1 MATCHES "^([^/]+)/")
        set(name "${suite}.${CMAKE_MATCH_1}")
        set(selects "${name}/*")
      endif()
      if(NOT suite IN_LIST TOGETHER AND NOT name IN_LIST written)
        write_test("${name}" "${selects}" ${speed})
        list(APPEND written "${name}")
      endif()
    elseif(line MATCHES "^([A-Za-z_0-9/]+)\\.$")
      set(suite ${CMAKE_MATCH_1})
    endif()
  endforeach()
  set(written "${written}" PARENT_SCOPE)
  set(${found} ${any} PARENT_SCOPE)
endfunction()

file(WRITE ${OUTPUT} "")
if(SHARDS GREATER 0)
  math(EXPR last "${SHARDS} - 1")
  foreach(speed IN ITEMS fast slow)
    set(filter "${SLOW}")
    if(speed STREQUAL fast)
      set(filter "-${SLOW}")
    endif()
    execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${filter} OUTPUT_VARIABLE listed
      TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
    if(filter STREQUAL "" OR NOT listed MATCHES "\n  ")
      continue()
    endif()
    foreach(shard RANGE ${last})
      set(name "[=[${FOLDER}.${speed}_${shard}]=]")
      file(APPEND ${OUTPUT}
        "add_test(${name} sh -c [=[exec \"${PROGRAM}\" --gtest_brief=1 --gtest_filter=\"\${GTEST_FILTER:-${filter}}\"]=])\n"
        "set_tests_properties(${name} PROPERTIES LABELS \"${FOLDER};${speed}\" WORKING_DIRECTORY ${folder}"
        " ENVIRONMENT \"GTEST_TOTAL_SHARDS=${SHARDS};GTEST_SHARD_INDEX=${shard}\")\n")
    endforeach()
  endforeach()
  return()
endif()
string(REPLACE ":" ";" TOGETHER "${TOGETHER}")
string(REPLACE ":" ";" patterns "${SLOW}")
foreach(pattern IN LISTS patterns)
  write_cases("${pattern}" slow found)
  if(NOT found)
    file(REMOVE ${OUTPUT})
    message(FATAL_ERROR "slow_${FOLDER} in tests/CMakeLists.txt: no case matches \"${pattern}\"")
  endif()
endforeach()
foreach(suite IN LISTS TOGETHER)
  write_cases("${suite}.*" slow found)
  if(NOT found)
    file(REMOVE ${OUTPUT})
    message(FATAL_ERROR "together_${FOLDER} in tests/CMakeLists.txt: there is no suite ${suite}")
  endif()
  write_test(${suite} "${suite}.*" slow)
endforeach()
write_cases("-${SLOW}" fast found)
