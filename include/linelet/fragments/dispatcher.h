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

/** \brief Waiting fragments by number of points, smallest first. */
using Waiting = std::deque<std::size_t>;

/** \brief SimpleH: which of the \a waiting fragments a free device takes: the slow
 * device the smallest, the others the largest. Empty if none is waiting. */
std::optional<std::size_t>
simpleH(const Waiting& waiting, bool slow);

/** \brief SimpleHS: the same, but the slow device takes a fragment only if it is
 * expected to finish it before the fastest one would finish all that wait, or if either
 * prediction is still unknown. */
std::optional<std::size_t>
simpleHS(const Waiting& waiting,
         bool slow,
         const std::vector<double>& points,
         const TimePrediction& on_slow,
         const TimePrediction& on_fastest);

/** \brief Assigns fragments to the devices of an executor or a simulation.
 * Every fragment is assigned once. Not thread-safe. */
class Dispatcher {
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /** \brief Assigns fragments by a dynamic heuristic.
   * \param[in] points of every fragment
   * \param[in] devices number of devices
   * \param[in] slow the device that is slower than the others, or \ref none */
  Dispatcher(Heuristic heuristic,
             std::vector<double> points,
             std::size_t devices,
             std::size_t slow);

  /** \brief Assigns fragments by a static schedule. */
  Dispatcher(const Schedule& schedule, std::size_t devices);

  /** \brief The next fragment of \a device; empty once none is left for it. */
  std::optional<std::size_t>
  next(std::size_t device);

  /** \brief Records that \a device took \a seconds for \a fragment. */
  void
  finished(std::size_t fragment, std::size_t device, double seconds);

private:
  bool dynamic_, predicts_ = false;
  std::vector<double> points_;
  std::size_t slow_ = none;
  Waiting waiting_;
  std::vector<Waiting> queues_;    ///< of a static schedule, one per device
  std::vector<TimePrediction> on_; ///< one per device
};

/** \brief A dispatcher for any heuristic: static ones decide by \a times, dynamic ones
 * by \a points and the slow device, which is the one with the largest sum of \a times
 * unless all are equal.
 * \param[in] points of every fragment, for the dynamic heuristics
 * \throws std::invalid_argument as \ref minMin, or unless there are as many points */
Dispatcher
dispatcherFor(Heuristic heuristic,
              const ExpectedTimes& times,
              const std::vector<double>& points);

/** \brief Simulates devices that take fragments as they become free; fragments take the
 * times in \a times. See \ref dispatcherFor. */
Schedule
simulate(Heuristic heuristic,
         const ExpectedTimes& times,
         const std::vector<double>& points);

} // namespace fragments
} // namespace linelet
