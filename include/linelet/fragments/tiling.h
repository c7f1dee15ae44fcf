// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief A box in plan, half-open: low <= p < high. */
struct Area {
  std::array<double, 2> low{}, high{};
};

/** \brief Extent and number of points of an input, from its header. */
struct Extent {
  Area area; ///< including its upper borders
  double points = 0;
};

/** \brief How to cut. */
struct TilingSettings {
  double ghost = 0; ///< width of the ghost zone around a box
  double chunk = 0; ///< side of the boxes, whose borders are multiples of it; 0: any
  /// With the ghost zone, as estimated from headers; 0: any number
  double most_points = 0;
};

/** \brief Boxes that tile the plane: every place is in exactly one, and those along the
 * outside reach to infinity. Boxes with too many points are split. */
class Tiling {
public:
  /** \brief A cut: places below \ref plane are on one side, all others on the other. A
   * side is the number of another cut, or -1 - the number of a box. */
  struct Cut {
    int axis = 0;
    double plane = 0;
    int below = -1, above = -1;
  };

  /** \brief One box, of everything. */
  Tiling() = default;

  /** \brief Cuts until no box holds more points than asked for, but never a box
   * narrower than four ghost zones, whose halves would be mostly ghost zone.
   * \throws std::invalid_argument for an invalid length or number */
  Tiling(const std::vector<Extent>& inputs, const TilingSettings& settings);

  /** \brief From cuts, as \ref cuts returns them. */
  explicit Tiling(std::vector<Cut> cuts);

  const std::vector<Cut>&
  cuts() const
  {
    return cuts_;
  }

  std::size_t
  boxes() const
  {
    return cuts_.size() + 1;
  }

  /** \brief The box that owns (x, y). */
  std::size_t
  owner(double x, double y) const;

  /** \brief Box \a number, with infinite borders where nothing lies beyond. */
  Area
  box(std::size_t number) const;

  /** \brief Calls \a use with every box that (x, y) is in or within \a ghost of, along
   * each axis. */
  template <class Use>
  void
  forEachNear(double x, double y, double ghost, Use use) const
  {
    if (cuts_.empty())
      use(std::size_t{0});
    else
      visit({x, y}, ghost, 0, use);
  }

  /** \brief The boxes that \a area, with its upper borders, is in or within \a ghost
   * of, in order. */
  std::vector<std::size_t>
  near(const Area& area, double ghost) const;

private:
  template <class Use>
  void
  visit(const std::array<double, 2>& place, double ghost, int node, Use& use) const
  {
    if (node < 0)
      return use(static_cast<std::size_t>(-1 - node));
    const Cut& cut = cuts_[static_cast<std::size_t>(node)];
    const double p = place[static_cast<std::size_t>(cut.axis)];
    if (p < cut.plane + ghost)
      visit(place, ghost, cut.below, use);
    if (p >= cut.plane - ghost)
      visit(place, ghost, cut.above, use);
  }

  int
  cut(const Area& box,
      const std::vector<Extent>& inputs,
      const TilingSettings& settings,
      int& boxes);

  std::vector<Cut> cuts_;
};

} // namespace fragments
} // namespace linelet
