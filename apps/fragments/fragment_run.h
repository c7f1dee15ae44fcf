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

/** \brief A run in fragments: its plan, and what is done of it. */
class FragmentRun {
public:
  /** \brief The folder of the run whose results go to \a place. */
  static std::string
  folderOf(const std::string& place);

  /** \brief What becomes of a plan that is there already. */
  enum class Existing {
    Remove,       ///< it is begun anew
    Resume,       ///< it is gone on with; where it is another one, that is an error
    KeepOrReplace ///< it is gone on with; where it is another one, that is removed
  };

  /** \brief Plans \a job, out of headers, into its folder. */
  static FragmentRun
  make(FragmentJob& job,
       const std::string& name,
       const std::vector<std::string>& arguments,
       Existing existing);

  /** \brief The run that was planned for \a place, with its job; the working folder
   * becomes that of the plan. \throws io::FileError where there is none, an input has
   * changed, or linelet has */
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

  /** \brief Works on \a tasks, each that is not done; with \a outputs, writes those
   * that are complete in between. What fails is tried once more and noted.
   * \return the numbers of the tasks that failed */
  std::vector<std::size_t>
  work(FragmentJob& job, const std::vector<std::size_t>& tasks, bool outputs);

  /** \brief Writes all outputs that are not written, and says what came of it.
   * \throws std::runtime_error where a fragment is missing, unless \a partial
   * \return how many fragments are missing */
  std::size_t
  merge(FragmentJob& job, bool partial);

  /** \brief Removes the folder. */
  void
  remove() const;

private:
  FragmentRun(fragments::Plan plan, std::string folder);

  void
  computeOne(FragmentJob& job, const fragments::Fragment& fragment);
  void
  writeReady(FragmentJob& job);
  void
  writeOutput(FragmentJob& job, std::size_t number, const std::vector<bool>& usable);

  fragments::Plan plan_;
  std::string folder_;
  fragments::Ledger ledger_;
};

} // namespace linelet::apps
