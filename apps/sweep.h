// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <bench/runs/benchmark_grid.h>
#include <linelet/curves/reconstruct_curves.h>

namespace linelet::apps {

/** \brief Every combination of values of some options, in a fixed order: the last
 * option varies fastest. */
class Sweep {
public:
  /** \param[in] texts NAME=VALUE,...; values that contain commas are separated by |
   * \throws std::runtime_error for a text without name or values, or a name that is not
   * an option of reconstruction or sampling */
  explicit Sweep(const std::vector<std::string>& texts);

  /** \brief Number of combinations. */
  std::size_t
  size() const;

  std::vector<std::string>
  names() const;

  /** \brief "NAME VALUE NAME VALUE ..." of combination \a index, from 0. */
  std::string
  label(std::size_t index) const;

  /** \brief Sets the values of a combination.
   * \return \a runs with the sample settings replaced by varied ones, each once
   * \throws std::runtime_error for a value out of range */
  std::vector<bench::BenchmarkRun>
  apply(std::size_t index,
        ReconstructionSettings& settings,
        const std::vector<bench::BenchmarkRun>& runs) const;

private:
  struct Option {
    std::string name;
    std::vector<std::string> values;
    bool of_samples;
  };

  /** \brief The index of each option's value. */
  std::vector<std::size_t>
  places(std::size_t index) const;

  std::vector<Option> options_;
};

} // namespace linelet::apps
