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
  PieceLink there, back;
};

/** \brief The place on a course nearest to a point. */
struct NearestPlace {
  double distance = std::numeric_limits<double>::infinity();
  Point at = Point::Zero();
  std::size_t edge = 0; ///< that it is on
  std::size_t next = 0; ///< the first vertex behind it
};

/** \param[in] same distance within which two places count as one */
NearestPlace
nearestOn(const Points& course, const Point& p, double same)
{
  NearestPlace nearest;
  for (std::size_t k = 0; k + 1 < course.size(); ++k) {
    const Point& a = course[k];
    const Point way = course[k + 1] - a;
    const double squared = way.squaredNorm();
    const double t = squared > 0 ? std::clamp(way.dot(p - a) / squared, 0.0, 1.0) : 0;
    const Point at = a + t * way;
    if ((at - p).norm() <= nearest.distance)
      nearest = {
          (at - p).norm(), at, k, (course[k + 1] - at).norm() > same ? k + 1 : k + 2};
  }
  return nearest;
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

  /** \brief Whether the end is not cut, just not continued. */
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
    if (outward(a).dot(outward(b)) >= 0)
      return;
    const double same = 1e-3 * tolerance_;
    const NearestPlace on_a = nearestOn(courseOf(a), place(b), same),
                       on_b = nearestOn(courseOf(b), place(a), same);
    const double apart = std::max(on_a.distance, on_b.distance);
    if (apart <= tolerance_)
      candidates_.push_back({apart, a, b, linkTo(b, a, on_b), linkTo(a, b, on_a)});
  }

  /** \brief An end that was cut and one that just ends. */
  void
  reach(std::size_t a, std::size_t b)
  {
    if (outward(a).dot(outward(b)) >= 0)
      return;
    Points course = cut(a).beyond;
    course.insert(course.begin(), place(a));
    const NearestPlace nearest = nearestOn(course, place(b), 1e-3 * tolerance_);
    if (nearest.distance > tolerance_)
      return;
    PieceLink there, back;
    there.to = b;
    there.bridge.assign(course.begin() + 1,
                        course.begin() + 1 + static_cast<std::ptrdiff_t>(nearest.edge));
    back.to = a;
    back.bridge.assign(there.bridge.rbegin(), there.bridge.rend());
    candidates_.push_back({nearest.distance, a, b, there, back});
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
      links[c.a] = c.there;
      links[c.b] = c.back;
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

  /** From \a end to where \a to continues it, at \a nearest on its course. */
  PieceLink
  linkTo(std::size_t to, std::size_t end, const NearestPlace& nearest) const
  {
    PieceLink link;
    link.to = to;
    link.seam = (place(end) + nearest.at) / 2;
    const Points& beyond = cut(to).beyond;
    for (std::size_t k = nearest.next; k < beyond.size(); ++k)
      link.bridge.push_back(beyond[beyond.size() - 1 - k]);
    link.skip = nearest.next - std::min(nearest.next, beyond.size());
    return link;
  }

  /** The course of the curve on both sides of the cut, equally far. */
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
  // At a corner, one may have gone through a third part and the other not.
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
