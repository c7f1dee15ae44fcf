// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/progress_monitor.h>

namespace linelet {

/** \brief Passes on cancellation alone, for work beside that whose progress is shown.
 */
class QuietMonitor : public ProgressMonitor {
public:
  /** \param[in] outer may be null */
  explicit QuietMonitor(const ProgressMonitor* outer) : outer_(outer) {}

  bool
  canceled() const override
  {
    return outer_ != nullptr && outer_->canceled();
  }

private:
  const ProgressMonitor* outer_;
};

} // namespace linelet
