// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief How to read a point file. */
struct ReadOptions {
  bool lenient = false; ///< read the complete part of a truncated file
  /// Only points in X0,Y0,X1,Y1 or in X0,Y0,Z0,X1,Y1,Z1, borders included, in the
  /// coordinates of the file; empty: all.
  std::vector<double> bounds, bounds_3d;
  /// COPC: only the levels that this point spacing needs, unit of the file; 0: all
  double resolution = 0;
  std::string crs; ///< reference system of the input: "EPSG:n", WKT or a file of it
  unsigned threads = 0;       ///< for decompression; 0: all
  std::optional<Point> shift; ///< Cloud::shift to use, as nearly as a LAS grid allows
  /// Columns to read, if the file has them; in LAZ with point formats 6 to 10, the
  /// others are not even decompressed. Not set: all.
  std::optional<std::vector<std::string>> attributes;
};

template <class Visit>
void
describe(ReadOptions& s, Visit&& visit)
{
  visit("lenient", s.lenient, "read what is complete of a truncated file");
  visit("bounds", s.bounds, "read only points within X0,Y0,X1,Y1");
  visit("bounds-3d", s.bounds_3d, "read only points within X0,Y0,Z0,X1,Y1,Z1");
  visit("resolution",
        s.resolution,
        "COPC: read only the levels that this point spacing needs, in the unit of "
        "the cloud; 0: all");
  visit("crs",
        s.crs,
        "reference system of the input, in place of its own: EPSG:n or a WKT file");
}

/** \brief How to write a point file. */
struct WriteOptions {
  /// Write coordinates relative to the shift of the cloud, and the shift to PATH.shift,
  /// where \ref readCloud finds it. Not for LAS, which has its own.
  bool shifted = false;
  unsigned threads = 0; ///< that make and compress records; 0: all
};

template <class Visit>
void
describe(WriteOptions& s, Visit&& visit)
{
  visit(
      "shifted",
      s.shifted,
      "subtract a shift from the coordinates, so that they fit PCL's floats, and write "
      "it to OUTPUT.shift, where linelet finds it again (not for .las, .laz and .h5)");
}

} // namespace io
} // namespace linelet
