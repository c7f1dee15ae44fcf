// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>

#include <Eigen/Core>

#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/weighting.h>

namespace LINELET_PUBLIC linelet {

/** \brief A symmetric 3x3 tensor by its six entries, in squared length. */
struct SymmetricTensor {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  /** \brief Adds weight * v (x) v. */
  void
  add(double weight, const Point& v)
  {
    xx += weight * v.x() * v.x();
    xy += weight * v.x() * v.y();
    xz += weight * v.x() * v.z();
    yy += weight * v.y() * v.y();
    yz += weight * v.y() * v.z();
    zz += weight * v.z() * v.z();
  }

  SymmetricTensor&
  operator+=(const SymmetricTensor& other)
  {
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
    return *this;
  }

  SymmetricTensor&
  operator*=(double factor)
  {
    xx *= factor;
    xy *= factor;
    xz *= factor;
    yy *= factor;
    yz *= factor;
    zz *= factor;
    return *this;
  }

  double
  trace() const
  {
    return xx + yy + zz;
  }

  Eigen::Matrix3d
  matrix() const
  {
    Eigen::Matrix3d m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }
};

/** \brief What the sum over the neighbors is divided by. Eigenvectors and shape factors
 * do not depend on it, entries and eigenvalues do. */
enum class Normalization {
  Weights, ///< the sum of the weights
  Count    ///< the number of neighbors (Ritter et al. 2012, Ritter & Benger 2012)
};

template <>
struct Names<Normalization> {
  static constexpr std::string_view kind = "normalization";
  static constexpr std::array<std::pair<Normalization, std::string_view>, 2> table = {{
      {Normalization::Weights, "weights"},
      {Normalization::Count, "count"},
  }};
};

/** \brief t = 1/sum(w_i) sum(w_i v_i (x) v_i), v_i = p_i - c, w_i = w(|v_i| / r).
 *
 * Ritter et al. 2012, Ritter & Benger 2012. Positive semidefinite up to rounding.
 * \param[in] neighbors p_i, best relative to the query point
 * \param[in] centroid c, in the same coordinates
 * \param[in] radius r of the neighborhood; 0 if all neighbors coincide
 * \param[in] weighting w_T
 * \param[in] normalization the divisor: sum(w_i), or the number of neighbors
 * \return NaN in every entry if the divisor is 0: no neighbors, or none with a weight
 */
SymmetricTensor
neighborhoodTensor(const Points& neighbors,
                   const Point& centroid,
                   double radius,
                   const Weighting& weighting,
                   Normalization normalization = Normalization::Weights);

} // namespace linelet
