// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/features/centroid_shift.h>
#include <linelet/features/multi_scale.h>

#include "fourth_order_columns.h"
#include "fragments/cloud_fragment_job.h"

namespace linelet::apps {

/** \brief The command `multiscale`, with its options read. */
class MultiscaleJob : public CloudFragmentJob {
public:
  explicit MultiscaleJob(const std::vector<std::string>& arguments);

  void
  check() override;
  double
  ghost(const Figures& /*measures*/) override
  {
    return multiScaleMargin(settings_.radii);
  }
  Figures
  compute(const FragmentTask& task) override;
  Figures
  write(const OutputTask& task) override;
  void
  report(const Figures& figures) override;
  int
  runWhole() override;

private:
  /** \brief A single input: all options. */
  void
  runOne();
  /** \brief Several inputs: the radii of the first for all, with neighbors across their
   * borders. */
  void
  runSeveral();
  bool
  looksAtOneCloud() const
  {
    return !graphs_.empty() || shift_.radius != 0 || settings_.stop_change > 0 ||
           fourth_order_ != FourthOrderOption::None;
  }

  MultiScaleSettings settings_;
  CentroidShiftSettings shift_;
  std::string graphs_;
  FourthOrderOption fourth_order_ = FourthOrderOption::None;
};

} // namespace linelet::apps
