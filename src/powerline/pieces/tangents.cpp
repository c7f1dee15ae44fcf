// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/tangents.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr TangentSettings settings;
constexpr double stride = 4; // meters of a wire examined at once

/** A downward break of the slope. */
struct Break {
  double s, sureness;
};

// Slopes rise evenly along a span; how much they drop at \a s, in standard deviations.
// Samples are sorted by place.
double
dropAt(const std::vector<Tangents::Sample>& samples, double s)
{
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0;
  std::size_t before = 0, behind = 0;
  const auto from =
      std::partition_point(samples.begin(), samples.end(), [&](const auto& sample) {
        return sample.s - s < -settings.window;
      });
  for (auto sample = from; sample != samples.end(); ++sample) {
    const double on = sample->s - s;
    if (on > settings.window)
      break;
    if (std::abs(on) < settings.blurred)
      continue;
    ++(on < 0 ? before : behind);
    const Eigen::Vector3d x(1, on, on > 0 ? 1 : 0);
    normal += x * x.transpose();
    right += sample->slope * x;
    squares += sample->slope * sample->slope;
  }
  if (before < settings.least_seeds || behind < settings.least_seeds)
    return 0;
  // A prior on the bend prevents artifacts of a one-sided spread of seeds.
  const double n = static_cast<double>(before + behind);
  const double weight = std::pow(settings.least_noise / (2 * priors.bend_spread), 2);
  normal(1, 1) += weight;
  right[1] += weight * 2 * priors.usual_bend;
  const auto solver = normal.ldlt();
  const Eigen::Vector3d c = solver.solve(right);
  if (-c[2] < std::max(settings.least_kink, settings.least_span * c[1]))
    return 0;
  const double noise = std::max(
      settings.least_noise, std::sqrt(std::max(0.0, squares - c.dot(right)) / (n - 2)));
  return -c[2] / (noise * std::sqrt(solver.solve(Eigen::Vector3d::UnitZ())[2]));
}

} // namespace

Tangents::Tangents(const Candidates& candidates, const std::vector<Seed>& seeds)
    : candidates_(candidates), known_(candidates.points.size(), -1)
{
  for (const Seed& seed : seeds)
    if (static_cast<double>(seed.radius) >= settings.least_radius) {
      known_[seed.candidate] = static_cast<int>(directions_.size());
      directions_.push_back(seed.direction);
    }
}

std::vector<Tangents::Sample>
Tangents::along(const SpanModel& model) const
{
  std::vector<Sample> samples;
  for (double from = model.begin; from < model.end; from += stride)
    candidates_.grid.forEachWithin(
        model.at(from + stride / 2),
        std::hypot(stride, priors.rack),
        [&](Index i, double) {
          if (known_[i] < 0)
            return;
          const double s = model.along(candidates_.points[i]);
          if (s < from || s >= std::min(from + stride, model.end) ||
              model.residual(candidates_.points[i], s).norm() > priors.rack)
            return;
          const Point& seen = directions_[static_cast<std::size_t>(known_[i])];
          const double on = seen.head<2>().dot(model.direction);
          if (std::abs(on) >= settings.least_cosine * seen.head<2>().norm())
            samples.push_back({s, seen.z() / on});
        });
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.s != b.s ? a.s < b.s : a.slope < b.slope;
  });
  return samples;
}

std::vector<double>
findKinks(const std::vector<Tangents::Sample>& samples)
{
  std::vector<Break> breaks;
  for (const Tangents::Sample& sample : samples)
    if (const double sureness = dropAt(samples, sample.s); sureness >= settings.clear)
      breaks.push_back({sample.s, sureness});
  std::stable_sort(breaks.begin(), breaks.end(), [](const Break& a, const Break& b) {
    return a.sureness > b.sureness;
  });
  std::vector<double> kinks;
  for (const Break& candidate : breaks)
    if (std::none_of(kinks.begin(), kinks.end(), [&](double s) {
          return std::abs(s - candidate.s) < settings.window;
        }))
      kinks.push_back(candidate.s);
  std::sort(kinks.begin(), kinks.end());
  return kinks;
}

bool
hangAlong(SpanModel& model,
          const std::vector<Tangents::Sample>& samples,
          double low,
          double high)
{
  const double weight = std::pow(settings.least_noise / (2 * priors.bend_spread), 2);
  Eigen::Matrix2d normal = Eigen::Vector2d(0, weight).asDiagonal();
  Eigen::Vector2d right(0, weight * 2 * priors.usual_bend);
  const double middle = (low + high) / 2;
  std::size_t count = 0;
  for (const Tangents::Sample& sample : samples) {
    if (sample.s < low + settings.blurred || sample.s > high - settings.blurred)
      continue;
    const Eigen::Vector2d x(1, sample.s - middle);
    normal += x * x.transpose();
    right += sample.slope * x;
    ++count;
  }
  if (count < settings.least_seeds)
    return false;
  const Eigen::Vector2d c = normal.ldlt().solve(right);
  const double height = model.height(middle);
  model.begin = low;
  model.end = high;
  // height + c0 (s - middle) + c1 / 2 (s - middle)^2, expanded
  model.z = {height - c[0] * middle + c[1] / 2 * middle * middle,
             c[0] - c[1] * middle,
             c[1] / 2};
  return true;
}

} // namespace linelet::powerline
