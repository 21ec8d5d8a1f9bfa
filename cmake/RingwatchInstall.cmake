# Installs the headers, the libraries and the package files for find_package(ringwatch [COMPONENTS …]).
include(CMakePackageConfigHelpers)
get_property(folders GLOBAL PROPERTY RINGWATCH_FOLDERS)
foreach(folder IN LISTS folders)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ringwatch/${folder}
    FILES_MATCHING PATTERN "*.h")
endforeach()
get_property(libraries GLOBAL PROPERTY RINGWATCH_LIBRARIES)
foreach(library IN LISTS libraries)
  install(TARGETS ringwatch_${library} EXPORT ringwatchTargets)
endforeach()
install(TARGETS ringwatch ringwatch_abi EXPORT ringwatchTargets)
install(EXPORT ringwatchTargets NAMESPACE ringwatch:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ringwatch)

# The packages that ringwatch_find_package found for a component are found again for who asks for that component.
set(RINGWATCH_DEPENDENCIES "")
foreach(component core ${libraries})
  get_property(packages GLOBAL PROPERTY RINGWATCH_PACKAGES_${component})
  set(finds "")
  foreach(package IN LISTS packages)
    string(APPEND finds "  find_dependency(${package})\n")
  endforeach()
  if(finds)
    string(APPEND RINGWATCH_DEPENDENCIES "if(ringwatch_needs_${component})\n${finds}endif()\n")
  endif()
endforeach()
# What each component brings with it.
set(RINGWATCH_NEEDS "")
foreach(library IN LISTS libraries)
  list(JOIN ringwatch_needs_${library} " " needs)
  string(APPEND RINGWATCH_NEEDS "set(ringwatch_of_${library} ${needs})\n")
endforeach()
list(JOIN libraries " " RINGWATCH_LIBRARIES)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ringwatchConfig.cmake.in
  ${PROJECT_BINARY_DIR}/ringwatchConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ringwatch)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ringwatchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ringwatchConfig.cmake ${PROJECT_BINARY_DIR}/ringwatchConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ringwatch)
