// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/geometries/random_shapes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace linelet::bench {

namespace {

constexpr double extent = 10;
constexpr int smooth_vertices = 400;
constexpr double sample_step = 0.1; // of the test for stretches that pass each other
constexpr int waves = 3;            // of a smooth curve
constexpr double degree = pi / 180;

Point
randomDirection(bool flat, Random& random)
{
  while (true) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = flat ? 0 : random.uniform(-1, 1);
    const Point p(x, y, z);
    if (p.norm() > 0.1 && p.norm() < 1)
      return p.normalized();
  }
}

/** \brief \a direction turned by \a angle toward a random direction across it. */
Point
turnedAtRandom(const Point& direction, double angle, bool flat, Random& random)
{
  while (true) {
    const Point other = randomDirection(flat, random);
    const Point across = other - other.dot(direction) * direction;
    if (across.norm() > 0.3)
      return std::cos(angle) * direction + std::sin(angle) * across.normalized();
  }
}

Curve
curveOf(const Points& points, bool closed)
{
  Curve curve;
  curve.points = points;
  curve.closed = closed;
  if (closed)
    curve.front.kind = curve.back.kind = EndKind::Loop;
  return curve;
}

/** \brief A sum of waves whose amplitude falls with their number. */
class Waves {
public:
  Waves(double amplitude, int first, Random& random) : first_(first)
  {
    for (int k = 0; k < waves; ++k) {
      amplitude_.push_back(random.normal(amplitude / (first + k)));
      phase_.push_back(random.uniform(0, 2 * pi));
    }
  }

  /** \brief The sum at \a angle, of which 2 pi is one wave. */
  double
  at(double angle) const
  {
    double sum = 0;
    for (int k = 0; k < waves; ++k) {
      const auto i = static_cast<std::size_t>(k);
      sum += amplitude_[i] * std::sin((first_ + k) * angle + phase_[i]);
    }
    return sum;
  }

private:
  int first_;
  std::vector<double> amplitude_, phase_;
};

/** \brief A curve whose direction swings as waves do. */
Curve
openCurve(double amplitude, bool flat, Random& random)
{
  const Waves azimuth(amplitude, 1, random), slope(0.5 * amplitude, 1, random);
  Points points{Point::Zero()};
  for (int i = 0; i < smooth_vertices; ++i) {
    const double angle = 2 * pi * (i + 0.5) / smooth_vertices;
    const double rise = flat ? 0 : slope.at(angle);
    points.push_back(points.back() + Point(std::cos(azimuth.at(angle)) * std::cos(rise),
                                           std::sin(azimuth.at(angle)) * std::cos(rise),
                                           std::sin(rise)));
  }
  return curveOf(points, false);
}

Curve
closedCurve(bool flat, Random& random)
{
  const Waves radius(0.4, 2, random), height(0.6, 1, random);
  Points points;
  for (int i = 0; i < smooth_vertices; ++i) {
    const double angle = 2 * pi * i / smooth_vertices, r = 1 + radius.at(angle);
    points.emplace_back(
        r * std::cos(angle), r * std::sin(angle), flat ? 0 : height.at(angle));
  }
  return curveOf(points, true);
}

Curve
polygon(bool flat, Random& random)
{
  const int sides = random.integer(3, 7);
  Points points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * (i + random.uniform(-0.3, 0.3)) / sides;
    const double radius = random.uniform(0.6, 1);
    const double height = flat ? 0 : random.uniform(-0.4, 0.4);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
  }
  return curveOf(points, true);
}

Curve
corners(bool flat, Random& random)
{
  const int sides = random.integer(2, 5);
  Point direction = randomDirection(flat, random);
  Points points{Point::Zero()};
  for (int i = 0; i < sides; ++i) {
    points.push_back(points.back() + random.uniform(0.6, 1.2) * direction);
    direction = turnedAtRandom(
        direction, random.uniform(40 * degree, 110 * degree), flat, random);
  }
  return curveOf(points, false);
}

CurveNetwork
tree(bool flat, Random& random)
{
  CurveNetwork network;
  const Point up = randomDirection(flat, random);
  network.curves.push_back(curveOf({Point::Zero(), up}, false));
  const int branches = random.integer(2, 4);
  for (int b = 0; b < branches; ++b) {
    const auto parent = static_cast<std::size_t>(
        random.integer(0, static_cast<int>(network.curves.size()) - 1));
    const Points ends = network.curves[parent].points;
    const Point from = ends[0] + random.uniform(0.25, 0.75) * (ends[1] - ends[0]);
    const double angle = random.uniform(35 * degree, 90 * degree);
    const Point direction =
        turnedAtRandom((ends[1] - ends[0]).normalized(), angle, flat, random);
    Curve branch = curveOf({from, from + random.uniform(0.35, 0.7) * direction}, false);
    branch.front = {EndKind::Junction, b};
    network.junctions.push_back({from, {parent, network.curves.size()}});
    network.curves.push_back(branch);
  }
  return network;
}

/** \brief Corners of the box around \a network. */
Eigen::AlignedBox3d
boxOf(const CurveNetwork& network)
{
  Eigen::AlignedBox3d box;
  for (const Curve& curve : network.curves)
    for (const Point& p : curve.points)
      box.extend(p);
  return box;
}

/** \brief Moves and scales \a network into its box. */
void
fitIntoBox(CurveNetwork& network)
{
  const Eigen::AlignedBox3d box = boxOf(network);
  const double factor = extent / box.sizes().maxCoeff();
  const auto place = [&](Point& p) { p = factor * (p - box.center()); };
  for (Curve& curve : network.curves)
    for (Point& p : curve.points)
      place(p);
  for (Junction& junction : network.junctions)
    place(junction.position);
}

/** \brief Copies of the curve of \a network beside it, at \a distance of each other. */
void
addParallels(CurveNetwork& network, double distance, bool flat, Random& random)
{
  const Points middle = network.curves.front().points;
  const Point up = flat ? Point(Point::UnitZ()) : randomDirection(false, random);
  const int count = random.integer(2, 3);
  network.curves.clear();
  for (int k = 0; k < count; ++k) {
    Points points;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      const Point along =
          middle[std::min(i + 1, middle.size() - 1)] - middle[i == 0 ? 0 : i - 1];
      points.push_back(middle[i] + (k - 0.5 * (count - 1)) * distance *
                                       up.cross(along).normalized());
    }
    network.curves.push_back(curveOf(points, false));
  }
}

/** \brief Whether no stretch passes another within \a gap: stretches that are farther
 * apart along the curves than they would be around a corner of 35 degrees. */
bool
isClear(const CurveNetwork& network, double gap)
{
  struct Sample {
    Point at;
    std::size_t curve;
    double arc;
  };
  std::vector<Sample> samples;
  std::vector<double> lengths;
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    const Curve& curve = network.curves[c];
    const std::size_t n = curve.points.size();
    double arc = 0;
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
      const Point a = curve.points[i], b = curve.points[(i + 1) % n];
      const double steps = std::ceil((b - a).norm() / sample_step);
      for (double k = 0; k < steps; ++k)
        samples.push_back(
            {a + k / steps * (b - a), c, arc + k / steps * (b - a).norm()});
      arc += (b - a).norm();
    }
    lengths.push_back(arc);
  }
  const double around = 3.5 * gap; // 1 / sin(35 / 2 degrees), and a little more
  const auto meet = [&](const Sample& s, const Sample& t) {
    if (s.curve == t.curve) {
      const double arc = std::abs(s.arc - t.arc);
      const double other =
          network.curves[s.curve].closed ? lengths[s.curve] - arc : arc;
      return std::min(arc, other) < around;
    }
    for (const Junction& junction : network.junctions)
      if ((s.at - junction.position).norm() < around &&
          (t.at - junction.position).norm() < around)
        return true;
    return false;
  };
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = i + 1; j < samples.size(); ++j)
      if ((samples[i].at - samples[j].at).squaredNorm() < gap * gap &&
          !meet(samples[i], samples[j]))
        return false;
  return true;
}

CurveNetwork
draw(ShapeFamily family, bool flat, Random& random)
{
  switch (family) {
  case ShapeFamily::Open:
    return {{openCurve(2, flat, random)}, {}};
  case ShapeFamily::Closed:
    return {{closedCurve(flat, random)}, {}};
  case ShapeFamily::Polygon:
    return {{polygon(flat, random)}, {}};
  case ShapeFamily::Corners:
    return {{corners(flat, random)}, {}};
  case ShapeFamily::Tree:
    return tree(flat, random);
  case ShapeFamily::Parallel:
    return {{openCurve(0.5, flat, random)}, {}};
  }
  return {};
}

} // namespace

CurveNetwork
randomShape(ShapeFamily family, bool flat, double gap, Random& random)
{
  while (true) {
    CurveNetwork network = draw(family, flat, random);
    fitIntoBox(network);
    if (family == ShapeFamily::Parallel)
      addParallels(network, gap + random.uniform(0, 1), flat, random);
    fitIntoBox(network);
    // Copies of a curve that bends come a little closer in the fitted box.
    if (isClear(network, family == ShapeFamily::Parallel ? 0.9 * gap : gap))
      return network;
  }
}

} // namespace linelet::bench
