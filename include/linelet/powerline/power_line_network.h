// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/powerline/ground.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Classes of LAS 1.4 (ASPRS) that linelet assigns. */
constexpr std::uint8_t wire_class = 14;
constexpr std::uint8_t pylon_class = 15;     ///< transmission tower; poles as well
constexpr std::uint8_t connector_class = 16; ///< insulators between wire and structure
constexpr std::uint8_t unclassified = 1;

/** \brief A hanging wire: a catenary in a plane that wind may have swung out.
 *
 * With d the horizontal unit vector of \ref azimuth, r the one to its right and phi the
 * \ref swing,
 *
 *     p(s) = lowest + s d + a (cosh(s / a) - 1) (cos(phi) z + sin(phi) r),
 *
 * with s from \ref from to \ref to. The lowest point may lie outside the span. */
struct Catenary {
  Point lowest = Point::Zero(); ///< vertex of the curve
  double a = 1000;    ///< horizontal tension over weight per length, meters; > 0
  double azimuth = 0; ///< degrees clockwise from +y (north), [0, 360)
  double swing = 0;   ///< degrees from the vertical, positive to the right; 0: no wind
  double from = 0;    ///< s of the front end, meters
  double to = 0;      ///< s of the back end, > from

  /** \brief The point at \a s, meters along the azimuth from the lowest point. */
  Point
  at(double s) const;

  /** \brief s of the point of the curve beside \a p (at the same distance along the
   * azimuth). */
  double
  along(const Point& p) const;

  /** \brief Distance of \a p from the curve in the plane perpendicular to it, meters.
   */
  double
  distance(const Point& p) const;

  /** \brief Vertices from front to back; the edges deviate from the curve by at most \a
   * deviation, meters. */
  Points
  polyline(double deviation = 0.005) const;
};

/** \brief The closest approach of something below or beside a wire. */
struct Clearance {
  /// Meters; NaN: nothing near
  double distance = std::numeric_limits<double>::quiet_NaN();
  Point wire = Point::Zero();  ///< place on the wire
  Point other = Point::Zero(); ///< place on the ground, or point of the object

  /** \brief Whether anything was near enough to be measured. */
  bool
  known() const
  {
    return distance == distance;
  }
};

/** \brief A reviewer's verdict on a wire. */
struct Review {
  enum class Verdict {
    None,     ///< not reviewed
    Accepted, ///< it is a wire
    Rejected  ///< it is not a wire
  };
  Verdict verdict = Verdict::None;
  int point_class = -1; ///< class for its points, 0 to 255; -1: the wire class
  std::string note;

  bool
  empty() const
  {
    return verdict == Verdict::None && point_class < 0 && note.empty();
  }
};

/** \brief One wire (or bundle) in one span. */
struct Wire {
  int id = 0;      ///< index in PowerLineNetwork::wires + 1; 0 means no wire
  int span = 0;    ///< id of its span
  int circuit = 0; ///< id of its circuit (chain of spans)
  /// 1, 2, ... across the span, from left to right, then downward; the same for a
  /// conductor from span to span where it can be followed
  int number = 0;
  Catenary curve;
  Point front = Point::Zero(),
        back = Point::Zero();              ///< end points, = curve at its ends
  int front_support = 0, back_support = 0; ///< ids of the supports there; 0: none seen
  int conductors = 1; ///< 2: a bundle of two or more conductors that the points do not
                      ///< resolve everywhere
  std::size_t points = 0; ///< number of cloud points that it explains
  double rms = 0;         ///< of their distances to the curve, meters
  double length = 0;      ///< along the curve, meters
  double span_length = 0; ///< horizontal distance between the end points, meters
  double sag = 0;         ///< largest vertical distance from the chord, meters
  double largest_gap = 0; ///< longest stretch without a point, meters
  Clearance ground;       ///< lowest vertical clearance to the terrain
  Clearance vegetation;  ///< smallest distance to a point above ground that is not part
                         ///< of the line (trees, bushes, houses)
  double confidence = 1; ///< [0, 1]
  std::string reason;    ///< why the confidence is low; empty if it is not
  Review review;         ///< see review.h
};

/** \brief Vertices of \a wire from its front to its back point; wires that meet at a
 * support share that point exactly. */
Points
polyline(const Wire& wire, double deviation = 0.005);

/** \brief All wires between two neighboring supports. */
struct Span {
  int id = 0;      ///< index in PowerLineNetwork::spans + 1
  int circuit = 0; ///< id of its circuit
  int number = 0;  ///< 1, 2, ... along the circuit
  int from_support = 0,
      to_support = 0;     ///< ids; 0: none seen (at the edge of the data, for example)
  std::vector<int> wires; ///< ids, by wire number
  double length = 0;      ///< mean horizontal length of its wires, meters
  double azimuth = 0; ///< degrees clockwise from +y, in the direction of the circuit
};

/** \brief A pylon or pole. */
struct Support {
  enum class Kind {
    Pylon, ///< a tower: wider than a pole
    Pole   ///< all points within half a meter or so of one axis
  };
  int id = 0; ///< index in PowerLineNetwork::supports + 1
  Kind kind = Kind::Pylon;
  Point base = Point::Zero(); ///< on the ground; if unknown, its lowest point
  Point top = Point::Zero();  ///< above the base, at the height of its highest point
  double height = 0;          ///< top - base, meters; NaN if the ground is unknown
  /// Number of cloud points assigned to it; 0: inferred from wires alone
  std::size_t points = 0;
  double confidence = 1; ///< [0, 1]
};

/** \brief The loop that carries the current past a support: from the end of a conductor
 * on one side to the same phase on the other, clear of the structure. */
struct Jumper {
  int id = 0;      ///< index in PowerLineNetwork::jumpers + 1
  int support = 0; ///< id; 0: removed
  /// Ids of the wires that it connects; for a bundle drawn as several wires, one of
  /// them; 0: removed
  int from_wire = 0, to_wire = 0;
  Points course;          ///< vertices, from clamp to clamp
  double length = 0;      ///< along the course, meters
  double sag = 0;         ///< largest vertical distance below the chord, meters
  double rms = 0;         ///< of the distances of its points to the course, meters
  std::size_t points = 0; ///< number of its cloud points
};

/** \brief A string of insulators, or several side by side, between a structure and a
 * live part. */
struct InsulatorString {
  enum class Kind {
    Tension,    ///< in line with a wire that ends here
    Suspension, ///< a wire hangs from it
    Jumper      ///< a jumper hangs from it
  };
  int id = 0; ///< index in PowerLineNetwork::insulators + 1
  Kind kind = Kind::Tension;
  int support = 0; ///< id; 0: removed
  int wire = 0;    ///< id of the wire that it holds; 0: none
  int jumper = 0;  ///< id of the jumper that it holds or that begins there; 0: none
  Point structure = Point::Zero(), live = Point::Zero(); ///< its ends
  double length = 0;                                     ///< between them, meters
  std::size_t points = 0;                                ///< number of its cloud points
};

/** \brief A circuit: spans that follow each other from support to support. */
struct Circuit {
  int id = 0;                ///< index in PowerLineNetwork::circuits + 1
  std::vector<int> spans;    ///< ids, in order
  std::vector<int> supports; ///< ids, in order, one more than spans; 0: none seen
};

/** \brief Something above ground that looks like a line at its own scale but belongs to
 * no wire or support found: a missed wire, or a crane, pipe, ridge or fence. */
struct UnexplainedLine {
  int id = 0;             ///< index in PowerLineNetwork::unexplained + 1
  Points course;          ///< vertices, from one end to the other
  double length = 0;      ///< meters
  double width = 0;       ///< standard deviation of its points about it, meters
  std::size_t points = 0; ///< number of its cloud points that nothing explains
};

/** \brief Time that a stage took. */
struct StageTime {
  std::string stage;
  double seconds = 0;
};

/** \brief What \ref extractPowerLines found, in the coordinates of its input, or in
 * meters from the same origin (MetricFrame) if the input is not in meters. */
struct PowerLineNetwork {
  std::vector<Wire> wires;
  std::vector<Span> spans;
  std::vector<Support> supports;
  std::vector<Circuit> circuits;
  std::vector<Jumper> jumpers;              ///< by support
  std::vector<InsulatorString> insulators;  ///< by support
  std::vector<UnexplainedLine> unexplained; ///< the longest first

  /// \name One entry per point, in input order
  /// @{
  /// 14 wire or jumper, 15 pylon or pole, 16 insulator; else as given, but 1 where 14
  /// or 15 was given
  std::vector<std::uint8_t> classes;
  std::vector<std::int32_t> wire_id;        ///< 0: none, or a jumper
  std::vector<std::int32_t> span_id;        ///< 0: none
  std::vector<float> wire_distance;         ///< to its wire, meters; NaN: none
  std::vector<std::uint8_t> is_unexplained; ///< 1: point of an \ref unexplained line
  /// @}

  Ground ground; ///< terrain, for profiles and clearances; without heights if the cloud
                 ///< has no ground
  std::vector<StageTime> stages; ///< in order
};

/** \brief Total length of the unexplained lines, meters. */
double
unexplainedLength(const PowerLineNetwork& network);

/** \brief Whether so much is unexplained that the network may lack whole wires: more
 * than a twentieth of the length of the wires found, and more than a short span (25 m).
 */
bool
muchIsUnexplained(const PowerLineNetwork& network);

} // namespace powerline

template <>
struct Names<powerline::InsulatorString::Kind> {
  static constexpr std::string_view kind = "kind of insulator string";
  static constexpr std::
      array<std::pair<powerline::InsulatorString::Kind, std::string_view>, 3>
          table = {{{powerline::InsulatorString::Kind::Tension, "tension"},
                    {powerline::InsulatorString::Kind::Suspension, "suspension"},
                    {powerline::InsulatorString::Kind::Jumper, "jumper"}}};
};

template <>
struct Names<powerline::Review::Verdict> {
  static constexpr std::string_view kind = "verdict";
  static constexpr std::array<std::pair<powerline::Review::Verdict, std::string_view>,
                              3>
      table = {{{powerline::Review::Verdict::None, ""},
                {powerline::Review::Verdict::Accepted, "accepted"},
                {powerline::Review::Verdict::Rejected, "rejected"}}};
};

} // namespace linelet
