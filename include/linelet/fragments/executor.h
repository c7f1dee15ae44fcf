// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <linelet/fragments/dispatcher.h>
#include <linelet/fragments/pieces.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief What \ref execute does with a fragment. Fragments have the numbers that the
 * dispatcher gives out. */
struct FragmentWork {
  /// Loads a fragment. Called from several threads at once.
  std::function<Fragment(std::size_t number)> load;
  /// Computes it on a device, and may consume its contents. Called from several threads
  /// at once, but by one at a time for every device except the first.
  std::function<void(Fragment& fragment, std::size_t number, std::size_t device)>
      compute;
  /// Notified that the fragment is done or, with a reason, has failed. Called once per
  /// fragment, by one thread at a time.
  std::function<void(std::size_t number, const std::string& reason)> settle;
};

/** \brief Processes all fragments of \a dispatcher with one queue per device, each in
 * its own thread, which loads its next fragment while it computes one (Grasso et al.
 * 2015, section 4). A fragment that fails is loaded once more and computed on the first
 * device.
 * \param[in] devices number of devices, 1 or more; with one, its queue runs in this
 * thread
 * \throws Canceled, or what \a work.settle throws, once all queues have ended */
void
execute(Dispatcher& dispatcher,
        std::size_t devices,
        const FragmentWork& work,
        ProgressMonitor* monitor = nullptr);

} // namespace fragments
} // namespace linelet
