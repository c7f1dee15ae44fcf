// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include <linelet/fragments/schedule.h>
#include <linelet/fragments/time_prediction.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief Fragments that wait, by number of points, the smallest first. */
using Waiting = std::deque<std::size_t>;

/** \brief SimpleH: what a free device takes of those that \a waiting: the slow one the
 * smallest, others the largest. Nothing where nothing waits. */
std::optional<std::size_t>
simpleH(const Waiting& waiting, bool slow);

/** \brief SimpleHS: the same, but the slow device takes a fragment only if it is
 * expected to be done with it before the fastest one would be with all that wait; as
 * long as one of the two predictions knows nothing, it takes it. */
std::optional<std::size_t>
simpleHS(const Waiting& waiting,
         bool slow,
         const std::vector<double>& points,
         const TimePrediction& on_slow,
         const TimePrediction& on_fastest);

/** \brief Answers the devices of an executor, or of a simulation: which fragment next?
 * Gives out every fragment once. Not for several threads at once. */
class Dispatcher {
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /** \brief Of a dynamic heuristic.
   * \param[in] points of every fragment
   * \param[in] devices how many
   * \param[in] slow the device that is slower than the others, or \ref none */
  Dispatcher(Heuristic heuristic,
             std::vector<double> points,
             std::size_t devices,
             std::size_t slow);

  /** \brief Of a static schedule. */
  Dispatcher(const Schedule& schedule, std::size_t devices);

  /** \brief What \a device is to compute next; nothing: it is not needed any more. */
  std::optional<std::size_t>
  next(std::size_t device);

  /** \brief Hears that \a device took \a seconds for \a fragment. */
  void
  finished(std::size_t fragment, std::size_t device, double seconds);

private:
  bool dynamic_, predicts_ = false;
  std::vector<double> points_;
  std::size_t slow_ = none;
  Waiting waiting_;
  std::vector<Waiting> queues_;    ///< of a static schedule, one a device
  std::vector<TimePrediction> on_; ///< one a device
};

/** \brief What happens where devices ask one after the other as they become free, and
 * fragments take the times that \a times says. Which device is slow, \a times says as
 * well: the one with the largest sum, unless all are alike.
 * \param[in] points of every fragment, for the dynamic heuristics
 * \throws std::invalid_argument as \ref minMin, or unless there are as many points */
Schedule
simulate(Heuristic heuristic,
         const ExpectedTimes& times,
         const std::vector<double>& points);

} // namespace fragments
} // namespace linelet
