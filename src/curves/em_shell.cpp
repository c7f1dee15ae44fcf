// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/em_fit.h>

#include <algorithm>
#include <cmath>

#include "em_kernels.h"

namespace linelet {

namespace {

// What a point says at least.
constexpr double least_information = 0.05;
// The width of the shell, as a share of its radius.
constexpr double widest = 0.3;

/** \brief Sums over the part of an edge whose points lie near the shell. */
struct ShellPart {
  double mass = 0, place = 0, residual = 0, spread = 0;

  void
  operator+=(const ShellPart& other)
  {
    mass += other.mass;
    place += other.place;
    residual += other.residual;
    spread += other.spread;
  }
};

/** \brief The part of an edge from the place \a foot at distance \a low to the place
 * \a end at distance \a high of a point; in between the distance is taken as linear. */
ShellPart
shellPart(double low, double high, double foot, double end, double radius, double width)
{
  const double a = (low - radius) / width, b = (high - radius) / width;
  ShellPart part;
  if (a > 4 || b < -4)
    return part;
  constexpr double root = 0.3989422804014327; // 1 / sqrt(2 pi)
  double mean, square;
  if (b - a < 0.3) {
    mean = 0.5 * (a + b);
    part.mass = std::abs(end - foot) * root * std::exp(-0.5 * mean * mean) / width;
    square = mean * mean;
  }
  else {
    const double pa = root * std::exp(-0.5 * a * a), pb = root * std::exp(-0.5 * b * b);
    const double below = 0.5 * (std::erfc(-b * M_SQRT1_2) - std::erfc(-a * M_SQRT1_2));
    const double inside = std::max(1e-12, below);
    part.mass = std::abs(end - foot) * inside / ((b - a) * width);
    mean = std::clamp((pa - pb) / inside, a, b);
    square = std::max(mean * mean, 1 + (a * pa - b * pb) / inside);
  }
  part.place = part.mass * (foot + (end - foot) * (b > a ? (mean - a) / (b - a) : 0.5));
  part.residual = part.mass * mean * width;
  part.spread = part.mass * square * width * width;
  return part;
}

} // namespace

void
EmFitter::dropHollow(Edge& edge, double hollow)
{
  std::size_t kept = edge.pairs_begin;
  const Point to = edge.from + edge.length * edge.direction;
  for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
    const Point x(pair_at_[0][k], pair_at_[1][k], pair_at_[2][k]);
    if (std::max((x - edge.from).squaredNorm(), (x - to).squaredNorm()) <
        hollow * hollow)
      continue;
    pair_slot_[kept] = pair_slot_[k];
    for (auto& coordinate : pair_at_)
      coordinate[kept] = coordinate[k];
    ++kept;
  }
  edge.pairs_end = kept;
}

void
EmFitter::shellDensitiesOf(const Edge& edge)
{
  // The integral of the normal density of the distance, as if all were the radius.
  const double volume = 4 * M_PI * (shell_ * shell_ + noise_ * noise_);
  const double factor = edge.weight / (edge.length * volume);
  for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
    const Point v = Point(pair_at_[0][k], pair_at_[1][k], pair_at_[2][k]) - edge.from;
    const double z = v.dot(edge.direction);
    const double off = std::max(0.0, v.squaredNorm() - z * z);
    // The distance from the point falls towards its foot and grows after it.
    const double foot = std::clamp(z, 0.0, edge.length);
    const double nearest = std::sqrt(off + (z - foot) * (z - foot));
    ShellPart all;
    for (const double end : {0.0, edge.length})
      if (foot != end)
        all += shellPart(
            nearest, std::sqrt(off + (z - end) * (z - end)), foot, end, shell_, noise_);
    const double share = all.mass > 0 ? 1 / all.mass : 0;
    pair_density_[k] = factor * all.mass;
    pair_place_[k] = all.place * share;
    pair_residual_[k] = all.residual * share;
    pair_spread_[k] = all.spread * share;
  }
}

/** \brief Per point: what it says of its distance, relative to a point whose place on
 * the curve is known. */
void
EmFitter::measureInformation()
{
  const std::size_t n = points_.size();
  inlier_.assign(n, 0);
  residual_.assign(n, 0);
  information_.assign(n, 0);
  for (const Edge& edge : edges_)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const std::size_t i = pair_slot_[k];
      inlier_[i] += pair_density_[k];
      residual_[i] += pair_density_[k] * pair_residual_[k];
      information_[i] += pair_density_[k] * pair_spread_[k];
    }
  for (std::size_t i = 0; i < n; ++i)
    if (inlier_[i] > 0) {
      const double mean = residual_[i] / inlier_[i];
      const double variance = information_[i] / inlier_[i] - mean * mean;
      information_[i] =
          std::clamp(1 - variance / (noise_ * noise_), least_information, 1.0);
    }
}

EdgeSums
EmFitter::shellSumsOf(const Edge& edge, bool front, bool back) const
{
  EdgeSums sums;
  Point at_a = Point::Zero(), at_b = Point::Zero();
  for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
    const double information = information_[pair_slot_[k]];
    const double r = pair_density_[k] * information;
    if (r < 1e-5)
      continue;
    const double place = pair_place_[k];
    const Point source = edge.from + place * edge.direction;
    Point x = Point(pair_at_[0][k], pair_at_[1][k], pair_at_[2][k]) - source;
    x *= std::clamp(pair_residual_[k] / information, -noise_, noise_) /
         std::max(x.norm(), 1e-300);
    // Along the curve only its ends are drawn by the points.
    if (!(front && place <= 0) && !(back && place >= edge.length))
      x -= x.dot(edge.direction) * edge.direction;
    x += source;
    const double t = place / edge.length;
    sums.aa += r * (1 - t) * (1 - t);
    sums.ab += r * (1 - t) * t;
    sums.bb += r * t * t;
    at_a += (r * (1 - t)) * x;
    at_b += (r * t) * x;
  }
  for (int axis = 0; axis < 3; ++axis) {
    sums.at_a[axis] = at_a[axis];
    sums.at_b[axis] = at_b[axis];
  }
  return sums;
}

void
EmFitter::measureShell(const EmSettings& settings)
{
  double sum = 0, square = 0, count = 0, information = 0;
  for (const Edge& edge : edges_)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k)
      square += pair_density_[k] * pair_spread_[k];
  for (std::size_t i = 0; i < points_.size(); ++i) {
    sum += residual_[i];
    count += inlier_[i];
    information += inlier_[i] * information_[i];
  }
  if (!(count > 0))
    return;
  // A Newton step for the radius; a wider shell is thinner.
  const double variance = noise_ * noise_;
  const double thinning = 2 * variance * shell_ / (shell_ * shell_ + variance);
  const double shift = 0.5 * (sum - thinning * count) / information;
  shell_ = std::max(shell_ + std::clamp(shift, -0.3 * noise_, 0.3 * noise_),
                    settings.least_noise);
  // Points inside the shell say nothing of its width, so a longer step than that of
  // expectation maximisation.
  const double change = std::pow(square / (variance * count), 1.5);
  noise_ = std::max(std::min(noise_ * std::clamp(change, 0.7, 1.4), widest * shell_),
                    settings.least_noise);
}

double
EmFitter::peakedness() const
{
  double count = 0, square = 0, fourth = 0;
  for (const Edge& edge : edges_)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const Point v = Point(pair_at_[0][k], pair_at_[1][k], pair_at_[2][k]) - edge.from;
      const double z = v.dot(edge.direction);
      const double off = std::max(0.0, v.squaredNorm() - z * z);
      count += pair_density_[k];
      square += pair_density_[k] * off;
      fourth += pair_density_[k] * off * off;
    }
  return square > 0 ? count * fourth / (square * square) : 0;
}

} // namespace linelet
