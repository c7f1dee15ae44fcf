// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

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
  ghost(const Figures& /*measures*/) override;
  Figures
  compute(const FragmentTask& task) override;
  Figures
  write(const OutputTask& task) override;
  void
  report(const Figures& figures) override;
  int
  runWhole() override;

private:
  TensorSettings settings_;
  NeighborFinder finder_;
  SizeFields fields_;
  FeatureList features_{"shape"};
};

} // namespace linelet::apps
