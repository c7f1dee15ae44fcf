# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
include(GNUInstallDirs)

# Compiler settings for our own targets only: consumers see nothing but the language
# level.
function(linelet_settings target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion
    $<$<BOOL:${LINELET_WERROR}>:-Werror>)
  set_property(GLOBAL APPEND PROPERTY LINELET_TARGETS ${target})
endfunction()

# linelet_library(NAME [STATIC] [SOURCES a.cpp ...] [DEPENDS targets of the public headers]
# [PRIVATE targets of the sources alone])
#
# A library linelet::NAME.
function(linelet_library name)
  cmake_parse_arguments(ARG "STATIC" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  set(target linelet_${name})
  if(ARG_STATIC)
    add_library(${target} STATIC ${ARG_SOURCES})
  else()
    add_library(${target} ${ARG_SOURCES})
  endif()
  add_library(linelet::${name} ALIAS ${target})
  linelet_settings(${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} DEFINE_SYMBOL ""
    VERSION ${PROJECT_VERSION}
    INSTALL_RPATH "$ORIGIN" # the others are in the same folder
    # Before 1.0 every minor version may change the interface.
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE})
  if(LINELET_WITH_OPENMP)
    target_link_libraries(${target} PUBLIC OpenMP::OpenMP_CXX)
  endif()
  if(BUILD_SHARED_LIBS AND NOT ARG_STATIC AND NOT APPLE)
    target_link_options(${target} PRIVATE LINKER:--no-undefined)
  endif()
endfunction()

# linelet_module(NAME [COMPONENT name] SOURCES ... [DEPENDS ...] [PRIVATE ...])
#
# An installed library, with the component of find_package that it belongs to:
# by default its own.
function(linelet_module name)
  cmake_parse_arguments(ARG "" "COMPONENT" "" ${ARGN})
  if(NOT ARG_COMPONENT)
    set(ARG_COMPONENT ${name})
  endif()
  linelet_library(${name} ${ARG_UNPARSED_ARGUMENTS})
  set_property(GLOBAL APPEND PROPERTY LINELET_MODULES linelet_${name})
  linelet_install_library(linelet_${name} ${ARG_COMPONENT})
endfunction()

function(linelet_install_library target component)
  install(TARGETS ${target} EXPORT linelet_${component}Targets
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries
    NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endfunction()

# linelet_part(NAME SOURCES a.cpp ... [DEPENDS ...] [PRIVATE ...])
#
# A folder of linelet::core; linelet::NAME is an alias of it in this build.
function(linelet_part name)
  cmake_parse_arguments(PART "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  target_sources(linelet_core PRIVATE ${PART_SOURCES})
  target_link_libraries(linelet_core PUBLIC ${PART_DEPENDS} PRIVATE ${PART_PRIVATE})
  add_library(linelet::${name} ALIAS linelet_core)
endfunction()

# linelet_test(NAME SOURCES a.cpp ... LINK linelet::module ... [INSIDE] [TOGETHER])
#
# A test program. It finds the reference data in LINELET_TEST_DATA (environment, or the
# folder ../shared/data beside the project) through test/test_data.h. With INSIDE it
# uses symbols that shared libraries hide, so it is left out of shared builds. With TOGETHER
# its tests run in one process and share what they compute.
function(linelet_test name)
  cmake_parse_arguments(TEST "INSIDE;TOGETHER" "TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(TEST_INSIDE AND BUILD_SHARED_LIBS)
    return()
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  set(target test_${name})
  add_executable(${target} ${TEST_SOURCES})
  linelet_settings(${target})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  if(TEST_INSIDE)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  endif()
  target_compile_definitions(${target} PRIVATE
    LINELET_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    LINELET_TEST_DATA_DIR="${PROJECT_SOURCE_DIR}/../shared/data")
  target_link_libraries(${target} PRIVATE ${TEST_LINK} GTest::gtest GTest::gtest_main)
  if(TEST_TOGETHER)
    add_test(NAME ${name}.all COMMAND ${target})
    set_tests_properties(${name}.all PROPERTIES TIMEOUT ${TEST_TIMEOUT})
    return()
  endif()
  include(GoogleTest)
  # Test names are listed when a program is first read from disk; on a busy machine that
  # takes longer than CMake's default of 5 s.
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 300
    TEST_PREFIX ${name}. PROPERTIES TIMEOUT ${TEST_TIMEOUT})
endfunction()
