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

/** \brief A wire as it was reviewed, with the verdict. */
struct ReviewedWire {
  Points vertices; ///< from end to end, in the coordinates of the network
  Review review;
};

/** \brief For every wire of \a network, the index of the same wire in \a reviewed, or
 * -1: among those that run within half a bundle's conductor spacing along more than
 * half of the shorter of the two, the one that covers most of it. */
std::vector<int>
matchReviewed(const PowerLineNetwork& network,
              const std::vector<ReviewedWire>& reviewed);

/** \brief Applies reviews to \a network: rejected wires leave it (their points become
 * unclassified; spans, circuits and supports that exist only because of them go too,
 * supports with points of their own stay), accepted ones become certain, and every wire
 * keeps class and note. Everything is renumbered, in the same order.
 * \return one sentence for every accepted wire that was not found */
std::vector<std::string>
applyReview(PowerLineNetwork& network, const std::vector<ReviewedWire>& reviewed);

} // namespace powerline
} // namespace linelet
