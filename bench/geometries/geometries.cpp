// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/geometries/geometries.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace linelet::bench {

namespace {

Curve
open(Points vertices)
{
  Curve curve;
  curve.points = std::move(vertices);
  return curve;
}

Curve
closed(Points vertices)
{
  Curve curve = open(std::move(vertices));
  curve.closed = true;
  curve.front.kind = curve.back.kind = EndKind::Loop;
  return curve;
}

/** \brief 800 vertices of \a at over the parameters [begin, end), or [begin, end]. */
template <class At>
Points
trace(At at, double begin, double end, bool include_end)
{
  constexpr std::size_t steps = 800;
  Points vertices;
  for (std::size_t i = 0; i < steps + (include_end ? 1 : 0); ++i)
    vertices.push_back(at(begin + (end - begin) * static_cast<double>(i) / steps));
  return vertices;
}

/** \brief Arms from \a center, where they are joined. */
CurveNetwork
arms(const Point& center, const Points& tips)
{
  CurveNetwork network;
  network.junctions.push_back({center, {}});
  for (const Point& tip : tips) {
    network.junctions.front().curves.push_back(network.curves.size());
    network.curves.push_back(open({center, tip}));
    network.curves.back().front = {EndKind::Junction, 0};
  }
  return network;
}

Point
sCurve(double t)
{
  // Half circles of radius 2.5 around (0, 2.5) and (0, -2.5), passing through the
  // origin.
  const double angle =
      t < 0.5 ? M_PI / 2 + 2 * M_PI * t : M_PI / 2 - 2 * M_PI * (t - 0.5);
  const Point center(0, t < 0.5 ? 2.5 : -2.5, 0);
  return center + 2.5 * Point(std::cos(angle), std::sin(angle), 0);
}

CurveNetwork
star()
{
  Points corners;
  for (int i = 0; i < 10; ++i) {
    const double angle = M_PI / 2 + i * M_PI / 5, radius = i % 2 == 0 ? 5.0 : 2.0;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return {{closed(corners)}, {}};
}

CurveNetwork
flatTruthOf(Geometry geometry)
{
  switch (geometry) {
  case Geometry::Circle:
    return {{closed(trace(
                [](double t) { return Point(5 * std::cos(t), 5 * std::sin(t), 0); },
                0,
                2 * M_PI,
                false))},
            {}};
  case Geometry::Rectangle:
    return {{closed({{-5, -4, 0}, {5, -4, 0}, {5, 4, 0}, {-5, 4, 0}})}, {}};
  case Geometry::Triangle: {
    const double height = 5 * std::sqrt(3.0);
    return {
        {closed({{-5, -height / 3, 0}, {5, -height / 3, 0}, {0, 2 * height / 3, 0}})},
        {}};
  }
  case Geometry::Line:
    return {{open({{-5, -3, 0}, {5, 3, 0}})}, {}};
  case Geometry::Wave:
    return {{open(trace(
                [](double x) { return Point(x, 2 * std::sin(2 * M_PI * x / 5), 0); },
                -5,
                5,
                true))},
            {}};
  case Geometry::Crossing:
    return {{open({{-5, -5, 0}, {5, 5, 0}}), open({{-5, 5, 0}, {5, -5, 0}})}, {}};
  case Geometry::Elbow:
    return {{open({{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {5, 5, 5}})}, {}};
  case Geometry::Helix:
    return {{open(trace(
                [](double t) {
                  return Point(3 * std::cos(t), 3 * std::sin(t), 10 * t / (4 * M_PI));
                },
                0,
                4 * M_PI,
                true))},
            {}};
  case Geometry::Mikado:
    return {{open({{-5, -1, -1}, {5, 1, 1}}),
             open({{-4, -3, 1}, {4, 3, 1}}),
             open({{-1, -5, 2}, {1, 5, 2.5}}),
             open({{1.5, -2, 3.5}, {-2, 0.5, -5.5}})},
            {}};
  case Geometry::Crossing3d:
    return {{open({{-5, 0, 0}, {5, 0, 0}}),
             open({{0, -5, 0}, {0, 5, 0}}),
             open({{0, 0, -5}, {0, 0, 5}})},
            {}};
  case Geometry::FigureEight:
    return {{closed(trace(
                [](double t) {
                  return Point(
                      5 * std::sin(t), 2.5 * std::sin(2 * t), 1.5 * std::cos(t));
                },
                0,
                2 * M_PI,
                false))},
            {}};
  case Geometry::YBranch:
    return arms({0, 0, 0}, {{0, -5, 0}, {4, 3.5, 1}, {-4, 3.5, -1}});
  case Geometry::Tee: {
    // The bar is one component, so that the arm meets it inside an edge.
    CurveNetwork tee{{open({{-5, 0, 0}, {5, 0, 0}}), open({{0, 0, 0}, {0, -5, 2}})},
                     {}};
    tee.junctions.push_back({{0, 0, 0}, {0, 1}});
    tee.curves[1].front = {EndKind::Junction, 0};
    return tee;
  }
  case Geometry::Parallel:
    return {{open({{-5, -0.5, 0}, {5, -0.5, 0}}), open({{-5, 0.5, 0}, {5, 0.5, 0}})},
            {}};
  case Geometry::Vee: {
    const double half = M_PI / 12, x = 10 * std::cos(half), y = 10 * std::sin(half);
    return {{open({{5 - x, -y, 0}, {5, 0, 0}, {5 - x, y, 0}})}, {}};
  }
  case Geometry::Spiral:
    return {{open(trace(
                [](double t) {
                  const double radius = 1 + 4 * t / (4.5 * M_PI);
                  return Point(radius * std::cos(t), radius * std::sin(t), 0);
                },
                0,
                4.5 * M_PI,
                true))},
            {}};
  case Geometry::SCurve:
    return {{open(trace(sCurve, 0, 1, true))}, {}};
  case Geometry::Star:
    return star();
  case Geometry::Trefoil:
    return {{closed(trace(
                [](double t) {
                  const double radius = 1.6 * (2 + std::cos(3 * t));
                  return Point(radius * std::cos(2 * t),
                               radius * std::sin(2 * t),
                               1.6 * std::sin(3 * t));
                },
                0,
                2 * M_PI,
                false))},
            {}};
  }
  return {};
}

/** \brief Adds vertices along straight edges, so that they can be bent. */
void
refine(Curve& curve, double step)
{
  Points fine;
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i) {
    const Point a = curve.points[i], b = curve.points[(i + 1) % count];
    const auto pieces = static_cast<std::size_t>(std::ceil((b - a).norm() / step));
    for (std::size_t k = 0; k < pieces; ++k)
      fine.push_back(a +
                     (b - a) * (static_cast<double>(k) / static_cast<double>(pieces)));
  }
  if (!curve.closed)
    fine.push_back(curve.points.back());
  curve.points = std::move(fine);
}

} // namespace

const std::vector<Geometry>&
benchmarkGeometries()
{
  static const std::vector<Geometry> ten = {Geometry::Circle,
                                            Geometry::Rectangle,
                                            Geometry::Triangle,
                                            Geometry::Line,
                                            Geometry::Wave,
                                            Geometry::Crossing,
                                            Geometry::Elbow,
                                            Geometry::Helix,
                                            Geometry::Mikado,
                                            Geometry::Crossing3d};
  return ten;
}

const std::vector<Geometry>&
heldOutGeometries()
{
  static const std::vector<Geometry> apart = {Geometry::FigureEight,
                                              Geometry::YBranch,
                                              Geometry::Tee,
                                              Geometry::Parallel,
                                              Geometry::Vee,
                                              Geometry::Spiral,
                                              Geometry::SCurve,
                                              Geometry::Star,
                                              Geometry::Trefoil};
  return apart;
}

CurveNetwork
truthOf(Geometry geometry, double out_of_plane)
{
  return bentOutOfPlane(flatTruthOf(geometry), out_of_plane);
}

CurveNetwork
bentOutOfPlane(CurveNetwork network, double out_of_plane)
{
  if (out_of_plane == 0 || network.curves.empty())
    return network;
  double low = network.curves.front().points.front().y(), high = low;
  for (const Curve& curve : network.curves)
    for (const Point& vertex : curve.points) {
      low = std::min(low, vertex.y());
      high = std::max(high, vertex.y());
    }
  const double center = (low + high) / 2, extent = high > low ? high - low : 1;
  const auto bend = [&](Point& p) {
    p.z() += out_of_plane * std::cos(M_PI / 2 * (p.y() - center) / (2 * extent));
  };
  for (Curve& curve : network.curves) {
    refine(curve, 0.05);
    for (Point& vertex : curve.points)
      bend(vertex);
  }
  for (Junction& junction : network.junctions)
    bend(junction.position);
  return network;
}

double
densityOf(Geometry geometry, double t)
{
  return geometry == Geometry::SCurve ? 1 - 0.75 * t : 1;
}

} // namespace linelet::bench
