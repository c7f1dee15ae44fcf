// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/executor.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace linelet::fragments {

namespace {

/** The queues of all devices. */
class Queues {
public:
  Queues(Dispatcher& dispatcher, const FragmentWork& work, ProgressMonitor* monitor)
      : dispatcher_(dispatcher), work_(work), monitor_(monitor)
  {
  }

  void
  run(std::size_t devices)
  {
    // Every device gets its first fragment before any can finish.
    std::vector<std::optional<std::size_t>> first;
    for (std::size_t device = 0; device < devices; ++device)
      first.push_back(dispatcher_.next(device));
    std::vector<std::thread> threads;
    for (std::size_t device = 1; device < devices; ++device)
      threads.emplace_back([&, device] { serve(device, first[device]); });
    serve(0, first.front());
    for (std::thread& thread : threads)
      thread.join();
    if (error_)
      std::rethrow_exception(error_);
  }

private:
  /** A fragment of a queue, on its way from disk. */
  struct Loading {
    std::optional<std::size_t> number;
    std::future<Fragment> fragment;
  };

  void
  serve(std::size_t device, std::optional<std::size_t> first)
  {
    try {
      Loading now = start(first);
      while (now.number && !ended_)
        now = work(std::move(now), device);
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!error_)
        error_ = std::current_exception();
      ended_ = true; // the other queues end, too, after their current fragment
    }
  }

  Loading
  start(std::optional<std::size_t> number) const
  {
    if (!number)
      return {};
    return {number, std::async(std::launch::async, work_.load, *number)};
  }

  Loading
  startNext(std::size_t device)
  {
    std::optional<std::size_t> next;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!ended_)
        next = dispatcher_.next(device);
    }
    return start(next);
  }

  /** \return the next of the device */
  Loading
  work(Loading now, std::size_t device)
  {
    std::optional<Loading> next;
    std::string reason;
    for (const bool again : {false, true})
      try {
        Fragment fragment = again ? work_.load(*now.number) : now.fragment.get();
        if (!next)
          next = startNext(device);
        compute(fragment, *now.number, again ? 0 : device);
        reason.clear();
        break;
      }
      catch (const Canceled&) {
        throw;
      }
      catch (const std::exception& error) {
        throwIfCanceled(monitor_);
        reason = error.what();
      }
    {
      const std::lock_guard<std::mutex> lock(settling_);
      work_.settle(*now.number, reason);
    }
    return next ? std::move(*next) : startNext(device);
  }

  void
  compute(Fragment& fragment, std::size_t number, std::size_t device)
  {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    work_.compute(fragment, number, device);
    const std::chrono::duration<double> seconds = Clock::now() - begin;
    const std::lock_guard<std::mutex> lock(mutex_);
    dispatcher_.finished(number, device, seconds.count());
  }

  Dispatcher& dispatcher_;
  const FragmentWork& work_;
  ProgressMonitor* monitor_;
  std::mutex mutex_;    ///< of dispatcher and error
  std::mutex settling_; ///< apart, since it may take long
  std::exception_ptr error_;
  std::atomic<bool> ended_{false};
};

} // namespace

void
execute(Dispatcher& dispatcher,
        std::size_t devices,
        const FragmentWork& work,
        ProgressMonitor* monitor)
{
  if (devices > 0)
    Queues(dispatcher, work, monitor).run(devices);
}

} // namespace linelet::fragments
