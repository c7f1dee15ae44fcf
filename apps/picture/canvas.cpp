// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <cairo.h>

#include <linelet/io/output_file.h>

namespace linelet::apps {

namespace {

void
useFont(cairo_t* cairo, double size, bool bold)
{
  cairo_select_font_face(cairo,
                         "sans-serif",
                         CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
}

double
advance(cairo_t* cairo, const std::string& words)
{
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, words.c_str(), &extents);
  return extents.x_advance;
}

std::size_t
offset(int x, int y, int stride)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(stride) +
         static_cast<std::size_t>(x) * sizeof(std::uint32_t);
}

/// 0xRRGGBB, as cairo keeps it.
std::uint32_t
packed(const Color& color)
{
  std::uint32_t pixel = 0;
  for (const double channel : color)
    pixel = pixel << 8 | static_cast<std::uint32_t>(
                             std::lround(std::clamp(channel, 0.0, 1.0) * 255));
  return pixel;
}

} // namespace

void
Canvas::Destroy::operator()(_cairo_surface* surface) const
{
  cairo_surface_destroy(surface);
}

void
Canvas::Destroy::operator()(_cairo* cairo) const
{
  cairo_destroy(cairo);
}

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      surface_(
          cairo_image_surface_create(CAIRO_FORMAT_RGB24, fineWidth(), fineHeight())),
      cairo_(cairo_create(surface_.get()))
{
  if (cairo_status(cairo_.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("no memory for a picture of " + std::to_string(width) +
                             " x " + std::to_string(height) +
                             " pixels; make it smaller");
  cairo_set_source_rgb(cairo_.get(), 1, 1, 1);
  cairo_paint(cairo_.get());
  cairo_scale(cairo_.get(), fineness, fineness);
  cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

_cairo*
Canvas::pen(const Color& color)
{
  if (touched_)
    cairo_surface_mark_dirty(surface_.get());
  touched_ = false;
  cairo_set_source_rgb(cairo_.get(), color[0], color[1], color[2]);
  cairo_new_path(cairo_.get());
  return cairo_.get();
}

void
Canvas::rectangle(Spot corner, double width, double height, const Color& color)
{
  _cairo* cairo = pen(color);
  // Whole fine pixels, so that adjacent ones leave no seam.
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
  cairo_rectangle(cairo, corner.x, corner.y, width, height);
  cairo_fill(cairo);
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
}

void
Canvas::line(Spot from, Spot to, double width, const Color& color)
{
  polyline({from, to}, width, color);
}

void
Canvas::polyline(const std::vector<Spot>& spots, double width, const Color& color)
{
  if (spots.size() < 2)
    return;
  _cairo* cairo = pen(color);
  cairo_set_line_width(cairo, width);
  for (const Spot& spot : spots)
    cairo_line_to(cairo, spot.x, spot.y);
  cairo_stroke(cairo);
}

void
Canvas::disc(Spot center, double radius, const Color& color)
{
  _cairo* cairo = pen(color);
  constexpr double turn = 2 * M_PI;
  cairo_arc(cairo, center.x, center.y, radius, 0, turn);
  cairo_fill(cairo);
}

void
Canvas::ring(Spot center, double radius, double width, const Color& color)
{
  _cairo* cairo = pen(color);
  constexpr double turn = 2 * M_PI;
  cairo_set_line_width(cairo, width);
  cairo_arc(cairo, center.x, center.y, radius - width / 2, 0, turn);
  cairo_stroke(cairo);
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
  _cairo* cairo = pen(color);
  cairo_save(cairo);
  useFont(cairo, size, bold);
  cairo_translate(cairo, at.x, at.y);
  if (upwards)
    cairo_rotate(cairo, -M_PI / 2);
  const double part = align == Align::Left ? 0 : align == Align::Center ? 0.5 : 1;
  // Capitals are about 0.7 of the size high; centers them at the given place.
  cairo_move_to(cairo, -part * advance(cairo, words), 0.35 * size);
  cairo_show_text(cairo, words.c_str());
  cairo_restore(cairo);
}

double
Canvas::textWidth(const std::string& words, double size, bool bold)
{
  const Canvas canvas(1, 1);
  useFont(canvas.cairo_.get(), size, bold);
  return advance(canvas.cairo_.get(), words);
}

void
Canvas::setFine(int x, int y, const Color& color)
{
  if (x < 0 || y < 0 || x >= fineWidth() || y >= fineHeight())
    return;
  if (!touched_)
    cairo_surface_flush(surface_.get());
  touched_ = true;
  const int stride = cairo_image_surface_get_stride(surface_.get());
  unsigned char* data = cairo_image_surface_get_data(surface_.get());
  *reinterpret_cast<std::uint32_t*>(data + offset(x, y, stride)) = packed(color);
}

void
Canvas::save(const std::string& path) const
{
  const std::unique_ptr<_cairo_surface, Destroy> image(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_, height_));
  cairo_surface_flush(surface_.get());
  const int fine_stride = cairo_image_surface_get_stride(surface_.get());
  const int stride = cairo_image_surface_get_stride(image.get());
  const unsigned char* fine = cairo_image_surface_get_data(surface_.get());
  unsigned char* data = cairo_image_surface_get_data(image.get());
  if (data == nullptr || fine == nullptr)
    throw std::runtime_error(path + ": no memory for the picture");
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      for (std::size_t c = 0; c < 3; ++c) { // the fourth byte is unused
        unsigned sum = 0;
        for (int v = 0; v < fineness; ++v)
          for (int u = 0; u < fineness; ++u) {
            const std::size_t pixel =
                offset(x * fineness + u, y * fineness + v, fine_stride);
            sum += *reinterpret_cast<const std::uint32_t*>(fine + pixel) >> (8 * c) &
                   0xFFU;
          }
        const unsigned mean = sum / (fineness * fineness);
        std::uint32_t& out =
            *reinterpret_cast<std::uint32_t*>(data + offset(x, y, stride));
        out = (out & ~(0xFFU << (8 * c))) | mean << (8 * c);
      }
  cairo_surface_mark_dirty(image.get());
  std::string png; // to memory, so that we report write errors
  const auto append = [](void* text, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes),
                                            count);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status =
      cairo_surface_write_to_png_stream(image.get(), append, &png);
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(
        path + ": the picture cannot be made: " + cairo_status_to_string(status));
  io::OutputFile file(path);
  file.write(png);
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
