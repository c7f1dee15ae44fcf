// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/tensor_engine.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include <linelet/support/threads.h>

#include "stages.h"

namespace linelet::opencl {

namespace {

/** \brief Adds the time since its making, or the last call, to a stage. */
class Lap {
public:
  explicit Lap(const cl::CommandQueue& queue) : queue_(queue) {}

  void
  add(double& stage)
  {
    queue_.finish();
    const auto now = Clock::now();
    stage += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

private:
  using Clock = std::chrono::steady_clock;
  const cl::CommandQueue& queue_;
  Clock::time_point last_ = Clock::now();
};

/** \brief Bytes on the device for so many points and queries. */
std::size_t
bytesNeeded(std::size_t points, std::size_t queries)
{
  const std::size_t entries =
      sizeof(Entry) * (paddedCount(points) + paddedCount(queries));
  const std::size_t a_point = 16 + 12 + 24 + 12 + 24; // cell, offset, position, sorted
  const std::size_t a_query =
      16 + 12 + 24 + 8 + 12 + 300 + 28; // runs in a cell of its own
  return entries + a_point * points + a_query * queries;
}

bool
isOutOfMemory(cl_int code)
{
  return code == CL_MEM_OBJECT_ALLOCATION_FAILURE || code == CL_OUT_OF_RESOURCES ||
         code == CL_OUT_OF_HOST_MEMORY || code == CL_INVALID_BUFFER_SIZE;
}

} // namespace

struct TensorEngine::State {
  explicit State(const std::string& device) : context(device) {}

  Context context;
  std::size_t memory_limit = 0;
  StageTimes times;
  std::size_t slabs = 0;
};

namespace {

/** \brief One call of \ref TensorEngine::estimate. */
class Estimation {
public:
  Estimation(Context& context,
             StageTimes& times,
             const Points& surface,
             const Points& queries,
             const TensorSettings& settings,
             const NeighbourhoodSizes& sizes,
             Monitor* monitor)
      : context_(context),
        times_(times),
        surface_(surface),
        queries_(queries),
        settings_(settings),
        sizes_(sizes),
        monitor_(monitor),
        definitions_(tensorDefinitions(
            settings.centroid, settings.weighting, settings.centroid_weighting)),
        records_(queries.size(), unknownTensor(0))
  {
  }

  std::vector<PointDistributionTensor>
  run(std::size_t memory_limit)
  {
    memory_limit_ = memory_limit;
    Indices points, queries;
    for (std::size_t i = 0; i < surface_.size(); ++i)
      if (surface_[i].allFinite())
        points.push_back(static_cast<Index>(i));
    for (std::size_t i = 0; i < queries_.size(); ++i)
      if (queries_[i].allFinite() && radiusOf(i) > 0 && std::isfinite(radiusOf(i)))
        queries.push_back(static_cast<Index>(i));
    if (monitor_ != nullptr)
      monitor_->begin("tensor", queries_.size());
    if (!points.empty() && !queries.empty())
      solve(points, queries);
    return std::move(records_);
  }

  std::size_t slabs = 0;

private:
  double
  radiusOf(std::size_t query) const
  {
    return settings_.radius > 0 ? settings_.radius : sizes_.radii[query];
  }

  /** \brief All queries of a slab at once, or in two halves where that is too much. */
  void
  solve(const Indices& points, Indices& queries)
  {
    if (monitor_ != nullptr && monitor_->cancelled())
      throw Cancelled();
    double largest = 0;
    for (const Index i : queries)
      largest = std::max(largest, radiusOf(i));
    if (queries.size() == 1 ||
        bytesNeeded(points.size(), queries.size()) <= memory_limit_) {
      try {
        solveSlab(points, queries, largest);
        ++slabs;
        if (monitor_ != nullptr)
          monitor_->advance(queries.size());
        return;
      }
      catch (const cl::Error& error) {
        if (queries.size() == 1 || !isOutOfMemory(error.err()))
          throw;
      }
    }
    halve(points, queries, largest);
  }

  /** \brief Cuts the queries at their median along the longest axis; each half takes
   * the points as far as the radius beyond it. */
  void
  halve(const Indices& points, Indices& queries, double largest)
  {
    Point low = queries_[queries.front()], high = low;
    for (const Index i : queries) {
      low = low.cwiseMin(queries_[i]);
      high = high.cwiseMax(queries_[i]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const auto middle =
        queries.begin() + static_cast<Indices::difference_type>(queries.size() / 2);
    std::nth_element(queries.begin(), middle, queries.end(), [&](Index a, Index b) {
      return queries_[a][axis] < queries_[b][axis];
    });
    const double cut = queries_[*middle][axis];
    Indices halves[2] = {{queries.begin(), middle}, {middle, queries.end()}};
    queries = {};
    for (int side = 0; side < 2; ++side) {
      const double reach = largest * (1 + 1e-6);
      Indices near;
      for (const Index i : points)
        if (side == 0 ? surface_[i][axis] <= cut + reach
                      : surface_[i][axis] >= cut - reach)
          near.push_back(i);
      if (!near.empty())
        solve(near, halves[side]);
    }
  }

  void
  solveSlab(const Indices& points, const Indices& queries, double largest)
  {
    const CellFrame frame(surface_, points, largest);
    Lap lap(context_.queue());
    SortedCells sorted_points = uploadPoints(context_, surface_, points, frame);
    // Most often every point asks for its own neighbourhood.
    const bool same = &surface_ == &queries_ && points == queries;
    SortedCells sorted_queries =
        same ? sorted_points : uploadPoints(context_, queries_, queries, frame);
    lap.add(times_.upload);
    sortCells(context_, sorted_points);
    if (same)
      sorted_queries = sorted_points;
    else
      sortCells(context_, sorted_queries);
    const RunTable table = neighbourRuns(context_, sorted_queries, sorted_points);
    lap.add(times_.grid);
    std::vector<double> radii;
    radii.reserve(queries.size());
    for (const Index i : queries)
      radii.push_back(radiusOf(i));
    cl::Buffer device_components, device_counts;
    computeTensors(context_,
                   definitions_,
                   frame,
                   sorted_queries,
                   sorted_points,
                   table,
                   radii,
                   device_components,
                   device_counts);
    lap.add(times_.tensor);
    std::vector<float> components(6 * queries.size());
    std::vector<cl_uint> counts(queries.size());
    context_.queue().enqueueReadBuffer(device_components,
                                       CL_TRUE,
                                       0,
                                       components.size() * sizeof(float),
                                       components.data());
    context_.queue().enqueueReadBuffer(
        device_counts, CL_TRUE, 0, counts.size() * sizeof(cl_uint), counts.data());
    lap.add(times_.download);
    analyse(queries, radii, components, counts);
    lap.add(times_.analysis);
  }

  void
  analyse(const Indices& queries,
          const std::vector<double>& radii,
          const std::vector<float>& components,
          const std::vector<cl_uint>& counts)
  {
    const auto count = static_cast<std::ptrdiff_t>(queries.size());
#pragma omp parallel for num_threads(threadCount(settings_.threads))
    for (std::ptrdiff_t k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const float* t = &components[6 * i];
      // An extent below float's precision of the radius is rounding.
      const double least = 1e-6 * radii[i];
      const double trace = double{t[0]} + double{t[3]} + double{t[5]};
      records_[queries[i]] =
          trace > least * least
              ? recordOf({t[0], t[1], t[2], t[3], t[4], t[5]}, 0, counts[i])
              : unknownTensor(counts[i]);
    }
  }

  Context& context_;
  StageTimes& times_;
  const Points& surface_;
  const Points& queries_;
  const TensorSettings& settings_;
  const NeighbourhoodSizes& sizes_;
  Monitor* monitor_;
  std::string definitions_;
  std::vector<PointDistributionTensor> records_;
  std::size_t memory_limit_ = 0;
};

} // namespace

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
                       const NeighbourhoodSizes& sizes,
                       Monitor* monitor)
{
  if (settings.k > 0 || !sizes.counts.empty())
    throw std::invalid_argument(
        "the OpenCL engine makes neighbourhoods by radius only; "
        "for the k nearest points choose the engine tree");
  if (settings.centroid == Centroid::WeightedMedian)
    throw std::invalid_argument(
        "the OpenCL engine has no weighted median, which among its "
        "several minima float would choose by chance; choose the "
        "engine grid or tree");
  validate(settings, sizes, queries.size());
  state_->times = {};
  const std::size_t limit = state_->memory_limit > 0
                                ? state_->memory_limit
                                : static_cast<std::size_t>(device().memory) / 5 * 4;
  Estimation estimation(
      state_->context, state_->times, surface, queries, settings, sizes, monitor);
  try {
    auto records = estimation.run(limit);
    state_->slabs = estimation.slabs;
    return records;
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

} // namespace linelet::opencl
