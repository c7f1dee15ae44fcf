// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <functional>
#include <vector>

#include <linelet/powerline/power_line_network.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief A wire that is not yet part of a network. Its ends are 0 (front) and 1
 * (back). */
struct LooseWire {
  /** \brief Where it ends, and what continues it. Indices in the lists of the part. */
  struct End {
    Point place = Point::Zero(); ///< attachment point, or the last place with points
    int partner = -1;    ///< wire that continues it beyond the support; -1: none
    int partner_end = 0; ///< which of that wire's ends is there
    int support = -1;    ///< -1: none seen
    bool fixed = false;  ///< place is an attachment point
  };

  Wire wire; ///< id: that of the network of the part
  /// Polynomial along which it was followed, in its own frame: origin (2) and direction
  /// (2) in plan, deviation to the left (3) and height (3) as functions of the distance
  /// along it, first and last such distance, robust scale of the residuals, tolerance,
  /// thickness of a bundle. Meters.
  std::array<double, 15> course{};
  std::array<End, 2> ends;
  Points points; ///< to which it is fitted
};

/** \brief What was found in a part of a cloud, to be merged with that of other parts.
 */
struct NetworkPart {
  std::vector<LooseWire> wires;
  std::vector<Support> supports;
  std::vector<Jumper> jumpers;             ///< support, wires: ids in the part
  std::vector<InsulatorString> insulators; ///< likewise
  std::vector<UnexplainedLine> unexplained;
  /// Whether the part owns a place in plan (coordinates of the network). Every place
  /// has one owner.
  std::function<bool(double x, double y)> owns;
};

/** \brief What became of the wires and supports of a part: for each id there, the id in
 * the whole; 0: dropped. */
struct PartIds {
  std::vector<int> wires, supports;
};

/** \brief The network of a whole cloud, without labels of points and without terrain.
 *
 * A wire is taken from the part that owns the middle of its catenary, a support and the
 * attachment points there from the one that owns its axis; a wire whose attachment
 * points another part knows better is fitted again to its points. What both of two
 * parts own, or neither, because they place it on different sides of a border, is taken
 * once. Jumpers and insulators are taken from the part that owns their middle. Each
 * part contributes what it owns of an unexplained line, joined at the borders. Spans,
 * circuits and all ids follow as for a single cloud. Parts must overlap by a whole span
 * and its supports.
 * \param[out] ids for each part, what became of its wires and supports */
PowerLineNetwork
mergeParts(const std::vector<NetworkPart>& parts, std::vector<PartIds>& ids);

} // namespace powerline
} // namespace linelet
