# cmake -D WAY=find_package|component|add_subdirectory -D SOURCE=… -D BUILD=… -D WORK=… … -P run_consumer.cmake
# Installs the build tree into a folder of its own if need be, then configures, builds and runs an outside project.
file(REMOVE_RECURSE ${WORK})
set(configure ${CMAKE_COMMAND} -B ${WORK}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER})
set(tangents_project -S ${CMAKE_CURRENT_LIST_DIR}/outside_tangents -D PROGRAM=${SOURCE}/examples/embed_tangents.cpp)
if(WAY STREQUAL "add_subdirectory")
  list(APPEND configure ${tangents_project} -D COMPONENT=bounds -D OUTSIDE_RINGWATCH_SOURCE=${SOURCE} -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_CXX_FLAGS_DEBUG=-O0)
else()
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND configure -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_BUILD_TYPE=${BUILD_TYPE})
  if(WAY STREQUAL "component")
    list(APPEND configure ${tangents_project} -D COMPONENT=monitor)
  else()
    list(APPEND configure -S ${CMAKE_CURRENT_LIST_DIR}/outside)
  endif()
endif()
execute_process(COMMAND ${configure} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target outside COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/outside COMMAND_ERROR_IS_FATAL ANY)
