// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include "curves/mixture/model_score.h"

using namespace linelet;

namespace {

EmFit
fitOfOneCurve()
{
  EmFit fit;
  fit.log_likelihood = -10;
  fit.freedom = 3;
  fit.outlier_share = 0;
  fit.curves.resize(1);
  return fit;
}

TEST(ModelScore, CountsTheParametersOfAnOpenCurve)
{
  // Its share, its existence, two ends, and three for its shape.
  EXPECT_DOUBLE_EQ(scoreOf(fitOfOneCurve(), 100), 20 + 7 * std::log(100.0));
}

TEST(ModelScore, AClosedCurveHasNoEnds)
{
  EmFit fit = fitOfOneCurve();
  fit.curves[0].closed = true;
  EXPECT_DOUBLE_EQ(scoreOf(fit, 100), 20 + 5 * std::log(100.0));
}

TEST(ModelScore, HingesOutliersAndVariedNoiseCost)
{
  EmFit fit = fitOfOneCurve();
  fit.curves[0].hinges = {4, 9};
  EXPECT_DOUBLE_EQ(scoreOf(fit, 100), 20 + 9 * std::log(100.0));
  fit.outlier_share = 0.1;
  EXPECT_DOUBLE_EQ(scoreOf(fit, 100), 20 + 10 * std::log(100.0));
  fit.width_cost = 5;
  EXPECT_DOUBLE_EQ(scoreOf(fit, 100), 25 + 10 * std::log(100.0));
}

} // namespace
