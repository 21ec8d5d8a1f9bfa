# Installs the headers, the libraries and the package files for find_package(ringwatch).
include(CMakePackageConfigHelpers)
get_property(folders GLOBAL PROPERTY RINGWATCH_FOLDERS)
foreach(folder IN LISTS folders)
  install(TARGETS ringwatch_${folder} EXPORT ringwatchTargets)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ringwatch/${folder}
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(TARGETS ringwatch ringwatch_abi EXPORT ringwatchTargets)
install(EXPORT ringwatchTargets NAMESPACE ringwatch:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ringwatch)

# The packages that ringwatch_find_package found here are found again there.
get_property(packages GLOBAL PROPERTY RINGWATCH_PACKAGES)
if(RINGWATCH_WITH_VTK AND RINGWATCH_VTK_COMPONENTS)
  list(JOIN RINGWATCH_VTK_COMPONENTS " " components)
  list(APPEND packages "VTK 9.0 COMPONENTS ${components}")
endif()
set(RINGWATCH_DEPENDENCIES "")
foreach(package IN LISTS packages)
  string(APPEND RINGWATCH_DEPENDENCIES "find_dependency(${package})\n")
endforeach()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ringwatchConfig.cmake.in
  ${PROJECT_BINARY_DIR}/ringwatchConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ringwatch)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ringwatchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ringwatchConfig.cmake ${PROJECT_BINARY_DIR}/ringwatchConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ringwatch)
