// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "curves/mixture/banded_system.h"

using namespace linelet;

namespace {

/** \brief The same random system, banded and dense, made definite by its diagonal. */
struct Both {
  BandedSystem banded;
  Eigen::MatrixXd dense;
};

Both
randomSystem(std::size_t nodes, bool closed, boost::random::mt19937& random)
{
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  const auto n = static_cast<Eigen::Index>(nodes);
  Both both;
  both.banded.reset(nodes, closed);
  both.dense = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < nodes; ++i) {
    const double diagonal = 4.5 + uniform(random);
    both.banded.addDiagonal(i, diagonal);
    both.dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += diagonal;
    for (std::size_t step = 1; step <= 2; ++step) {
      if (!closed && i + step >= nodes)
        continue;
      const double value = uniform(random);
      const auto a = static_cast<Eigen::Index>(i);
      const auto b = static_cast<Eigen::Index>((i + step) % nodes);
      if (step == 1)
        both.banded.addNext(i, value);
      else
        both.banded.addAfterNext(i, value);
      both.dense(a, b) += value;
      both.dense(b, a) += value;
    }
  }
  return both;
}

TEST(EmBanded, SolvesAndInvertsAsADenseSystemDoes)
{
  boost::random::mt19937 random(42);
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  for (const bool closed : {false, true})
    for (std::size_t nodes = closed ? 6 : 3; nodes < 40; nodes += 1 + nodes / 10) {
      SCOPED_TRACE(std::to_string(nodes) + (closed ? " closed" : " open"));
      Both both = randomSystem(nodes, closed, random);
      Points solution(nodes);
      Eigen::MatrixXd right(nodes, 3);
      for (std::size_t i = 0; i < nodes; ++i) {
        solution[i] = Point(uniform(random), uniform(random), uniform(random));
        right.row(static_cast<Eigen::Index>(i)) = solution[i].transpose();
      }
      both.banded.solve(solution);
      const Eigen::MatrixXd expected = both.dense.fullPivLu().solve(right);
      const Eigen::MatrixXd inverse = both.dense.inverse();
      EXPECT_NEAR(
          both.banded.logDeterminant(), std::log(both.dense.determinant()), 1e-10);
      std::vector<double> diagonal, next, after_next;
      both.banded.inverseBand(diagonal, next, after_next);
      for (std::size_t i = 0; i < nodes; ++i) {
        const auto a = static_cast<Eigen::Index>(i);
        EXPECT_LT((solution[i].transpose() - expected.row(a)).norm(), 1e-12);
        EXPECT_NEAR(diagonal[i], inverse(a, a), 1e-12);
        if (closed || i + 1 < nodes) {
          EXPECT_NEAR(
              next[i], inverse(a, static_cast<Eigen::Index>((i + 1) % nodes)), 1e-12);
        }
        if (closed || i + 2 < nodes) {
          EXPECT_NEAR(after_next[i],
                      inverse(a, static_cast<Eigen::Index>((i + 2) % nodes)),
                      1e-12);
        }
      }
    }
}

TEST(EmBanded, TakesANewSystemAfterReset)
{
  boost::random::mt19937 random(43);
  Both large = randomSystem(30, true, random);
  Points unused(30, Point(1, 2, 3));
  large.banded.solve(unused);
  large.banded.reset(3, false);
  for (std::size_t i = 0; i < 3; ++i)
    large.banded.addDiagonal(i, 2);
  Points x(3, Point(1, 2, 3));
  large.banded.solve(x);
  for (const Point& p : x)
    EXPECT_EQ(p, Point(0.5, 1, 1.5));
}

} // namespace
