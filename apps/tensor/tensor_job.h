// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <linelet/features/cloud_piece.h>

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
  Devices
  devices() override;
  Figures
  compute(const FragmentTask& task) override;
  Figures
  write(const OutputTask& task) override;
  void
  report(const Figures& figures) override;
  int
  runWhole() override;

private:
  std::vector<PointDistributionTensor>
  tensorsOf(const FragmentTask& task, const CloudPiece& piece);
  DeviceEngine&
  openDevice(std::size_t device);

  TensorSettings settings_;
  NeighborFinder finder_;
  SizeFields fields_;
  FeatureList features_{"shape"};
  fragments::Heuristic schedule_ = fragments::Heuristic::SimpleHS;
  std::vector<NamedDevice> devices_; ///< besides the processor
  bool listed_ = false;              ///< whether these are known
  /// Indexed like \ref devices_, or the one of --engine opencl; each opened by its
  /// first user.
  std::vector<std::unique_ptr<DeviceEngine>> engines_;
};

} // namespace linelet::apps
