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

/** \brief How far work has come. */
struct Progress {
  std::string stage;
  double part = 0; ///< of [0, 1]; 0 where the length is not known
};

/** \brief Runs one piece of work at a time in a thread of its own, with progress and
 * cancel. All functions are for one thread, that of the window. */
class Worker {
public:
  Worker() = default;
  ~Worker();
  Worker(const Worker&) = delete;
  Worker&
  operator=(const Worker&) = delete;

  /** \brief What work does in its thread, and what is then done with it in the thread
   * of \ref poll; that is left out where the work was canceled or failed. */
  using Work = std::function<void(ProgressMonitor*)>;
  using Finish = std::function<void()>;

  /** \brief Ends what runs, which is not waited for longer than it takes to hear of
   * it, and begins \a work. */
  void
  start(Work work, Finish finish);

  /** \brief Asks what runs to stop. */
  void
  cancel();

  /** \brief Whether something was started whose end \ref poll has not told yet. */
  bool
  busy() const
  {
    return thread_.joinable();
  }

  Progress
  progress() const;

  /** \brief Takes over what has come to its end, if anything has.
   * \param[out] error what went wrong, in a sentence; empty where nothing did or it was
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
