# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
include(GNUInstallDirs)

# Compiler settings of our own targets only: consumers see the language level, no more.
function(linelet_settings target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion
    $<$<BOOL:${LINELET_WERROR}>:-Werror>)
endfunction()

# linelet_library(NAME SOURCES a.cpp ... [DEPENDS targets of the public headers] [PRIVATE
# targets of the sources alone])
#
# A library linelet::NAME.
function(linelet_library name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  set(target linelet_${name})
  add_library(${target} ${ROOM_SOURCES})
  add_library(linelet::${name} ALIAS ${target})
  linelet_settings(${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PUBLIC ${ROOM_DEPENDS} PRIVATE ${ROOM_PRIVATE})
  if(LINELET_WITH_OPENMP)
    target_link_libraries(${target} PUBLIC OpenMP::OpenMP_CXX)
  endif()
endfunction()

# linelet_room(NAME SOURCES ... [DEPENDS ...] [PRIVATE ...] [EXPORT set])
#
# A library that is installed: a folder of include/linelet and src.
function(linelet_room name)
  cmake_parse_arguments(ROOM "" "EXPORT" "" ${ARGN})
  if(NOT ROOM_EXPORT)
    set(ROOM_EXPORT linelet)
  endif()
  linelet_library(${name} ${ROOM_UNPARSED_ARGUMENTS})
  install(TARGETS linelet_${name} EXPORT ${ROOM_EXPORT}Targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()

# linelet_test(NAME SOURCES a.cpp ... LINK linelet::room ...)
#
# A test program. It finds the reference data in LINELET_TEST_DATA (environment, or the
# folder ../shared/data beside the project) through test/test_data.h.
function(linelet_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  set(target test_${name})
  add_executable(${target} ${TEST_SOURCES})
  linelet_settings(${target})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(${target} PRIVATE
    LINELET_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    LINELET_TEST_DATA_DIR="${PROJECT_SOURCE_DIR}/../shared/data")
  target_link_libraries(${target} PRIVATE ${TEST_LINK} GTest::gtest GTest::gtest_main)
  include(GoogleTest)
  # A program is asked for its tests' names when it is first read from disk; beside a full
  # machine that takes longer than the 5 s that CMake grants.
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 300
    TEST_PREFIX ${name}. PROPERTIES TIMEOUT ${TEST_TIMEOUT})
endfunction()
