// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief A wire, with the parallel strands of its bundle that are not separate
 * wires. */
struct Strand {
  Piece piece;
  std::vector<Piece> companions; ///< short parts of other conductors of the bundle
};

/** \brief Resolves bundles: a short piece close beside a long one is either completed
 * to a separate wire, in the shape of the long one, or becomes its companion. */
std::vector<Strand>
sortBundles(Growth& growth,
            std::vector<Piece> pieces,
            const PowerLineSettings& settings);

} // namespace linelet::powerline
