// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <linelet/curves/curve_parts.h>
#include <linelet/curves/refined_settings.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The rectangles in plan into which a scene is divided to search it for curves.
 *
 * What is found in a block depends only on the points in it and in a margin around it:
 * they give the same curves there, to the last digit, whatever else of the cloud is
 * loaded. A scene no larger than a block, a small cloud, and a cloud of only curves,
 * whose connected components cross any border, are one block. */
class CurveBlocks {
public:
  /** \param[in] whole traits of the cloud */
  explicit CurveBlocks(const CloudTraits& whole);

  std::size_t
  count() const
  {
    return numbers_[0] * numbers_[1];
  }

  /** \brief The block that owns \a p; every place has one owner. */
  std::size_t
  owner(const Point& p) const;

  /** \brief The center of \a block in plan; its height is 0. */
  Point
  middle(std::size_t block) const;

  /** \brief Whether \a block uses a point at \a p. */
  bool
  takesPart(const Point& p, std::size_t block) const;

  /** \brief The blocks that use a point at \a p; none if it is not finite. */
  std::vector<std::size_t>
  around(const Point& p) const;

  /** \brief No point that a block uses is farther than this from its center along x or
   * y. */
  double
  reach() const;

private:
  std::array<double, 2> low_{}, sides_{};
  std::array<std::size_t, 2> numbers_{1, 1};
  double margin_ = 0;
};

/** \brief The curves of the whole cloud.
 * \param[in] parts by block, as \ref curvesOfBlock gives them
 * \param[in] whole traits of the cloud */
CurveNetwork
joinBlocks(std::vector<CurvePart> parts, const CloudTraits& whole);

/** \brief Sorts \a found, the curves of a whole cloud, by place, as \ref joinBlocks
 * does. */
CurveNetwork
inOrderOfPlaces(const CurveNetwork& found);

} // namespace linelet
