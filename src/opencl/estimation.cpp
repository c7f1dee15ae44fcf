// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "estimation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <linelet/support/threads.h>

#include "nearest.h"
#include "tensor_stages.h"

namespace linelet::opencl {

namespace {

bool
isSize(double radius)
{
  return radius > 0 && std::isfinite(radius);
}

Indices
finiteOnes(const Points& points)
{
  Indices finite;
  finite.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      finite.push_back(static_cast<Index>(i));
  return finite;
}

/** \brief One call of \ref estimateOn. */
class Estimation {
public:
  Estimation(Context& context,
             std::size_t memory_limit,
             const Points& surface,
             const Points& queries,
             const TensorSettings& settings,
             const NeighborhoodSizes& sizes,
             ProgressMonitor* monitor)
      : context_(context),
        surface_(surface),
        queries_(queries),
        settings_(settings),
        sizes_(sizes),
        monitor_(monitor),
        slabs_(context,
               surface,
               queries,
               memory_limit,
               threadCount(settings.threads),
               outcome_.times,
               monitor)
  {
    outcome_.records.resize(queries.size(), unknownTensor(0));
  }

  Outcome
  run()
  {
    if (monitor_ != nullptr)
      monitor_->begin("tensor", queries_.size());
    const Indices points = finiteOnes(surface_);
    std::vector<double> radii(queries_.size(), settings_.radius);
    std::vector<cl_uint> wanted;
    const bool nearest = settings_.k > 0 || !sizes_.counts.empty();
    if (nearest) {
      wanted = wantedCounts(points.size());
      radii = nearestRadii(
          context_, slabs_, surface_, queries_, points, wanted, outcome_.times);
    }
    else if (!sizes_.radii.empty())
      radii = sizes_.radii;
    std::string definitions = tensorDefinitions(
        settings_.centroid, settings_.weighting, settings_.centroid_weighting);
    if (settings_.normalization == Normalization::Count)
      definitions += " -DBY_COUNT";
    if (nearest)
      definitions += " -DENDING_AT_POINTS";
    estimateByRadius(points, radii, definitions);
    completeOnHost(wanted);
    outcome_.slabs = slabs_.count();
    return std::move(outcome_);
  }

private:
  std::vector<cl_uint>
  wantedCounts(std::size_t points) const
  {
    std::vector<cl_uint> wanted(queries_.size(), settings_.k);
    if (settings_.k == 0)
      wanted.assign(sizes_.counts.begin(), sizes_.counts.end());
    for (std::size_t i = 0; i < queries_.size(); ++i)
      wanted[i] = queries_[i].allFinite()
                      ? static_cast<cl_uint>(std::min<std::size_t>(wanted[i], points))
                      : 0;
    return wanted;
  }

  void
  estimateByRadius(const Indices& points,
                   const std::vector<double>& radii,
                   const std::string& definitions)
  {
    // Radii within a factor of two go together: cells are as wide as the largest.
    std::map<int, Indices> classes;
    for (std::size_t i = 0; i < queries_.size(); ++i)
      if (queries_[i].allFinite() && isSize(radii[i]))
        classes[std::ilogb(radii[i])].push_back(static_cast<Index>(i));
    for (auto& [exponent, chosen] : classes)
      slabs_.forEach(points,
                     std::move(chosen),
                     radii,
                     [&](const Slab& slab, const Indices& queries) {
                       estimateSlab(slab, queries, radii, definitions);
                     });
  }

  void
  estimateSlab(const Slab& slab,
               const Indices& queries,
               const std::vector<double>& radii,
               const std::string& definitions)
  {
    StageTimes& times = outcome_.times;
    Lap lap(context_.queue());
    std::vector<double> some;
    some.reserve(queries.size());
    for (const Index i : queries)
      some.push_back(radii[i]);
    lap.add(times.upload);
    const DeviceTensors tensors = computeTensors(context_, definitions, slab, some);
    lap.add(times.tensor);
    const cl::Buffer records = computeShapes(context_, tensors, slab);
    lap.add(times.analysis);
    download(records, queries);
    lap.add(times.download);
    if (monitor_ != nullptr)
      monitor_->advance(queries.size());
  }

  void
  download(const cl::Buffer& device_records, const Indices& queries)
  {
    std::vector<PointDistributionTensor>& all = outcome_.records;
    const auto read = [&](PointDistributionTensor* records) {
      context_.queue().enqueueReadBuffer(
          device_records, CL_TRUE, 0, queries.size() * sizeof *records, records);
    };
    if (queries.size() == all.size() &&
        std::is_sorted(queries.begin(), queries.end())) {
      read(all.data());
      return;
    }
    std::vector<PointDistributionTensor> records(queries.size());
    read(records.data());
    for (std::size_t i = 0; i < queries.size(); ++i)
      all[queries[i]] = records[i];
  }

  /** \brief Estimates on the host what the device left undecided: pairs at the radius
   * where it has no double, and nearest points equally far or hard to find.
   * \param[in] wanted numbers of nearest points, empty for neighborhoods by radius */
  void
  completeOnHost(const std::vector<cl_uint>& wanted)
  {
    std::vector<PointDistributionTensor>& records = outcome_.records;
    Indices open;
    for (std::size_t i = 0; i < records.size(); ++i)
      if (wanted.empty() ? records[i].neighbors == undecided
                         : records[i].neighbors != wanted[i])
        open.push_back(static_cast<Index>(i));
    outcome_.on_host = open.size();
    if (open.empty())
      return;
    Points queries;
    NeighborhoodSizes sizes;
    TensorSettings settings = settings_;
    settings.engine = Engine::Auto;
    for (const Index i : open) {
      queries.push_back(queries_[i]);
      if (!sizes_.radii.empty())
        sizes.radii.push_back(sizes_.radii[i]);
      if (!sizes_.counts.empty())
        sizes.counts.push_back(sizes_.counts[i]);
    }
    const auto completed =
        estimateTensors(surface_, queries, settings, sizes, monitor_);
    for (std::size_t i = 0; i < open.size(); ++i)
      records[open[i]] = completed[i];
  }

  Context& context_;
  const Points& surface_;
  const Points& queries_;
  const TensorSettings& settings_;
  const NeighborhoodSizes& sizes_;
  ProgressMonitor* monitor_;
  Outcome outcome_;
  Slabs slabs_;
};

} // namespace

Outcome
estimateOn(Context& context,
           std::size_t memory_limit,
           const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes,
           ProgressMonitor* monitor)
{
  return Estimation(context, memory_limit, surface, queries, settings, sizes, monitor)
      .run();
}

} // namespace linelet::opencl
