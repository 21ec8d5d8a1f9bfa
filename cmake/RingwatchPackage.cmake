# A Debian package of what is installed: scripts/package builds it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ringwatch)
set(CPACK_PACKAGE_VENDOR "The ringwatch authors")
# Who distributes the package names himself: cmake -DRINGWATCH_PACKAGE_CONTACT=…
set(RINGWATCH_PACKAGE_CONTACT "The ringwatch authors <ringwatch@example.org>" CACHE STRING "Maintainer of the Debian package")
mark_as_advanced(RINGWATCH_PACKAGE_CONTACT)
set(CPACK_PACKAGE_CONTACT "${RINGWATCH_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "stability monitor for explicit finite element runs")
set(CPACK_PACKAGE_DESCRIPTION "ringwatch says at every step of an explicit nonlinear finite element run how
large a step it can take, between two bounds that are proven, which element
stands in the way, and when the run has left safe ground. The package has the
programs, the C++ libraries with their headers, and the CMake package.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(RINGWATCH_PYTHON)
  # The module is for one minor version of Python.
  string(REGEX MATCH "python([0-9]+)\\.([0-9]+)" found "${RINGWATCH_PYTHON_DIR}")
  math(EXPR next "${CMAKE_MATCH_2} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "python3 (>= ${CMAKE_MATCH_1}.${CMAKE_MATCH_2}), python3 (<< ${CMAKE_MATCH_1}.${next}), python3-numpy")
endif()
# What those need who build against the libraries, gnuplot for the pictures of a run, and meshio for meshes of other programs.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, libeigen3-dev, libspectra-dev, python3-meshio, python3-h5py, python3-netcdf4")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libvtk9-dev, libsundials-dev, paraview")
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish.cmake)
set(CPACK_PROJECT_CONFIG_FILE "")
set(CPACK_RINGWATCH_SOURCE_DIR ${PROJECT_SOURCE_DIR})
include(CPack)
