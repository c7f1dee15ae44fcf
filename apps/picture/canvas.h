// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "color.h"

struct _cairo;
struct _cairo_surface;

namespace linelet::apps {

/** \brief Position on a canvas in pixels, from the upper left corner, y down. */
struct Spot {
  double x = 0, y = 0;
};

enum class Align { Left, Center, Right };

/** \brief A picture drawn in memory by Cairo; no display needed.
 *
 * Everything is drawn at three times the output resolution, and averaged. */
class Canvas {
public:
  Canvas(int width, int height);

  int
  width() const
  {
    return width_;
  }
  int
  height() const
  {
    return height_;
  }

  void
  rectangle(Spot corner, double width, double height, const Color& color);

  void
  line(Spot from, Spot to, double width, const Color& color);

  void
  polyline(const std::vector<Spot>& spots, double width, const Color& color);

  void
  disc(Spot center, double radius, const Color& color);

  /** \brief A circle line of \a width inside \a radius. */
  void
  ring(Spot center, double radius, double width, const Color& color);

  /** \brief One line of text, aligned at \a at and vertically centered there.
   * \param[in] size height of capitals plus descenders, pixels
   * \param[in] upwards written from bottom to top */
  void
  text(Spot at,
       const std::string& words,
       double size,
       const Color& color = ink::text,
       Align align = Align::Left,
       bool upwards = false,
       bool bold = false);

  /** \brief Width of \a words in pixels. */
  static double
  textWidth(const std::string& words, double size, bool bold = false);

  /** \brief Writes a PNG file. \throws io::FileError */
  void
  save(const std::string& path) const;

  /// Fine pixels per output pixel.
  static constexpr int fineness = 3;

  /** \brief A fine pixel, for pixel-by-pixel drawing. */
  void
  setFine(int x, int y, const Color& color);

  int
  fineWidth() const
  {
    return width_ * fineness;
  }
  int
  fineHeight() const
  {
    return height_ * fineness;
  }

private:
  struct Destroy {
    void
    operator()(_cairo_surface* surface) const;
    void
    operator()(_cairo* cairo) const;
  };

  /** \brief Sets the color to draw in. */
  _cairo*
  pen(const Color& color);

  int width_, height_;
  std::unique_ptr<_cairo_surface, Destroy> surface_; // fine
  std::unique_ptr<_cairo, Destroy> cairo_;           // in written pixels
  bool touched_ = false;                             // pixels were set outside Cairo
};

/** \brief Fails before long work if saving a picture to \a path would fail after it.
 * \throws std::runtime_error */
void
checkPictureOutput(const std::string& path);

} // namespace linelet::apps
