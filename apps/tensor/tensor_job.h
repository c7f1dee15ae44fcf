// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "fragments/cloud_fragment_job.h"
#include "neighbor_finder.h"
#include "size_fields.h"
#include "tensor_features.h"

namespace linelet::apps {

/** \brief The command `tensor`, with its options read. */
class TensorJob : public CloudFragmentJob {
public:
  explicit TensorJob(const std::vector<std::string>& arguments);

  void
  check() override;
  double
  ghost(const std::map<std::string, double>& /*measures*/) override;
  double
  bytesPerPoint(bool in_fragments) const override;
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
  TensorSettings settings_;
  NeighborFinder finder_;
  SizeFields fields_;
  FeatureList features_{"shape"};
};

} // namespace linelet::apps
