// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/curve_parts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "piece_ends.h"

namespace linelet {

namespace {

bool
isBefore(const Point& a, const Point& b)
{
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

const Point&
firstPlaceOf(const Curve& curve)
{
  if (curve.closed)
    return *std::min_element(curve.points.begin(), curve.points.end(), isBefore);
  return std::min(curve.points.front(), curve.points.back(), isBefore);
}

/** \brief A curve that grows piece by piece. */
class Chain {
public:
  /** \param[in] entry end of \a piece that comes first */
  void
  add(const CurvePiece& piece, int entry, const PieceLink& link)
  {
    Curve next = piece.curve;
    if (entry == 1) {
      std::reverse(next.points.begin(), next.points.end());
      std::reverse(next.support.begin(), next.support.end());
      std::swap(next.front, next.back);
    }
    const double w = length(next);
    length_ += w;
    squares_ += w * next.noise * next.noise;
    points_ += w * next.density;
    evidence_ += next.evidence;
    if (curve_.points.empty()) {
      curve_ = std::move(next);
      return;
    }
    const bool counted = !curve_.support.empty() && !next.support.empty();
    if (!counted) {
      curve_.support.clear();
      next.support.clear();
    }
    goTo(link, next);
    curve_.points.insert(curve_.points.end(), next.points.begin(), next.points.end());
    curve_.support.insert(
        curve_.support.end(), next.support.begin(), next.support.end());
    curve_.back = next.back;
  }

  /** The last piece leads back to the first. */
  void
  close(const PieceLink& link)
  {
    goTo(link, curve_);
    curve_.closed = true;
    curve_.front = curve_.back = {EndKind::Loop, -1};
  }

  Curve
  release()
  {
    curve_.noise = std::sqrt(squares_ / length_);
    curve_.density = points_ / length_;
    curve_.evidence = evidence_;
    for (CurveEnd* end : {&curve_.front, &curve_.back})
      if (end->kind == EndKind::Bounds) // of its part, but nothing continues it
        end->kind = EndKind::Support;
    if (!curve_.closed && isBefore(curve_.points.back(), curve_.points.front())) {
      std::reverse(curve_.points.begin(), curve_.points.end());
      std::reverse(curve_.support.begin(), curve_.support.end());
      std::swap(curve_.front, curve_.back);
    }
    return std::move(curve_);
  }

private:
  /** Appends the link to \a next, and removes from it what both share. */
  void
  goTo(const PieceLink& link, Curve& next)
  {
    const auto skip =
        static_cast<std::ptrdiff_t>(std::min(link.skip, next.points.size() - 1));
    if (link.seam)
      curve_.points.back() = *link.seam;
    next.points.erase(next.points.begin(), next.points.begin() + skip);
    curve_.points.insert(curve_.points.end(), link.bridge.begin(), link.bridge.end());
    if (next.support.empty())
      return;
    const auto end = next.support.begin() + skip;
    curve_.support.back() =
        std::accumulate(next.support.begin(), end, curve_.support.back());
    next.support.erase(next.support.begin(), end);
    curve_.support.insert(curve_.support.end(), link.bridge.size(), 0);
  }

  Curve curve_;
  double length_ = 0, squares_ = 0, points_ = 0, evidence_ = 0;
};

/** \brief All curves, and what became of the pieces. */
class Joining {
public:
  Joining(const std::vector<CurvePiece>& pieces, const PieceLinks& links)
      : pieces_(pieces), links_(links), curve_of_(pieces.size(), none)
  {
    for (std::size_t p = 0; p < pieces.size(); ++p)
      for (const int end : {0, 1})
        if (links[2 * p + static_cast<std::size_t>(end)].to == none)
          follow(p, end);
    for (std::size_t p = 0; p < pieces.size(); ++p) // rings
      follow(p, 0);
  }

  std::vector<Curve> curves;

  std::size_t
  curveOf(std::size_t piece) const
  {
    return curve_of_[piece];
  }

private:
  void
  follow(std::size_t piece, int entry)
  {
    if (curve_of_[piece] != none)
      return;
    Chain chain;
    const std::size_t first = 2 * piece + static_cast<std::size_t>(entry);
    PieceLink link;
    for (std::size_t in = first;;) {
      curve_of_[in / 2] = curves.size();
      chain.add(pieces_[in / 2], static_cast<int>(in % 2), link);
      link = links_[in ^ 1];
      if (link.to == none)
        break;
      in = link.to;
      if (in == first) {
        chain.close(link);
        break;
      }
    }
    curves.push_back(chain.release());
  }

  static constexpr std::size_t none = PieceLink::none;
  const std::vector<CurvePiece>& pieces_;
  const PieceLinks& links_;
  std::vector<std::size_t> curve_of_;
};

} // namespace

CurveNetwork
joinParts(std::vector<CurvePart> parts, double tolerance)
{
  CurveNetwork network;
  std::vector<CurvePiece> pieces;
  std::vector<std::size_t> part_of;
  for (std::size_t f = 0; f < parts.size(); ++f) {
    const std::size_t before = pieces.size();
    const int junctions = static_cast<int>(network.junctions.size());
    for (CurvePiece& piece : parts[f].pieces) {
      for (CurveEnd* end : {&piece.curve.front, &piece.curve.back})
        if (end->junction >= 0)
          end->junction += junctions;
      pieces.push_back(std::move(piece));
      part_of.push_back(f);
    }
    for (Junction& junction : parts[f].junctions) {
      for (std::size_t& piece : junction.curves)
        piece += before;
      network.junctions.push_back(std::move(junction));
    }
  }
  Joining joining(pieces, linkEnds(pieces, part_of, tolerance));

  std::vector<std::size_t> order(joining.curves.size()), place(order.size());
  for (std::size_t c = 0; c < order.size(); ++c)
    order[c] = c;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return isBefore(firstPlaceOf(joining.curves[a]), firstPlaceOf(joining.curves[b]));
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    network.curves.push_back(std::move(joining.curves[order[k]]));
  }
  for (Junction& junction : network.junctions) {
    for (std::size_t& piece : junction.curves)
      piece = place[joining.curveOf(piece)];
    std::sort(junction.curves.begin(), junction.curves.end());
    junction.curves.erase(std::unique(junction.curves.begin(), junction.curves.end()),
                          junction.curves.end());
  }
  return network;
}

} // namespace linelet
