// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <linelet/fragments/tiling.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief A file to read, and the state in which it was planned. */
struct PlannedInput {
  std::string path;
  std::uint64_t bytes = 0;
  std::int64_t changed = 0;     ///< nanoseconds since 1970
  Extent extent;                ///< by its header, world coordinates
  double low_z = 0, high_z = 0; ///< likewise
};

/** \brief What to do, planned from headers alone: which command, on which files,
 * in which boxes. Kept as `plan.json` in the folder of the run. */
struct Plan {
  std::string version;                    ///< of linelet
  std::string command;                    ///< tensor, multiscale, ...
  std::vector<std::string> arguments;     ///< after the command's name
  std::string place;                      ///< folder that relative paths start from
  std::vector<PlannedInput> inputs;       ///< in the order of the whole cloud
  Point shift = Point::Zero();            ///< subtracted from all points
  std::map<std::string, double> measures; ///< of the whole cloud, by name
  double ghost = 0;                       ///< width of the ghost zones
  double most_points = 0;                 ///< in a fragment, as memory allows; 0: any
  Tiling tiling;                          ///< in world coordinates

  /** \brief A hash of the whole plan. */
  std::string
  fingerprint() const;

  /** \brief How far beyond their box points are copied: \ref ghost, plus a margin for
   * rounding. */
  double
  reach() const;

  /** \brief The inputs that may have points in fragment \a number. */
  std::vector<std::size_t>
  inputsOf(std::size_t number) const;
};

/** \brief The state of \a path now, without its extent. \throws io::FileError */
PlannedInput
stateOf(const std::string& path);

/** \brief Fails if an input has changed since the plan was made.
 * \throws io::FileError */
void
checkInputs(const Plan& plan);

/** \brief Writes `plan.json` into \a folder, which is created. \throws io::FileError */
void
savePlan(const Plan& plan, const std::string& folder);

/** \brief Reads it. \throws io::FileError if it is missing or damaged */
Plan
loadPlan(const std::string& folder);

} // namespace fragments
} // namespace linelet
