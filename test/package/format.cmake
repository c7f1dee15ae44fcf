# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The sources are formatted by clang-format 14. Other versions differ in places, so the
# test is skipped with them.
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version)
if(NOT version MATCHES "version 14\\.")
  message(STATUS "SKIPPED: needs clang-format 14, not ${version}")
  return()
endif()
set(files)
foreach(folder include src apps test bench)
  file(GLOB_RECURSE found ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.hpp
    ${SOURCE_DIR}/${folder}/*.cpp)
  list(APPEND files ${found})
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files}
  RESULT_VARIABLE result ERROR_VARIABLE complaints)
if(result)
  message(FATAL_ERROR "run clang-format -i on these:\n${complaints}")
endif()
