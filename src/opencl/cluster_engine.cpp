// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/cluster_engine.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "clustering/cluster_with.h"
#include "context.h"
#include "launch.h"

namespace linelet::opencl {

namespace {

using namespace clustering;

/** \brief Grid of clusters.cl. */
struct Grid {
  cl_double low[3], inverse[3];
  cl_double eye[3], axes[9];
  cl_double tangent[2], scale[2];
  cl_ulong bricks[2];
  cl_int cells[4];
  cl_int perspective;
};

Grid
gridOf(const CellFrame& frame, const CellDirectory& directory)
{
  Grid grid{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    grid.low[a] = frame.low[axis];
    grid.inverse[a] = frame.inverse[axis];
    grid.eye[a] = frame.eye[axis];
    grid.cells[a] = frame.cells[a];
    for (std::size_t b = 0; b < 3; ++b)
      grid.axes[3 * a + b] = frame.axes(axis, static_cast<Eigen::Index>(b));
  }
  grid.tangent[0] = frame.tangent_x;
  grid.tangent[1] = frame.tangent_y;
  grid.scale[0] = frame.scale_x;
  grid.scale[1] = frame.scale_y;
  grid.bricks[0] = directory.bricks()[0];
  grid.bricks[1] = directory.bricks()[1];
  grid.perspective = frame.perspective ? 1 : 0;
  return grid;
}

class DevicePasses : public PointPasses {
public:
  DevicePasses(Context& context, const Points& points, std::vector<std::int32_t> field)
      : context_(context), count_(static_cast<cl_uint>(points.size()))
  {
    static_assert(sizeof(Point) == 3 * sizeof(double));
    points_ = upload(context_, points);
    field_ = upload(context_, field);
    home_ = context_.buffer(count_ * sizeof(cl_uint));
    assigned_ = context_.buffer(count_ * sizeof(cl_uint));
    faces_ = context_.buffer(count_);
  }

  void
  fill(CellDirectory& directory, const CellFrame& frame) override
  {
    const cl::Buffer grid = gridBuffer(frame, directory);
    const cl::Buffer depths = upload(context_, frame.depths);
    if (!directory.markAll(count_)) {
      const cl::Buffer marked = zeros<cl_uint>(directory.marked.words.size());
      launch("markBricks", points_, count_, grid, depths, marked);
      directory.marked.words =
          download<std::uint32_t>(marked, directory.marked.words.size());
      directory.marked.rank();
    }
    const std::size_t words = directory.marked.count * CellDirectory::brick_cells / 32;
    const cl::Buffer occupied = zeros<cl_uint>(words);
    launch("markCells",
           points_,
           count_,
           grid,
           depths,
           upload(context_, directory.marked.words),
           upload(context_, directory.marked.before),
           occupied);
    directory.occupied.words = download<std::uint32_t>(occupied, words);
    directory.occupied.rank();
  }

  void
  findHomes(CellDirectory& directory, const CellFrame& frame, double border) override
  {
    fill(directory, frame);
    slots_ = directory.slots();
    launch("findHomes",
           points_,
           count_,
           gridBuffer(frame, directory),
           upload(context_, frame.depths),
           upload(context_, directory.marked.words),
           upload(context_, directory.marked.before),
           upload(context_, directory.occupied.words),
           upload(context_, directory.occupied.before),
           static_cast<cl_double>(border),
           static_cast<cl_double>(steps / border),
           home_,
           assigned_,
           faces_);
  }

  void
  setOrigins(const std::vector<CellOrigin>& origins) override
  {
    origins_ = upload(context_, origins);
  }

  void
  setNeighbors(const Indices& neighbors) override
  {
    neighbors_ = upload(context_, neighbors);
  }

  std::vector<std::uint32_t>
  borderCounts() override
  {
    const std::size_t size = slots_ * faces * steps;
    const cl::Buffer counts = zeros<cl_uint>(size);
    launch("borderCounts", home_, faces_, count_, counts);
    return download<std::uint32_t>(counts, size);
  }

  const std::vector<CellSums>&
  sums() override
  {
    static_assert(sizeof(CellSums) == 10 * sizeof(cl_long));
    const cl::Buffer sums = zeros<CellSums>(slots_);
    launch("cellSums", points_, assigned_, count_, origins_, sums);
    sums_ = download<CellSums>(sums, slots_);
    return sums_;
  }

  std::vector<FieldSum>
  fieldSums() override
  {
    static_assert(sizeof(FieldSum) == 2 * sizeof(cl_long));
    const cl::Buffer sums = zeros<FieldSum>(slots_);
    launch("fieldSums", field_, assigned_, count_, sums);
    return download<FieldSum>(sums, slots_);
  }

  void
  moveBySteps(const std::vector<std::uint8_t>& shifts) override
  {
    launch("moveBySteps",
           home_,
           faces_,
           count_,
           neighbors_,
           upload(context_, shifts),
           assigned_);
  }

  void
  moveToPlanes(const std::vector<CellPlane>& planes) override
  {
    static_assert(sizeof(CellPlane) == 6 * sizeof(cl_double));
    launch("moveToPlanes",
           home_,
           faces_,
           count_,
           neighbors_,
           upload(context_, planes),
           points_,
           assigned_);
  }

  void
  moveByField(const std::vector<double>& means) override
  {
    launch("moveByField",
           home_,
           faces_,
           count_,
           neighbors_,
           upload(context_, means),
           field_,
           assigned_);
  }

  Indices
  assigned() override
  {
    return download<Index>(assigned_, count_);
  }

private:
  cl::Buffer
  gridBuffer(const CellFrame& frame, const CellDirectory& directory) const
  {
    return upload(context_, std::vector<Grid>{gridOf(frame, directory)});
  }

  template <class T>
  cl::Buffer
  zeros(std::size_t size) const
  {
    const std::size_t bytes = std::max(size * sizeof(T), sizeof(cl_uint));
    cl::Buffer buffer = context_.buffer(bytes);
    context_.queue().enqueueFillBuffer(buffer, cl_uint{0}, 0, bytes);
    return buffer;
  }

  template <class T>
  std::vector<T>
  download(const cl::Buffer& buffer, std::size_t size) const
  {
    std::vector<T> values(size);
    if (size > 0)
      context_.queue().enqueueReadBuffer(
          buffer, CL_TRUE, 0, size * sizeof(T), values.data());
    return values;
  }

  /** \brief Runs a kernel over all points. */
  template <class... Arguments>
  void
  launch(const char* name, const Arguments&... arguments)
  {
    if (count_ == 0)
      return;
    cl::Kernel kernel = context_.exactKernel(name);
    setArguments(kernel, arguments...);
    run(context_, kernel, count_);
    // Buffers uploaded for this call only are released with it.
    context_.queue().finish();
  }

  Context& context_;
  cl_uint count_;
  std::size_t slots_ = 0;
  std::vector<CellSums> sums_;
  cl::Buffer points_, field_, home_, assigned_, faces_, neighbors_, origins_;
};

} // namespace

struct ClusterEngine::State {
  explicit State(const std::string& device) : context(device)
  {
    if (!context.device().double_precision)
      throw Error("the OpenCL device '" + context.device().name +
                      "' has no double precision, which clusters need; cluster without "
                      "a device",
                  0);
  }

  Context context;
};

ClusterEngine::ClusterEngine(const std::string& device)
    : state_(std::make_unique<State>(device))
{
}

ClusterEngine::~ClusterEngine() = default;
ClusterEngine::ClusterEngine(ClusterEngine&&) noexcept = default;
ClusterEngine&
ClusterEngine::operator=(ClusterEngine&&) noexcept = default;

const Device&
ClusterEngine::device() const
{
  return state_->context.device();
}

Clusters
ClusterEngine::cluster(const Points& points,
                       const ClusterSettings& settings,
                       const std::vector<double>& field,
                       ProgressMonitor* monitor)
{
  const MakePasses make = [&](const Points& all,
                              std::vector<std::int32_t> integers,
                              int /*threads*/) {
    return std::make_unique<DevicePasses>(state_->context, all, std::move(integers));
  };
  try {
    return clusterWith(make, points, settings, field, monitor);
  }
  catch (const cl::Error& error) {
    throw explained(error, device().name);
  }
}

} // namespace linelet::opencl
