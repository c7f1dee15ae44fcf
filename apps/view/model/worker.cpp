// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "worker.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace linelet::view {

void
Worker::Monitor::begin(std::string_view new_stage, std::size_t new_total)
{
  const std::lock_guard<std::mutex> lock(mutex);
  stage = new_stage;
  total = new_total;
  done = 0;
}

void
Worker::Monitor::advance(std::size_t steps)
{
  done += steps;
}

bool
Worker::Monitor::canceled() const
{
  return stop;
}

Worker::~Worker()
{
  cancel();
  join();
}

void
Worker::join()
{
  if (thread_.joinable())
    thread_.join();
}

void
Worker::start(Work work, Finish finish)
{
  cancel();
  join();
  monitor_.begin("", 0);
  monitor_.stop = false;
  ended_ = false;
  worked_ = false;
  error_.clear();
  finish_ = std::move(finish);
  thread_ = std::thread([this, work = std::move(work)] {
    try {
      work(&monitor_);
      worked_ = true;
    }
    catch (const Canceled&) {
    }
    catch (const std::bad_alloc&) {
      error_ = "not enough memory for this; try it on a box of the cloud";
    }
    catch (const std::exception& error) {
      error_ = error.what();
    }
    ended_ = true;
  });
}

void
Worker::cancel()
{
  monitor_.stop = true;
}

Progress
Worker::progress() const
{
  const std::lock_guard<std::mutex> lock(monitor_.mutex);
  const auto total = static_cast<double>(monitor_.total);
  return {monitor_.stage,
          total > 0 ? std::min(1.0, static_cast<double>(monitor_.done) / total) : 0};
}

bool
Worker::poll(std::string& error)
{
  error.clear();
  if (!thread_.joinable() || !ended_)
    return false;
  join();
  const Finish finish = std::exchange(finish_, nullptr);
  error = error_;
  if (worked_ && !monitor_.stop && finish)
    finish();
  return true;
}

} // namespace linelet::view
