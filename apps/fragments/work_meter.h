// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>

#include <linelet/fragments/ledger.h>

namespace linelet::apps {

/** \brief Time since construction, and memory of the process. */
class WorkMeter {
public:
  double
  seconds() const;

  /** \brief Writes both into \a entry. */
  void
  note(fragments::Ledger::Entry& entry) const;

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

} // namespace linelet::apps
