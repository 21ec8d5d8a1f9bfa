# Precompiled headers: what nearly every file includes is parsed once for the libraries, once for what is compiled with -O1 and
# once for the tests. Every file still includes what it uses: scripts/check_headers and -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON build
# without them.
#
# ringwatch_precompile(NAME LINKS … HEADERS …) makes a set of headers; ringwatch_use_precompiled(TARGET NAME) lets a
# target use it. All targets of a set are compiled alike: GCC takes a set only for the options that it was made with, and of the
# optimisation it takes, in silence, what the set was made with.
function(ringwatch_precompile name)
  cmake_parse_arguments(ARG "PIC" "" "LINKS;HEADERS;OPTIONS" ${ARGN})
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "// Holds the precompiled headers ${name}.\n")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ${ARG_PIC})
  target_include_directories(${name} PRIVATE ${RINGWATCH_INCLUDE_DIR})
  target_link_libraries(${name} PRIVATE ringwatch_abi ringwatch_options ${ARG_LINKS})
  target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
  list(TRANSFORM ARG_HEADERS REPLACE "(.+)" "$<$<COMPILE_LANGUAGE:CXX>:<\\1$<ANGLE-R>>")
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

function(ringwatch_use_precompiled target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

set(RINGWATCH_COMMON_HEADERS algorithm array cmath cstdint functional limits map memory optional span string string_view
  variant vector ringwatch/base/eigen_instances.h Eigen/Geometry Eigen/LU)
