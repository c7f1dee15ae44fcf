// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "las_format.h"

namespace linelet::io {

/** \brief Point records of length \a stride to fill, for points from \a first on. */
struct LasBlock {
  char* records;
  std::size_t stride;
  std::size_t first, count;
};

/** \brief Whether \a field can hold every value of \a column unchanged. */
bool
fitsLasField(const LasField& field, const Column& column);

/** \brief Fills \a field from \a column times \a factor; null: with its default. */
void
writeLasField(const LasField& field,
              const Column* column,
              double factor,
              const LasBlock& block);

/** \brief Fills the extra entry at byte \a at of each record from the columns of \a
 * cloud, or from the raw bytes of the entry if the columns still agree with them. */
void
writeLasExtra(const LasExtra& extra,
              std::size_t at,
              const Cloud& cloud,
              const LasBlock& block);

/** \brief Grid steps of point \a i of \a cloud. */
class LasSteps {
public:
  /** The grid that the cloud came with if it fits, otherwise one that fits.
   * \param[in] threads 0: all */
  explicit LasSteps(const Cloud& cloud, unsigned threads = 0);

  std::array<std::int32_t, 3>
  operator()(std::size_t i) const;

  const LasGrid&
  grid() const
  {
    return grid_;
  }

  /** \brief Whether the cloud came from LAS, but its grid cannot hold the points. */
  bool
  replaced() const
  {
    return replaced_;
  }

private:
  double
  steps(const Point& point, int axis) const;
  bool
  holds(unsigned threads) const;
  void
  choose(const Cloud& cloud);

  const Points& points_;
  Point shift_;
  LasGrid grid_;
  bool native_ = false; ///< points are steps from grid_.corner
  bool replaced_ = false;
};

} // namespace linelet::io
