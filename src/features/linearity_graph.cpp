// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/linearity_graph.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace linelet {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A run of equal values among the defined scales: places first..last.
struct Run {
  std::size_t first, last;
  double value;
};

/// The defined scales of a graph.
struct Defined {
  std::vector<std::size_t> scale;
  std::vector<double> value;
  std::vector<double> position; ///< what the area integrates over
};

Defined
definedScales(const std::vector<double>& linearity,
              const std::vector<double>& radii,
              GraphIntegral integral)
{
  Defined graph;
  for (std::size_t k = 0; k < linearity.size(); ++k) {
    if (std::isnan(linearity[k]))
      continue;
    graph.scale.push_back(k);
    graph.value.push_back(linearity[k]);
    graph.position.push_back(integral == GraphIntegral::LogRadius ? std::log(radii[k])
                                                                  : radii[k]);
  }
  return graph;
}

/// Runs of the places from \a begin on. A run holds what differs little from its first
/// value, so that a slow ramp stays a ramp.
std::vector<Run>
runsFrom(const Defined& graph, std::size_t begin)
{
  std::vector<Run> runs;
  for (std::size_t i = begin; i < graph.value.size(); ++i) {
    if (!runs.empty() && std::abs(graph.value[i] - runs.back().value) <= flat_linearity)
      runs.back().last = i;
    else
      runs.push_back({i, i, graph.value[i]});
  }
  return runs;
}

/// Area under the graph between two places, both included.
double
area(const Defined& graph, std::size_t first, std::size_t last, GraphIntegral integral)
{
  double sum = 0;
  if (integral == GraphIntegral::Scales)
    for (std::size_t i = first; i <= last; ++i)
      sum += graph.value[i];
  else
    for (std::size_t i = first; i < last; ++i)
      sum += (graph.value[i] + graph.value[i + 1]) / 2 *
             (graph.position[i + 1] - graph.position[i]);
  return sum;
}

double
unit(double x)
{
  return std::clamp(x, 0.0, 1.0);
}

double
score(ScaleScore kind,
      double relative_scale,
      double linearity,
      double fraction,
      double delta)
{
  const double first = kind == ScaleScore::Product ? (1 - relative_scale) * linearity
                                                   : linearity - relative_scale;
  return unit(first) + unit(fraction) - unit(delta / 2);
}

} // namespace

LinearityGraph
readLinearityGraph(const std::vector<double>& linearity,
                   const std::vector<std::uint32_t>& neighbors,
                   const std::vector<double>& radii,
                   const LinearityGraphSettings& settings)
{
  if (linearity.size() != radii.size() || neighbors.size() != radii.size())
    throw std::invalid_argument(
        "readLinearityGraph: linearity, neighbors and radii differ in length");
  LinearityGraph result;
  result.area = result.largest = result.blend = nan;
  const Defined graph = definedScales(linearity, radii, settings.integral);
  if (graph.scale.empty())
    return result;
  const std::size_t end = graph.scale.size() - 1;
  result.largest = *std::max_element(graph.value.begin(), graph.value.end());

  const std::vector<Run> runs = runsFrom(graph, 0);
  std::vector<Run> minima;
  for (std::size_t i = 1; i + 1 < runs.size(); ++i)
    if (runs[i].value < runs[i - 1].value && runs[i].value < runs[i + 1].value)
      minima.push_back(runs[i]);
  for (const Run& minimum : minima)
    result.minima.push_back(graph.scale[minimum.last]);
  const std::size_t area_end = minima.empty() ? end : minima.back().last;
  result.area = area(graph, 0, area_end, settings.integral);

  std::size_t begin = 0;
  while (begin <= end && neighbors[graph.scale[begin]] < settings.min_neighbors)
    ++begin;
  const std::vector<Run> candidates = runsFrom(graph, begin);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Run& run = candidates[i];
    if ((i > 0 && candidates[i - 1].value > run.value) ||
        (i + 1 < candidates.size() && candidates[i + 1].value > run.value))
      continue;
    std::size_t left = begin, right = end;
    for (const Run& minimum : minima) {
      if (minimum.last < run.first)
        left = std::max(left, minimum.last);
      if (minimum.first > run.last)
        right = std::min(right, minimum.first);
    }
    const double value = graph.value[run.first];
    const double fraction =
        result.area > 0
            ? unit(area(graph, left, right, settings.integral) / result.area)
            : 1.0;
    const double delta = value - std::max(graph.value[left], graph.value[right]);
    const double relative_scale =
        static_cast<double>(graph.scale[run.first]) / static_cast<double>(radii.size());
    result.maxima.push_back(
        {graph.scale[run.first],
         graph.scale[left],
         graph.scale[right],
         fraction,
         delta,
         score(settings.score, relative_scale, value, fraction, delta)});
    if (result.best == LinearityGraph::none ||
        result.maxima.back().score > result.maxima[result.best].score) {
      result.best = result.maxima.size() - 1;
      result.blend = std::clamp(fraction / 2 + (value - 0.5), 0.05, 0.95);
    }
  }
  return result;
}

} // namespace linelet
