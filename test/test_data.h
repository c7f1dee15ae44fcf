// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace linelet::test {

/** \brief Path of a file or folder of the reference data, which lies outside the
 * project (LINELET_TEST_DATA, otherwise ../shared/data); it may be absent, see \ref
 * LINELET_NEEDS_DATA. */
inline std::filesystem::path
dataPath(const std::string& relative)
{
  const char* folder = std::getenv("LINELET_TEST_DATA");
  return std::filesystem::path(folder != nullptr ? folder : LINELET_TEST_DATA_DIR) /
         relative;
}

} // namespace linelet::test

/** \brief Skips the test, with a message, if the reference data \a relative are
 * absent. */
#define LINELET_NEEDS_DATA(relative)                                                   \
  if (!std::filesystem::exists(linelet::test::dataPath(relative)))                     \
  GTEST_SKIP() << "no reference data at " << linelet::test::dataPath(relative)
