// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <linelet/fragments/ledger.h>

#include "fragment_job.h"

namespace linelet::apps {

/** \brief Outputs to write while fragments are computed, each as soon as its fragments
 * are done. Results that are no longer needed are removed. */
class OutputQueue {
public:
  /** \brief Writes an output. \param[in] done which fragments are */
  using Write = std::function<void(std::size_t output, const std::vector<bool>& done)>;

  /** \param[in] folder of the run */
  OutputQueue(FragmentJob& job,
              const fragments::Plan& plan,
              const std::string& folder,
              const fragments::Ledger& ledger,
              Write write);

  /** \brief Writes outputs that are complete before any fragment is computed. */
  void
  begin();

  /** \brief Fragment \a number is done: writes outputs that this completes. */
  void
  add(std::size_t number);

private:
  /** An output that is not yet written. */
  struct Pending {
    std::size_t number = 0;
    std::vector<std::size_t> needs;
    std::size_t missing = 0; ///< fragments not yet done
  };

  void
  write(const Pending& output);
  void
  removeUnneeded(std::size_t number) const;

  std::string folder_;
  Write write_;
  std::vector<bool> done_;
  std::vector<Pending> outputs_;
  std::vector<std::vector<std::size_t>> of_; ///< by fragment: places in outputs_
  std::vector<std::size_t> pending_;         ///< by fragment: how many need it
};

} // namespace linelet::apps
