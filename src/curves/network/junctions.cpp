// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "junctions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meetings.h"

namespace linelet {

namespace {

/** \brief Closes the curves whose own ends meet. */
void
closeLoops(CurveNetwork& network, const EndReaches& reaches)
{
  const CurveEnds ends(network, reaches);
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    Curve& curve = network.curves[c];
    if (!ends.isOpen(2 * c) || curve.points.size() < 4 ||
        !ends.meet(2 * c, 2 * c + 1) || length(curve) < reaches[c][0].loop)
      continue;
    curve.closed = true;
    curve.front = curve.back = {EndKind::Loop, -1};
  }
}

/** \brief The junction of \a meeting: on the curve that passes, otherwise amid the
 * ends. */
Junction
junctionOf(const CurveNetwork& network, const Meeting& meeting)
{
  Junction result;
  for (const std::size_t end : meeting.ends) {
    const Points& points = network.curves[end / 2].points;
    result.position += end % 2 == 0 ? points.front() : points.back();
    result.curves.push_back(end / 2);
  }
  result.position /= static_cast<double>(meeting.ends.size());
  if (!meeting.places.empty())
    result.position = meeting.places.front().position;
  for (const Place& place : meeting.places)
    result.curves.push_back(place.curve);
  std::sort(result.curves.begin(), result.curves.end());
  result.curves.erase(std::unique(result.curves.begin(), result.curves.end()),
                      result.curves.end());
  return result;
}

/** \brief Adds the junction of \a meeting and marks the ends joined there. */
void
addJunction(CurveNetwork& network, const Meeting& meeting)
{
  const int number = static_cast<int>(network.junctions.size());
  network.junctions.push_back(junctionOf(network, meeting));
  for (const std::size_t end : meeting.ends) {
    Curve& curve = network.curves[end / 2];
    (end % 2 == 0 ? curve.front : curve.back) = {EndKind::Junction, number};
  }
}

/** \brief Adds the junctions inside curves as vertices. */
void
insertVertices(CurveNetwork& network, const std::vector<Meeting>& meetings)
{
  std::vector<Place> places;
  for (const Meeting& meeting : meetings)
    if (!meeting.places.empty())
      places.push_back(meeting.places.front());
  // From the back, so that earlier edges keep their numbers.
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.edge != b.edge ? a.edge > b.edge : a.along > b.along;
  });
  for (const Place& place : places) {
    Curve& curve = network.curves[place.curve];
    const auto at = static_cast<std::ptrdiff_t>(place.edge + 1);
    curve.points.insert(curve.points.begin() + at, place.position);
    if (!curve.support.empty())
      curve.support.insert(curve.support.begin() + at, 0);
  }
}

/** \brief Reverses the vertices; front and back keep their kinds. */
void
reverseVertices(Curve& curve)
{
  std::reverse(curve.points.begin(), curve.points.end());
  std::reverse(curve.support.begin(), curve.support.end());
}

/** \brief Removes vertices from the back of \a curve that lie past \a position, or
 * beside it. */
void
cutBack(Curve& curve, const Point& position)
{
  const double moved = (curve.points.back() - position).norm();
  while (curve.points.size() > 2 &&
         (curve.points[curve.points.size() - 2] - position).norm() <= moved) {
    curve.points.pop_back();
    if (!curve.support.empty()) {
      const Index count = curve.support.back();
      curve.support.pop_back();
      curve.support.back() += count;
    }
  }
}

/** \brief Leads the last edge of \a curve to \a position, in edges of about \a
 * spacing. */
void
moveBackTo(Curve& curve, const Point& position, double spacing)
{
  // As finely as the rest, so that little besides the junction lies on an edge between
  // two curves.
  curve.points.pop_back();
  const Point from = curve.points.back();
  const double parts =
      spacing > 0 ? std::max(1.0, std::round((position - from).norm() / spacing)) : 1;
  for (double k = 1; k < parts; ++k)
    curve.points.emplace_back(from + k / parts * (position - from));
  curve.points.push_back(position); // exactly
  if (!curve.support.empty())
    curve.support.insert(
        curve.support.end() - 1, static_cast<std::size_t>(parts) - 1, 0);
}

void
leadTo(Curve& curve, bool at_front, const Point& position)
{
  if (at_front)
    reverseVertices(curve);
  const double spacing =
      length(curve) /
      static_cast<double>(std::max<std::size_t>(curve.points.size(), 2) - 1);
  cutBack(curve, position);
  moveBackTo(curve, position, spacing);
  if (at_front)
    reverseVertices(curve);
}

} // namespace

void
connectEnds(CurveNetwork& network, const EndReaches& reaches)
{
  closeLoops(network, reaches);
  const std::vector<Meeting> meetings = findMeetings(network, reaches);
  for (const Meeting& meeting : meetings)
    addJunction(network, meeting);
  insertVertices(network, meetings);
  for (std::size_t m = 0; m < meetings.size(); ++m)
    for (const std::size_t end : meetings[m].ends)
      leadTo(network.curves[end / 2], end % 2 == 0, network.junctions[m].position);
}

} // namespace linelet
