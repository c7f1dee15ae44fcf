// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "dataset.h"

#include <cpl_conv.h>

#include <linelet/io/file_error.h>

#include "layer_formats.h"

namespace linelet::io {

std::unique_ptr<GDALDataset>
openDataset(const std::string& path, const Complaints& complaints)
{
  GDALAllRegister();
  std::string driver = findReadLayerDriver(path);
  if (driver.empty())
    driver = layerDriver(path); // throws with the reason
  const char* const drivers[] = {driver.c_str(), nullptr};
  std::unique_ptr<GDALDataset> dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
  if (dataset == nullptr)
    throw FileError(path + ": cannot be read in the format of its ending (" +
                    complaints.first() + "); check that it is whole");
  return dataset;
}

std::string
referenceOf(OGRLayer& layer)
{
  const OGRSpatialReference* system = layer.GetSpatialRef();
  char* text = nullptr;
  std::string wkt;
  if (system != nullptr && system->IsLocal() == 0 &&
      system->exportToWkt(&text) == OGRERR_NONE)
    wkt = text;
  CPLFree(text);
  return wkt;
}

} // namespace linelet::io
