# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# find_package(linelet CONFIG) with one component per module, and a pkg-config file for
# each.
include(CMakePackageConfigHelpers)

set(LINELET_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/linelet)
set(LINELET_STATIC ON)
if(BUILD_SHARED_LIBS)
  set(LINELET_STATIC OFF)
endif()

# linelet_component(NAME DESCRIPTION [LIBS name ...] [REQUIRES pkg ...]
# [PRIVATE_REQUIRES pkg ...] [PRIVATE_LIBS -lx ...])
#
# A component's pkg-config file and targets. Programs link the private libraries only if
# linelet is static.
set(LINELET_COMPONENTS)
function(linelet_component name description)
  cmake_parse_arguments(PC "" "" "LIBS;REQUIRES;PRIVATE_REQUIRES;PRIVATE_LIBS" ${ARGN})
  set(PC_NAME linelet-${name})
  set(PC_DESCRIPTION ${description})
  set(PC_LINK)
  foreach(lib IN LISTS PC_LIBS)
    string(APPEND PC_LINK " -llinelet_${lib}")
  endforeach()
  if(name STREQUAL "core" AND LINELET_WITH_OPENMP)
    string(APPEND PC_LINK " ${OpenMP_CXX_FLAGS}")
    set(PC_CFLAGS " ${OpenMP_CXX_FLAGS}")
  endif()
  if(LINELET_STATIC)
    list(APPEND PC_REQUIRES ${PC_PRIVATE_REQUIRES})
    foreach(lib IN LISTS PC_PRIVATE_LIBS)
      string(APPEND PC_LINK " ${lib}")
    endforeach()
  endif()
  # Relative to the file, so that the installation is relocatable.
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" up "${up}")
  set(PC_PREFIX "\${pcfiledir}/${up}")
  list(JOIN PC_REQUIRES ", " PC_REQUIRES)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/linelet.pc.in
    ${PROJECT_BINARY_DIR}/linelet-${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/linelet-${name}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
  install(EXPORT linelet_${name}Targets NAMESPACE linelet::
    DESTINATION ${LINELET_CONFIG_DIR} COMPONENT development)
  set(LINELET_COMPONENTS ${LINELET_COMPONENTS} ${name} PARENT_SCOPE)
endfunction()

linelet_component(core "Shapes and curves of point clouds"
  LIBS core REQUIRES eigen3 PRIVATE_REQUIRES libhwy)
if(TARGET linelet_pcl)
  linelet_component(pcl "linelet's PCL classes"
    LIBS pcl REQUIRES linelet-core pcl_common pcl_kdtree pcl_octree pcl_search)
endif()
if(TARGET linelet_io)
  if(LINELET_HDF5_FOUND)
    set(io_private hdf5-serial zlib)
  endif()
  linelet_component(io "Point files"
    LIBS io REQUIRES linelet-core PRIVATE_REQUIRES liblzf ${io_private})
  linelet_component(fragments "Clouds larger than memory, in fragments"
    LIBS fragments REQUIRES linelet-io)
  linelet_component(vector "Vector files and reference systems"
    LIBS vector REQUIRES linelet-io PRIVATE_REQUIRES gdal)
  linelet_component(powerline "Power lines of point clouds"
    LIBS powerline_output powerline REQUIRES linelet-vector
    PRIVATE_LIBS -lceres -lglog)
endif()
if(TARGET linelet_opencl)
  linelet_component(opencl "linelet's tensors on OpenCL devices"
    LIBS opencl REQUIRES linelet-pcl PRIVATE_REQUIRES OpenCL)
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/linelet
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lineletConfig.cmake.in
  ${PROJECT_BINARY_DIR}/lineletConfig.cmake INSTALL_DESTINATION ${LINELET_CONFIG_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lineletConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lineletConfig.cmake
  ${PROJECT_BINARY_DIR}/lineletConfigVersion.cmake DESTINATION ${LINELET_CONFIG_DIR}
  COMPONENT development)
