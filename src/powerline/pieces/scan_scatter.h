// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/points.h>

#include "powerline/pieces/piece.h"

namespace linelet::powerline {

/** \brief How far the points of single wires scatter in a scan.
 *
 * The scatter comes from the sensor and is about the same for all wires. What scatters
 * much more widely is more likely a row of other objects. */
class ScanScatter {
public:
  struct Sample {
    double rms = 0; ///< of the points about their wire, meters
    double points = 0;
  };

  /** \param[in] wires most of whose points belong to real, single wires */
  explicit ScanScatter(const std::vector<Sample>& wires);

  /** \brief By how many standard deviations \a wire scatters more widely than usual; 0
   * if it does not. */
  double
  excess(const Sample& wire) const;

private:
  double usual_ = 0; // median of ln(rms), over the points
  double spread_ = 0;
};

/** \brief How the points of a single wire scatter. */
ScanScatter::Sample
sampleOf(const Piece& wire, const Points& points);

/** \brief Logarithm of the prior of a wire whose scatter has this \a excess, relative
 * to the usual scatter: a Student distribution with 3 degrees of freedom, as some are
 * unresolved bundles. */
double
logPriorOfScatter(double excess);

} // namespace linelet::powerline
