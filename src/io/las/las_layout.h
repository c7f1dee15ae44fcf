// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "las_format.h"

namespace linelet::io {

/** \brief The layout of a LAS file for a cloud, chosen before its points are
 * written. */
struct LasLayout {
  int format = 0;
  bool as_origin = false; ///< same point format and version as the file it came from
  std::vector<const Column*> fields; ///< for each of lasFields(format), or null
  double color_factor = 1;           ///< to 16 bit
  std::vector<LasExtra> extras;
  /// Attributes rounded in their field, and exact in an extra entry
  std::vector<std::string> rounded;
  bool extras_as_origin = false;
  std::size_t record_length = 0;
};

/** \brief Chooses the format that holds most attributes of \a cloud unchanged: that of
 * its origin, otherwise the smallest. Every attribute that is not part of LAS, or that
 * its field cannot hold, becomes an extra entry. */
LasLayout
chooseLasLayout(const Cloud& cloud);

} // namespace linelet::io
