// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "source.h"

namespace linelet::io {

/** \brief Reads vector files as points, by GDAL in linelet::vector. A program linked
 * without it reads none. */
struct VectorPoints {
  /** \brief Whether there is a driver for the ending of \a path. */
  bool (*reads)(const std::string& path);

  /** \brief The vertices of all layers. \throws FileError */
  Cloud (*read)(const Source& source);
};

/** \brief The reader that the program was linked with, or null. */
const VectorPoints*
vectorPoints();

/** \brief Called once, when linelet::vector is loaded. */
LINELET_PUBLIC void
setVectorPoints(const VectorPoints* reader);

} // namespace linelet::io
