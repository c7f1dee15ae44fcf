// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curves/selection/component_model.h"

#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/search/scale_unit.h>

#include "curves/network/curve_similarity.h"

using namespace linelet;

namespace {

constexpr double any = std::numeric_limits<double>::infinity();

/** \brief Noisy points of \a sticks sticks of length 10 that cross in one place. */
Points
crossingSticks(int sticks, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  const auto within = [&](double size) {
    const double x = size * uniform(random), y = size * uniform(random);
    return Point(x, y, size * uniform(random));
  };
  Points points;
  for (int k = 0; k < sticks; ++k) {
    const Point middle = within(1.5);
    const Point half = 5 * within(1).normalized();
    for (int i = 0; i < 60; ++i) {
      const Point place = middle + uniform(random) * half;
      points.push_back(place + within(0.2));
    }
  }
  return points;
}

class Component {
public:
  explicit Component(const Points& points)
      : points_(points),
        component_(
            points_, scaleUnit(points_, 1024, 1, 1), settings_, [] { return false; })
  {
    for (std::size_t k = 0; k < bandwidths.size(); ++k)
      component_.tryBandwidth(k);
  }

  ComponentModel&
  operator*()
  {
    return component_;
  }

private:
  Points points_;
  RefinedSettings settings_;
  ComponentModel component_;
};

TEST(ComponentModel, RunnerUpTakesAnotherCourseAndIsNotAhead)
{
  int found = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    Component component(crossingSticks(4, seed));
    const auto runner_up = (*component).runnerUp(any);
    if (!runner_up)
      continue;
    ++found;
    const Fitted& best = (*component).best();
    EXPECT_GE(runner_up->score, best.score) << "seed " << seed;
    EXPECT_FALSE(
        ofOneCourse(runner_up->fit.curves, best.fit.curves, (*component).scaleUnit()))
        << "seed " << seed;
    for (const Fitted& other : (*component).traced())
      EXPECT_TRUE(
          other.score >= runner_up->score ||
          ofOneCourse(other.fit.curves, best.fit.curves, (*component).scaleUnit()))
          << "seed " << seed;
    EXPECT_FALSE((*component).runnerUp(0)) << "seed " << seed;
  }
  EXPECT_GT(found, 5); // bandwidths differ where sticks cross
}

TEST(ComponentModel, WithoutDisagreementThereIsNoRunnerUp)
{
  Points line;
  for (int i = 0; i < 200; ++i)
    line.emplace_back(0.1 * i, 0.02 * (i % 3), 0);
  EXPECT_FALSE((*Component(line)).runnerUp(any));
}

TEST(ComponentModel, SearchContinuesFromAnotherFit)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    Component component(crossingSticks(4, seed));
    const auto runner_up = (*component).runnerUp(any);
    if (!runner_up)
      continue;
    const double best = (*component).best().score;
    (*component).goOnFrom(*runner_up);
    EXPECT_EQ((*component).best().score, runner_up->score);
    EXPECT_GE((*component).best().score, best);
    return;
  }
  FAIL() << "no runner-up in ten clouds";
}

} // namespace
