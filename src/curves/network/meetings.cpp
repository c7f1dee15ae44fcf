// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "meetings.h"

#include <algorithm>
#include <cmath>

#include <linelet/search/uniform_grid.h>

#include "support/groups.h"

namespace linelet {

namespace {

// Curves that run within 20 degrees of each other are side by side.
constexpr double side_by_side = 0.94;

std::size_t
edgesOf(const Curve& curve)
{
  const std::size_t n = curve.points.size();
  return curve.closed || n == 0 ? n : n - 1;
}

/** \brief Edge \a e of \a curve as a vector. */
Point
edgeOf(const Curve& curve, std::size_t e)
{
  return curve.points[e + 1 == curve.points.size() ? 0 : e + 1] - curve.points[e];
}

/** \brief Finds the places inside curves that ends meet. */
class PlaceFinder {
public:
  PlaceFinder(const CurveNetwork& network, const CurveEnds& ends);

  /** \brief The nearest place inside a curve that \a end meets; its curve is none if
   * there is no such place. */
  Place
  nearest(std::size_t end) const;

private:
  Place
  nearestOnEdge(std::size_t c, std::size_t e, const Point& point) const;
  bool
  isTip(const Place& place) const;
  bool
  runsBeside(const Point& direction, const Place& place) const;

  const CurveNetwork& network_;
  const CurveEnds& ends_;
  UniformGrid grid_;                  // of all vertices
  std::vector<std::size_t> curve_of_; // by vertex
  std::vector<std::size_t> first_;    // vertex of each curve
  double longest_edge_ = 0;
};

PlaceFinder::PlaceFinder(const CurveNetwork& network, const CurveEnds& ends)
    : network_(network), ends_(ends), grid_({}, 1)
{
  Points vertices;
  double widest = 0;
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    const Curve& curve = network.curves[c];
    first_.push_back(vertices.size());
    vertices.insert(vertices.end(), curve.points.begin(), curve.points.end());
    curve_of_.resize(vertices.size(), c);
    for (std::size_t e = 0; e < edgesOf(curve); ++e)
      longest_edge_ = std::max(longest_edge_, edgeOf(curve, e).norm());
    for (const std::size_t end : {2 * c, 2 * c + 1})
      widest = std::max(widest, ends.reachOf(end).distance);
  }
  grid_ = UniformGrid(vertices, widest + longest_edge_);
}

Place
PlaceFinder::nearest(std::size_t end) const
{
  Place best;
  const Point& tip = ends_.tip(end);
  const Point direction = ends_.outward(end);
  const EndReach& reach = ends_.reachOf(end);
  double best_distance = reach.distance;
  grid_.forEachWithin(tip, reach.distance + longest_edge_, [&](Index v, double) {
    const std::size_t c = curve_of_[v], e = v - first_[c];
    if (e >= edgesOf(network_.curves[c]))
      return;
    const Place place = nearestOnEdge(c, e, tip);
    const double distance = (place.position - tip).norm();
    if (distance > best_distance || runsBeside(direction, place) || isTip(place))
      return;
    // An end is always close to its own curve.
    if (c == end / 2 && ends_.arcTo(end, e) < reach.loop)
      return;
    best_distance = distance;
    best = place;
  });
  return best;
}

Place
PlaceFinder::nearestOnEdge(std::size_t c, std::size_t e, const Point& point) const
{
  const Curve& curve = network_.curves[c];
  const Point& from = curve.points[e];
  const Point edge = edgeOf(curve, e);
  const double squared = edge.squaredNorm();
  const double t =
      squared > 0 ? std::clamp((point - from).dot(edge) / squared, 0.0, 1.0) : 0;
  return {c, e, t, from + t * edge};
}

/** \brief Whether \a place is the tip of an open curve, where ends meet ends. */
bool
PlaceFinder::isTip(const Place& place) const
{
  const Curve& curve = network_.curves[place.curve];
  return !curve.closed && ((place.edge == 0 && place.along <= 0) ||
                           (place.edge + 1 == edgesOf(curve) && place.along >= 1));
}

bool
PlaceFinder::runsBeside(const Point& direction, const Place& place) const
{
  const Point edge = edgeOf(network_.curves[place.curve], place.edge);
  return std::abs(direction.dot(edge)) >= side_by_side * edge.norm();
}

/** \brief An open end, and the place inside a curve that it meets. */
struct OpenEnd {
  std::size_t name;
  Point tip;
  double distance;
  Place place;
};

std::vector<OpenEnd>
openEnds(const CurveEnds& ends)
{
  std::vector<OpenEnd> result;
  for (std::size_t end = 0; end < ends.size(); ++end)
    if (ends.isOpen(end))
      result.push_back({end, ends.tip(end), ends.reachOf(end).distance, {}});
  return result;
}

void
uniteTips(Groups& groups,
          const std::vector<OpenEnd>& open,
          const CurveEnds& ends,
          double widest)
{
  Points tips;
  for (const OpenEnd& end : open)
    tips.push_back(end.tip);
  const UniformGrid grid(tips, widest);
  for (std::size_t i = 0; i < open.size(); ++i)
    grid.forEachWithin(tips[i], open[i].distance, [&](Index j, double) {
      if (open[j].name / 2 != open[i].name / 2 && ends.meet(open[i].name, open[j].name))
        groups.unite(i, j);
    });
}

/** \brief Groups ends that meet the same curve at the same place. */
void
unitePlaces(Groups& groups, const std::vector<OpenEnd>& open, double widest)
{
  Points positions;
  std::vector<std::size_t> end_of;
  for (std::size_t i = 0; i < open.size(); ++i)
    if (open[i].place.curve != Place::none) {
      positions.push_back(open[i].place.position);
      end_of.push_back(i);
    }
  const UniformGrid grid(positions, widest);
  for (const std::size_t i : end_of)
    grid.forEachWithin(open[i].place.position, open[i].distance, [&](Index k, double) {
      if (open[end_of[k]].place.curve == open[i].place.curve)
        groups.unite(i, end_of[k]);
    });
}

/** \brief Drops places on curves of which an end takes part as well: such a curve does
 * not pass through. */
void
dropEnded(Meeting& meeting)
{
  const auto ends_here = [&](const Place& place) {
    return std::any_of(meeting.ends.begin(), meeting.ends.end(), [&](std::size_t end) {
      return end / 2 == place.curve;
    });
  };
  std::vector<Place>& places = meeting.places;
  places.erase(std::remove_if(places.begin(), places.end(), ends_here), places.end());
}

std::vector<Meeting>
meetingsOf(Groups& groups, const std::vector<OpenEnd>& open)
{
  std::vector<Meeting> result(open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    Meeting& meeting = result[groups.root(i)];
    meeting.ends.push_back(open[i].name);
    if (open[i].place.curve != Place::none)
      meeting.places.push_back(open[i].place);
  }
  for (Meeting& meeting : result)
    if (meeting.ends.size() > 1)
      dropEnded(meeting);
  const auto is_alone = [](const Meeting& meeting) {
    return meeting.ends.size() < 2 && meeting.places.empty();
  };
  result.erase(std::remove_if(result.begin(), result.end(), is_alone), result.end());
  return result;
}

} // namespace

Point
CurveEnds::outward(std::size_t end) const
{
  const std::size_t n = curveOf(end).points.size();
  std::size_t k = 1;
  while (k + 1 < n && (vertex(end, k) - tip(end)).norm() < reachOf(end).distance)
    ++k;
  return (tip(end) - vertex(end, k)).normalized();
}

double
CurveEnds::arcTo(std::size_t end, std::size_t edge) const
{
  const std::size_t n = curveOf(end).points.size();
  const std::size_t steps = end % 2 == 0 ? edge : n - 2 - edge;
  double result = 0;
  for (std::size_t k = 0; k < steps; ++k)
    result += (vertex(end, k + 1) - vertex(end, k)).norm();
  return result;
}

bool
CurveEnds::meet(std::size_t end, std::size_t other) const
{
  const double distance = std::min(reachOf(end).distance, reachOf(other).distance);
  return (tip(end) - tip(other)).norm() <= distance &&
         outward(end).dot(outward(other)) < side_by_side;
}

std::vector<Meeting>
findMeetings(const CurveNetwork& network, const EndReaches& reaches)
{
  const CurveEnds ends(network, reaches);
  std::vector<OpenEnd> open = openEnds(ends);
  double widest = 0;
  for (const OpenEnd& end : open)
    widest = std::max(widest, end.distance);
  if (!(widest > 0))
    return {};
  const PlaceFinder places(network, ends);
  for (OpenEnd& end : open)
    end.place = places.nearest(end.name);
  Groups groups(open.size());
  uniteTips(groups, open, ends, widest);
  unitePlaces(groups, open, widest);
  return meetingsOf(groups, open);
}

} // namespace linelet
