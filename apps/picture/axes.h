// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "canvas.h"

namespace linelet::apps {

/** \brief A range of values mapped to pixels. */
class Axis {
public:
  /** \param[in] low, high values; positive if \a logarithmic
   * \param[in] begin, end their pixels */
  Axis(double low, double high, double begin, double end, bool logarithmic);

  double
  pixel(double value) const;

  /** \brief Values for labels: 1, 2 or 5 times a power of ten, within the range. */
  std::vector<double>
  ticks() const;

  double
  begin() const
  {
    return begin_;
  }
  double
  end() const
  {
    return end_;
  }

private:
  double low_, high_, begin_, end_;
  bool logarithmic_;
};

/** \brief A number as printed on an axis. */
std::string
numberText(double value, int digits = 4);

/** \brief Frame, ticks and labels of a plot; \a grid draws lines across it. */
void
drawAxes(Canvas& canvas,
         const Axis& x,
         const std::string& x_label,
         const Axis& y,
         const std::string& y_label,
         bool grid);

/** \brief Color swatches with their names, from left to right. */
void
drawLegend(Canvas& canvas,
           Spot at,
           const std::vector<std::pair<Color, std::string>>& entries);

constexpr double text_size = 15;
constexpr double title_size = 18;

} // namespace linelet::apps
