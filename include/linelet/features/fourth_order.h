// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <linelet/features/multi_scale_settings.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/neighborhood_tensor.h>

namespace LINELET_PUBLIC linelet {

/** \brief w_4, the weight of each scale's tensor in the fourth-order tensor. */
enum class ScaleWeight { Linearity, Planarity, Sphericity, Uniform };

template <>
struct Names<ScaleWeight> {
  static constexpr std::string_view kind = "scale weight";
  static constexpr std::array<std::pair<ScaleWeight, std::string_view>, 4> table = {
      {{ScaleWeight::Linearity, "linearity"},
       {ScaleWeight::Planarity, "planarity"},
       {ScaleWeight::Sphericity, "sphericity"},
       {ScaleWeight::Uniform, "uniform"}}};
};

/** \brief A symmetric 3x3 tensor as a vector whose dot product is the double
 * contraction: xx, yy, zz, sqrt(2) yz, sqrt(2) xz, sqrt(2) xy (Mandel's notation). */
using MandelVector = Eigen::Matrix<double, 6, 1>;

MandelVector
mandel(const Eigen::Matrix3d& tensor);

Eigen::Matrix3d
fromMandel(const MandelVector& vector);

/** \brief A fourth-order tensor that acts on symmetric second-order ones, T_ijkl =
 * T_jikl = T_ijlk = T_klij: in Mandel's notation a symmetric 6x6 matrix with 21
 * independent components. */
class FourthOrderTensor {
public:
  using Matrix = Eigen::Matrix<double, 6, 6>;

  FourthOrderTensor() : matrix_(Matrix::Zero()) {}
  explicit FourthOrderTensor(const Matrix& mandel) : matrix_(mandel) {}

  /** \brief Adds weight * t (x) t of a symmetric \a t. */
  void
  add(double weight, const Eigen::Matrix3d& t);

  const Matrix&
  mandelMatrix() const
  {
    return matrix_;
  }

  /** \brief T_ijkl, indices 0 to 2. */
  double
  operator()(int i, int j, int k, int l) const;

  /** \brief The 21 components: the upper triangle of the matrix, row by row. */
  std::array<double, 21>
  components() const;

  static FourthOrderTensor
  fromComponents(const std::array<double, 21>& components);

  /** \brief Q_ia Q_jb Q_kc Q_ld T_abcd of a rotation or reflection Q. */
  FourthOrderTensor
  rotated(const Eigen::Matrix3d& q) const;

  /** \brief Eigenvalues, ascending, and their symmetric 3x3 eigentensors of norm 1,
   * each with a nonnegative trace. */
  struct EigenTensors {
    std::array<double, 6> values;
    std::array<Eigen::Matrix3d, 6> tensors;

    /** \brief The major eigentensor. */
    const Eigen::Matrix3d&
    major() const
    {
      return tensors[5];
    }
  };
  EigenTensors
  eigenTensors() const;

private:
  Matrix matrix_;
};

/** \brief A fully symmetric fourth-order tensor: 15 components, one for each
 * combination of four indices. */
class SymmetricFourthOrderTensor {
public:
  SymmetricFourthOrderTensor() = default;

  /** \brief The mean of \a tensor over all orders of its indices: the part on which the
   * form T_ijkl v_i v_j v_k v_l depends. */
  explicit SymmetricFourthOrderTensor(const FourthOrderTensor& tensor);

  /** \brief T_ijkl, indices 0 to 2. */
  double
  operator()(int i, int j, int k, int l) const
  {
    return components_[place(i, j, k, l)];
  }

  /** \brief xxxx, xxxy, xxxz, xxyy, xxyz, xxzz, xyyy, xyyz, xyzz, xzzz, yyyy, yyyz,
   * yyzz, yzzz, zzzz. */
  const std::array<double, 15>&
  components() const
  {
    return components_;
  }

  /** \brief T_ijkl v_i v_j v_k v_l. */
  double
  along(const Eigen::Vector3d& v) const;

  /** \brief The same tensor in the form that has eigentensors. */
  FourthOrderTensor
  expanded() const;

private:
  static std::size_t
  place(int i, int j, int k, int l);

  std::array<double, 15> components_{};
};

/** \brief The fourth-order multi-scale tensor T = sum_k w4 t(r_k) (x) t(r_k) / sum w4.
 *
 * An extension that combines the tensors of all scales; its major eigentensor is a
 * compromise between them.
 * \param[in] tensors of the scales; those that are zero or not finite are left out
 * \param[in] weight which shape factor of each tensor is its weight
 * \return NaN in every component if all weights are 0 */
FourthOrderTensor
fourthOrderTensor(const std::vector<SymmetricTensor>& tensors,
                  ScaleWeight weight = ScaleWeight::Linearity);

/** \brief The fourth-order tensor of the neighborhood of every query over the radii
 * that \a settings ask for; see \ref multiScaleShapes, errors included. */
std::vector<FourthOrderTensor>
fourthOrderTensors(const Points& surface,
                   const Points& queries,
                   const MultiScaleSettings& settings = {},
                   ScaleWeight weight = ScaleWeight::Linearity,
                   ProgressMonitor* monitor = nullptr);

} // namespace linelet
