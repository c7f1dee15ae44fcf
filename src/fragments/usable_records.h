// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <linelet/fragments/plan.h>
#include <linelet/io/file_error.h>
#include <linelet/io/usable_points.h>

#include "piece_files.h"

namespace linelet::fragments {

constexpr std::size_t block_size = 500000; ///< points read at a time

/** \brief Calls \a use with every usable point of \a cloud, which begins at index \a
 * first of \a input, as a record, and its world coordinates. \throws io::FileError if
 * one lies outside the bounds in the header of \a input */
template <class Use>
void
forEachRecord(const Plan& plan,
              const PlannedInput& input,
              const io::ClassFilter& filter,
              const io::Cloud& cloud,
              std::size_t first,
              Use use)
{
  if (first + cloud.points.size() > std::numeric_limits<std::uint32_t>::max())
    throw io::FileError(input.path +
                        ": has more than 4,294,967,295 points; cut it in two");
  const Area& area = input.extent.area;
  const io::UsablePoints usable(cloud, nullptr, filter);
  const io::Column* classes = cloud.find("classification");
  const io::Column* returns = cloud.find("number_of_returns");
  const auto numberIn = [](const io::Column* column, std::size_t i) {
    return column == nullptr ? std::uint8_t{0}
                             : static_cast<std::uint8_t>(io::valueAt(*column, i));
  };
  const Point offset = cloud.shift - plan.shift;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!usable.points()[i].allFinite())
      continue;
    const Point p = usable.points()[i] + offset;
    const Point world = p + plan.shift;
    for (std::size_t a = 0; a < 2; ++a) {
      const double value = world[static_cast<Eigen::Index>(a)];
      if (value < area.low[a] || value > area.high[a])
        throw io::FileError(input.path +
                            ": has points outside the bounds in its header; "
                            "rewrite it with linelet convert");
    }
    use(PieceRecord{p.x(),
                    p.y(),
                    p.z(),
                    static_cast<std::uint32_t>(first + i),
                    numberIn(classes, i),
                    numberIn(returns, i),
                    0},
        world);
  }
}

} // namespace linelet::fragments
