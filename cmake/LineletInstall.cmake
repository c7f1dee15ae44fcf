# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# find_package(linelet CONFIG) and its components: the core always; io, powerline and
# opencl where they were built.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(LINELET_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/linelet)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/linelet
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT lineletTargets NAMESPACE linelet:: DESTINATION ${LINELET_CONFIG_DIR})
set(LINELET_HAS_IO OFF)
if(TARGET linelet_io)
  set(LINELET_HAS_IO ON)
  install(EXPORT linelet_ioTargets NAMESPACE linelet:: DESTINATION ${LINELET_CONFIG_DIR})
endif()
set(LINELET_HAS_OPENCL OFF)
if(TARGET linelet_opencl)
  set(LINELET_HAS_OPENCL ON)
  install(EXPORT linelet_openclTargets NAMESPACE linelet::
    DESTINATION ${LINELET_CONFIG_DIR})
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lineletConfig.cmake.in
  ${PROJECT_BINARY_DIR}/lineletConfig.cmake INSTALL_DESTINATION ${LINELET_CONFIG_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lineletConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lineletConfig.cmake
  ${PROJECT_BINARY_DIR}/lineletConfigVersion.cmake DESTINATION ${LINELET_CONFIG_DIR})
