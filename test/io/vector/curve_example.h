// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

#include "io/file_helpers.h"

namespace linelet::test {

using namespace linelet::io;

inline const Point utm_shift(689012.0, 5527515.0, 210.0);

/** GeoJSON in the coordinates of the input. */
inline const VectorOptions kept{"", true};

/** An open and a closed curve, with coordinates that need every digit. */
inline CurveNetwork
example()
{
  CurveNetwork network;
  Curve open;
  open.points = {{0.123456789, 1.0 / 3, 0}, {1, 2, 3.0000001}, {7.7, -0.1, 1e-7}};
  open.back.kind = EndKind::Bounds;
  Curve closed;
  closed.points = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  closed.closed = true;
  closed.front.kind = closed.back.kind = EndKind::Loop;
  network.curves = {open, closed};
  return network;
}

/** The reference system of a code combined with the heights of another, as text. */
inline std::string
wktOf(int code, int height = 0)
{
  OGRSpatialReference system;
  system.importFromEPSG(code);
  if (height != 0) {
    OGRSpatialReference plane = system, vertical;
    vertical.importFromEPSG(height);
    system.SetCompoundCS("both", &plane, &vertical);
  }
  char* text = nullptr;
  system.exportToWkt(&text);
  const std::string wkt = text;
  CPLFree(text);
  return wkt;
}

/** A file as read by GDAL. */
inline std::unique_ptr<GDALDataset>
open(const std::string& path)
{
  GDALAllRegister();
  return std::unique_ptr<GDALDataset>(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
}

} // namespace linelet::test
