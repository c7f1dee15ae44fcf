// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <features/multi_scale/multi_scale_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <features/multi_scale/shape_summary.h>
#include <features/simd_grid/multi_scale/multi_scale_engine.h>
#include <linelet/support/threads.h>

namespace linelet {

namespace {

using grid::leaf_queries;
using grid::LeafShapes;

/// Bytes of graphs that are held at once.
constexpr std::size_t graph_memory = std::size_t{64} << 20;

/** \brief Major directions of tensors, one per lane. */
class Directions {
public:
  std::array<grid::Lanes<double>, 6> tensor;

  void
  compute()
  {
    grid::EigenBatch batch{};
    batch.count = leaf_queries;
    for (std::size_t entry = 0; entry < 6; ++entry)
      batch.tensor[entry] = tensor[entry].lane;
    for (std::size_t i = 0; i < 3; ++i) {
      batch.values[i] = unused_[i].lane;
      batch.major[i] = major_[i].lane;
      batch.normal[i] = unused_[3 + i].lane;
    }
    kernels_.eigen(batch);
  }

  template <class Record>
  void
  put(std::size_t lane, Record& record) const
  {
    record.major_x = static_cast<float>(major_[0][lane]);
    record.major_y = static_cast<float>(major_[1][lane]);
    record.major_z = static_cast<float>(major_[2][lane]);
  }

private:
  grid::SweepKernels kernels_ = grid::sweepKernels();
  std::array<grid::Lanes<double>, 3> major_;
  std::array<grid::Lanes<double>, 6> unused_;
};

/** \brief Makes the records of a leaf. */
class Recorder {
public:
  Recorder(const std::vector<double>& radii,
           const LinearityGraphSettings& settings,
           std::vector<MultiScaleShape>& shapes)
      : summary_(radii, settings), shapes_(shapes)
  {
  }

  void
  operator()(const LeafShapes& leaf)
  {
    std::array<MultiScaleShape, leaf_queries> records;
    for (std::size_t lane = 0; lane < leaf.count; ++lane) {
      MultiScaleShape& record = records[lane];
      record = summary_({&leaf.linearity[0][lane],
                         &leaf.planarity[0][lane],
                         &leaf.sphericity[0][lane],
                         &leaf.neighbors[0][lane],
                         leaf_queries},
                        leaf.here[lane]);
      if (record.scale >= 0)
        for (std::size_t entry = 0; entry < 6; ++entry)
          directions_.tensor[entry][lane] =
              leaf.tensors[static_cast<std::size_t>(record.scale)][entry][lane];
    }
    directions_.compute();
    for (std::size_t lane = 0; lane < leaf.count; ++lane) {
      if (records[lane].scale >= 0)
        directions_.put(lane, records[lane]);
      shapes_[leaf.query[lane]] = records[lane];
    }
  }

private:
  ShapeSummary summary_;
  Directions directions_;
  std::vector<MultiScaleShape>& shapes_;
};

/** \brief Writes the graphs of a leaf into those of all queries from \a first on. */
class GraphWriter {
public:
  GraphWriter(std::size_t first, std::vector<ShapeGraph>& graphs)
      : first_(first), graphs_(graphs)
  {
  }

  void
  operator()(const LeafShapes& leaf)
  {
    for (std::size_t k = 0; k < leaf.linearity.size(); ++k) {
      directions_.tensor = leaf.tensors[k];
      directions_.compute();
      for (std::size_t lane = 0; lane < leaf.count; ++lane) {
        ScaleShape& shape = graphs_[leaf.query[lane] - first_][k];
        shape.neighbors = leaf.neighbors[k][lane];
        if (std::isnan(leaf.linearity[k][lane]))
          continue;
        shape.linearity = leaf.linearity[k][lane];
        shape.planarity = leaf.planarity[k][lane];
        shape.sphericity = leaf.sphericity[k][lane];
        directions_.put(lane, shape);
      }
    }
  }

private:
  std::size_t first_;
  std::vector<ShapeGraph>& graphs_;
  Directions directions_;
};

} // namespace

int
usefulThreads(unsigned requested, std::size_t queries)
{
  constexpr std::size_t queries_a_thread = 1024;
  const std::size_t useful = queries / queries_a_thread + 1;
  return static_cast<int>(
      std::min(useful, static_cast<std::size_t>(threadCount(requested))));
}

bool
multiScaleShapesOnGrid(const Points& surface,
                       const Points& queries,
                       const CloudPiece* piece,
                       const MultiScaleSettings& settings,
                       const ShapeGraphSink& sink,
                       ProgressMonitor* monitor,
                       MultiScaleShapes& result)
{
  const std::vector<double>& radii = result.radii;
  const grid::MultiScaleEngine engine(surface,
                                      queries,
                                      radii.back(),
                                      usefulThreads(settings.threads, queries.size()),
                                      piece);
  if (!engine.usable())
    return false;
  result.shapes.assign(queries.size(), MultiScaleShape());
  if (monitor != nullptr)
    monitor->begin("multi-scale", queries.size());
  const auto recorder = [&] { return Recorder(radii, settings.graph, result.shapes); };
  if (!sink) {
    engine.run(
        queries,
        nullptr,
        radii,
        settings,
        [&] { return grid::LeafVisitor(recorder()); },
        monitor);
    return true;
  }

  const std::size_t most = std::max<std::size_t>(
      4096, graph_memory / (radii.size() * sizeof(ScaleShape) + sizeof(ShapeGraph)));
  std::vector<ShapeGraph> graphs;
  Indices chosen;
  for (std::size_t begin = 0; begin < queries.size(); begin += most) {
    const std::size_t end = std::min(begin + most, queries.size());
    graphs.assign(end - begin, ShapeGraph(radii.size()));
    chosen.clear();
    for (std::size_t i = begin; i < end; ++i)
      chosen.push_back(static_cast<Index>(i));
    engine.run(
        queries,
        end - begin < queries.size() ? &chosen : nullptr,
        radii,
        settings,
        [&] {
          return [record = recorder(),
                  write = GraphWriter(begin, graphs)](const LeafShapes& leaf) mutable {
            record(leaf);
            write(leaf);
          };
        },
        monitor);
    for (std::size_t i = begin; i < end; ++i)
      sink(i, graphs[i - begin]);
  }
  return true;
}

bool
fourthOrderTensorsOnGrid(const Points& surface,
                         const Points& queries,
                         const std::vector<double>& radii,
                         const MultiScaleSettings& settings,
                         ScaleWeight weight,
                         ProgressMonitor* monitor,
                         std::vector<FourthOrderTensor>& tensors)
{
  const grid::MultiScaleEngine engine(
      surface, queries, radii.back(), usefulThreads(settings.threads, queries.size()));
  if (!engine.usable())
    return false;
  // Queries without neighbors have no scale.
  tensors.assign(queries.size(), fourthOrderTensor({}, weight));
  if (monitor != nullptr)
    monitor->begin("fourth order", queries.size());
  const double unit = engine.unit() * engine.unit();
  engine.run(
      queries,
      nullptr,
      radii,
      settings,
      [&] {
        return [&, scales = std::vector<SymmetricTensor>()](
                   const LeafShapes& leaf) mutable {
          for (std::size_t lane = 0; lane < leaf.count; ++lane) {
            scales.clear();
            for (std::size_t k = 0; k < radii.size(); ++k) {
              if (std::isnan(leaf.linearity[k][lane]))
                continue;
              const auto& t = leaf.tensors[k];
              scales.push_back({t[0][lane],
                                t[1][lane],
                                t[2][lane],
                                t[3][lane],
                                t[4][lane],
                                t[5][lane]});
              scales.back() *= unit;
            }
            tensors[leaf.query[lane]] = fourthOrderTensor(scales, weight);
          }
        };
      },
      monitor);
  return true;
}

} // namespace linelet
