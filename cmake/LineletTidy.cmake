# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# `tidy`: clang-tidy over all sources, on request. It takes several seconds per file, so no
# build and no test runs it. Needs clang-tidy and libomp-14-dev.
find_program(LINELET_RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
if(LINELET_RUN_CLANG_TIDY)
  # The compile commands omit the compiler's own default.
  add_custom_target(tidy
    COMMAND ${LINELET_RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR}
      -extra-arg=-std=c++17 "${PROJECT_SOURCE_DIR}/(src|apps|bench)/"
    USES_TERMINAL VERBATIM)
endif()
