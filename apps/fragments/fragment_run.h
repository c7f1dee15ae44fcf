// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <linelet/fragments/ledger.h>

#include "fragment_job.h"

namespace linelet::apps {

/** \brief A run in fragments: its plan and progress. */
class FragmentRun {
public:
  /** \brief The folder of the run whose results go to \a place. */
  static std::string
  folderOf(const std::string& place);

  /** \brief What to do with an existing plan. */
  enum class Existing {
    Remove,       ///< it is removed and the run starts over
    Resume,       ///< the run continues; a different plan is an error
    KeepOrReplace ///< the run continues; a different plan is removed
  };

  /** \brief Plans \a job into its folder, from headers. */
  static FragmentRun
  make(FragmentJob& job,
       const std::string& name,
       const std::vector<std::string>& arguments,
       Existing existing);

  /** \brief The run planned for \a place, with its job; changes to the working folder
   * of the plan.
   * \throws io::FileError if there is none, or an input or linelet has changed */
  static FragmentRun
  open(const std::string& place, std::unique_ptr<FragmentJob>& job);

  const fragments::Plan&
  plan() const
  {
    return plan_;
  }
  const fragments::Ledger&
  ledger() const
  {
    return ledger_;
  }
  const std::string&
  folder() const
  {
    return folder_;
  }

  /** \brief Processes those of \a tasks that are not done; with \a outputs, writes
   * outputs as they become complete. Failures are retried once and then recorded.
   * \return the numbers of the tasks that failed */
  std::vector<std::size_t>
  work(FragmentJob& job, const std::vector<std::size_t>& tasks, bool outputs);

  /** \brief Writes all missing outputs, and reports the results.
   * \throws std::runtime_error if a fragment is missing, unless \a partial
   * \return number of missing fragments */
  std::size_t
  merge(FragmentJob& job, bool partial);

  /** \brief Removes the folder. */
  void
  remove() const;

private:
  FragmentRun(fragments::Plan plan, std::string folder);

  void
  computeOne(FragmentJob& job,
             fragments::Fragment& fragment,
             std::size_t device,
             const std::string& device_name);
  void
  summarizeDevices(Frame& frame) const;
  void
  writeOutput(FragmentJob& job, std::size_t number, const std::vector<bool>& usable);

  fragments::Plan plan_;
  std::string folder_;
  fragments::Ledger ledger_;
};

} // namespace linelet::apps
