// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

#include <linelet/io/point_file.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief The header of a point file. */
struct FileSummary {
  std::string path, format;
  std::size_t points = 0;
  Point low = Point::Zero(), high = Point::Zero(); ///< world coordinates
  std::string wkt;                                 ///< reference system, empty: unknown
};

/** \brief Reads the header of a LAS or LAZ file, or the whole of any other file.
 * \throws FileError */
FileSummary
summaryOf(const std::string& path,
          const ReadOptions& options = {},
          std::vector<std::string>* warnings = nullptr);

} // namespace io
} // namespace linelet
