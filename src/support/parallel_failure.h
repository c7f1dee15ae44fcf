// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <exception>
#include <mutex>

namespace linelet {

/** \brief Carries an exception out of a parallel region, which no exception may leave:
 * wrap whatever may throw inside (allocations, too), and rethrow after the region. */
class ParallelFailure {
public:
  /** \brief Runs \a work and keeps what it throws. Does nothing once something has
   * failed. */
  template <class Work>
  void
  guard(Work&& work) noexcept
  {
    if (failed_)
      return;
    try {
      work();
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_)
        failure_ = std::current_exception();
      failed_ = true;
    }
  }

  bool
  failed() const
  {
    return failed_;
  }

  /** \brief Throws the first failure, if there was one. */
  void
  rethrow() const
  {
    if (failure_)
      std::rethrow_exception(failure_);
  }

private:
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

} // namespace linelet
