// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_image.h"

#include <memory>
#include <stdexcept>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>

namespace linelet::powerline::report {

namespace {

GDALDriverH
driver(const char* name)
{
  GDALAllRegister();
  const GDALDriverH found = GDALGetDriverByName(name);
  if (found == nullptr)
    throw std::runtime_error(std::string("GDAL has no driver ") + name +
                             " for the report's plan; install a GDAL that has it");
  return found;
}

struct Closer {
  void
  operator()(GDALDatasetH dataset) const
  {
    GDALClose(dataset);
  }
};
using Dataset = std::unique_ptr<void, Closer>;

/** A picture in memory, with its palette. */
Dataset
pictureOf(std::size_t width,
          std::size_t height,
          std::vector<std::uint8_t> pixels,
          const std::vector<std::array<std::uint8_t, 3>>& palette)
{
  const int columns = static_cast<int>(width), rows = static_cast<int>(height);
  Dataset picture(GDALCreate(driver("MEM"), "", columns, rows, 1, GDT_Byte, nullptr));
  const GDALRasterBandH band = GDALGetRasterBand(picture.get(), 1);
  const GDALColorTableH colors = GDALCreateColorTable(GPI_RGB);
  for (std::size_t k = 0; k < palette.size(); ++k) {
    const GDALColorEntry entry = {palette[k][0], palette[k][1], palette[k][2], 255};
    GDALSetColorEntry(colors, static_cast<int>(k), &entry);
  }
  GDALSetRasterColorTable(band, colors);
  GDALDestroyColorTable(colors);
  if (GDALRasterIO(band,
                   GF_Write,
                   0,
                   0,
                   columns,
                   rows,
                   pixels.data(),
                   columns,
                   rows,
                   GDT_Byte,
                   0,
                   0) != CE_None)
    throw std::runtime_error("GDAL cannot fill the picture of the report's plan");
  return picture;
}

} // namespace

std::string
base64(const std::vector<std::uint8_t>& data)
{
  const std::unique_ptr<char, void (*)(void*)> text(
      CPLBase64Encode(static_cast<int>(data.size()), data.data()), VSIFree);
  return text.get();
}

std::string
pngBase64(std::size_t width,
          std::size_t height,
          const std::vector<std::uint8_t>& pixels,
          const std::vector<std::array<std::uint8_t, 3>>& palette)
{
  const Dataset picture = pictureOf(width, height, pixels, palette);
  const std::string path =
      "/vsimem/report" +
      std::to_string(reinterpret_cast<std::uintptr_t>(picture.get()));
  Dataset(GDALCreateCopy(
      driver("PNG"), path.c_str(), picture.get(), FALSE, nullptr, nullptr, nullptr));
  vsi_l_offset size = 0;
  const std::unique_ptr<GByte, void (*)(void*)> png(
      VSIGetMemFileBuffer(path.c_str(), &size, TRUE), VSIFree);
  if (!png)
    throw std::runtime_error("GDAL cannot write the picture of the report's plan");
  return base64({png.get(), png.get() + size});
}

} // namespace linelet::powerline::report
