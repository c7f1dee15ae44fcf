// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/runs/benchmark.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <limits>
#include <mutex>

#include <linelet/features/multi_scale.h>
#include <linelet/features/noise_rate.h>
#include <linelet/search/scale_unit.h>
#include <linelet/support/threads.h>

namespace linelet::bench {

namespace {

using Clock = std::chrono::steady_clock;

double
milliseconds(Clock::duration duration)
{
  return std::chrono::duration<double, std::milli>(duration).count();
}

/** \brief Notes when the features are computed. */
class StageTimer : public ProgressMonitor {
public:
  explicit StageTimer(const ProgressMonitor* cancel) : cancel_(cancel) {}

  void
  begin(std::string_view stage, std::size_t) override
  {
    if (stage == "curves")
      curves_begun_ = Clock::now();
  }

  bool
  canceled() const override
  {
    return cancel_ != nullptr && cancel_->canceled();
  }

  const Clock::time_point begun = Clock::now();

  Clock::time_point
  featuresDone() const
  {
    return curves_begun_ == Clock::time_point() ? begun : curves_begun_;
  }

private:
  const ProgressMonitor* cancel_;
  Clock::time_point curves_begun_;
};

RandomCloud
cloudOf(const BenchmarkRun& run)
{
  if (run.random)
    return randomCloud(*run.random, run.sampling);
  return {sample(run.geometry, run.sampling),
          truthOf(run.geometry, run.sampling.out_of_plane),
          1};
}

/** \brief The measures of \a found in a unit of which the extent of the \a truth has
 * ten, as for the geometries. */
Measures
measureIn(double unit, const CurveNetwork& found, const CurveNetwork& truth)
{
  MeasureSettings settings;
  settings.step *= unit;
  settings.reach *= unit;
  settings.max_mean_distance *= unit;
  Measures result = measure(found, truth, settings);
  result.e_h /= unit;
  result.e_v /= unit;
  return result;
}

} // namespace

BenchmarkRow
perform(const std::string& method,
        const BenchmarkRun& run,
        const Reconstruct& reconstruct,
        const ProgressMonitor* cancel)
{
  BenchmarkRow row;
  row.method = method;
  row.run = run;
  const RandomCloud cloud = cloudOf(run);
  const Points& points = cloud.points;
  StageTimer timer(cancel);
  const CurveNetwork found = reconstruct(points, &timer);
  const Clock::time_point done = Clock::now();
  row.feature_ms = milliseconds(timer.featuresDone() - timer.begun);
  row.reconstruction_ms = milliseconds(done - timer.featuresDone());
  row.measures = measureIn(cloud.unit, found, cloud.truth);
  MultiScaleSettings shape; // with the centroid for which the noise rate is defined
  shape.engine = ScaleEngine::Grid; // accurate enough for a rate, and single-threaded
  shape.threads = 1;
  shape.scale_unit =
      scaleUnit(points, shape.scale_unit_sample, shape.scale_unit_seed, shape.threads);
  row.noise_rate = shape.scale_unit > 0
                       ? noiseRate(multiScaleShapes(points, points, shape).shapes)
                       : std::numeric_limits<double>::quiet_NaN();
  return row;
}

void
runBenchmark(const std::string& method,
             const std::vector<BenchmarkRun>& runs,
             const Reconstruct& reconstruct,
             const std::function<void(const BenchmarkRow&)>& sink,
             unsigned threads,
             ProgressMonitor* monitor)
{
  if (monitor != nullptr)
    monitor->begin("benchmark", runs.size());
  std::mutex mutex;
  std::exception_ptr failure;
  std::atomic<bool> stop{false};
  const auto count = static_cast<std::ptrdiff_t>(runs.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(threadCount(threads))
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    if (stop)
      continue;
    try {
      if (monitor != nullptr && monitor->canceled())
        throw Canceled();
      const BenchmarkRow row =
          perform(method, runs[static_cast<std::size_t>(i)], reconstruct, monitor);
      const std::lock_guard<std::mutex> lock(mutex);
      sink(row);
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!stop)
        failure = std::current_exception();
      stop = true;
    }
    if (monitor != nullptr)
      monitor->advance(1);
  }
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace linelet::bench
