// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <gtest/gtest.h>

#include <linelet/curves/integration_scheme.h>

using namespace linelet;

namespace {

/** \brief Directions of circles around the z axis. */
Point
circleField(const Point& x)
{
  return Point(-x.y(), x.x(), 0) / std::hypot(x.x(), x.y());
}

/** \brief How far from its start a full turn of \a steps steps ends. */
double
errorAfterATurn(IntegrationScheme scheme, int steps)
{
  Point x(1, 0, 0);
  const double h = 2 * M_PI / steps;
  for (int i = 0; i < steps; ++i)
    x += integrationStep(butcherTable(scheme), x, h, circleField);
  return (x - Point(1, 0, 0)).norm();
}

using State = std::array<double, 3>;

template <class Stepper>
Point
odeintStep(Stepper stepper, const Point& from, double h)
{
  State state = {from.x(), from.y(), from.z()};
  stepper.do_step(
      [](const State& x, State& dx, double) {
        const Point d = circleField(Point(x[0], x[1], x[2]));
        dx = {d.x(), d.y(), d.z()};
      },
      state,
      0.0,
      h);
  return Point(state[0], state[1], state[2]) - from;
}

} // namespace

class EveryScheme
    : public ::testing::TestWithParam<std::pair<IntegrationScheme, std::string_view>> {
};

TEST_P(EveryScheme, ConvergesWithItsOrderOnACircle)
{
  const IntegrationScheme scheme = GetParam().first;
  const int order = butcherTable(scheme).order;
  // Few steps for high orders, whose errors soon reach rounding.
  const int steps = order >= 8 ? 10 : order >= 5 ? 40 : 200;
  const double coarse = errorAfterATurn(scheme, steps);
  const double fine = errorAfterATurn(scheme, 2 * steps);
  // On a circle, symmetric schemes may gain an order, but none falls short of its own.
  EXPECT_GT(std::log2(coarse / fine), order - 0.35);
  EXPECT_LT(std::log2(coarse / fine), order + 1.35);
}

TEST_P(EveryScheme, HasAConsistentTable)
{
  const ButcherTable& table = butcherTable(GetParam().first);
  ASSERT_EQ(table.a.size(), table.b.size());
  double sum = 0, first_moment = 0, second_moment = 0;
  for (std::size_t i = 0; i < table.b.size(); ++i) {
    ASSERT_EQ(table.a[i].size(), i);
    double c = 0;
    for (const double a : table.a[i])
      c += a;
    sum += table.b[i];
    first_moment += table.b[i] * c;
    second_moment += table.b[i] * c * c;
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  if (table.order >= 2) {
    EXPECT_NEAR(first_moment, 1.0 / 2, 1e-13);
  }
  if (table.order >= 3) {
    EXPECT_NEAR(second_moment, 1.0 / 3, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes,
                         EveryScheme,
                         ::testing::ValuesIn(Names<IntegrationScheme>::table),
                         [](const auto& info) {
                           std::string name(info.param.second);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(IntegrationSchemes, StepAsOdeintDoes)
{
  namespace odeint = boost::numeric::odeint;
  const Point from(0.8, 0.3, 0.1);
  const auto step = [&](IntegrationScheme scheme, double h) {
    return integrationStep(butcherTable(scheme), from, h, circleField);
  };
  for (const double h : {0.01, 0.3, 1.0}) {
    EXPECT_LT((step(IntegrationScheme::Euler, h) -
               odeintStep(odeint::euler<State>(), from, h))
                  .norm(),
              1e-15);
    EXPECT_LT((step(IntegrationScheme::Rk4, h) -
               odeintStep(odeint::runge_kutta4_classic<State>(), from, h))
                  .norm(),
              1e-15);
    EXPECT_LT((step(IntegrationScheme::Dopri5, h) -
               odeintStep(odeint::runge_kutta_dopri5<State>(), from, h))
                  .norm(),
              1e-15);
  }
}
