// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <linelet/fragments/schedule.h>

#include "cloud_files.h"
#include "fragment_options.h"
#include "fragment_tasks.h"
#include "frame.h"

namespace linelet::apps {

/** \brief The peak memory of a command, in bytes per point. */
struct BytesPerPoint {
  double in_fragments; ///< of one fragment, with the next one loaded beside it
  double in_one_piece;
};

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
  const BytesPerPoint&
  bytesPerPoint() const
  {
    return bytes_per_point_;
  }
  /** \brief Where the results go: a file or folder. */
  virtual const std::string&
  place() const = 0;

  /** \brief Fails if the command cannot run in fragments or write its results. */
  virtual void
  check() = 0;
  /** \brief Properties of the whole cloud that its fragments need; kept in the
   * plan. */
  virtual Figures
  measures()
  {
    return {};
  }
  /** \brief The width of the ghost zones. */
  virtual double
  ghost(const Figures& measures) = 0;

  /** \brief Devices that compute fragments concurrently. */
  struct Devices {
    std::vector<std::string> names = {""};
    fragments::Heuristic heuristic = fragments::Heuristic::SimpleHS;
  };
  /** \brief The devices of this machine; by default a single one without a name. */
  virtual Devices
  devices()
  {
    return {};
  }

  /** \brief Computes a fragment and writes its result. On the first device, several
   * threads may do so at once.
   * \return figures to sum over the fragments */
  virtual Figures
  compute(const FragmentTask& task) = 0;

  /** \brief The fragments that output \a number needs; empty beyond the last output.
   * By default one output needs all. */
  virtual std::vector<std::size_t>
  needs(const fragments::Plan& plan, std::size_t number);

  /** \brief Writes an output. \return figures to sum over the outputs */
  virtual Figures
  write(const OutputTask& task) = 0;

  /** \brief Prints and summarizes the sums over fragments and outputs. */
  virtual void
  report(const Figures& /*figures*/)
  {
  }

  /** \brief Processes the cloud in one piece. \return the exit code */
  virtual int
  runWhole() = 0;

protected:
  template <class... Input>
  FragmentJob(const std::string& command,
              const std::string& summary,
              const BytesPerPoint& bytes_per_point,
              const Input&... input)
      : frame_(command, summary),
        input_(frame_, input...),
        bytes_per_point_(bytes_per_point)
  {
  }

  Frame frame_;
  FragmentOptions fragments_;
  CloudInput input_;

private:
  BytesPerPoint bytes_per_point_;
};

/** \brief The command \a name with \a arguments, parsed.
 * \throws std::runtime_error if it cannot run in fragments; Exit */
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
