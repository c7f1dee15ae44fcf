// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
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
  ghost(const std::map<std::string, double>& /*measures*/) override
  {
    return multiScaleMargin(settings_.radii);
  }
  double
  bytesPerPoint(bool in_fragments) const override
  {
    // Two fragments, engine and shapes; or cloud, usable points, engine, shapes, and
    // these as columns.
    return in_fragments ? 220 : 300;
  }
  std::map<std::string, double>
  compute(const fragments::Plan& plan,
          const fragments::Fragment& fragment,
          const std::string& result,
          ProgressMonitor* monitor) override;
  std::map<std::string, double>
  write(const fragments::Plan& plan,
        const std::string& folder,
        std::size_t number,
        const std::vector<bool>& usable,
        ProgressMonitor* monitor) override;
  void
  report(const std::map<std::string, double>& figures) override;
  int
  runWhole() override;

private:
  /** \brief One input: all options. */
  void
  runOne();
  /** \brief Several inputs: the radii of the first for all, and neighbors across their
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
