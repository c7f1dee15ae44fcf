// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/curves/curve_parts.h>
#include <linelet/curves/reconstruct_curves.h>
#include <linelet/io/vector_file.h>

#include "fragments/fragment_job.h"
#include "simplify_curves.h"

namespace linelet::apps {

/** \brief The command `curves`, with its options read. */
class CurvesJob : public FragmentJob {
public:
  explicit CurvesJob(const std::vector<std::string>& arguments);

  const std::string&
  place() const override
  {
    return output_;
  }
  void
  check() override;
  Figures
  measures() override;
  double
  ghost(const Figures& measures) override;
  Figures
  compute(const FragmentTask& task) override;
  Figures
  write(const OutputTask& task) override;
  int
  runWhole() override;

private:
  void
  warnOfUnusedOptions();
  /** \brief Warns if fragments cannot keep to the given memory. */
  void
  warnOfOneBlock(const CloudTraits& traits);
  /** \brief Simplifies \a network, writes it and reports it. */
  void
  finish(CurveNetwork network,
         double points,
         const Point& shift,
         const std::string& wkt,
         const io::Cloud* beside,
         ProgressMonitor* monitor);

  ReconstructionSettings settings_;
  std::string output_;
  SimplifyTolerance simplify_{"auto"};
  io::VectorOptions vectors_;
  bool tensors_ = false;
};

} // namespace linelet::apps
