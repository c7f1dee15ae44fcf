// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "color.h"

namespace linelet::apps {

/** \brief Place on a canvas in pixels, from the upper left corner, y downwards. */
struct Spot {
  double x = 0, y = 0;
};

enum class Align { Left, Center, Right };

/** \brief A picture drawn in memory, no display needed.
 *
 * Everything is drawn three times as fine as it is written, and averaged. */
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

  /** \brief One line of text, \a at its alignment point, vertically centered there.
   * \param[in] size height of capitals and descenders together, pixels
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

  /// Fine pixels along one written pixel.
  static constexpr int fineness = 3;

  /** \brief A fine pixel, for what is computed pixel by pixel. */
  void
  setFine(int x, int y, const Color& color)
  {
    blend(x, y, color, 1);
  }
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
  void
  blend(int x, int y, const Color& color, double alpha);

  template <class Inside>
  void
  fill(double x0, double y0, double x1, double y1, const Color& color, Inside inside);

  int width_, height_;
  std::vector<std::uint8_t> pixels_; // fine, rows downwards, 3 bytes each
};

/** \brief Fails at once where saving a picture at \a path would fail after long work.
 * \throws std::runtime_error */
void
checkPictureOutput(const std::string& path);

} // namespace linelet::apps
