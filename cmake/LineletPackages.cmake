# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake --workflow --preset package: the tool (linelet), headers and libraries to link
# with (liblinelet-dev), and the shared libraries if they are built (liblinelet0.1).
set(CPACK_PACKAGE_NAME linelet)
set(CPACK_PACKAGE_VENDOR "the linelet authors")
set(CPACK_PACKAGE_CONTACT "the linelet authors <linelet@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Curves from raw 3D point clouds")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME linelet)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME liblinelet-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libhwy-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
  "libpcl-dev, liblzf-dev, libgdal-dev, libceres-dev, libhdf5-dev, ocl-icd-opencl-dev, liblz4-dev")
if(BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL libraries)
  set(version ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME liblinelet${version})
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
  set(exact "liblinelet${version} (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "${exact}")
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", ${exact}")
  # The tool's own libraries are not installed yet when its dependencies are determined.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)
endif()
foreach(component runtime development libraries)
  string(TOUPPER ${component} name)
  set(CPACK_COMPONENT_${name}_DESCRIPTION
    "Wires, edges and outlines of point clouds as polylines.")
endforeach()
include(CPack)
