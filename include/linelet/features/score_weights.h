// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Factors of the terms of a maximum's score O_m: those of the published eq. 9,
 * and those that the thesis lists as unused (Appendix A.2, MSSFW*), 0 by default.
 *
 * The thesis also names MSSFWDNR without saying what it multiplies; it has no
 * counterpart here. */
struct ScoreWeights {
  double linearity = 1; ///< MSSFWLin: of CL_j
  double scale = -1;    ///< MSSFWSize: of k_j / K
  double area = 1;      ///< MSSFWIntegral: of A_j / A
  double depth = -0.5;  ///< MSSFWMinMaxDiff: of delta
  /// MSSFWLinDiff: of the largest rise from the scales before and after
  double step = 0;
  double width = 0; ///< MSSFWidth: of (k_j+ - k_j-) / K
  /// MSSFWNeighRatio, "a neighbor to radius relation", without a formula: of
  /// (N_j / N_K) (r_K / r_j), at most 1, as it is where neighbors lie along a line.
  double neighbors = 0;
  double second = 0; ///< MSSFWSecond: added at the second maximum, by scale

  ScoreWeights() = default;

  /** \brief From "published" or "NAME=VALUE,...", with the names above; others keep
   * their defaults.
   * \throws std::invalid_argument for an unknown name or a value that is not a finite
   * number */
  explicit ScoreWeights(std::string_view text);

  /** \brief The weights that differ from the published ones, as text for that
   * constructor. */
  std::string
  name() const;
};

} // namespace linelet
