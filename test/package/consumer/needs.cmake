# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fails if PROGRAM is linked with GDAL, PCL or Ceres.
execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE libraries RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "ldd ${PROGRAM} failed")
endif()
if(libraries MATCHES "(libgdal|libpcl_|libceres)[^ ]*")
  message(FATAL_ERROR "${PROGRAM} is linked with ${CMAKE_MATCH_0}")
endif()
