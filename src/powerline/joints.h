// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

#include "powerline/merge.h"
#include "powerline/underside.h"

namespace linelet::powerline {

/** \brief One end of a wire: where it is fixed, and to whom. */
struct End {
  Point place = Point::Zero(); ///< attachment point, or the last place with points
  int partner = -1;            ///< wire that goes on beyond the support, -1: none seen
  int partner_side = 0;        ///< its end there: 0 begin, 1 end
  int support = -1;            ///< place in the list of supports, -1: none seen
  bool fixed = false;          ///< place is an attachment point
};

/** \brief A wire with its two ends (0 begin, 1 end of its model). */
struct WireWithEnds {
  Strand strand;
  std::array<End, 2> ends;
  std::array<bool, 2> leaves = {}; ///< another line there, as service drops do

  const SpanModel&
  model() const
  {
    return strand.piece.model;
  }

  double
  edge(int side) const
  {
    return side == 0 ? model().begin : model().end;
  }

  /** \brief Horizontal unit vector out of the wire at one end. */
  Eigen::Vector2d
  outward(int side) const
  {
    return side == 0 ? Eigen::Vector2d(-model().direction) : model().direction;
  }
};

/** \brief A horizontal line that attachment points of one support lie near: the
 * crossarm. */
struct Crossarm {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d along =
      Eigen::Vector2d::UnitX(); ///< direction of the line, unit length
  double turn = 0;    ///< tangent of the crossarm's angle to the perpendicular of along
  double spread = -1; ///< standard deviation of attachment points off it; < 0: unknown
};

/** \brief Where two wires meet that face each other: their closest approach, near their
 * ends and near the crossarm if one is known.
 *
 * Their attachment points are one and the same where the gap is no larger than the
 * models and the scatter of their points leave open; else each stays on its own wire.
 */
struct Meeting {
  double a = 0, b = 0; ///< place along each model
  double gap = 0;      ///< distance there, meters
  std::array<Point, 2> places = {Point::Zero(), Point::Zero()}; ///< attachment points
};

Meeting
meet(const WireWithEnds& a,
     int side_a,
     const WireWithEnds& b,
     int side_b,
     const Crossarm& arm = {});

/** \brief Carries wires on, across gaps, as far as those beside them reach. */
void
completeByCompany(std::vector<WireWithEnds>& wires,
                  Growth& growth,
                  const PowerLineSettings& settings);

/** \brief Splits low wires where a pole stands below them: in a dip of the terrain a
 * line runs over its poles without a kink. What sticks out beyond a last pole is cut
 * off. */
void
splitAtPoles(std::vector<WireWithEnds>& wires, Growth& growth);

/** \brief Adds wires that are short because the data end: they go on from the end of
 * another wire, or run beside one. */
void
addStubs(std::vector<WireWithEnds>& wires,
         Growth& growth,
         const std::vector<Seed>& seeds,
         const Underside& underside,
         const PowerLineSettings& settings);

/** \brief Whether the data end within a few meters beyond one end of \a model. */
bool
leavesData(const SpanModel& model, int side, const Underside& underside);

/** \brief Drops what only looks like a wire. A wire ends at a support or at the border
 * of the data; short families of wires inside the data with neither, or without sag,
 * are chords of booms and crossarms, and straight steep loose pieces are ropes. Their
 * points become free. Ends must have been matched.
 * \param[in] terrain whether the cloud shows any: then lines hang clear of it */
void
dropUnlikely(std::vector<WireWithEnds>& wires,
             Growth& growth,
             const Underside& underside,
             bool terrain,
             const PowerLineSettings& settings);

/** \brief Drops wires whose attachment points do not fit their points: too close
 * together, or off the wire. What was left of a span behind a pole is like that.
 * \return whether there were any */
bool
dropMisled(std::vector<WireWithEnds>& wires, Growth& growth);

/** \brief Whether more wires of a line run past a place without an end than the \a
 * ending that end there: then no support stands there. */
bool
isPassedBy(const std::vector<WireWithEnds>& wires,
           const Point& place,
           const Eigen::Vector2d& along,
           std::size_t ending);

/** \brief Joins partners that meet where the rest of their line runs past: no support
 * breaks them, but too few points, or a bundle of which each took another conductor.
 * Ends must have been matched, and have to be again.
 * \return whether there were any */
bool
mendBreaks(std::vector<WireWithEnds>& wires,
           Growth& growth,
           const PowerLineSettings& settings);

/** \brief Makes partners of ends that face each other across a support, best first. */
void
matchEnds(std::vector<WireWithEnds>& wires);

} // namespace linelet::powerline
