# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The preset `demo` builds a tool that runs: the sources of a folder as one, without PCL and
# OpenCL. Here without the optimizer, which takes most of the time, and with shared
# libraries, which link only if no library needs what another hides.
execute_process(WORKING_DIRECTORY ${SOURCE_DIR} COMMAND ${CMAKE_COMMAND}
  --preset demo -B ${BUILD_DIR} -DBUILD_SHARED_LIBS=ON -DCMAKE_BUILD_TYPE=None
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD_DIR} -j 2 --target linelet_tool
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${BUILD_DIR}/bin/linelet info ${SOURCE_DIR}/data/corridor.las
  COMMAND_ERROR_IS_FATAL ANY)
