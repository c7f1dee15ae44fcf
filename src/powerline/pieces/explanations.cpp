// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/explanations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Core>

#include "powerline/line_priors.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/profile.h"
#include "powerline/pieces/tube_radius.h"

namespace linelet::powerline {

namespace {

// Of a wire: three coefficients each to the side and up, two ends, density and noise.
constexpr double parameters = 10;
constexpr double most = 0.5; // of the smaller one's points, shared by competitors

/** Density of points that a wire causes, per cubic meter. */
class WireDensity {
public:
  /** \param[in] count points that it explains, of its members */
  WireDensity(const Piece& piece, double count, const Points& points)
      : model_(piece.model)
  {
    const auto n = static_cast<double>(piece.members.size());
    double squares = 0;
    for (const Index i : piece.members)
      squares += model_.residual(points[i], model_.along(points[i])).squaredNorm();
    // Per axis.
    variance_ = squares / (2 * n) + least_residual * least_residual;
    peak_ = count / std::max(bin_length, model_.length()) / (2 * M_PI * variance_);
  }

  double
  at(const Point& p) const
  {
    const double s = model_.along(p);
    if (s < model_.begin - bin_length / 2 || s > model_.end + bin_length / 2)
      return 0;
    return peak_ * std::exp(-model_.residual(p, s).squaredNorm() / (2 * variance_));
  }

private:
  SpanModel model_;
  double variance_, peak_;
};

// Groups of competing pieces; those of one side come first, then those of the other.
std::vector<std::size_t>
groupsOf(const std::vector<Piece>& pieces, std::size_t others, std::size_t candidates)
{
  std::vector<std::size_t> group(pieces.size());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&](std::size_t k) {
    while (group[k] != k)
      k = group[k] = group[group[k]];
    return k;
  };
  std::vector<std::size_t> owner(candidates, pieces.size());
  for (std::size_t k = 0; k < others; ++k)
    for (const Index i : pieces[k].members)
      owner[i] = k;
  for (std::size_t k = others; k < pieces.size(); ++k) {
    std::map<std::size_t, std::size_t> shared;
    for (const Index i : pieces[k].members)
      if (owner[i] < pieces.size())
        ++shared[owner[i]];
    for (const auto& [other, count] : shared)
      if (static_cast<double>(count) >=
          most * static_cast<double>(
                     std::min(pieces[k].members.size(), pieces[other].members.size())))
        group[std::max(root(k), root(other))] = std::min(root(k), root(other));
  }
  for (std::size_t k = 0; k < group.size(); ++k)
    group[k] = root(k);
  return group;
}

// Logarithm of the likelihood of \a all points under \a wires, what these leave to the
// wide ones among \a others, and \a background.
double
likelihood(const std::vector<const Piece*>& wires,
           const std::vector<const Piece*>& others,
           const Indices& all,
           const std::vector<double>& background,
           const Points& points)
{
  std::vector<WireDensity> densities;
  double sum = 0;
  const auto add = [&](const Piece& wire, double count) {
    densities.emplace_back(wire, count, points);
    sum -= parameters / 2 * std::log(static_cast<double>(wire.members.size()));
  };
  Indices explained;
  for (const Piece* wire : wires) {
    add(*wire, static_cast<double>(wire->members.size()));
    explained.insert(explained.end(), wire->members.begin(), wire->members.end());
  }
  std::sort(explained.begin(), explained.end());
  if (!others.empty()) // each is one of many possible in a wide one
    sum -= LinePriors().alone * static_cast<double>(wires.size());
  for (const Piece* other : others)
    if (other->model.isWide())
      add(*other,
          static_cast<double>(
              std::count_if(other->members.begin(), other->members.end(), [&](Index i) {
                return !std::binary_search(explained.begin(), explained.end(), i);
              })));
  for (std::size_t k = 0; k < all.size(); ++k) {
    double density = background[k];
    for (const WireDensity& wire : densities)
      density += wire.at(points[all[k]]);
    sum += std::log(density);
  }
  return sum;
}

// Density of other points around each of \a all, per cubic meter.
std::vector<double>
densityAround(const Indices& all, const Candidates& candidates)
{
  const double volume = 4 * M_PI / 3 * std::pow(widest_tube_seen, 3);
  std::vector<double> result;
  for (const Index i : all) {
    double count = 1;
    candidates.grid.forEachWithin(
        candidates.points[i], widest_tube_seen, [&](Index j, double) {
          if (!std::binary_search(all.begin(), all.end(), j))
            ++count;
        });
    result.push_back(count / volume);
  }
  return result;
}

} // namespace

std::vector<Piece>
likelierPieces(Growth& growth,
               std::vector<Piece> first,
               std::vector<Piece> second,
               const PowerLineSettings& settings)
{
  const Candidates& candidates = growth.candidates();
  const Points& points = candidates.points;
  const std::size_t others = first.size();
  std::vector<Piece> pieces = std::move(first);
  std::move(second.begin(), second.end(), std::back_inserter(pieces));
  const std::vector<std::size_t> group = groupsOf(pieces, others, points.size());
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    groups[group[k]].push_back(k);
  std::vector<char> stays(pieces.size(), 0);
  std::fill_n(stays.begin(), others, 1);
  for (const auto& entry : groups) {
    std::vector<const Piece*> sides[2];
    Indices all;
    bool wide = false;
    for (const std::size_t k : entry.second) {
      wide |= pieces[k].model.isWide();
      sides[k < others ? 0 : 1].push_back(&pieces[k]);
      all.insert(all.end(), pieces[k].members.begin(), pieces[k].members.end());
    }
    if (sides[0].empty() || sides[1].empty() || !wide)
      continue;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    const std::vector<double> background = densityAround(all, candidates);
    const auto best = [&](int side) {
      return std::max(
          likelihood(sides[side], {}, all, background, points),
          likelihood(sides[side], sides[1 - side], all, background, points));
    };
    const bool second_stays = best(1) > best(0);
    for (const std::size_t k : entry.second)
      stays[k] = (k >= others) == second_stays;
  }
  growth.release();
  std::vector<Piece> result;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (stays[k] == 0)
      continue;
    // Points shared with pieces that it did not compete with stay theirs.
    Piece& piece = pieces[k];
    if (k >= others &&
        std::any_of(piece.members.begin(),
                    piece.members.end(),
                    [&](Index i) { return growth.owner(i) != Growth::nobody; }) &&
        (!growth.collect(piece, piece.tolerance()) ||
         !weigh(growth, piece, settings).accepted))
      continue;
    growth.claim(pieces[k], static_cast<int>(result.size()));
    result.push_back(std::move(pieces[k]));
  }
  return result;
}

} // namespace linelet::powerline
