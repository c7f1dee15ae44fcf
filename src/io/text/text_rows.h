// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/io/output_file.h>

#include "io/coordinate_form.h"
#include "io/source.h"

namespace linelet::io {

/** \brief Appends the world coordinates of point \a i. */
inline void
appendPlace(std::string& text,
            const Cloud& cloud,
            std::size_t i,
            const CoordinateForm& form,
            char gap)
{
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0)
      text += gap;
    appendCoordinate(text, cloud.shift[axis] + cloud.points[i][axis], form);
  }
}

/** \brief Writes \a header and a line per point, whose words come from \a
 * append_row. */
template <class AppendRow>
void
writeRows(const Target& target,
          const std::string& header,
          std::size_t points,
          AppendRow append_row)
{
  OutputFile file(target.name);
  std::string text = header;
  for (std::size_t i = 0; i < points; ++i) {
    append_row(text, i);
    text += '\n';
    if (i % block_points == block_points - 1) {
      file.write(text);
      text.clear();
      target.advance(block_points);
    }
  }
  file.write(text);
  file.commit();
}

} // namespace linelet::io
