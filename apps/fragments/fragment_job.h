// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <linelet/fragments/pieces.h>
#include <linelet/fragments/plan.h>

#include "cloud_files.h"
#include "fragment_options.h"
#include "frame.h"

namespace linelet::apps {

/** \brief A command that can work on a cloud in fragments. */
class FragmentJob {
public:
  virtual ~FragmentJob() = default;

  Frame&
  frame()
  {
    return frame_;
  }
  CloudInput&
  input()
  {
    return input_;
  }
  const FragmentOptions&
  options() const
  {
    return fragments_;
  }
  /** \brief Where the results go: a file or folder. */
  virtual const std::string&
  place() const = 0;

  /** \brief Fails where the command cannot work so, or could not write its results. */
  virtual void
  check() = 0;
  /** \brief What must be known of the whole cloud before its fragments are worked on;
   * the plan keeps it. */
  virtual std::map<std::string, double>
  measures()
  {
    return {};
  }
  /** \brief The width of the ghost zones. */
  virtual double
  ghost(const std::map<std::string, double>& measures) = 0;
  /** \brief The memory that a point takes at the most, of a fragment (with the next one
   * loaded beside it), and of the cloud in one piece. */
  virtual double
  bytesPerPoint(bool in_fragments) const = 0;

  /** \brief Works on \a fragment and writes the file \a result.
   * \return what is to be added up over the fragments */
  virtual std::map<std::string, double>
  compute(const fragments::Plan& plan,
          const fragments::Fragment& fragment,
          const std::string& result,
          ProgressMonitor* monitor) = 0;

  /** \brief The fragments that output \a number is made of; empty for one behind the
   * last. Here, one output of all. */
  virtual std::vector<std::size_t>
  needs(const fragments::Plan& plan, std::size_t number);

  /** \brief Writes output \a number.
   * \param[in] usable which fragments there are; all but for --partial
   * \return figures of it */
  virtual std::map<std::string, double>
  write(const fragments::Plan& plan,
        const std::string& folder,
        std::size_t number,
        const std::vector<bool>& usable,
        ProgressMonitor* monitor) = 0;

  /** \brief Says what came of it; \a figures are sums over outputs. */
  virtual void
  report(const std::map<std::string, double>& figures) = 0;

  /** \brief Works on the cloud in one piece. \return the exit code */
  virtual int
  runWhole() = 0;

protected:
  template <class... Input>
  FragmentJob(const std::string& command,
              const std::string& summary,
              const Input&... input)
      : frame_(command, summary), input_(frame_, input...)
  {
  }

  Frame frame_;
  FragmentOptions fragments_;
  CloudInput input_;
};

/** \brief The command \a name with \a arguments, parsed. \throws std::runtime_error
 * where it knows no fragments; Exit */
std::unique_ptr<FragmentJob>
makeFragmentJob(const std::string& name, const std::vector<std::string>& arguments);

std::unique_ptr<FragmentJob>
makeTensorJob(const std::vector<std::string>& arguments);
std::unique_ptr<FragmentJob>
makeMultiscaleJob(const std::vector<std::string>& arguments);
std::unique_ptr<FragmentJob>
makeCurvesJob(const std::vector<std::string>& arguments);
std::unique_ptr<FragmentJob>
makePowerlinesJob(const std::vector<std::string>& arguments);

} // namespace linelet::apps
