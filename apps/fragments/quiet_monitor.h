// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string_view>

#include <linelet/support/progress_monitor.h>

namespace linelet::apps {

/** \brief Passes on only cancellation: progress is reported per fragment. */
class QuietMonitor : public ProgressMonitor {
public:
  explicit QuietMonitor(const ProgressMonitor& outer) : outer_(outer) {}
  void
  begin(std::string_view, std::size_t) override
  {
  }
  void
  advance(std::size_t) override
  {
  }
  bool
  canceled() const override
  {
    return outer_.canceled();
  }

private:
  const ProgressMonitor& outer_;
};

} // namespace linelet::apps
