// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/bundles.h"

#include <algorithm>
#include <cmath>

#include "powerline/line_priors.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/vertical_slice.h"

namespace linelet::powerline {

namespace {

constexpr double bundle_width = 0.7; // meters between conductors of one bundle
constexpr double own_cover = 0.5;    // of the bins of a conductor in its own right
constexpr double complete = 0.8;     // part of its neighbor's length
constexpr double kept = 0.85;        // of its points
constexpr double alike = 0.25; // of the points of one conductor, another has at least

/** The conductor that hangs like \a whole, shifted to \a part. */
bool
completed(Growth& growth, const Piece& part, const SpanModel& whole, Piece& result)
{
  const Points& points = growth.candidates().points;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  for (const Index i : part.members)
    shift += whole.residual(points[i], whole.along(points[i]));
  shift /= static_cast<double>(part.members.size());
  result.model = whole;
  result.model.t[0] += shift[0];
  result.model.z[0] += shift[1];
  if (!growth.collect(result, 0.2) ||
      static_cast<double>(result.members.size()) <
          kept * static_cast<double>(part.members.size()))
    return false;
  const SpanModel& m = result.model;
  if (m.length() < complete * whole.length())
    return false;
  const int bins = static_cast<int>(std::ceil(m.length() / bin_length));
  int occupied = 0;
  for (int k = 0; k < bins; ++k)
    if (growth.look(m, m.begin + k * bin_length, m.begin + (k + 1) * bin_length, 0.2)
            .tube > 0)
      ++occupied;
  return occupied >= own_cover * bins;
}

/** Frees the points of pieces that are only the scatter of a wire: they lie in its
 * tube, or within its noise if that is wider, and have few points compared with it,
 * whereas conductors of a bundle are seen equally well. */
void
dropScatter(Growth& growth, std::vector<Piece>& pieces)
{
  const auto isScatter = [&](const Piece& piece) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& wire) {
      if (alike * static_cast<double>(wire.members.size()) <=
          static_cast<double>(piece.members.size()))
        return false;
      const Parallel parallel = compare(piece.model, wire.model);
      return parallel.overlap >= 0.7 * piece.model.length() &&
             parallel.distance <= std::max(wire.tolerance(), 3 * wire.model.sigma);
    });
  };
  std::vector<char> scatter;
  for (const Piece& piece : pieces)
    scatter.push_back(isScatter(piece));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (scatter[i] != 0)
      growth.claim(pieces[i], Growth::nobody);
    else if (kept++ != i)
      pieces[kept - 1] = std::move(pieces[i]);
  pieces.resize(kept);
}

} // namespace

std::vector<Strand>
sortBundles(Growth& growth,
            std::vector<Piece> pieces,
            const PowerLineSettings& settings)
{
  dropScatter(growth, pieces);
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return a.model.length() > b.model.length();
  });
  std::vector<Strand> wires;
  for (Piece& piece : pieces) {
    Strand* neighbor = nullptr;
    double nearest = bundle_width;
    for (Strand& wire : wires) {
      const Parallel parallel = compare(piece.model, wire.piece.model);
      if (parallel.overlap < 0.7 * piece.model.length() || parallel.distance > nearest)
        continue;
      nearest = parallel.distance;
      neighbor = &wire;
    }
    if (neighbor == nullptr) {
      wires.push_back({std::move(piece), {}});
      continue;
    }
    const SpanModel& whole = neighbor->piece.model;
    if (piece.model.length() >= complete * whole.length()) {
      wires.push_back({std::move(piece), {}});
      continue;
    }
    growth.claim(piece, Growth::nobody);
    Piece conductor;
    if (completed(growth, piece, whole, conductor) &&
        weigh(growth, conductor, settings).accepted) {
      growth.claim(conductor, 0);
      wires.push_back({std::move(conductor), {}});
      continue;
    }
    growth.claim(piece, 0);
    // If they are farther apart than they scatter, they are two wires. Wires of low
    // lines hang on racks, however short they are, and the longer one may continue past
    // a pole; bundles show short pieces of single conductors.
    const double scatter = piece.tolerance() + neighbor->piece.tolerance();
    const bool on_rack = heightOf(piece, growth.candidates()) < priors.highest_pole;
    if (on_rack ? nearest > scatter / 2
                : nearest > scatter && piece.model.length() >= priors.short_line)
      wires.push_back({std::move(piece), {}});
    else
      neighbor->companions.push_back(std::move(piece));
  }
  return wires;
}

} // namespace linelet::powerline
