// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/tensor_engine.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

#include <Eigen/Geometry>

#include <linelet/support/threads.h>

#include "stages.h"

namespace linelet::opencl {

namespace {

/** \brief Points or queries of a slab: the device counts places of its tables in 32
 * bits. */
constexpr std::size_t most_at_once = std::size_t{1} << 25;

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

/** \brief Bytes on the device for so many points and queries, the table apart. */
std::size_t
bytesNeeded(std::size_t points, std::size_t queries)
{
  // Cell, offset, position, key, sorted position.
  const std::size_t a_point = 16 + 12 + 24 + 8 + 12;
  // Cell, offset, position, key, slot, radii, tensor, count, record.
  const std::size_t a_query = 16 + 12 + 24 + 8 + 8 + 12 + 24 + 4 + 76;
  return a_point * points + a_query * queries + 16 * sort_block;
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
        records_(queries.size())
  {
  }

  std::vector<PointDistributionTensor>
  run(std::size_t memory_limit)
  {
    memory_limit_ = memory_limit;
    Indices points, queries;
    points.reserve(surface_.size());
    queries.reserve(queries_.size());
    for (std::size_t i = 0; i < surface_.size(); ++i)
      if (surface_[i].allFinite())
        points.push_back(static_cast<Index>(i));
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      if (queries_[i].allFinite() && radiusOf(i) > 0 && std::isfinite(radiusOf(i)))
        queries.push_back(static_cast<Index>(i));
      else
        records_[i] = unknownTensor(0);
    }
    if (monitor_ != nullptr)
      monitor_->begin("tensor", queries_.size());
    if (!queries.empty())
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
    if (points.empty()) {
      for (const Index i : queries)
        records_[i] = unknownTensor(0);
      return;
    }
    const CellFrame frame(surface_, points, largest);
    const std::size_t count = std::max(points.size(), queries.size());
    const bool small = bytesNeeded(points.size(), queries.size()) <= memory_limit_ &&
                       count <= most_at_once;
    if (queries.size() == 1 || (small && frame.fits(count))) {
      try {
        solveSlab(points, queries, frame);
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
   * the points as far as the radius around it. */
  void
  halve(const Indices& points, Indices& queries, double largest)
  {
    const Eigen::AlignedBox3d box = boxOf(queries);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto middle =
        queries.begin() + static_cast<Indices::difference_type>(queries.size() / 2);
    std::nth_element(queries.begin(), middle, queries.end(), [&](Index a, Index b) {
      return queries_[a][axis] < queries_[b][axis];
    });
    Indices halves[2] = {{queries.begin(), middle}, {middle, queries.end()}};
    queries = {};
    const Point reach = Point::Constant(largest * (1 + 1e-6));
    for (Indices& half : halves) {
      const Eigen::AlignedBox3d inner = boxOf(half);
      const Eigen::AlignedBox3d outer(inner.min() - reach, inner.max() + reach);
      Indices near;
      std::copy_if(points.begin(),
                   points.end(),
                   std::back_inserter(near),
                   [&](Index i) { return outer.contains(surface_[i]); });
      solve(near, half);
    }
  }

  Eigen::AlignedBox3d
  boxOf(const Indices& queries) const
  {
    Eigen::AlignedBox3d box;
    for (const Index i : queries)
      box.extend(queries_[i]);
    return box;
  }

  void
  solveSlab(const Indices& points, const Indices& queries, const CellFrame& frame)
  {
    const int threads = threadCount(settings_.threads);
    const KeyLayout layout = frame.layout(std::max(points.size(), queries.size()));
    Lap lap(context_.queue());
    // Most often every point asks for its own neighbourhood.
    const bool same = &surface_ == &queries_ && points == queries;
    const DevicePoints device_points =
        uploadPoints(context_, surface_, points, frame, threads);
    const DevicePoints device_queries =
        same ? device_points
             : uploadPoints(context_, queries_, queries, frame, threads);
    std::vector<double> radii;
    radii.reserve(queries.size());
    for (const Index i : queries)
      radii.push_back(radiusOf(i));
    lap.add(times_.upload);

    const cl::Buffer point_keys = sortedKeys(context_, device_points, frame, layout);
    const cl::Buffer query_keys =
        same ? point_keys : sortedKeys(context_, device_queries, frame, layout);
    CellTable table = assignSlots(context_, query_keys, queries.size(), layout);
    if (queries.size() > 1 &&
        bytesNeeded(points.size(), queries.size()) + table.bytes() > memory_limit_)
      throw cl::Error(CL_MEM_OBJECT_ALLOCATION_FAILURE, "the table of cells");
    fillTable(context_, table, query_keys, point_keys, points.size(), layout);
    lap.add(times_.grid);

    const DeviceTensors tensors = computeTensors(context_,
                                                 definitions_,
                                                 {frame,
                                                  layout,
                                                  device_queries,
                                                  query_keys,
                                                  device_points,
                                                  point_keys,
                                                  table,
                                                  radii});
    lap.add(times_.tensor);
    const cl::Buffer records =
        computeShapes(context_, tensors, query_keys, queries.size(), layout);
    lap.add(times_.analysis);
    download(records, queries);
    lap.add(times_.download);
  }

  void
  download(const cl::Buffer& device_records, const Indices& queries)
  {
    const auto read = [&](PointDistributionTensor* records) {
      context_.queue().enqueueReadBuffer(
          device_records, CL_TRUE, 0, queries.size() * sizeof *records, records);
    };
    if (queries.size() == records_.size() &&
        std::is_sorted(queries.begin(), queries.end())) {
      read(records_.data());
      return;
    }
    std::vector<PointDistributionTensor> records(queries.size());
    read(records.data());
    for (std::size_t i = 0; i < queries.size(); ++i)
      records_[queries[i]] = records[i];
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
