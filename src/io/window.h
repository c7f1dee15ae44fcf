// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/file_options.h>
#include <linelet/support/points.h>

namespace linelet::io {

/** \brief The box to read, in world coordinates, borders included. */
struct Window {
  Point low, high;

  bool
  contains(const Point& world) const
  {
    return (world.array() >= low.array()).all() &&
           (world.array() <= high.array()).all();
  }

  /** \brief Whether the box from \a from to \a to intersects it. */
  bool
  meets(const Point& from, const Point& to) const
  {
    return (to.array() >= low.array()).all() && (from.array() <= high.array()).all();
  }

  /** \brief Whether it is bounded at all. */
  bool
  limits() const;
};

/** \brief The window that \a options request; everything if they request none.
 * \throws FileError if the numbers do not bound an area */
Window
windowOf(const ReadOptions& options);

/** \brief The warning about --resolution for files without levels. */
constexpr const char* no_copc = "it is not a COPC file; --resolution has no effect";

} // namespace linelet::io
