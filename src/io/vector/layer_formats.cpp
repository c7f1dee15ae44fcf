// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "layer_formats.h"

#include <sstream>

#include <gdal_priv.h>

#include <linelet/io/file_error.h>

#include "io/files.h"

namespace linelet::io {

std::string
findLayerDriver(const std::string& path)
{
  const std::string ending = endingOf(path);
  // .json and .txt are ambiguous, and a shapefile consists of several files.
  for (const char* other : {"", ".json", ".txt", ".csv", ".shp"})
    if (ending == other)
      return {};
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (int i = 0; i < drivers.GetDriverCount(); ++i) {
    GDALDriver& driver = *drivers.GetDriver(i);
    const char* endings = driver.GetMetadataItem(GDAL_DMD_EXTENSIONS);
    if (endings == nullptr || driver.GetMetadataItem(GDAL_DCAP_VECTOR) == nullptr ||
        driver.GetMetadataItem(GDAL_DCAP_CREATE) == nullptr ||
        driver.GetMetadataItem(GDAL_DCAP_NONSPATIAL) != nullptr)
      continue;
    std::istringstream words(endings);
    for (std::string word; words >> word;)
      if ("." + word == ending)
        return driver.GetDescription();
  }
  return {};
}

std::string
layerDriver(const std::string& path)
{
  std::string driver = findLayerDriver(path);
  if (!driver.empty())
    return driver;
  const std::string ending = endingOf(path);
  throw FileError(
      path + ": the ending '" + ending +
      "' names no vector format; use .geojson, .gpkg, .dxf, " +
      (ending == ".shp" ? ".shz (a shapefile in one file) " : ".kml, .fgb ") +
      "or another that GDAL writes");
}

std::string
findReadLayerDriver(const std::string& path)
{
  return endingOf(path) == ".shp" ? "ESRI Shapefile" : findLayerDriver(path);
}

} // namespace linelet::io
