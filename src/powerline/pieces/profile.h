// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace linelet::powerline {

constexpr double independent = 2;       ///< points per meter that count as independent
constexpr double least_residual = 0.02; ///< meters; smaller differences are noise
constexpr double profile_step = 0.25;   ///< meters between the places tried for a kink

/** \brief Sums of a least squares fit of a parabola; two of them subtract. */
struct Moments {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0;
  double count = 0;

  void
  add(double s, double z)
  {
    const Eigen::Vector3d x(1, s, s * s);
    normal += x * x.transpose();
    right += z * x;
    squares += z * z;
    count += 1;
  }

  Moments
  operator-(const Moments& other) const
  {
    Moments m = *this;
    m.normal -= other.normal;
    m.right -= other.right;
    m.squares -= other.squares;
    m.count -= other.count;
    return m;
  }

  /** \brief The parabola and its sum of squared deviations. */
  std::pair<Eigen::Vector3d, double>
  solve() const;
};

/** \brief Two parabolas that meet. */
struct Hinge {
  double squares = 0; ///< sum of squared deviations
  double jump = 0;    ///< change of slope where they meet
};

/** \brief Sorted heights (or offsets) along a wire, for fits to any part of them. */
class Profile {
public:
  /** \brief The profile of \a samples: places along the wire and values there. */
  explicit Profile(std::vector<std::pair<double, double>> samples);

  /** \brief Fits one parabola to the samples from \a low to \a high. */
  double
  squaresOfOne(double low, double high) const;

  /** \brief Fits two parabolas of nearly the same bend that meet at \a s: neighboring
   * spans of a line have the same tension. */
  Hinge
  hingeAt(double s, double low, double high) const;

  /** \brief Number of samples from \a low to \a high. */
  double
  count(double low, double high) const;

private:
  Moments
  between(double low, double high) const;

  std::vector<double> places_;
  std::vector<Moments> before_; // one more than places
};

} // namespace linelet::powerline
