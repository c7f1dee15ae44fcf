// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/tensor_engine.h>

#include <stdexcept>

#include <linelet/opencl/device_cost.h>

#include "estimation.h"

namespace linelet::opencl {

struct TensorEngine::State {
  explicit State(const std::string& device) : context(device) {}

  Context context;
  std::size_t memory_limit = 0;
  StageTimes times;
  std::size_t slabs = 0, on_host = 0;
};

TensorEngine::TensorEngine(const std::string& device)
    : state_(std::make_unique<State>(device))
{
}

TensorEngine::~TensorEngine() = default;
TensorEngine::TensorEngine(TensorEngine&&) noexcept = default;
TensorEngine&
TensorEngine::operator=(TensorEngine&&) noexcept = default;

const Device&
TensorEngine::device() const
{
  return state_->context.device();
}

void
TensorEngine::setMemoryLimit(std::size_t bytes)
{
  state_->memory_limit = bytes;
}

std::vector<PointDistributionTensor>
TensorEngine::estimate(const Points& surface,
                       const Points& queries,
                       const TensorSettings& settings,
                       const NeighborhoodSizes& sizes,
                       ProgressMonitor* monitor)
{
  validate(settings, sizes, queries.size());
  const bool nearest = settings.k > 0 || !sizes.counts.empty();
  if (nearest && !device().double_precision)
    throw std::invalid_argument("the OpenCL device '" + device().name +
                                "' has no double precision, which the k nearest "
                                "points need; choose the engine tree or a radius");
  if (const char* reason = unsupported(settings))
    throw std::invalid_argument(reason);
  const std::size_t limit = state_->memory_limit > 0
                                ? state_->memory_limit
                                : static_cast<std::size_t>(device().memory) / 5 * 4;
  try {
    Outcome outcome =
        estimateOn(state_->context, limit, surface, queries, settings, sizes, monitor);
    state_->times = outcome.times;
    state_->slabs = outcome.slabs;
    state_->on_host = outcome.on_host;
    return std::move(outcome.records);
  }
  catch (const cl::Error& error) {
    throw explained(error, device().name);
  }
}

const StageTimes&
TensorEngine::stageTimes() const
{
  return state_->times;
}

std::size_t
TensorEngine::slabs() const
{
  return state_->slabs;
}

std::size_t
TensorEngine::queriesOnHost() const
{
  return state_->on_host;
}

} // namespace linelet::opencl
