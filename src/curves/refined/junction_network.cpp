// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
#include "junction_network.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <linelet/search/uniform_grid.h>

namespace linelet {

namespace {

// Curves that run within 20 degrees of each other are side by side.
constexpr double side_by_side = 0.94;

constexpr auto none = static_cast<std::size_t>(-1);

/** \brief A place inside a curve, on the edge that begins at vertex \a edge. */
struct Place {
  std::size_t curve = none, edge = 0;
  double along = 0; // of the edge, 0 to 1
  Point position = Point::Zero();
};

/** \brief Ends that meet, and the places inside curves that they meet. */
struct Meeting {
  std::vector<std::size_t> ends;
  std::vector<Place> places;
};

class Connector {
public:
  Connector(CurveNetwork& network, const std::vector<std::array<EndReach, 2>>& reaches)
      : network_(network), reaches_(reaches), grid_({}, 1)
  {
  }

  void
  run();

private:
  // Ends are named 2 * curve + (0 front, 1 back).
  const Curve&
  curveOf(std::size_t end) const
  {
    return network_.curves[end / 2];
  }
  const EndReach&
  reachOf(std::size_t end) const
  {
    return reaches_[end / 2][end % 2];
  }
  const Point&
  vertex(std::size_t end, std::size_t steps) const
  {
    const Points& points = curveOf(end).points;
    return points[end % 2 == 0 ? steps : points.size() - 1 - steps];
  }
  bool
  isOpen(std::size_t end) const
  {
    return !curveOf(end).closed && curveOf(end).points.size() > 1;
  }

  Point
  outward(std::size_t end) const;
  bool
  meets(std::size_t end, std::size_t other) const;
  Place
  nearestPlace(std::size_t end) const;
  std::vector<Meeting>
  meetings() const;
  void
  closeLoops();
  void
  leadTo(std::size_t end, const Point& position);

  CurveNetwork& network_;
  const std::vector<std::array<EndReach, 2>>& reaches_;
  UniformGrid grid_;                  // of all vertices
  std::vector<std::size_t> curve_of_; // by vertex
  std::vector<std::size_t> first_;    // vertex of each curve
  double longest_edge_ = 0;
};

/** \brief Unit vector that leads out of the curve over the last stretch as long as the
 * end's distance. */
Point
Connector::outward(std::size_t end) const
{
  const std::size_t n = curveOf(end).points.size();
  std::size_t k = 1;
  while (k + 1 < n && (vertex(end, k) - vertex(end, 0)).norm() < reachOf(end).distance)
    ++k;
  return (vertex(end, 0) - vertex(end, k)).normalized();
}

bool
Connector::meets(std::size_t end, std::size_t other) const
{
  const double distance = std::min(reachOf(end).distance, reachOf(other).distance);
  return (vertex(end, 0) - vertex(other, 0)).norm() <= distance &&
         outward(end).dot(outward(other)) < side_by_side;
}

/** \brief The nearest place inside a curve that \a end meets; its curve is none where
 * there is no such place. */
Place
Connector::nearestPlace(std::size_t end) const
{
  Place best;
  const Point& tip = vertex(end, 0);
  const Point direction = outward(end);
  const EndReach& reach = reachOf(end);
  double best_distance = reach.distance;
  const auto look = [&](std::size_t c, std::size_t e) {
    const Curve& curve = network_.curves[c];
    const std::size_t n = curve.points.size();
    if (e >= n || (e + 1 == n && !curve.closed))
      return;
    const Point& from = curve.points[e];
    const Point edge = curve.points[e + 1 == n ? 0 : e + 1] - from;
    const double squared = edge.squaredNorm();
    const double t =
        squared > 0 ? std::clamp((tip - from).dot(edge) / squared, 0.0, 1.0) : 0;
    const Point position = from + t * edge;
    const double distance = (position - tip).norm();
    if (distance > best_distance ||
        std::abs(direction.dot(edge)) >= side_by_side * std::sqrt(squared))
      return;
    // The very end of an open curve is for ends to meet.
    if (!curve.closed && ((e == 0 && t <= 0) || (e + 2 == n && t >= 1)))
      return;
    if (c == end / 2) {
      double walked = 0;
      const std::size_t steps = end % 2 == 0 ? e : n - 2 - e;
      for (std::size_t k = 0; k < steps; ++k)
        walked += (vertex(end, k + 1) - vertex(end, k)).norm();
      if (walked < reach.loop)
        return;
    }
    best_distance = distance;
    best = {c, e, t, position};
  };
  grid_.forEachWithin(tip, reach.distance + longest_edge_, [&](Index v, double) {
    const std::size_t c = curve_of_[v];
    const std::size_t e = v - first_[c];
    look(c, e);
  });
  return best;
}

std::vector<Meeting>
Connector::meetings() const
{
  Points tips;
  std::vector<std::size_t> ends;
  double widest = 0;
  for (std::size_t end = 0; end < 2 * network_.curves.size(); ++end)
    if (isOpen(end)) {
      ends.push_back(end);
      tips.push_back(vertex(end, 0));
      widest = std::max(widest, reachOf(end).distance);
    }
  if (ends.empty() || !(widest > 0))
    return {};
  std::vector<std::size_t> group(ends.size());
  std::iota(group.begin(), group.end(), std::size_t(0));
  const auto root = [&](std::size_t i) {
    while (group[i] != i)
      i = group[i] = group[group[i]];
    return i;
  };
  const auto unite = [&](std::size_t i, std::size_t j) {
    const std::size_t a = root(i), b = root(j);
    group[std::max(a, b)] = std::min(a, b);
  };
  std::vector<Place> places(ends.size());
  const UniformGrid tip_grid(tips, widest);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    tip_grid.forEachWithin(tips[i], reachOf(ends[i]).distance, [&](Index j, double) {
      if (ends[j] / 2 != ends[i] / 2 && meets(ends[i], ends[j]))
        unite(i, j);
    });
    places[i] = nearestPlace(ends[i]);
  }
  // Ends that meet one curve at one place.
  Points positions;
  for (const Place& place : places)
    positions.push_back(place.curve == none ? Point::Constant(std::nan(""))
                                            : place.position);
  const UniformGrid place_grid(positions, widest);
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (places[i].curve != none)
      place_grid.forEachWithin(
          positions[i], reachOf(ends[i]).distance, [&](Index j, double) {
            if (places[j].curve == places[i].curve)
              unite(i, j);
          });

  std::vector<Meeting> result(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Meeting& meeting = result[root(i)];
    meeting.ends.push_back(ends[i]);
    if (places[i].curve != none)
      meeting.places.push_back(places[i]);
  }
  // A curve one of whose ends meets is no curve that passes.
  for (Meeting& meeting : result) {
    const auto ends_here = [&](const Place& place) {
      return std::count(meeting.ends.begin(), meeting.ends.end(), 2 * place.curve) +
                 std::count(
                     meeting.ends.begin(), meeting.ends.end(), 2 * place.curve + 1) >
             0;
    };
    if (meeting.ends.size() > 1)
      meeting.places.erase(
          std::remove_if(meeting.places.begin(), meeting.places.end(), ends_here),
          meeting.places.end());
  }
  result.erase(std::remove_if(result.begin(),
                              result.end(),
                              [](const Meeting& meeting) {
                                return meeting.ends.size() < 2 &&
                                       meeting.places.empty();
                              }),
               result.end());
  return result;
}

/** \brief Closes the curves whose own ends meet. */
void
Connector::closeLoops()
{
  for (std::size_t c = 0; c < network_.curves.size(); ++c) {
    Curve& curve = network_.curves[c];
    if (!isOpen(2 * c) || curve.points.size() < 4 || !meets(2 * c, 2 * c + 1) ||
        length(curve) < reaches_[c][0].loop)
      continue;
    curve.closed = true;
    curve.front = curve.back = {EndKind::Loop, -1};
  }
}

void
Connector::leadTo(std::size_t end, const Point& position)
{
  Curve& curve = network_.curves[end / 2];
  if (end % 2 == 0) {
    std::reverse(curve.points.begin(), curve.points.end());
    std::reverse(curve.support.begin(), curve.support.end());
  }
  const double spacing =
      length(curve) /
      static_cast<double>(std::max<std::size_t>(curve.points.size(), 2) - 1);
  // What lies past the junction, or beside it, goes.
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
  // As finely as the rest, so that little more than the junction itself lies on an edge
  // between two curves.
  curve.points.pop_back();
  const Point from = curve.points.back();
  const double parts =
      spacing > 0 ? std::max(1.0, std::round((position - from).norm() / spacing)) : 1;
  for (double k = 1; k < parts; ++k)
    curve.points.emplace_back(from + k / parts * (position - from));
  curve.points.push_back(position); // to the last bit
  if (!curve.support.empty())
    curve.support.insert(
        curve.support.end() - 1, static_cast<std::size_t>(parts) - 1, 0);
  if (end % 2 == 0) {
    std::reverse(curve.points.begin(), curve.points.end());
    std::reverse(curve.support.begin(), curve.support.end());
  }
}

void
Connector::run()
{
  closeLoops();
  Points vertices;
  double widest = 0;
  for (std::size_t c = 0; c < network_.curves.size(); ++c) {
    const Curve& curve = network_.curves[c];
    const std::size_t n = curve.points.size();
    first_.push_back(vertices.size());
    for (std::size_t k = 0; k < n; ++k) {
      vertices.push_back(curve.points[k]);
      curve_of_.push_back(c);
      if (k + 1 < n || curve.closed)
        longest_edge_ =
            std::max(longest_edge_,
                     (curve.points[k + 1 == n ? 0 : k + 1] - curve.points[k]).norm());
    }
    widest = std::max({widest, reaches_[c][0].distance, reaches_[c][1].distance});
  }
  if (vertices.empty() || !(widest > 0))
    return;
  grid_ = UniformGrid(vertices, widest + longest_edge_);

  std::vector<Place> inserted;
  std::vector<std::pair<std::size_t, Point>> led;
  for (const Meeting& meeting : meetings()) {
    Junction junction;
    if (meeting.places.empty()) {
      for (const std::size_t end : meeting.ends)
        junction.position += vertex(end, 0);
      junction.position /= static_cast<double>(meeting.ends.size());
    }
    else {
      junction.position = meeting.places.front().position;
      inserted.push_back(meeting.places.front());
    }
    const int number = static_cast<int>(network_.junctions.size());
    for (const std::size_t end : meeting.ends) {
      Curve& curve = network_.curves[end / 2];
      (end % 2 == 0 ? curve.front : curve.back) = {EndKind::Junction, number};
      junction.curves.push_back(end / 2);
      led.emplace_back(end, junction.position);
    }
    for (const Place& place : meeting.places)
      junction.curves.push_back(place.curve);
    std::sort(junction.curves.begin(), junction.curves.end());
    junction.curves.erase(std::unique(junction.curves.begin(), junction.curves.end()),
                          junction.curves.end());
    network_.junctions.push_back(std::move(junction));
  }
  // From the back, so that the edges before keep their numbers.
  std::sort(inserted.begin(), inserted.end(), [](const Place& a, const Place& b) {
    return a.edge != b.edge ? a.edge > b.edge : a.along > b.along;
  });
  for (const Place& place : inserted) {
    Curve& curve = network_.curves[place.curve];
    const auto at = static_cast<std::ptrdiff_t>(place.edge + 1);
    curve.points.insert(curve.points.begin() + at, place.position);
    if (!curve.support.empty())
      curve.support.insert(curve.support.begin() + at, 0);
  }
  for (const auto& [end, position] : led)
    leadTo(end, position);
}

} // namespace

void
connectEnds(CurveNetwork& network, const std::vector<std::array<EndReach, 2>>& reaches)
{
  Connector(network, reaches).run();
}

} // namespace linelet
