// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <features/multi_scale/stop_rule.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include <features/multi_scale/multi_scale_grid.h>
#include <features/multi_scale/sweep_queries.h>
#include <features/simd_grid/multi_scale/multi_scale_engine.h>
#include <linelet/features/scale_engine.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

namespace {

/// Scales measured at a time; those behind the stop are wasted.
constexpr std::size_t window = 3;

/// The grid engine's factors are too inexact for smaller changes.
constexpr double least_change_on_grid = 1e-3;

/** \brief Changes of the shapes of points from one scale to the next. */
struct Change {
  double largest = 0;   ///< of a factor; 1 for a point that had no shape before
  bool defined = false; ///< any point has a shape

  void
  add(const ShapeFactors& last, const ShapeFactors& next)
  {
    defined = defined || !std::isnan(next.linearity);
    if (std::isnan(last.linearity) && !std::isnan(next.linearity))
      largest = std::max(largest, 1.0);
    // fmax passes over factors that are not defined.
    for (const double difference : {next.linearity - last.linearity,
                                    next.planarity - last.planarity,
                                    next.sphericity - last.sphericity})
      largest = std::fmax(largest, std::abs(difference));
  }
};

/** \brief Changes at the scales of a window, over all points. */
class Changes {
public:
  explicit Changes(std::size_t scales) : changes_(scales) {}

  /** \brief Those that one thread sees; merged when it ends. */
  class Collector {
  public:
    explicit Collector(Changes& all) : seen(all.changes_.size()), all_(all) {}
    Collector(const Collector&) = delete;
    Collector&
    operator=(const Collector&) = delete;

    ~Collector()
    {
      const std::lock_guard<std::mutex> lock(all_.mutex_);
      for (std::size_t k = 0; k < seen.size(); ++k) {
        Change& change = all_.changes_[k];
        change.largest = std::max(change.largest, seen[k].largest);
        change.defined = change.defined || seen[k].defined;
      }
    }

    std::vector<Change> seen;

  private:
    Changes& all_;
  };

  std::shared_ptr<Collector>
  collector()
  {
    return std::make_shared<Collector>(*this);
  }

  const Change&
  operator[](std::size_t scale) const
  {
    return changes_[scale];
  }

private:
  std::vector<Change> changes_;
  std::mutex mutex_;
};

/** \brief The changes at \a radii on the grid engine; false where it cannot run. */
bool
changesOnGrid(const Points& surface,
              const std::vector<double>& radii,
              const MultiScaleSettings& settings,
              ProgressMonitor* monitor,
              std::vector<ShapeFactors>& last,
              Changes& changes)
{
  if (settings.stop_change < least_change_on_grid ||
      chosenScaleEngine(surface, surface, radii.back(), settings) != ScaleEngine::Grid)
    return false;
  const grid::MultiScaleEngine engine(
      surface, surface, radii.back(), usefulThreads(settings.threads, surface.size()));
  if (!engine.usable())
    return false;
  engine.run(
      surface,
      nullptr,
      radii,
      settings,
      [&] {
        return [&last, collector = changes.collector()](const grid::LeafShapes& leaf) {
          for (std::size_t lane = 0; lane < leaf.count; ++lane)
            for (std::size_t k = 0; k < collector->seen.size(); ++k) {
              const ShapeFactors next{static_cast<double>(leaf.linearity[k][lane]),
                                      static_cast<double>(leaf.planarity[k][lane]),
                                      static_cast<double>(leaf.sphericity[k][lane])};
              ShapeFactors& before = last[leaf.query[lane]];
              collector->seen[k].add(before, next);
              before = next;
            }
        };
      },
      monitor);
  return true;
}

void
changesInDouble(const NeighborSearch* search,
                const Points& surface,
                const std::vector<double>& radii,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor,
                std::vector<ShapeFactors>& last,
                Changes& changes)
{
  sweepQueries(SweepNeighbors(surface, radii.back(), search),
               surface,
               0,
               surface.size(),
               radii,
               settings,
               monitor,
               [&] {
                 return [&last, collector = changes.collector()](
                            std::size_t query, const ScaleSweep& sweep) {
                   for (std::size_t k = 0; k < collector->seen.size(); ++k) {
                     collector->seen[k].add(last[query], sweep.factors()[k]);
                     last[query] = sweep.factors()[k];
                   }
                 };
               });
}

} // namespace

void
applyStopRule(const NeighborSearch* search,
              const Points& surface,
              const MultiScaleSettings& settings,
              std::vector<double>& radii,
              ProgressMonitor* monitor)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<ShapeFactors> last(surface.size(), {nan, nan, nan});
  for (std::size_t begin = 0; begin < radii.size(); begin += window) {
    const auto at = [&](std::size_t k) {
      return radii.begin() + static_cast<std::ptrdiff_t>(std::min(k, radii.size()));
    };
    const std::vector<double> some(at(begin), at(begin + window));
    if (monitor != nullptr)
      monitor->begin("largest radius", surface.size());
    Changes changes(some.size());
    if (search != nullptr ||
        !changesOnGrid(surface, some, settings, monitor, last, changes))
      changesInDouble(search, surface, some, settings, monitor, last, changes);
    for (std::size_t k = 0; k < some.size(); ++k)
      if (changes[k].defined && changes[k].largest < settings.stop_change) {
        radii.resize(begin + k + 1);
        return;
      }
  }
}

} // namespace linelet
