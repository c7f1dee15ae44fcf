// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/evidence.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/counts.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double largest_rms = 0.64; // of the widest tolerance
constexpr double bundle_rms = 0.35;  // meters
// Slope of a wire at its ends, against its chord, and of the chord: that of terrain.
constexpr double steepest_end = 0.6, steepest_chord = 1;
constexpr double least_height = 4;   // meters, mean
constexpr double hump = 0.10;        // meters of negative sag that noise may cause
constexpr double clean_length = 6;   // meters that must at least be clean
constexpr double clean_part = 0.5;   // of the occupied bins
constexpr double least_cover = 0.35; // of the bins
constexpr double least_even = 0.5;   // of the bins that as many random points occupy
constexpr double crowd = 0.35;       // guard ring points per tube point in a clean bin
constexpr std::size_t least_points = 8;
constexpr double largest_log = 500; // of an exponent, within the range of a double

// Evidence of a wire from the counts along it. Part of it is hidden; that share is
// estimated together with its density.
double
likelihoodOf(const std::vector<Counts>& bins)
{
  double total = 0, expected = 0;
  for (const Counts& c : bins) {
    total += c.tube;
    expected += c.around / c.larger;
  }
  const auto n = static_cast<double>(bins.size());
  double density = std::max(0.1, (total - expected) / n), shown = 0.8, result = 0;
  for (int iteration = 0; iteration < 4; ++iteration) {
    double visible = 0, points = 0;
    result = 0;
    for (const Counts& c : bins) {
      const double wire = shown * std::exp(std::min(largest_log, logWire(c, density)));
      const double part = wire / (wire + 1 - shown);
      visible += part;
      points += part * std::max(0.0, c.tube - c.around / c.larger);
      result += std::log(wire + 1 - shown);
    }
    shown = std::clamp((visible + 1) / (n + 2), 0.02, 0.98);
    density = std::max(0.1, points / std::max(1.0, visible));
  }
  return result;
}

} // namespace

Evidence
weigh(const Growth& growth, const Piece& piece, const PowerLineSettings& settings)
{
  Evidence e;
  const SpanModel& m = piece.model;
  const Candidates& candidates = growth.candidates();
  if (piece.members.empty() || m.length() < settings.min_length)
    return e;
  for (const Index i : piece.members)
    e.height += static_cast<double>(candidates.height[i]);
  e.height /= static_cast<double>(piece.members.size());
  const double rms = rootMeanSquare(m, candidates.points, piece.members);
  e.chord = std::abs(m.rise((m.begin + m.end) / 2));
  e.slope = std::abs(m.z[2]) * m.length();
  e.sag = m.z[2] * m.length() * m.length() / 4;
  e.bins = static_cast<int>(std::ceil(m.length() / bin_length));
  const double step = m.length() / e.bins;
  const double tolerance = piece.tolerance();
  const double reach = std::max(ring_radius, 2 * tolerance);
  const double larger = reach * reach / (tolerance * tolerance) - 1;
  std::vector<Counts> counts(static_cast<std::size_t>(e.bins));
  double tube = 0;
  for (int k = 0; k < e.bins; ++k) {
    const Bin bin =
        growth.look(m, m.begin + k * step, m.begin + (k + 1) * step, tolerance);
    counts[static_cast<std::size_t>(k)] = {
        static_cast<double>(bin.tube), static_cast<double>(bin.ring), larger};
    tube += static_cast<double>(bin.tube);
    if (bin.tube == 0)
      continue;
    ++e.occupied;
    if (static_cast<double>(bin.guard_ring) <= crowd * static_cast<double>(bin.tube))
      ++e.clean;
  }
  std::vector<Counts> smooth = counts; // with the surroundings of the adjacent bins
  for (std::size_t k = 0; k < counts.size(); ++k)
    for (const std::size_t other : {k - 1, k + 1})
      if (other < counts.size()) {
        smooth[k].around += counts[other].around;
        smooth[k].larger += counts[other].larger;
      }
  e.likelihood = likelihoodOf(smooth);
  e.hangs = piece.members.size() >= least_points &&
            rms <= (piece.thickness > 0 ? bundle_rms : largest_rms * m.widest) &&
            e.slope <= steepest_end && e.chord <= steepest_chord && e.sag >= -hump &&
            e.height >= least_height;
  e.sound = e.hangs && e.clean >= clean_part * e.occupied &&
            e.clean * bin_length >= clean_length;
  e.even =
      e.sound && e.occupied >= least_even * e.bins * (1 - std::exp(-tube / e.bins));
  e.accepted = e.sound && e.occupied >= least_cover * e.bins &&
               e.likelihood >= LinePriors().in_company;
  return e;
}

} // namespace linelet::powerline
