// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "piece_ends.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace linelet {

namespace {

/** \brief Two ends that may be joined, and how far apart their courses are. */
struct Candidate {
  double apart;
  std::size_t a, b;
  bool amid;
  Points bridge;
};

double
distanceTo(const Points& course, const Point& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < course.size(); ++k) {
    const Point& a = course[k];
    const Point way = course[std::min(k + 1, course.size() - 1)] - a;
    const double squared = way.squaredNorm();
    const double t = squared > 0 ? std::clamp(way.dot(p - a) / squared, 0.0, 1.0) : 0;
    least = std::min(least, (a + t * way - p).norm());
  }
  return least;
}

class EndLinks {
public:
  EndLinks(const std::vector<CurvePiece>& pieces, double tolerance)
      : links(2 * pieces.size()), pieces_(pieces), tolerance_(tolerance)
  {
  }

  PieceLinks links;

  bool
  isFree(std::size_t end) const
  {
    return links[end].to == PieceLink::none;
  }

  const CurvePiece::Cut&
  cut(std::size_t end) const
  {
    return pieces_[end / 2].cuts[end % 2];
  }

  bool
  isCut(std::size_t end) const
  {
    return cut(end).neighbor != CurvePiece::whole;
  }

  /** \brief Whether it ends for no reason but that nothing goes on. */
  bool
  isOpen(std::size_t end) const
  {
    const Curve& curve = pieces_[end / 2].curve;
    const CurveEnd& state = end % 2 == 0 ? curve.front : curve.back;
    return !curve.closed && !isCut(end) && state.junction < 0;
  }

  const Point&
  place(std::size_t end) const
  {
    const Points& points = pieces_[end / 2].curve.points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  /** \brief Two ends that were cut at the border of their parts. */
  void
  meet(std::size_t a, std::size_t b)
  {
    const Point way = place(b) - place(a);
    if (way.norm() > tolerance_ + std::max(reachOf(a), reachOf(b)) ||
        outward(a).dot(outward(b)) >= 0)
      return;
    const double apart =
        std::max(distanceTo(courseOf(a), place(b)), distanceTo(courseOf(b), place(a)));
    if (apart <= tolerance_)
      candidates_.push_back({apart, a, b, true, {}});
  }

  /** \brief An end that was cut, and one that just ends. */
  void
  reach(std::size_t a, std::size_t b)
  {
    const Points& beyond = cut(a).beyond;
    const Point& end = place(b);
    double least = std::min(tolerance_, (place(a) - end).norm());
    std::size_t count = 0;
    for (std::size_t k = 0; k < beyond.size(); ++k)
      if ((beyond[k] - end).norm() < least) {
        least = (beyond[k] - end).norm();
        count = k;
      }
    if (least > tolerance_ || outward(a).dot(outward(b)) >= 0)
      return;
    candidates_.push_back(
        {least,
         a,
         b,
         false,
         Points(beyond.begin(), beyond.begin() + static_cast<std::ptrdiff_t>(count))});
  }

  /** \brief Joins candidates, the closest first. */
  void
  join()
  {
    std::sort(candidates_.begin(), candidates_.end(), [](const auto& x, const auto& y) {
      return std::tie(x.apart, x.a, x.b) < std::tie(y.apart, y.a, y.b);
    });
    for (const Candidate& c : candidates_) {
      if (!isFree(c.a) || !isFree(c.b) || c.a == c.b)
        continue;
      links[c.a] = {c.b, c.amid, c.bridge};
      links[c.b] = {c.a, c.amid, Points(c.bridge.rbegin(), c.bridge.rend())};
    }
    candidates_.clear();
  }

private:
  Point
  outward(std::size_t end) const
  {
    const Points& points = pieces_[end / 2].curve.points;
    return end % 2 == 0 ? Point(points.front() - points[1])
                        : Point(points.back() - points[points.size() - 2]);
  }

  double
  reachOf(std::size_t end) const
  {
    const Points& beyond = cut(end).beyond;
    return beyond.empty() ? 0 : (beyond.back() - place(end)).norm();
  }

  /** The curve beyond the cut, and as far before it. */
  Points
  courseOf(std::size_t end) const
  {
    const Points& points = pieces_[end / 2].curve.points;
    const Points& beyond = cut(end).beyond;
    const std::size_t before = std::min(points.size(), beyond.size() + 2);
    Points course(beyond.rbegin(), beyond.rend());
    for (std::size_t k = 0; k < before; ++k)
      course.push_back(points[end % 2 == 0 ? k : points.size() - 1 - k]);
    return course;
  }

  const std::vector<CurvePiece>& pieces_;
  double tolerance_;
  std::vector<Candidate> candidates_;
};

} // namespace

PieceLinks
linkEnds(const std::vector<CurvePiece>& pieces,
         const std::vector<std::size_t>& part_of,
         double tolerance)
{
  EndLinks ends(pieces, tolerance);
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> cuts;
  std::map<std::size_t, std::vector<std::size_t>> open; // by part
  for (std::size_t end = 0; end < 2 * pieces.size(); ++end) {
    if (ends.isCut(end))
      cuts[{part_of[end / 2], ends.cut(end).neighbor}].push_back(end);
    else if (ends.isOpen(end))
      open[part_of[end / 2]].push_back(end);
  }
  for (const auto& [parts, from] : cuts) {
    const auto to = cuts.find({parts.second, parts.first});
    if (parts.first > parts.second || to == cuts.end())
      continue;
    for (const std::size_t a : from)
      for (const std::size_t b : to->second)
        ends.meet(a, b);
  }
  ends.join();
  // At a corner, one went through a third part and the other did not.
  std::vector<std::size_t> left;
  for (const auto& [parts, from] : cuts)
    std::copy_if(from.begin(), from.end(), std::back_inserter(left), [&](auto end) {
      return ends.isFree(end);
    });
  for (const std::size_t a : left)
    for (const std::size_t b : left)
      if (part_of[a / 2] < part_of[b / 2])
        ends.meet(a, b);
  ends.join();
  for (const auto& [parts, from] : cuts)
    for (const std::size_t a : from)
      if (ends.isFree(a))
        for (const std::size_t b : open[parts.second])
          ends.reach(a, b);
  ends.join();
  return std::move(ends.links);
}

} // namespace linelet
