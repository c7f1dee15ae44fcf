// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/scan_scatter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double to_deviation = 1.4826; // of a median absolute deviation, if normal

using Weighted = std::pair<double, double>; // value, weight

double
weightedMedian(std::vector<Weighted> values)
{
  std::sort(values.begin(), values.end());
  double all = 0, sum = 0;
  for (const Weighted& v : values)
    all += v.second;
  for (const Weighted& v : values) {
    sum += v.second;
    if (2 * sum >= all)
      return v.first;
  }
  return 0;
}

} // namespace

ScanScatter::ScanScatter(const std::vector<Sample>& wires)
{
  std::vector<Weighted> logarithms;
  for (const Sample& wire : wires)
    if (wire.rms > 0)
      logarithms.emplace_back(std::log(wire.rms), wire.points);
  usual_ = weightedMedian(logarithms);
  for (Weighted& v : logarithms)
    v.first = std::abs(v.first - usual_);
  spread_ = std::max(priors.scatter_spread,
                     to_deviation * weightedMedian(std::move(logarithms)));
}

double
ScanScatter::excess(const Sample& wire) const
{
  if (!(wire.rms > 0) || !(wire.points > 0))
    return 0;
  // The deviation of ln(rms) of 2 n normal coordinates is 1 / (2 sqrt(n)).
  const double deviation = std::hypot(spread_, 0.5 / std::sqrt(wire.points));
  return std::max(0.0, (std::log(wire.rms) - usual_) / deviation);
}

ScanScatter::Sample
sampleOf(const Piece& wire, const Points& points)
{
  return {rootMeanSquare(wire.model, points, wire.members),
          static_cast<double>(wire.members.size())};
}

double
logPriorOfScatter(double excess)
{
  return -2 * std::log1p(excess * excess / 3);
}

} // namespace linelet::powerline
