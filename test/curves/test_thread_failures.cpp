// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// A failure in one of several threads (memory, the caller's search or progress monitor)
// reaches the caller; without a guard the program would terminate.

#include <atomic>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <linelet/curves/streamline_reconstruction.h>
#include <linelet/features/multi_scale.h>
#include <linelet/features/tensor_estimation.h>
#include <linelet/search/kd_tree.h>
#include <linelet/search/scale_unit.h>

using namespace linelet;

namespace {

struct Failure : std::runtime_error {
  Failure() : std::runtime_error("a failure of the test") {}
};

class FailingMonitor : public ProgressMonitor {
public:
  void
  advance(std::size_t) override
  {
    throw Failure();
  }
};

/** Fails after a number of calls. */
class FailingSearch : public NeighborSearch {
public:
  FailingSearch(const Points& points, int questions) : tree_(points), left_(questions)
  {
  }

  void
  within(const Point& query, double radius, Indices& found) const override
  {
    ask();
    tree_.within(query, radius, found);
  }

  double
  nearest(const Point& query, std::size_t count, Indices& found) const override
  {
    ask();
    return tree_.nearest(query, count, found);
  }

  int
  left() const
  {
    return left_;
  }

private:
  void
  ask() const
  {
    if (--left_ < 0)
      throw Failure();
  }

  KdTree tree_;
  mutable std::atomic<int> left_;
};

Points
circle()
{
  Points points;
  for (int i = 0; i < 400; ++i) {
    const double a = 0.0157 * i;
    points.emplace_back(std::cos(a), std::sin(a), 0.01 * (i % 3));
  }
  return points;
}

} // namespace

TEST(ThreadFailures, OfAMonitorLeaveTheEngines)
{
  const Points points = circle();
  FailingMonitor monitor;
  for (const Engine engine : {Engine::Tree, Engine::Grid}) {
    TensorSettings tensor;
    tensor.radius = 0.2;
    tensor.engine = engine;
    tensor.threads = 4;
    EXPECT_THROW(estimateTensors(points, points, tensor, {}, &monitor), Failure);
  }
  for (const ScaleEngine engine : {ScaleEngine::Sweep, ScaleEngine::Grid}) {
    MultiScaleSettings scales;
    scales.radii = {0.1, 0.2, 0.4};
    scales.engine = engine;
    scales.threads = 4;
    EXPECT_THROW(multiScaleShapes(points, points, scales, {}, &monitor), Failure);
  }
}

TEST(ThreadFailures, OfASearchLeaveTheScaleUnit)
{
  const Points points = circle();
  const FailingSearch search(points, 100);
  EXPECT_THROW(scaleUnit(search, points, 1024, 1, 4), Failure);
}

// Wherever it happens: in the features, the starts, or the growth of line-lets.
TEST(ThreadFailures, OfASearchLeaveTheReconstruction)
{
  const Points points = circle();
  StreamlineSettings settings;
  settings.threads = 4;
  settings.max_iterations = 50;
  constexpr int many = 100000000;
  const FailingSearch lasting(points, many);
  ASSERT_NO_THROW(reconstructPublished(lasting, points, settings));
  const int all = many - lasting.left();
  for (int part = 1; part < 10; ++part) {
    const FailingSearch search(points, all / 10 * part);
    EXPECT_THROW(reconstructPublished(search, points, settings), Failure) << part;
  }
}
