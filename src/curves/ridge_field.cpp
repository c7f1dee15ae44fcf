// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/ridge_field.h>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace linelet {

namespace {

// Points with less support than this share of the median, or than this many points at
// no distance, take no part.
constexpr double least_share = 0.3;
constexpr double least_support = 1.5;

double
kernel(double squared, double inverse_squared_radius)
{
  const double u = 1 - squared * inverse_squared_radius;
  const double u2 = u * u;
  return u2 * u2;
}

} // namespace

RidgeField::RidgeField(const Points& points, double bandwidth)
    : bandwidth_(bandwidth), grid_({}, 1)
{
  const double radius = 3 * bandwidth;
  const double inverse = 1 / (radius * radius);
  const UniformGrid all(points, radius);
  supports_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0;
    all.forEachWithin(points[i], radius, [&](Index, double squared) {
      sum += kernel(squared, inverse);
    });
    supports_[i] = sum;
  }
  if (points.empty())
    return;
  std::vector<double> sorted = supports_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  median_support_ = *middle;

  const double least = std::max(least_share * median_support_, least_support);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (supports_[i] >= least) {
      kept_.push_back(points[i]);
      kept_indices_.push_back(static_cast<Index>(i));
    }
    else
      supports_[i] = 0;
  }
  grid_ = UniformGrid(kept_, radius);

  std::vector<double> scores(points.size(), 0);
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    const Sample here = sample(kept_[k], true);
    scores[kept_indices_[k]] = here.support * (0.2 + linearityOf(here.covariance));
  }
  seeds_ = kept_indices_;
  std::sort(seeds_.begin(), seeds_.end(), [&](Index a, Index b) {
    return scores[a] != scores[b] ? scores[a] > scores[b] : a < b;
  });
}

RidgeField::Sample
RidgeField::sample(const Point& x, bool with_covariance) const
{
  const double radius = 3 * bandwidth_;
  const double inverse = 1 / (radius * radius);
  Sample result;
  Point first = Point::Zero();
  if (with_covariance) {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    grid_.forEachWithin(x, radius, [&](Index k, double squared) {
      const double w = kernel(squared, inverse);
      const Point v = kept_[k] - x;
      const Point wv = w * v;
      result.support += w;
      first += wv;
      xx += wv.x() * v.x();
      xy += wv.x() * v.y();
      xz += wv.x() * v.z();
      yy += wv.y() * v.y();
      yz += wv.y() * v.z();
      zz += wv.z() * v.z();
    });
    if (!(result.support > 0))
      return result;
    first /= result.support;
    result.covariance << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    result.covariance /= result.support;
    result.covariance -= first * first.transpose();
  }
  else {
    grid_.forEachWithin(x, radius, [&](Index k, double squared) {
      const double w = kernel(squared, inverse);
      result.support += w;
      first += w * (kept_[k] - x);
    });
    if (!(result.support > 0))
      return result;
    first /= result.support;
  }
  result.mean = x + first;
  return result;
}

double
linearityOf(const Eigen::Matrix3d& m)
{
  const double trace = m.trace();
  if (!(trace > 0))
    return 0;
  // Eigenvalues of a symmetric 3x3 matrix by the trigonometric formula.
  const double q = trace / 3;
  const double off = m(0, 1) * m(0, 1) + m(0, 2) * m(0, 2) + m(1, 2) * m(1, 2);
  const double p2 = (m(0, 0) - q) * (m(0, 0) - q) + (m(1, 1) - q) * (m(1, 1) - q) +
                    (m(2, 2) - q) * (m(2, 2) - q) + 2 * off;
  const double p = std::sqrt(p2 / 6);
  if (!(p > 1e-12 * q))
    return 0;
  const Eigen::Matrix3d b = (m - q * Eigen::Matrix3d::Identity()) / p;
  const double r = std::clamp(b.determinant() / 2, -1.0, 1.0);
  const double phi = std::acos(r) / 3;
  const double largest = q + 2 * p * std::cos(phi);
  const double smallest = q + 2 * p * std::cos(phi + 2 * M_PI / 3);
  const double middle = 3 * q - largest - smallest;
  return (largest - middle) / trace;
}

Point
majorDirection(const Eigen::Matrix3d& matrix, const Point& like)
{
  Eigen::Matrix3d power = matrix;
  for (int k = 0; k < 5; ++k) {
    const double trace = power.trace();
    if (!(trace > 0))
      return like;
    power /= trace;
    power = (power * power).eval();
  }
  // The longest column is the direction unless the two largest eigenvalues agree.
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (power(k, k) > power(longest, longest))
      longest = k;
  Point direction = power.col(longest);
  const double norm = direction.norm();
  if (!(norm > 0))
    return like;
  direction /= norm;
  return direction.dot(like) < 0 ? Point(-direction) : direction;
}

} // namespace linelet
