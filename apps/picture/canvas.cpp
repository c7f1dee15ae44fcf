// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <vtkAutoInit.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <linelet/io/output_file.h>

VTK_MODULE_INIT(vtkRenderingFreeType) // registers what the text renderer writes with

namespace linelet::apps {

namespace {

/// Text as an image of coverage, rows upwards.
struct Lettering {
  int width = 0, height = 0;
  std::vector<std::uint8_t> coverage;
};

Lettering
lettering(const std::string& words, double fine_size, bool bold)
{
  constexpr int dots_per_inch = 72; // a point is a pixel
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial();
  property->SetFontSize(std::max(1, static_cast<int>(std::lround(fine_size))));
  property->SetBold(bold);
  property->SetColor(1, 1, 1);
  vtkNew<vtkImageData> image;
  Lettering letters;
  int size[2] = {0, 0};
  if (words.empty() || !vtkTextRenderer::GetInstance()->RenderString(
                           property, words, image, size, dots_per_inch))
    return letters;
  // The image may be larger than its text, which lies in its lower left corner.
  letters.width = size[0];
  letters.height = size[1];
  int extent[6];
  image->GetExtent(extent);
  for (int y = 0; y < letters.height; ++y)
    for (int x = 0; x < letters.width; ++x)
      letters.coverage.push_back(static_cast<const std::uint8_t*>(
          image->GetScalarPointer(extent[0] + x, extent[2] + y, 0))[3]);
  return letters;
}

} // namespace

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(fineWidth()) *
                  static_cast<std::size_t>(fineHeight()) * 3,
              255)
{
}

void
Canvas::blend(int x, int y, const Color& color, double alpha)
{
  if (x < 0 || y < 0 || x >= fineWidth() || y >= fineHeight())
    return;
  const std::size_t place =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(fineWidth()) +
       static_cast<std::size_t>(x)) *
      3;
  for (std::size_t i = 0; i < 3; ++i) {
    const double old = pixels_[place + i];
    pixels_[place + i] = static_cast<std::uint8_t>(
        std::lround(old + (std::clamp(color[i], 0.0, 1.0) * 255 - old) * alpha));
  }
}

template <class Inside>
void
Canvas::fill(
    double x0, double y0, double x1, double y1, const Color& color, Inside inside)
{
  const int left = std::max(0, static_cast<int>(std::floor(x0 * fineness)));
  const int top = std::max(0, static_cast<int>(std::floor(y0 * fineness)));
  const int right =
      std::min(fineWidth() - 1, static_cast<int>(std::ceil(x1 * fineness)));
  const int bottom =
      std::min(fineHeight() - 1, static_cast<int>(std::ceil(y1 * fineness)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      if (inside((x + 0.5) / fineness, (y + 0.5) / fineness))
        blend(x, y, color, 1);
}

void
Canvas::rectangle(Spot corner, double width, double height, const Color& color)
{
  const double right = corner.x + width, bottom = corner.y + height;
  fill(corner.x, corner.y, right, bottom, color, [&](double x, double y) {
    return x >= corner.x && x < right && y >= corner.y && y < bottom;
  });
}

void
Canvas::line(Spot from, Spot to, double width, const Color& color)
{
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double squared = dx * dx + dy * dy, half = width / 2;
  fill(std::min(from.x, to.x) - half,
       std::min(from.y, to.y) - half,
       std::max(from.x, to.x) + half,
       std::max(from.y, to.y) + half,
       color,
       [&](double x, double y) {
         const double along =
             squared > 0 ? ((x - from.x) * dx + (y - from.y) * dy) / squared : 0;
         const double t = std::clamp(along, 0.0, 1.0);
         return std::hypot(x - from.x - t * dx, y - from.y - t * dy) <= half;
       });
}

void
Canvas::polyline(const std::vector<Spot>& spots, double width, const Color& color)
{
  for (std::size_t i = 1; i < spots.size(); ++i)
    line(spots[i - 1], spots[i], width, color);
}

void
Canvas::disc(Spot center, double radius, const Color& color)
{
  fill(center.x - radius,
       center.y - radius,
       center.x + radius,
       center.y + radius,
       color,
       [&](double x, double y) {
         return std::hypot(x - center.x, y - center.y) <= radius;
       });
}

void
Canvas::ring(Spot center, double radius, double width, const Color& color)
{
  fill(center.x - radius,
       center.y - radius,
       center.x + radius,
       center.y + radius,
       color,
       [&](double x, double y) {
         const double distance = std::hypot(x - center.x, y - center.y);
         return distance <= radius && distance >= radius - width;
       });
}

void
Canvas::text(Spot at,
             const std::string& words,
             double size,
             const Color& color,
             Align align,
             bool upwards,
             bool bold)
{
  const Lettering letters = lettering(words, size * fineness, bold);
  const double part = align == Align::Left ? 0 : align == Align::Center ? 0.5 : 1;
  // Along and across the writing direction, in fine pixels.
  const int along = static_cast<int>(std::lround(-part * letters.width));
  const int across = -letters.height / 2;
  const int x0 = static_cast<int>(std::lround(at.x * fineness));
  const int y0 = static_cast<int>(std::lround(at.y * fineness));
  for (int v = 0; v < letters.height; ++v)
    for (int u = 0; u < letters.width; ++u) {
      const double alpha =
          letters.coverage[static_cast<std::size_t>(v) *
                               static_cast<std::size_t>(letters.width) +
                           static_cast<std::size_t>(u)] /
          255.0;
      if (alpha <= 0)
        continue;
      if (upwards)
        blend(x0 - across - v, y0 - along - u, color, alpha);
      else
        blend(x0 + along + u, y0 - across - v, color, alpha);
    }
}

double
Canvas::textWidth(const std::string& words, double size, bool bold)
{
  return static_cast<double>(lettering(words, size * fineness, bold).width) / fineness;
}

void
Canvas::save(const std::string& path) const
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width_, height_, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<std::uint8_t*>(image->GetScalarPointer());
  const auto fine_row = static_cast<std::size_t>(fineWidth()) * 3;
  for (int y = height_ - 1; y >= 0; --y) // VTK's rows go upwards
    for (int x = 0; x < width_; ++x)
      for (std::size_t i = 0; i < 3; ++i) {
        unsigned sum = 0;
        for (int v = 0; v < fineness; ++v)
          for (int u = 0; u < fineness; ++u)
            sum += pixels_[static_cast<std::size_t>(y * fineness + v) * fine_row +
                           static_cast<std::size_t>(x * fineness + u) * 3 + i];
        *out++ = static_cast<std::uint8_t>(sum / (fineness * fineness));
      }
  vtkNew<vtkPNGWriter> writer; // in memory: VTK says on stderr what fails on disk
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray& png = *writer->GetResult();
  io::OutputFile file(path);
  file.write({reinterpret_cast<const char*>(png.GetPointer(0)),
              static_cast<std::size_t>(png.GetNumberOfValues())});
  file.commit();
}

void
checkPictureOutput(const std::string& path)
{
  const auto ending = std::filesystem::path(path).extension();
  if (ending != ".png" && ending != ".PNG")
    throw std::runtime_error(path + ": pictures are written as .png only");
  io::checkWritable(path);
}

} // namespace linelet::apps
