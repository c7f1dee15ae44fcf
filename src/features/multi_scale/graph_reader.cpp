// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graph_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace linelet {

namespace {

double
unit(double x)
{
  return std::clamp(x, 0.0, 1.0);
}

double
blend(BlendMode mode,
      double relative_scale,
      double linearity,
      double fraction,
      double mean_linearity)
{
  const double value = mode == BlendMode::Integral    ? fraction
                       : mode == BlendMode::Sum       ? mean_linearity
                       : mode == BlendMode::Linearity ? linearity
                       : mode == BlendMode::Index     ? 1 - relative_scale
                                                  : fraction / 2 + (linearity - 0.5);
  return std::clamp(value, 0.05, 0.95);
}

} // namespace

GraphReader::GraphReader(const std::vector<double>& radii,
                         const LinearityGraphSettings& settings)
    : settings_(settings), radii_(radii)
{
  for (const double radius : radii)
    positions_.push_back(
        settings.integral == GraphIntegral::LogRadius ? std::log(radius) : radius);
}

void
GraphReader::findRuns(std::size_t begin, std::vector<Run>& runs) const
{
  runs.clear();
  for (std::size_t i = begin; i < value_.size(); ++i) {
    if (!runs.empty() && std::abs(value_[i] - runs.back().value) <= flat_linearity)
      runs.back().last = i;
    else
      runs.push_back({i, i, value_[i]});
  }
}

double
GraphReader::area(std::size_t first, std::size_t last) const
{
  double sum = 0;
  if (settings_.integral == GraphIntegral::Scales)
    for (std::size_t i = first; i <= last; ++i)
      sum += value_[i];
  else
    for (std::size_t i = first; i < last; ++i)
      sum += (value_[i] + value_[i + 1]) / 2 *
             (positions_[scale_[i + 1]] - positions_[scale_[i]]);
  return sum;
}

const LinearityGraph&
GraphReader::read(const std::vector<double>& linearity,
                  const std::vector<std::uint32_t>& neighbors)
{
  scale_.clear();
  value_.clear();
  minima_.clear();
  result_.maxima.clear();
  result_.minima.clear();
  result_.best = LinearityGraph::none;
  result_.area = result_.largest = result_.blend =
      std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < linearity.size(); ++k) {
    if (std::isnan(linearity[k]))
      continue;
    scale_.push_back(k);
    value_.push_back(linearity[k]);
  }
  if (scale_.empty())
    return result_;
  const std::size_t end = scale_.size() - 1;
  result_.largest = *std::max_element(value_.begin(), value_.end());

  findRuns(0, runs_);
  for (std::size_t i = 1; i + 1 < runs_.size(); ++i)
    if (runs_[i].value < runs_[i - 1].value && runs_[i].value < runs_[i + 1].value)
      minima_.push_back(runs_[i]);
  for (const Run& minimum : minima_)
    result_.minima.push_back(scale_[minimum.last]);
  const bool whole = settings_.area_end == AreaEnd::WholeGraph || minima_.empty();
  result_.area = area(0, whole ? end : minima_.back().last);

  std::size_t begin = 0;
  while (begin <= end && neighbors[scale_[begin]] < settings_.min_neighbors)
    ++begin;
  if (begin > 0)
    findRuns(begin, runs_);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    if ((i == 0 || runs_[i - 1].value <= run.value) &&
        (i + 1 >= runs_.size() || runs_[i + 1].value <= run.value))
      addMaximum(run, begin, end, neighbors);
  }
  return result_;
}

double
GraphReader::score(const GraphMaximum& maximum,
                   const Run& run,
                   const std::vector<std::uint32_t>& neighbors) const
{
  const ScoreWeights& weights = settings_.score_weights;
  const auto scales = static_cast<double>(radii_.size());
  const double value = value_[run.first];
  const double smaller = static_cast<double>(maximum.scale) / scales;
  const double first = settings_.score == ScaleScore::Product
                           ? (1 + weights.scale * smaller) * (weights.linearity * value)
                           : weights.linearity * value + weights.scale * smaller;
  double sum = std::clamp(first, 0.0, std::max(weights.linearity, 0.0)) +
               weights.area * maximum.area_fraction +
               weights.depth * unit(maximum.delta);
  if (weights.step != 0) {
    double step = 0;
    if (run.first > 0)
      step = std::max(step, value - value_[run.first - 1]);
    if (run.last + 1 < value_.size())
      step = std::max(step, value - value_[run.last + 1]);
    sum += weights.step * step;
  }
  sum += weights.width * static_cast<double>(maximum.right - maximum.left) / scales;
  if (neighbors.back() > 0)
    sum += weights.neighbors *
           unit(static_cast<double>(neighbors[maximum.scale]) / radii_[maximum.scale] /
                (static_cast<double>(neighbors.back()) / radii_.back()));
  return result_.maxima.size() == 1 ? sum + weights.second : sum;
}

void
GraphReader::addMaximum(const Run& run,
                        std::size_t begin,
                        std::size_t end,
                        const std::vector<std::uint32_t>& neighbors)
{
  std::size_t left = begin, right = end;
  for (const Run& minimum : minima_) {
    if (minimum.last < run.first)
      left = std::max(left, minimum.last);
    if (minimum.first > run.last)
      right = std::min(right, minimum.first);
  }
  const double value = value_[run.first];
  GraphMaximum maximum{};
  maximum.scale = scale_[run.first];
  maximum.left = scale_[left];
  maximum.right = scale_[right];
  maximum.area_fraction =
      result_.area > 0 ? unit(area(left, right) / result_.area) : 1.0;
  maximum.delta = value - std::max(value_[left], value_[right]);
  maximum.score = score(maximum, run, neighbors);
  result_.maxima.push_back(maximum);
  if (result_.best == LinearityGraph::none ||
      maximum.score > result_.maxima[result_.best].score) {
    result_.best = result_.maxima.size() - 1;
    const auto scales = static_cast<double>(radii_.size());
    const double mean = std::accumulate(value_.begin(), value_.end(), 0.0) / scales;
    result_.blend = blend(settings_.blend,
                          static_cast<double>(maximum.scale) / scales,
                          value,
                          maximum.area_fraction,
                          mean);
  }
}

} // namespace linelet
