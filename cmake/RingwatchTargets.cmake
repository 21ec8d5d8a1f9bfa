# One target a folder. `ringwatch_folder(NAME SOURCES … LINKS … PRIVATE_LINKS …)` makes the library of the
# folder NAME (an interface library when it has no sources), its alias ringwatch::NAME, its include path and
# its install rule, so that a folder's CMakeLists.txt holds nothing but its own list.

# Headers are included as <ringwatch/FOLDER/file.h> here, in examples and after installation alike. In the
# build tree that path is a link to the source tree.
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/include)
file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/include/ringwatch SYMBOLIC)
set(RINGWATCH_INCLUDE_DIR ${CMAKE_CURRENT_BINARY_DIR}/include)

add_library(ringwatch_options INTERFACE)
target_compile_features(ringwatch_options INTERFACE cxx_std_20)
target_compile_options(ringwatch_options INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wno-psabi>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${RINGWATCH_WARNINGS_AS_ERRORS}>>:-Werror>)
# GCC 12 finds its own AVX-512 intrinsics uninitialised (GCC bug 105593) wherever Eigen uses them.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(ringwatch_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-uninitialized -Wno-maybe-uninitialized>)
endif()
# Instruction sets are set for every file alike: mixing them by file breaks the ABI. -ffp-contract=fast lets
# the compiler fuse a*b+c; -ffast-math stays off, since it voids NaN checks and proven bounds.
if(RINGWATCH_NATIVE)
  target_compile_options(ringwatch_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-march=native>)
endif()
target_compile_options(ringwatch_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=fast -fno-math-errno>)
if(RINGWATCH_SANITIZE)
  target_compile_options(ringwatch_options INTERFACE -fsanitize=${RINGWATCH_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(ringwatch_options INTERFACE -fsanitize=${RINGWATCH_SANITIZE})
endif()

function(ringwatch_folder name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(target ringwatch_${name})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${RINGWATCH_INCLUDE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_link_libraries(${target} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS} $<BUILD_INTERFACE:ringwatch_options>)
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE
      $<BUILD_INTERFACE:${RINGWATCH_INCLUDE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(${target} INTERFACE cxx_std_20)
    target_link_libraries(${target} INTERFACE ${ARG_LINKS})
  endif()
  add_library(ringwatch::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY RINGWATCH_FOLDERS ${name})
endfunction()
