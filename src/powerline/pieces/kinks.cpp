// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/kinks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "powerline/pieces/piece.h"
#include "powerline/pieces/profile.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double end_stretch = 6; // meters from an end within which no kink is sought
constexpr double least_kink = 0.025; // change of slope
constexpr double better = 1.2;       // ratio of residuals, one parabola to two
constexpr double widest_step = 0.4;  // meters between the parabolas where they meet

} // namespace

std::vector<double>
findKinks(const Piece& piece, const Points& points)
{
  const SpanModel& m = piece.model;
  std::vector<std::pair<double, double>> samples; // s, height above the joint model
  for (const Index i : piece.members) {
    const double s = m.along(points[i]);
    samples.emplace_back(s, points[i].z() - m.height(s));
  }
  std::sort(samples.begin(), samples.end());
  if (m.length() < 2 * end_stretch || samples.size() < 12)
    return {};
  std::vector<Moments> before(samples.size() + 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    before[i + 1] = before[i];
    before[i + 1].add(samples[i].first, samples[i].second);
  }
  const Moments& all = before.back();
  const double joint = all.solve().second;

  double best = joint, place = 0;
  for (std::size_t i = 6; i + 6 <= samples.size(); ++i) {
    const double s = samples[i].first;
    if (s - samples.front().first < end_stretch ||
        samples.back().first - s < end_stretch)
      continue;
    const auto left = before[i].solve(), right = (all - before[i]).solve();
    const double jump =
        SpanModel::slope(right.first, s) - SpanModel::slope(left.first, s);
    const double step =
        SpanModel::value(right.first, s) - SpanModel::value(left.first, s);
    const double squares = left.second + right.second;
    if (jump < -least_kink && std::abs(step) < widest_step && squares < best) {
      best = squares;
      place = s;
    }
  }
  const double n = static_cast<double>(samples.size());
  const double floor = n * least_residual * least_residual;
  if (joint + floor < better * better * (best + floor))
    return {};
  return {place};
}

} // namespace linelet::powerline
