// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves along tensors given on a grid, as in a diffusion tensor image (Ritter & Benger
// 2012, section 2.3).

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <linelet/curves/streamline_reconstruction.h>

using namespace linelet;

namespace {

constexpr double cell = 0.2; // of the grid, and steps of a quarter, as published

/** \brief A direction field that curves everywhere: an ABC flow. */
Point
truth(const Point& p)
{
  return Point(std::sin(p.z()) + std::cos(p.y()),
               std::sin(p.x()) + std::cos(p.z()),
               std::sin(p.y()) + std::cos(p.x()))
      .normalized();
}

/** \brief Prolate, twice as long as wide along a direction, and of any size. */
SymmetricTensor
prolate(const Point& along, double size)
{
  SymmetricTensor t;
  t.add(size, along);
  for (Eigen::Index a = 0; a < 3; ++a)
    t.add(size, Point::Unit(a));
  return t;
}

/** \brief Tensors of the field on a grid of n x n x n. */
struct Grid {
  static constexpr int n = 20;
  Points points;
  std::vector<SymmetricTensor> tensors;

  Grid()
  {
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          points.emplace_back(cell * i, cell * j, cell * k);
          tensors.push_back(prolate(truth(points.back()), 1 + (i + j + k) % 3));
        }
  }

  static std::size_t
  number(int i, int j, int k)
  {
    return static_cast<std::size_t>((k * n + j) * n + i);
  }

  /** \brief Trilinear interpolation of the direction between grid points. */
  Point
  direction(const Point& at, const Point& last) const
  {
    const Point place = at / cell;
    const Eigen::Vector3i low = place.array().floor().cast<int>();
    Point sum = Point::Zero();
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1;
      Eigen::Vector3i of = low;
      for (int a = 0; a < 3; ++a) {
        const double part = place[a] - low[a];
        const bool upper = ((corner >> a) & 1) != 0;
        of[a] += upper ? 1 : 0;
        weight *= upper ? part : 1 - part;
      }
      const Point e = truth(points[number(of.x(), of.y(), of.z())]);
      sum += weight * (e.dot(last) < 0 ? Point(-e) : e);
    }
    return sum.normalized();
  }
};

StreamlineSettings
settingsOf(const Grid& grid, Index start, const Point& seed)
{
  StreamlineSettings settings;
  settings.tensors = grid.tensors;
  settings.direction = DirectionMode::Eigenvector;
  settings.interpolation_weighting = Kernel::Linear;
  settings.interpolation_radius = 1; // exactly the eight corners of a cell: linear
  settings.scheme = IntegrationScheme::Euler;
  settings.step = 0.25;
  settings.max_iterations = 20;
  settings.prune_distance = 4; // a cell: ends lie between points
  settings.starts = {start};
  settings.seed_direction = {seed.x(), seed.y(), seed.z()};
  return settings;
}

/** \brief The end of a line after 20 Euler steps. */
template <class Field>
Point
endOf(Point at, Point last, const Field& field)
{
  for (int step = 0; step < 20; ++step) {
    last = field(at, last);
    at += 0.25 * cell * last;
  }
  return at;
}

TEST(GivenTensors, LinesCoincideWithThoseOfTheUniformGrid)
{
  const Grid grid;
  const unsigned seed = 3;
  SCOPED_TRACE("seed " + std::to_string(seed));
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> inner(6, 13);
  const auto place = [&] { return static_cast<int>(inner(random)); };
  // 144 lines of length 1, of which 131 coincide in the publication.
  int coincide = 0, as_the_truth = 0;
  for (int line = 0; line < 144; ++line) {
    const int i = place(), j = place(), k = place();
    const std::size_t start = Grid::number(i, j, k);
    const Point from = grid.points[start], ahead = truth(from);
    const CurveNetwork network = reconstructPublished(
        grid.points, settingsOf(grid, static_cast<Index>(start), ahead));
    ASSERT_EQ(network.curves.size(), 1u);
    const Points& way = network.curves[0].points;
    ASSERT_EQ(way.size(), 21u);
    EXPECT_NEAR(length(network), 1, 1e-9);
    const Point end = (way.front() - from).norm() < 1e-9 ? way.back() : way.front();
    const Point on_grid = endOf(from, ahead, [&](const Point& at, const Point& last) {
      return grid.direction(at, last);
    });
    const Point exact =
        endOf(from, ahead, [&](const Point& at, const Point&) { return truth(at); });
    coincide += (end - on_grid).norm() < 0.1 * cell ? 1 : 0;
    as_the_truth += (end - exact).norm() < 0.1 * cell ? 1 : 0;
  }
  EXPECT_GE(coincide, 131);
  EXPECT_GE(as_the_truth, 131);
}

TEST(GivenTensors, EveryModeThatFollowsTensorsFollowsACircle)
{
  Points points;
  std::vector<SymmetricTensor> tensors;
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j)
      for (int k = 0; k < 3; ++k) {
        points.emplace_back(0.1 * i, 0.1 * j, 0.1 * k);
        const Point around(-points.back().y(), points.back().x(), 0);
        tensors.push_back(around.norm() > 0 ? prolate(around.normalized(), 1)
                                            : SymmetricTensor{});
      }
  for (const DirectionMode mode : {DirectionMode::Eigenvector, DirectionMode::Tensor}) {
    StreamlineSettings settings;
    settings.tensors = tensors;
    settings.direction = mode;
    settings.interpolation_radius = 1.5;
    settings.scheme = IntegrationScheme::Rk4;
    settings.starts = {(16 * 21 + 10) * 3 + 1}; // at (.6, 0, .1)
    ASSERT_LT((points[settings.starts[0]] - Point(0.6, 0, 0.1)).norm(), 1e-9);
    const CurveNetwork network = reconstructPublished(points, settings);
    ASSERT_EQ(network.curves.size(), 1u) << nameOf(mode);
    EXPECT_TRUE(network.curves[0].closed) << nameOf(mode);
    EXPECT_NEAR(length(network), 2 * 3.14159265 * 0.6, 0.1) << nameOf(mode);
    for (const Point& p : network.curves[0].points) {
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 0.6, 0.03) << nameOf(mode);
      EXPECT_NEAR(p.z(), 0.1, 0.01) << nameOf(mode);
    }
  }
}

TEST(GivenTensors, InvalidTensorsAreIgnored)
{
  const Grid grid;
  StreamlineSettings settings = settingsOf(grid, 0, Point::UnitX());
  settings.tensors.assign(grid.points.size(), SymmetricTensor{});
  settings.starts.clear();
  settings.seed_direction.clear();
  EXPECT_TRUE(reconstructPublished(grid.points, settings).curves.empty());
  settings.tensors.pop_back();
  EXPECT_THROW(reconstructPublished(grid.points, settings), std::invalid_argument);
  settings.tensors = grid.tensors;
  settings.direction = DirectionMode::ComputedAngular;
  EXPECT_THROW(reconstructPublished(grid.points, settings), std::invalid_argument);
}

} // namespace
