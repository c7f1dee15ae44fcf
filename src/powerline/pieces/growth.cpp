// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/growth.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/counts.h"
#include "powerline/pieces/kinks.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/tangents.h"

namespace linelet::powerline {

namespace {

constexpr double lock_length = 8;    // meters from which bundles are resolved
constexpr double lock_reach = 0.7;   // meters, around the model
constexpr double lock_kernel = 0.12; // meters
constexpr double seed_tube = 0.3;    // meters
constexpr double widest_tube = 0.6;  // meters, if the prediction is uncertain
constexpr std::size_t lock_sample = 400;

void
cut(Piece& piece, const Points& points, double low, double high)
{
  Indices& all = piece.members;
  all.erase(std::remove_if(all.begin(),
                           all.end(),
                           [&](Index i) {
                             const double s = piece.model.along(points[i]);
                             return s < low || s > high;
                           }),
            all.end());
}

} // namespace

Growth::Growth(const Candidates& candidates,
               const PowerLineSettings& settings,
               const std::vector<Seed>& seeds)
    : candidates_(candidates),
      settings_(settings),
      owner_(candidates.points.size(), nobody),
      tangents_(candidates, seeds)
{
}

void
Growth::claim(const Piece& piece, int owner)
{
  for (const Index i : piece.members)
    owner_[i] = owner;
}

void
Growth::release()
{
  std::fill(owner_.begin(), owner_.end(), nobody);
}

Bin
Growth::look(const SpanModel& model,
             double from,
             double to,
             double tolerance,
             Indices* members) const
{
  Bin bin;
  const double reach = std::max(ring_radius, 2 * tolerance);
  const double half = (to - from) / 2;
  const Point center = model.at((from + to) / 2);
  const double rise = half * std::abs(model.rise((from + to) / 2));
  candidates_.grid.forEachWithin(
      center, std::sqrt(half * half + rise * rise) + reach, [&](Index i, double) {
        if (owner_[i] != nobody)
          return;
        const Point& p = candidates_.points[i];
        const double s = model.along(p);
        if (s < from || s >= to)
          return;
        const double d = model.residual(p, s).norm();
        if (d <= tolerance) {
          ++bin.tube;
          if (members != nullptr)
            members->push_back(i);
        }
        else if (d <= reach) {
          ++bin.ring;
          if (d <= 2 * tolerance)
            ++bin.guard_ring;
        }
      });
  return bin;
}

bool
Growth::collect(Piece& piece, double reach) const
{
  const SpanModel& m = piece.model;
  Indices members;
  const int steps = std::max(1, static_cast<int>(std::ceil(m.length() / bin_length)));
  const double step = m.length() / steps;
  for (int k = 0; k < steps; ++k) {
    // The last bin is open-ended, lest it lose the outermost point.
    const double to = k + 1 < steps ? m.begin + (k + 1) * step : m.end + 1e-6;
    look(m, m.begin + k * step, to, reach, &members);
  }
  piece.members = std::move(members);
  if (!fit(piece.model, candidates_.points, piece.members, piece.cut()))
    return false;
  updateExtent(piece, candidates_.points);
  return true;
}

void
Growth::advance(
    Piece& piece, int side, double limit, double patience, Ahead& ahead) const
{
  SpanModel& m = piece.model;
  const double edge = side > 0 ? m.end : m.begin;
  const double near = edge + side * (ahead.gap + 1e-6),
               far = edge + side * (ahead.gap + bin_length);
  const double vague = 2 * m.uncertainty((near + far) / 2);
  if (side * (far - limit) > 0 || ahead.gap >= settings_.max_gap ||
      vague > widest_tube) {
    ahead.open = false;
    return;
  }
  const double tolerance =
      std::min(std::max(widest_tube, piece.thickness), piece.tolerance() + vague);
  const Bin bin =
      look(m, std::min(near, far), std::max(near, far), tolerance, &ahead.points);
  const double reach = std::max(ring_radius, 2 * tolerance);
  const double density = bin_length * static_cast<double>(piece.members.size()) /
                         std::max(bin_length, m.length());
  ahead.evidence += logWire({static_cast<double>(bin.tube),
                             static_cast<double>(bin.ring),
                             reach * reach / (tolerance * tolerance) - 1},
                            density,
                            LinePriors().hidden);
  ahead.gap += bin_length;
  if (ahead.evidence <= 0 || bin.tube == 0) {
    ahead.open = ahead.evidence > -patience;
    return;
  }
  for (const Index i : ahead.points) {
    const double s = m.along(candidates_.points[i]);
    (side > 0 ? m.end : m.begin) = side > 0 ? std::max(m.end, s) : std::min(m.begin, s);
    piece.members.push_back(i);
  }
  ahead = {};
}

bool
Growth::lockOnStrongestWire(Piece& piece) const
{
  piece.model = piece.model.reframed();
  SpanModel& m = piece.model;
  Indices around;
  for (double s = m.begin; s < m.end; s += bin_length)
    look(m, s, std::min(s + bin_length, m.end), lock_reach, &around);
  const std::size_t stride = around.size() / lock_sample + 1;
  std::vector<Eigen::Vector2d> residuals;
  for (std::size_t i = 0; i < around.size(); i += stride) {
    const Point& p = candidates_.points[around[i]];
    residuals.push_back(m.residual(p, m.along(p)));
  }
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double best_density = -1;
  for (const Eigen::Vector2d& center : residuals) {
    double density = 0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& r : residuals) {
      const double w =
          std::exp(-(r - center).squaredNorm() / (2 * lock_kernel * lock_kernel));
      density += w;
      sum += w * r;
    }
    if (density > best_density) {
      best_density = density;
      best = sum / density;
    }
  }
  m.t[0] += best[0];
  m.z[0] += best[1];
  return collect(piece, 0.25) && collect(piece, piece.model.tolerance);
}

bool
Growth::extend(Piece& piece, double low, double high, bool lock, double patience) const
{
  SpanModel& m = piece.model;
  Ahead ahead[2];
  double fitted = m.length();
  while (ahead[0].open || ahead[1].open) {
    if (lock && m.length() > lock_length) {
      lock = false;
      if (!lockOnStrongestWire(piece))
        return false;
      fitted = m.length();
      ahead[0] = ahead[1] = {};
    }
    for (int k = 0; k < 2; ++k)
      if (ahead[k].open)
        advance(piece, k == 0 ? -1 : 1, k == 0 ? low : high, patience, ahead[k]);
    if (m.length() >= fitted + std::max(bin_length, 0.05 * fitted)) {
      if (!fit(m, candidates_.points, piece.members, piece.cut()))
        return false;
      fitted = m.length();
    }
  }
  return fit(m, candidates_.points, piece.members, piece.cut());
}

std::vector<Piece>
Growth::grow(const Seed& seed) const
{
  const Point& p = candidates_.points[seed.candidate];
  Piece piece;
  SpanModel& m = piece.model;
  m.origin = p.head<2>();
  const double flat = seed.direction.head<2>().norm();
  if (owner_[seed.candidate] != nobody || !(flat > 0))
    return {};
  m.direction = seed.direction.head<2>() / flat;
  m.z = {p.z(), seed.direction.z() / flat, 0};
  m.begin = -seed.radius;
  m.end = seed.radius;
  m.tolerance = seed_tube;
  if (!collect(piece, seed_tube))
    return {};
  const double far = std::numeric_limits<double>::infinity();
  if (!extend(piece, -far, far, true))
    return {};

  return betweenSupports(std::move(piece));
}

std::vector<Piece>
Growth::betweenBreaks(const Piece& piece) const
{
  std::vector<Piece> parts;
  if (piece.thickness > 0)
    return parts;
  const std::vector<Tangents::Sample> samples = tangents_.along(piece.model);
  const std::vector<double> kinks = findKinks(samples);
  for (std::size_t k = 0; !kinks.empty() && k <= kinks.size(); ++k) {
    const double low = k == 0 ? piece.model.begin : kinks[k - 1];
    const double high = k == kinks.size() ? piece.model.end : kinks[k];
    Piece part = piece;
    const double far = std::numeric_limits<double>::infinity();
    const Point from = piece.model.at(low), to = piece.model.at(high);
    // Its points beyond the first break belong to others.
    if (!hangAlong(part.model, samples, low, high) || !lockOnStrongestWire(part))
      continue;
    const SpanModel& m = part.model;
    if (extend(
            part, k == 0 ? -far : m.along(from), k == kinks.size() ? far : m.along(to)))
      parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<Piece>
Growth::betweenSupports(Piece piece) const
{
  const Points& points = candidates_.points;
  const double far = std::numeric_limits<double>::infinity();
  std::vector<Piece> done, open;
  open.push_back(std::move(piece));
  for (int round = 0; round < 6 && !open.empty(); ++round) {
    std::vector<Piece> next;
    for (Piece& part : open) {
      if (part.members.size() < 5)
        continue;
      part.model = part.model.reframed();
      if (!collect(part, part.tolerance()))
        continue;
      if (std::vector<Piece> parts = betweenBreaks(part); !parts.empty()) {
        std::move(parts.begin(), parts.end(), std::back_inserter(next));
        continue;
      }
      const std::vector<double> kinks = findKinks(part, points);
      if (kinks.empty()) {
        done.push_back(std::move(part));
        continue;
      }
      for (std::size_t k = 0; k <= kinks.size(); ++k) {
        Piece split = part;
        const double low = k == 0 ? -far : kinks[k - 1];
        const double high = k == kinks.size() ? far : kinks[k];
        cut(split, points, low, high);
        if (split.members.size() < 5 ||
            !fit(split.model, points, split.members, split.cut()))
          continue;
        updateExtent(split, points);
        if (extend(split, low, high))
          next.push_back(std::move(split));
      }
    }
    open = std::move(next);
  }
  for (Piece& part : open)
    done.push_back(std::move(part));
  return done;
}

} // namespace linelet::powerline
