// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/unexplained.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double least_part = 0.05; // of the length of the wires: that is much
constexpr double short_span = 25;   // meters
constexpr double widths = 2.5;      // of a line, within which a point is part of it
constexpr double narrowest = 0.1;   // meters, the same
constexpr std::size_t fewest = 8;   // points of a line

bool
isExplained(const PowerLineNetwork& network, std::size_t input)
{
  const std::uint8_t found = network.classes[input];
  return found == wire_class || found == pylon_class || found == connector_class;
}

/** A step along a line: its points, and those that nothing else explains. */
struct Step {
  std::size_t all = 0;
  Indices open; ///< candidates
};

Points
evenly(const Points& course, double step)
{
  Points places = {course.front()};
  for (std::size_t v = 1; v < course.size(); ++v) {
    const Point edge = course[v] - course[v - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(edge.norm() / step)));
    for (int k = 1; k <= pieces; ++k)
      places.push_back(course[v - 1] + edge * (k / static_cast<double>(pieces)));
  }
  return places;
}

/** Walks along lines, so that every point is counted for the first that has it. */
class Search {
public:
  Search(PowerLineNetwork& network,
         const Candidates& candidates,
         const PowerLineSettings& settings)
      : network_(network),
        candidates_(candidates),
        settings_(settings),
        taken_(candidates.points.size(), 0)
  {
  }

  void
  follow(const SeenLine& line)
  {
    if (line.course.size() < 2)
      return;
    const Points places = evenly(line.course, bin_length);
    std::vector<Step> steps;
    for (std::size_t k = 1; k < places.size(); ++k)
      steps.push_back(look(places[k - 1], places[k], line.width));
    // From the first step with an open point to the last before a gap.
    std::size_t from = 0, last = 0, gap = 0;
    bool inside = false;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (2 * steps[k].open.size() > steps[k].all) {
        if (!inside)
          from = k;
        inside = true;
        last = k;
        gap = 0;
      }
      else if (inside && (steps[k].all > 0 ||
                          static_cast<double>(++gap) * bin_length > growth_gap)) {
        add(line, places, steps, from, last);
        inside = false;
        gap = 0;
      }
    }
    if (inside)
      add(line, places, steps, from, last);
  }

private:
  Step
  look(const Point& from, const Point& to, double width) const
  {
    const Point edge = to - from;
    const double reach = std::max(narrowest, widths * width);
    const double squared = std::max(edge.squaredNorm(), 1e-12);
    Step step;
    candidates_.grid.forEachWithin(
        from + edge / 2, std::hypot(edge.norm() / 2, reach), [&](Index i, double) {
          const Point offset = candidates_.points[i] - from;
          const double s = offset.dot(edge) / squared;
          if (s < 0 || s >= 1 || (offset - s * edge).norm() > reach)
            return;
          ++step.all;
          if (taken_[i] == 0 && !isExplained(network_, candidates_.input[i]))
            step.open.push_back(i);
        });
    return step;
  }

  void
  add(const SeenLine& line,
      const Points& places,
      const std::vector<Step>& steps,
      std::size_t from,
      std::size_t last)
  {
    UnexplainedLine found;
    found.course.assign(places.begin() + static_cast<std::ptrdiff_t>(from),
                        places.begin() + static_cast<std::ptrdiff_t>(last) + 2);
    found.width = line.width;
    for (std::size_t v = 1; v < found.course.size(); ++v)
      found.length += (found.course[v] - found.course[v - 1]).norm();
    for (std::size_t k = from; k <= last; ++k)
      found.points += steps[k].open.size();
    if (found.length < settings_.min_length || found.points < fewest)
      return;
    for (std::size_t k = from; k <= last; ++k)
      for (const Index i : steps[k].open) {
        taken_[i] = 1;
        network_.is_unexplained[candidates_.input[i]] = 1;
      }
    network_.unexplained.push_back(std::move(found));
  }

  PowerLineNetwork& network_;
  const Candidates& candidates_;
  const PowerLineSettings& settings_;
  std::vector<char> taken_;
};

} // namespace

SeenLine
seenLine(const Piece& piece)
{
  SeenLine line;
  const SpanModel& m = piece.model;
  const int steps = std::max(1, static_cast<int>(std::ceil(m.length() / bin_length)));
  for (int k = 0; k <= steps; ++k)
    line.course.push_back(m.at(m.begin + k * m.length() / steps));
  line.width = std::max(m.sigma, piece.thickness / 2);
  return line;
}

void
findUnexplained(PowerLineNetwork& network,
                const std::vector<SeenLine>& lines,
                const Candidates& candidates,
                const PowerLineSettings& settings)
{
  network.is_unexplained.assign(network.classes.size(), 0);
  Search search(network, candidates, settings);
  for (const SeenLine& line : lines)
    search.follow(line);
  std::stable_sort(network.unexplained.begin(),
                   network.unexplained.end(),
                   [](const UnexplainedLine& a, const UnexplainedLine& b) {
                     return a.length > b.length;
                   });
  int id = 0;
  for (UnexplainedLine& line : network.unexplained)
    line.id = ++id;
}

double
unexplainedLength(const PowerLineNetwork& network)
{
  return std::accumulate(
      network.unexplained.begin(),
      network.unexplained.end(),
      0.0,
      [](double sum, const UnexplainedLine& line) { return sum + line.length; });
}

bool
muchIsUnexplained(const PowerLineNetwork& network)
{
  double wires = 0;
  for (const Wire& wire : network.wires)
    wires += wire.length;
  return unexplainedLength(network) > std::max(short_span, least_part * wires);
}

} // namespace linelet::powerline
