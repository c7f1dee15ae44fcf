// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace linelet::view {

/** \brief The meaning of the colors of a picture. */
struct Legend {
  struct Entry {
    std::array<double, 3> color;
    std::string text;
  };
  std::string title;
  bool scale = false; ///< the gradient from \ref low to \ref high
  bool shape = false; ///< the triangle of linearity, planarity, sphericity
  double low = 0, high = 1;
  std::vector<Entry> entries; ///< classes
};

/** \brief Colors of all points. */
struct Coloring {
  std::vector<std::uint8_t> rgb; ///< three per point
  Legend legend;
};

/** \brief Colors by values: the gradient runs from the 2nd to the 98th percentile; NaN
 * is gray. */
Coloring
colorsByValue(const std::vector<float>& values, const std::string& title);

/** \brief Colors by shape factors, three vectors of equal length. */
Coloring
colorsByShape(const std::vector<float>& linearity,
              const std::vector<float>& planarity,
              const std::vector<float>& sphericity,
              const std::string& title);

/** \brief Colors of ASPRS classes, with a legend of those that occur. */
Coloring
colorsByClass(const std::vector<float>& classes, const std::string& title);

/** \brief Colors by number, with 0 gray: wires, spans. */
Coloring
colorsByNumber(const std::vector<float>& numbers, const std::string& title);

/** \brief Red, green, blue as stored in the file, with 8 or 16 bits. */
Coloring
colorsAsGiven(const std::vector<float>& red,
              const std::vector<float>& green,
              const std::vector<float>& blue);

/** \brief Name of an ASPRS class: "14 wire". */
std::string
className(int number);

} // namespace linelet::view
