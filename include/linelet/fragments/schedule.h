// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/support/names.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief How fragments are assigned to devices (Grasso et al. 2015, section 4). */
enum class Heuristic {
  MinMin,    ///< static: the fragment that can be finished first
  MaxMin,    ///< static: the fragment that can be finished last
  Sufferage, ///< static: the fragment that loses most without its best device
  SimpleH,   ///< dynamic: the slow device takes the smallest, the others the largest
  SimpleHS   ///< SimpleH, but the slow device stops in time, by predicted times
};

} // namespace fragments

template <>
struct Names<fragments::Heuristic> {
  using H = fragments::Heuristic;
  static constexpr std::string_view kind = "heuristic";
  static constexpr std::array<std::pair<H, std::string_view>, 5> table = {
      {{H::Sufferage, "sufferage"},
       {H::MinMin, "min-min"},
       {H::MaxMin, "max-min"},
       {H::SimpleH, "simple-h"},
       {H::SimpleHS, "simple-hs"}}};
};

namespace LINELET_PUBLIC fragments {

/** \brief Expected time to compute (ETC) every fragment on every device, seconds. */
class ExpectedTimes {
public:
  ExpectedTimes(std::size_t fragments, std::size_t devices)
      : devices_(devices), seconds_(fragments * devices, 0.0)
  {
  }

  std::size_t
  devices() const
  {
    return devices_;
  }
  std::size_t
  fragments() const
  {
    return devices_ == 0 ? 0 : seconds_.size() / devices_;
  }

  double&
  operator()(std::size_t fragment, std::size_t device)
  {
    return seconds_[fragment * devices_ + device];
  }
  double
  operator()(std::size_t fragment, std::size_t device) const
  {
    return seconds_[fragment * devices_ + device];
  }

private:
  std::size_t devices_;
  std::vector<double> seconds_;
};

/** \brief A fragment on a device, from \ref begin to \ref end. */
struct Assignment {
  std::size_t fragment = 0, device = 0;
  double begin = 0, end = 0; ///< seconds
};

/** \brief Assignments in the order in which they were decided; on each device, without
 * gaps. */
using Schedule = std::vector<Assignment>;

/** \brief The time at which all are done, seconds; 0 if empty. */
double
makespan(const Schedule& schedule);

/// \name Static heuristics: pure functions of the expected times
/// The completion time of a fragment on a device is the device's load so far plus the
/// expected time. Ties go to the first fragment and the first device; in sufferage, to
/// the longest fragment. All finish within n times the optimum for n devices (Ibarra
/// and Kim 1977). \throws std::invalid_argument if there are fragments but no device,
/// or a time is negative or not finite
/// @{
Schedule
minMin(const ExpectedTimes& times);
Schedule
maxMin(const ExpectedTimes& times);
Schedule
sufferage(const ExpectedTimes& times);
/// @}

} // namespace fragments
} // namespace linelet
