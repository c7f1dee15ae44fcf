// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/curve_parts.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace linelet {

namespace {

/** \brief Where the segment from \a inside, which \a self owns, to \a outside leaves
 * its region. */
double
leavesAt(const Point& inside,
         const Point& outside,
         std::size_t self,
         const PartOwner& owner)
{
  double in = 0, out = 1;
  for (int step = 0; step < 60; ++step) {
    const double middle = (in + out) / 2;
    (owner(inside + middle * (outside - inside)) == self ? in : out) = middle;
  }
  return out;
}

/** \brief Cuts one curve. */
class Cutter {
public:
  Cutter(const Curve& curve, std::size_t self, const PartOwner& owner, double reach)
      : curve_(opened(curve, self, owner)), self_(self), owner_(owner), reach_(reach)
  {
    markBorders();
  }

  void
  addTo(std::vector<CurvePiece>& pieces) const
  {
    for (std::size_t begin = 0; begin < owners_.size();) {
      std::size_t end = begin;
      while (end < owners_.size() && owners_[end] == self_)
        ++end;
      if (end > begin)
        pieces.push_back(pieceOf(begin, end));
      begin = end + 1;
    }
  }

private:
  /** Opens a closed curve at a vertex of another part, if it has to be cut. */
  static Curve
  opened(Curve curve, std::size_t self, const PartOwner& owner)
  {
    if (!curve.closed)
      return curve;
    const auto other = std::find_if(curve.points.begin(),
                                    curve.points.end(),
                                    [&](const Point& p) { return owner(p) != self; });
    const auto first = other - curve.points.begin();
    if (other == curve.points.end())
      return curve;
    std::rotate(curve.points.begin(), other, curve.points.end());
    curve.points.push_back(curve.points.front());
    if (!curve.support.empty()) {
      std::rotate(
          curve.support.begin(), curve.support.begin() + first, curve.support.end());
      curve.support.push_back(0);
    }
    curve.closed = false;
    return curve;
  }

  /** Inserts vertices where the curve crosses borders, so that every edge has one
   * owner. */
  void
  markBorders()
  {
    Points marked;
    std::vector<Index> support;
    const Points& points = curve_.points;
    for (std::size_t v = 0; v < points.size(); ++v) {
      marked.push_back(points[v]);
      if (!curve_.support.empty())
        support.push_back(curve_.support[v]);
      if (v + 1 == points.size())
        break;
      owners_.push_back(owner_(points[v]));
      while (owner_(points[v + 1]) != owners_.back()) {
        const Point at = marked.back();
        const double t = leavesAt(at, points[v + 1], owners_.back(), owner_);
        const Point border = at + t * (points[v + 1] - at);
        if (border == points[v + 1])
          break;
        marked.push_back(border);
        owners_.push_back(owner_(border));
        if (!curve_.support.empty())
          support.push_back(0);
      }
    }
    curve_.points = std::move(marked);
    curve_.support = std::move(support);
  }

  /** Edges begin to end - 1. */
  CurvePiece
  pieceOf(std::size_t begin, std::size_t end) const
  {
    CurvePiece piece;
    Curve& curve = piece.curve;
    curve = curve_;
    const auto at = [](const auto& list, std::size_t k) {
      return list.begin() + static_cast<std::ptrdiff_t>(k);
    };
    curve.points.assign(at(curve_.points, begin), at(curve_.points, end + 1));
    if (!curve_.support.empty())
      curve.support.assign(at(curve_.support, begin), at(curve_.support, end + 1));
    if (begin > 0) {
      curve.front = {EndKind::Bounds, -1};
      piece.cuts[0] = {owners_[begin - 1], courseFrom(curve_.points, begin - 1, -1)};
    }
    if (end < owners_.size()) {
      curve.back = {EndKind::Bounds, -1};
      piece.cuts[1] = {owners_[end], courseFrom(curve_.points, end + 1, 1)};
    }
    const double all = length(curve_);
    curve.evidence *= all > 0 ? length(curve) / all : 1;
    return piece;
  }

  /** The vertices of \a points from \a begin on, in direction \a way, within reach. */
  Points
  courseFrom(const Points& points, std::size_t begin, std::ptrdiff_t way) const
  {
    Points course;
    double sum = 0;
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    for (auto k = static_cast<std::ptrdiff_t>(begin);
         k >= 0 && k < count && sum <= reach_;
         k += way) {
      const Point& p = points[static_cast<std::size_t>(k)];
      if (!course.empty())
        sum += (p - course.back()).norm();
      course.push_back(p);
    }
    return course;
  }

  Curve curve_;
  std::size_t self_;
  const PartOwner& owner_;
  double reach_;
  std::vector<std::size_t> owners_; // by edge
};

} // namespace

CurvePart
ownedBy(const CurveNetwork& found,
        std::size_t self,
        const PartOwner& owner,
        double reach)
{
  CurvePart part;
  std::vector<std::size_t> curve_of; // by piece
  for (std::size_t c = 0; c < found.curves.size(); ++c) {
    Cutter(found.curves[c], self, owner, reach).addTo(part.pieces);
    curve_of.resize(part.pieces.size(), c);
  }
  std::vector<int> number(found.junctions.size(), -1);
  for (std::size_t j = 0; j < found.junctions.size(); ++j) {
    const Junction& junction = found.junctions[j];
    if (owner(junction.position) != self)
      continue;
    number[j] = static_cast<int>(part.junctions.size());
    part.junctions.push_back({junction.position, {}});
    for (std::size_t p = 0; p < part.pieces.size(); ++p) {
      const Points& points = part.pieces[p].curve.points;
      const auto& curves = junction.curves;
      // Junctions are vertices of all their curves.
      if (std::find(curves.begin(), curves.end(), curve_of[p]) != curves.end() &&
          std::find(points.begin(), points.end(), junction.position) != points.end())
        part.junctions.back().curves.push_back(p);
    }
  }
  for (CurvePiece& piece : part.pieces)
    for (CurveEnd* end : {&piece.curve.front, &piece.curve.back})
      if (end->kind == EndKind::Junction) {
        end->junction = number[static_cast<std::size_t>(end->junction)];
        if (end->junction < 0)
          *end = {EndKind::Support, -1};
      }
  return part;
}

} // namespace linelet
