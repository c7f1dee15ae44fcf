// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Symmetric positive definite system over the nodes of one polyline, where each
 * node is coupled with its two neighbors on either side.
 *
 * Open: pentadiagonal. Closed: the same around a ring, solved with the last two nodes
 * as a border. Linear time and memory. */
class BandedSystem {
public:
  /** \brief A system of zeros. \param[in] nodes at least 3 (closed: 6) */
  void
  reset(std::size_t nodes, bool closed);

  /** \brief Adds \a value at (i, i). */
  void
  addDiagonal(std::size_t i, double value)
  {
    diagonal_[i] += value;
  }
  /** \brief Adds \a value at (i, i + 1) and (i + 1, i), around the ring if closed. */
  void
  addNext(std::size_t i, double value)
  {
    next_[i] += value;
  }
  /** \brief Adds \a value at (i, i + 2) and (i + 2, i), around the ring if closed. */
  void
  addAfterNext(std::size_t i, double value)
  {
    after_next_[i] += value;
  }

  /** \brief Solves for three right-hand sides in place (one per coordinate). */
  void
  solve(Points& right_hand_sides);

  /** \brief Logarithm of the determinant; after \ref solve. */
  double
  logDeterminant() const;

  /** \brief Entries (i, i), (i, i + 1) and (i, i + 2) of the inverse; after \ref solve.
   */
  void
  inverseBand(std::vector<double>& diagonal,
              std::vector<double>& next,
              std::vector<double>& after_next) const;

private:
  void
  factorize();
  template <class Vector>
  void
  bandSolve(std::vector<Vector>& x) const;

  bool closed_ = false;
  std::size_t nodes_ = 0; // all
  std::size_t band_ = 0;  // without the border
  std::vector<double> diagonal_, next_, after_next_;
  // LDL^T of the band
  std::vector<double> pivot_, inverse_pivot_, lower1_, lower2_;
  std::vector<Eigen::Vector2d> border_; // band^-1 * coupling with the border
  Eigen::Matrix2d corner_inverse_ = Eigen::Matrix2d::Zero();
};

} // namespace linelet
