// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/profile.h"

#include <algorithm>

#include <Eigen/Dense>

#include "powerline/line_priors.h"

namespace linelet::powerline {

namespace {

constexpr double bend_spread = 5e-3; // 1/meters, of the halves at a support
constexpr double like_bend = 3e-4;   // 1/meters, between neighboring spans
constexpr double closed = 1e-3;      // meters between parabolas that meet

} // namespace

std::pair<Eigen::Vector3d, double>
Moments::solve() const
{
  Eigen::Matrix3d regular = normal;
  regular(2, 2) +=
      (priors.point_noise / bend_spread) * (priors.point_noise / bend_spread);
  const Eigen::Vector3d c = regular.ldlt().solve(right);
  return {c, std::max(0.0, squares - 2 * c.dot(right) + c.dot(normal * c))};
}

Profile::Profile(std::vector<std::pair<double, double>> samples)
    : before_(samples.size() + 1)
{
  std::sort(samples.begin(), samples.end());
  places_.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    places_.push_back(samples[i].first);
    before_[i + 1] = before_[i];
    before_[i + 1].add(samples[i].first, samples[i].second);
  }
}

Moments
Profile::between(double low, double high) const
{
  const auto from = std::lower_bound(places_.begin(), places_.end(), low);
  const auto to = std::lower_bound(from, places_.end(), high);
  return before_[static_cast<std::size_t>(to - places_.begin())] -
         before_[static_cast<std::size_t>(from - places_.begin())];
}

double
Profile::count(double low, double high) const
{
  return between(low, high).count;
}

double
Profile::squaresOfOne(double low, double high) const
{
  return between(low, high).solve().second;
}

Hinge
Profile::hingeAt(double s, double low, double high) const
{
  using Six = Eigen::Matrix<double, 6, 1>;
  const Moments left = between(low, s), right = between(s, high);
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  normal.topLeftCorner<3, 3>() = left.normal;
  normal.bottomRightCorner<3, 3>() = right.normal;
  Six sums, meeting, bends;
  sums << left.right, right.right;
  meeting << 1, s, s * s, -1, -s, -s * s;
  bends << 0, 0, 1, 0, 0, -1;
  meeting *= priors.point_noise / closed;
  bends *= priors.point_noise / like_bend;
  Eigen::Matrix<double, 6, 6> regular = normal;
  regular += meeting * meeting.transpose() + bends * bends.transpose();
  regular(2, 2) +=
      (priors.point_noise / bend_spread) * (priors.point_noise / bend_spread);
  regular(5, 5) +=
      (priors.point_noise / bend_spread) * (priors.point_noise / bend_spread);
  const Six c = regular.ldlt().solve(sums);
  Hinge hinge;
  hinge.squares =
      std::max(0.0, left.squares + right.squares - 2 * c.dot(sums) + c.dot(normal * c));
  hinge.jump = c[4] + 2 * c[5] * s - c[1] - 2 * c[2] * s;
  return hinge;
}

} // namespace linelet::powerline
