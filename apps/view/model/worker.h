// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include <linelet/support/progress_monitor.h>

namespace linelet::view {

/** \brief The progress of work. */
struct Progress {
  std::string stage;
  double part = 0; ///< in [0, 1]; 0 if the length is unknown
};

/** \brief Runs one piece of work at a time in its own thread, with progress and
 * cancellation. Call all functions from one thread, that of the window. */
class Worker {
public:
  Worker() = default;
  ~Worker();
  Worker(const Worker&) = delete;
  Worker&
  operator=(const Worker&) = delete;

  /** \brief What runs in the worker's thread, and what \ref poll then runs in the
   * caller's; the latter is skipped if the work was canceled or failed. */
  using Work = std::function<void(ProgressMonitor*)>;
  using Finish = std::function<void()>;

  /** \brief Cancels running work, waiting only until it reacts, and starts \a work. */
  void
  start(Work work, Finish finish);

  /** \brief Asks running work to stop. */
  void
  cancel();

  /** \brief Whether something was started whose end \ref poll has not yet reported. */
  bool
  busy() const
  {
    return thread_.joinable();
  }

  Progress
  progress() const;

  /** \brief Takes over finished work, if any.
   * \param[out] error what went wrong, in a sentence; empty if nothing did or it was
   * canceled
   * \return whether something ended */
  bool
  poll(std::string& error);

private:
  class Monitor : public ProgressMonitor {
  public:
    void
    begin(std::string_view stage, std::size_t total) override;
    void
    advance(std::size_t steps) override;
    bool
    canceled() const override;

    mutable std::mutex mutex;
    std::string stage;
    std::size_t total = 0;
    std::atomic<std::size_t> done{0};
    std::atomic<bool> stop{false};
  };

  void
  join();

  Monitor monitor_;
  std::thread thread_;
  std::atomic<bool> ended_{false};
  std::string error_; // written before ended_ is set
  bool worked_ = false;
  Finish finish_;
};

} // namespace linelet::view
