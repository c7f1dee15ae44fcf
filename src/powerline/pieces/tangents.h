// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

/** \brief How the directions of seeds reveal supports. Lengths in meters. */
struct TangentSettings {
  double least_radius = 2;     ///< of a seed: smaller ones do not give slopes to .01
  double least_cosine = 0.99;  ///< in plan, of a seed and the wire
  double window = 15;          ///< on both sides of a support: half of a short span
  double blurred = 3;          ///< around it, where neighborhoods reach beyond it
  std::size_t least_seeds = 4; ///< on both sides
  double least_kink = 0.03;    ///< change of slope: a span of 30 m that sags by .1 m
  double least_span = 20; ///< between supports, over which bends make up for a kink;
                          ///< shorter where strips are misaligned
  double clear = 6;       ///< standard deviations of that change
  double least_noise = 0.004; ///< of a slope, as measured in simulated scans
};

/** \brief Directions of the wires along a line, as given by seeds.
 *
 * Wires of a rack are too close together for a curve to keep to its own, but all have
 * the same direction: where it breaks downward, there is a support. */
class Tangents {
public:
  Tangents(const Candidates& candidates, const std::vector<Seed>& seeds);

  /** \brief Slope of a wire at a place along it. */
  struct Sample {
    double s, slope;
  };

  /** \brief The slopes of seeds near \a model, ascending. */
  std::vector<Sample>
  along(const SpanModel& model) const;

private:
  const Candidates& candidates_;
  Points directions_;
  std::vector<int> known_; ///< place of a candidate's direction, -1: none
};

/** \brief Where \a samples break downward; ascending. */
std::vector<double>
findKinks(const std::vector<Tangents::Sample>& samples);

/** \brief Gives \a model the slope and bend of the samples from \a low to \a high, and
 * keeps its height at their center.
 * \return false if they are too few */
bool
hangAlong(SpanModel& model,
          const std::vector<Tangents::Sample>& samples,
          double low,
          double high);

} // namespace linelet::powerline
