// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/features/linearity_graph.h>

namespace linelet {

/** \brief Reads one linearity graph after the other, as \ref readLinearityGraph does.
 * Holds buffers: make one per thread and use it for many points. */
class GraphReader {
public:
  GraphReader(const std::vector<double>& radii, const LinearityGraphSettings& settings);

  /** \param[in] linearity, neighbors at every radius
   * \return valid until the next call */
  const LinearityGraph&
  read(const std::vector<double>& linearity,
       const std::vector<std::uint32_t>& neighbors);

private:
  /** \brief A run of equal values among the defined scales: places first..last. */
  struct Run {
    std::size_t first, last;
    double value;
  };

  /** \brief Runs of the places from \a begin on. A run holds values that differ little
   * from its first one, so that a slow ramp stays a ramp. */
  void
  findRuns(std::size_t begin, std::vector<Run>& runs) const;

  /** \brief Area under the graph between two places, both included. */
  double
  area(std::size_t first, std::size_t last) const;

  /** \brief O_m of the next maximum, of which everything but the score is known. */
  double
  score(const GraphMaximum& maximum,
        const Run& run,
        const std::vector<std::uint32_t>& neighbors) const;

  /** \param[in] begin, end places between which maxima are sought */
  void
  addMaximum(const Run& run,
             std::size_t begin,
             std::size_t end,
             const std::vector<std::uint32_t>& neighbors);

  LinearityGraphSettings settings_;
  std::vector<double> radii_;
  std::vector<double> positions_;  // what the area integrates over, per scale
  std::vector<std::size_t> scale_; // the defined ones
  std::vector<double> value_;      // of these
  std::vector<Run> runs_, minima_;
  LinearityGraph result_;
};

} // namespace linelet
