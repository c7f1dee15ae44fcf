// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Receives the progress of long work and may cancel it.
 *
 * Library functions that can take longer than a second accept a `ProgressMonitor*`,
 * which may be null. \ref advance and \ref canceled are called from several threads at
 * once and must be thread-safe; \ref begin is called from one. */
class ProgressMonitor {
public:
  virtual ~ProgressMonitor() = default;

  /** \brief A stage of \a total equal steps begins (0: length unknown). */
  virtual void
  begin(std::string_view /*stage*/, std::size_t /*total*/)
  {
  }

  /** \brief \a steps more steps of the current stage are done. */
  virtual void
  advance(std::size_t /*steps*/)
  {
  }

  /** \brief True once the work should stop; it then throws \ref Canceled. */
  virtual bool
  canceled() const
  {
    return false;
  }
};

/** \brief Thrown by work that its monitor canceled. */
class Canceled : public std::runtime_error {
public:
  Canceled() : std::runtime_error("canceled") {}
};

/** \brief Ends work that \a monitor, which may be null, asked to stop. Not for loops
 * that run in several threads, out of which nothing may be thrown. \throws Canceled */
inline void
throwIfCanceled(const ProgressMonitor* monitor)
{
  if (monitor != nullptr && monitor->canceled())
    throw Canceled();
}

} // namespace linelet
