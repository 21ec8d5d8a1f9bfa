# One library a folder. `ringwatch_folder(NAME SOURCES … LINKS … PRIVATE_LINKS …)` makes the library of the folder NAME, its
# alias ringwatch::NAME, its include path and its install rule; ringwatch_sources finds its files, so that a folder's
# CMakeLists.txt says only what it links.

# Headers are included as <ringwatch/FOLDER/file.h> here, in examples and after installation alike. In the
# build tree that path is a link to the source tree.
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/include)
file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/include/ringwatch SYMBOLIC)
set(RINGWATCH_INCLUDE_DIR ${CMAKE_CURRENT_BINARY_DIR}/include)

# Files that are compiled together see each other's names, which a local name may hide, and GCC takes them for headers, in which a
# type of an anonymous namespace would be an error.
set(names -Wshadow)
if(RINGWATCH_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(names -Wshadow=local -Wno-subobject-linkage)
endif()
add_library(ringwatch_options INTERFACE)
target_compile_features(ringwatch_options INTERFACE cxx_std_20)
target_compile_options(ringwatch_options INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic ${names} -Wno-psabi>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${RINGWATCH_WARNINGS_AS_ERRORS}>>:-Werror>)
# GCC 12 finds its own AVX-512 intrinsics uninitialised (GCC bug 105593) wherever Eigen uses them, and strings that
# overlap themselves (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(ringwatch_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-uninitialized -Wno-maybe-uninitialized -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
endif()
# GCC collects its garbage, a tenth of its time, as soon as it has 128 MiB of it on any machine; most files here make less than this.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(ringwatch_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=524288>)  # KiB
endif()

# What all code that ends up in one program must agree on. The instruction set decides how Eigen aligns and allocates and
# how wide a pack is, so a program that mixes two of them breaks; the same goes for sanitizers. Of templates the linker keeps
# one instance, whoever compiled it: -ffp-contract=fast, which lets the compiler fuse a*b+c, would else give other bits
# (base/math.h refuses -ffast-math). So these flags are for every file alike, and the installed package hands them on to what links it.
add_library(ringwatch_abi INTERFACE)
add_library(ringwatch::abi ALIAS ringwatch_abi)
set_target_properties(ringwatch_abi PROPERTIES EXPORT_NAME abi)
target_compile_options(ringwatch_abi INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=fast -fno-math-errno>)
if(RINGWATCH_NATIVE)
  target_compile_options(ringwatch_abi INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-march=native>)
endif()
if(RINGWATCH_SANITIZE)
  target_compile_options(ringwatch_abi INTERFACE
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<BOOL:$<TARGET_PROPERTY:RINGWATCH_UNSANITIZED>>>>:-fsanitize=${RINGWATCH_SANITIZE}>
    $<$<COMPILE_LANGUAGE:CXX>:-fno-omit-frame-pointer>)
  target_link_options(ringwatch_abi INTERFACE -fsanitize=${RINGWATCH_SANITIZE})
endif()

# ringwatch_find_package(COMPONENT NAME [VERSION] …): find_package for every folder of this tree, and for a project that finds the
# installed ringwatch with that component; COMPONENT `core` is for all. What is only linked by programs and tests does not
# belong here.
macro(ringwatch_find_package component)
  find_package(${ARGN} REQUIRED GLOBAL)
  string(REPLACE ";" " " ringwatch_package "${ARGN}")
  set_property(GLOBAL APPEND PROPERTY RINGWATCH_PACKAGES_${component} "${ringwatch_package}")
endmacro()

# For scripts/check_headers: every header of a folder alone, with nothing but what its folder links, its library, or what is named.
function(ringwatch_check_headers name)
  ringwatch_sources(headers ENDING .h)
  set(sources "")
  foreach(header IN LISTS headers)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/${header}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <ringwatch/${name}/${header}>\n")
    list(APPEND sources ${source})
  endforeach()
  if(sources)
    add_library(ringwatch_${name}_headers OBJECT EXCLUDE_FROM_ALL ${sources})
    set(links ${ARGN})
    if(NOT links)
      set(links ringwatch_${name})
    endif()
    target_link_libraries(ringwatch_${name}_headers PRIVATE ${links} ringwatch_options)
    target_compile_options(ringwatch_${name}_headers PRIVATE -O0 -g0)
  endif()
endfunction()

# ringwatch_sources(FILES [EXCEPT …] [ENDING …]): the sources of this folder and of its subfolders
# without a CMakeLists.txt: files that end in .cpp or in what is given, less those of EXCEPT, in the list FILES. A new file
# is found by the next build: no list names it.
function(ringwatch_sources files)
  cmake_parse_arguments(ARG "" "" "EXCEPT;ENDING" ${ARGN})
  if(NOT ARG_ENDING)
    set(ARG_ENDING .cpp)
  endif()
  list(TRANSFORM ARG_ENDING PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/*")
  file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${ARG_ENDING})
  file(GLOB lists CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/*/CMakeLists.txt)
  foreach(list IN LISTS lists)
    get_filename_component(other ${list} DIRECTORY)
    list(FILTER found EXCLUDE REGEX "^${other}/")
  endforeach()
  foreach(file IN LISTS ARG_EXCEPT)
    if(NOT file IN_LIST found)
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR} has no ${file}")
    endif()
  endforeach()
  if(ARG_EXCEPT)
    list(REMOVE_ITEM found ${ARG_EXCEPT})
  endif()
  set(${files} ${found} PARENT_SCOPE)
endfunction()

# ringwatch_law_files(FILES TEMPLATE): configures TEMPLATE, a .in file, once for each shard of the laws (lawShards of
# materials/registry.h) and appends the results to the list FILES. @SHARD@ is the shard's number.
set(RINGWATCH_LAW_SHARDS 8)
function(ringwatch_law_files files template)
  math(EXPR last "${RINGWATCH_LAW_SHARDS} - 1")
  foreach(SHARD RANGE ${last})
    string(REGEX REPLACE "\\.([a-z]+)\\.in$" "_${SHARD}.\\1" name ${template})
    if(RINGWATCH_SCALAR)
      string(REPLACE "_${SHARD}." "_${SHARD}_${RINGWATCH_SCALAR}." name ${name})
    endif()
    configure_file(${template} ${CMAKE_CURRENT_BINARY_DIR}/${name} @ONLY)
    list(APPEND ${files} ${CMAKE_CURRENT_BINARY_DIR}/${name})
  endforeach()
  set(${files} ${${files}} PARENT_SCOPE)
endfunction()

# ringwatch_unity(TARGET [FILES]): compiles so many files of TARGET at a time, 5 unless given, where RINGWATCH_UNITY says so. Most of the time that a file of a
# few hundred lines takes goes into templates of the standard library and of Eigen, which its neighbours need too: eight files of
# app/run take 32 processor-seconds one by one and 11 together. Files that take as long as several others are compiled alone:
# ringwatch_compile_alone(FILES …), in the folder of the target. So are kernels, ringwatch_kernels(FILES …), where their speed
# counts: GCC inlines less where a function has more callers, and reduced 1-rings took 1.5 times as long.
function(ringwatch_unity target)
  set(files 5 ${ARGN})
  list(GET files -1 files)
  if(RINGWATCH_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${files})
  endif()
endfunction()

function(ringwatch_compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

function(ringwatch_kernels)
  if(NOT RINGWATCH_SANITIZE AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    ringwatch_compile_alone(${ARGN})
  endif()
endfunction()

function(ringwatch_light target)
  target_compile_options(${target} PRIVATE -O1)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  if(TARGET ringwatch_precompiled_light)
    ringwatch_use_precompiled(${target} ringwatch_precompiled_light)
    # GCC takes precompiled headers only where their macros are defined.
    target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:ringwatch_precompiled_light,COMPILE_DEFINITIONS>)
  endif()
endfunction()

# ringwatch_library(NAME [LIGHT] SOURCES … LINKS … PRIVATE_LINKS …): the library ringwatch::NAME, a component of the
# installed package; an interface library when it has no sources. LIGHT ones are compiled with -O1: they spend their time in the
# libraries below them.
function(ringwatch_library name)
  cmake_parse_arguments(ARG "LIGHT" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(target ringwatch_${name})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    set(public PUBLIC)
    target_link_libraries(${target} PRIVATE ${ARG_PRIVATE_LINKS} $<BUILD_INTERFACE:ringwatch_options>)
    if(ARG_LIGHT)
      ringwatch_light(${target})
    else()
      ringwatch_use_precompiled(${target} ringwatch_precompiled)
    endif()
    ringwatch_unity(${target})
  else()
    add_library(${target} INTERFACE)
    set(public INTERFACE)
  endif()
  target_include_directories(${target} ${public}
    $<BUILD_INTERFACE:${RINGWATCH_INCLUDE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${public} cxx_std_20)
  target_link_libraries(${target} ${public} ringwatch_abi ${ARG_LINKS})
  add_library(ringwatch::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY RINGWATCH_LIBRARIES ${name})
endfunction()

# ringwatch_headers(NAME): installs and checks the headers of the folder NAME.
function(ringwatch_headers name)
  set_property(GLOBAL APPEND PROPERTY RINGWATCH_FOLDERS ${name})
  if(RINGWATCH_BUILD_TESTS)
    ringwatch_check_headers(${name})
  endif()
endfunction()

# ringwatch_folder(NAME …): ringwatch_library for the folder NAME, with its headers.
function(ringwatch_folder name)
  ringwatch_library(${name} ${ARGN})
  ringwatch_headers(${name})
endfunction()
