// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/measures/segment_tree.h>

#include <algorithm>

namespace linelet::bench {

namespace {

constexpr std::size_t run = 4; // segments in a leaf

template <class Box>
double
squaredDistance(const Box& box, const Point& query)
{
  return (box.low - query).cwiseMax(query - box.high).cwiseMax(0.0).squaredNorm();
}

} // namespace

SegmentTree::SegmentTree(const CurveNetwork& network)
{
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    const Curve& curve = network.curves[c];
    const std::size_t count = curve.points.size();
    if (count == 1)
      segments_.push_back({curve.points[0], curve.points[0], c, 0});
    double arc = 0;
    for (std::size_t i = 0; count > 1 && i + (curve.closed ? 0 : 1) < count; ++i) {
      const Point& a = curve.points[i];
      const Point& b = curve.points[(i + 1) % count];
      segments_.push_back({a, b, c, arc});
      arc += (b - a).norm();
    }
  }
  for (leaves_ = 1; leaves_ * run < segments_.size();)
    leaves_ *= 2;
  boxes_.resize(2 * leaves_ - 1);
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    Box& box = boxes_[leaves_ - 1 + s / run];
    box.low = box.low.cwiseMin(segments_[s].a).cwiseMin(segments_[s].b);
    box.high = box.high.cwiseMax(segments_[s].a).cwiseMax(segments_[s].b);
  }
  for (std::size_t node = leaves_ - 1; node-- > 0;) {
    const Box &left = boxes_[2 * node + 1], &right = boxes_[2 * node + 2];
    boxes_[node].low = left.low.cwiseMin(right.low);
    boxes_[node].high = left.high.cwiseMax(right.high);
  }
}

void
SegmentTree::test(const Point& query, std::size_t segment, Nearest& best) const
{
  const Segment& s = segments_[segment];
  const Point edge = s.b - s.a, offset = query - s.a;
  const double squared_length = edge.squaredNorm();
  const double parameter =
      squared_length > 0 ? std::clamp(offset.dot(edge) / squared_length, 0.0, 1.0) : 0;
  const double squared = (offset - parameter * edge).squaredNorm();
  if (squared < best.squared_distance)
    best = {segment, parameter, squared};
}

void
SegmentTree::descend(std::size_t node, const Point& query, Nearest& best) const
{
  if (node >= leaves_ - 1) {
    const std::size_t begin = (node - (leaves_ - 1)) * run;
    for (std::size_t s = begin; s < std::min(begin + run, segments_.size()); ++s)
      test(query, s, best);
    return;
  }
  std::size_t near = 2 * node + 1, far = near + 1;
  double near_squared = squaredDistance(boxes_[near], query);
  double far_squared = squaredDistance(boxes_[far], query);
  if (far_squared < near_squared) {
    std::swap(near, far);
    std::swap(near_squared, far_squared);
  }
  if (near_squared < best.squared_distance)
    descend(near, query, best);
  if (far_squared < best.squared_distance)
    descend(far, query, best);
}

SegmentTree::Nearest
SegmentTree::nearest(const Point& query, std::size_t hint) const
{
  Nearest best;
  if (hint < segments_.size())
    test(query, hint, best);
  if (!segments_.empty())
    descend(0, query, best);
  return best;
}

SegmentTree::Nearest
SegmentTree::nearestOn(std::size_t curve, const Point& query) const
{
  // The segments of a curve are consecutive, in the order of the curves.
  const auto before = [](const Segment& s, std::size_t c) { return s.curve < c; };
  auto s = std::lower_bound(segments_.begin(), segments_.end(), curve, before);
  Nearest best;
  for (; s != segments_.end() && s->curve == curve; ++s)
    test(query, static_cast<std::size_t>(s - segments_.begin()), best);
  return best;
}

} // namespace linelet::bench
