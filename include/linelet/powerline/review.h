// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/powerline/power_line_network.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief A wire as it was reviewed, with the judgment. */
struct ReviewedWire {
  Points vertices; ///< from end to end, in the coordinates of the network
  Review review;
};

/** \brief For every wire of \a network the place in \a reviewed of the wire that it is,
 * or -1: the one that covers most of it, of those that run within half the spacing of
 * a bundle's conductors of it along more than half of the shorter of the two. */
std::vector<int>
matchReviewed(const PowerLineNetwork& network,
              const std::vector<ReviewedWire>& reviewed);

/** \brief Lets what was said stand in \a network: rejected wires leave it (their points
 * are unclassified again; spans, lines and supports that only they made go with them,
 * supports with points of their own stay), accepted ones are certain, and every wire
 * keeps class and note. Everything is numbered anew, in the same order.
 * \return one sentence for every accepted wire that was not found */
std::vector<std::string>
applyReview(PowerLineNetwork& network, const std::vector<ReviewedWire>& reviewed);

} // namespace powerline
} // namespace linelet
