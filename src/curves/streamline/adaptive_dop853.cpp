// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "adaptive_dop853.h"

#include <algorithm>
#include <cmath>

#include <linelet/curves/integration_scheme.h>

namespace linelet {

namespace {

constexpr std::size_t stages = 12; // of the scheme, plus one at the end of the step

// clang-format off
// Rows 13 to 15 of the scheme, for the dense output.
constexpr double extra[3][15] = {
    {0.056167502283047954, 0, 0, 0, 0, 0, 0.25350021021662483, -0.2462390374708025, -0.12419142326381637, 0.15329179827876568, 0.00820105229563469, 0.007567897660545699, -0.008298, 0, 0},
    {0.03183464816350214, 0, 0, 0, 0, 0.028300909672366776, 0.053541988307438566, -0.05492374857139099, 0, 0, -0.00010834732869724932, 0.0003825710908356584, -0.00034046500868740456, 0.1413124436746325, 0},
    {-0.42889630158379194, 0, 0, 0, 0, -4.697621415361164, 7.683421196062599, 4.06898981839711, 0.3567271874552811, 0, 0, 0, -0.0013990241651590145, 2.9475147891527724, -9.15095847217987},
};
constexpr double error3[12] = {-0.18980075407240762, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585, -0.4226823213237919, -0.1521609496625161, 0.20136540080403034, 0.02265179219836082};
constexpr double error5[12] = {0.01312004499419488, 0, 0, 0, 0, -1.2251564463762044, -0.4957589496572502, 1.6643771824549864, -0.35032884874997366, 0.3341791187130175, 0.08192320648511571, -0.022355307863886294};
constexpr double dense[4][16] = {
    {-8.428938276109013, 0, 0, 0, 0, 0.5667149535193777, -3.0689499459498917, 2.38466765651207, 2.117034582445028, -0.871391583777973, 2.2404374302607883, 0.6315787787694688, -0.08899033645133331, 18.148505520854727, -9.194632392478356, -4.436036387594894},
    {10.427508642579134, 0, 0, 0, 0, 242.28349177525817, 165.20045171727028, -374.5467547226902, -22.113666853125306, 7.733432668472264, -30.674084731089398, -9.332130526430229, 15.697238121770845, -31.139403219565178, -9.35292435884448, 35.81684148639408},
    {19.985053242002433, 0, 0, 0, 0, -387.0373087493518, -189.17813819516758, 527.8081592054236, -11.57390253995963, 6.8812326946963, -1.0006050966910838, 0.7777137798053443, -2.778205752353508, -60.19669523126412, 84.32040550667716, 11.99229113618279},
    {-25.69393346270375, 0, 0, 0, 0, -154.18974869023643, -231.5293791760455, 357.6391179106141, 93.40532418362432, -37.45832313645163, 104.0996495089623, 29.8402934266605, -43.53345659001114, 96.32455395918828, -39.17726167561544, -149.72683625798564},
};
// clang-format on

// The usual step control: the next step is a little shorter than the error allows, and
// neither much shorter nor much longer than the last.
constexpr double safety = 0.9, most_shrink = 0.2, most_growth = 5;

template <std::size_t count>
Point
sumOf(const double (&weights)[count], const std::array<Point, 16>& k)
{
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < count; ++i)
    if (weights[i] != 0)
      sum += weights[i] * k[i];
  return sum;
}

} // namespace

void
AdaptiveDop853::step(const Field& field)
{
  const ButcherTable& table = butcherTable(IntegrationScheme::Dop853);
  std::array<Point, 16> k;
  const auto ask = [&](const Point& at) {
    ++evaluations_;
    return field(at);
  };
  from_ = to_;
  k[0] = ask(from_);
  for (double h = std::clamp(next_, control_.least, control_.most);;) {
    for (std::size_t i = 1; i < stages; ++i) {
      Point at = from_;
      for (std::size_t j = 0; j < i; ++j)
        if (table.a[i][j] != 0)
          at += h * table.a[i][j] * k[j];
      k[i] = ask(at);
    }
    to_ = from_;
    for (std::size_t i = 0; i < stages; ++i)
      if (table.b[i] != 0)
        to_ += h * table.b[i] * k[i];
    const double fifth = sumOf(error5, k).squaredNorm();
    const double third = sumOf(error3, k).squaredNorm();
    const double error = fifth > 0 ? h * fifth / std::sqrt(fifth + 0.01 * third) : 0;
    const double factor =
        error > 0 ? std::clamp(safety * std::pow(control_.tolerance / error, 1. / 8),
                               most_shrink,
                               most_growth)
                  : most_growth;
    next_ = std::clamp(h * factor, control_.least, control_.most);
    if (error <= control_.tolerance || h <= control_.least) {
      length_ = h;
      break;
    }
    h = std::min(next_, h * safety);
    h = std::max(h, control_.least);
  }

  const double h = length_;
  k[12] = ask(to_);
  for (std::size_t i = 0; i < 3; ++i)
    k[13 + i] = ask(from_ + h * sumOf(extra[i], k));
  const Point way = to_ - from_;
  dense_[0] = way;
  dense_[1] = h * k[0] - way;
  dense_[2] = 2 * way - h * (k[12] + k[0]);
  for (std::size_t i = 0; i < 4; ++i)
    dense_[3 + i] = h * sumOf(dense[i], k);
}

Point
AdaptiveDop853::advance(double length, const Field& field)
{
  used_ += length;
  while (used_ > length_) {
    used_ -= length_;
    step(field);
  }
  if (!(length_ > 0))
    return to_;
  // Alternating powers of s and 1 - s.
  const double s = used_ / length_;
  Point sum = Point::Zero();
  for (std::size_t i = dense_.size(); i-- > 0;)
    sum = (sum + dense_[i]) * (i % 2 == 0 ? s : 1 - s);
  return from_ + sum;
}

} // namespace linelet
