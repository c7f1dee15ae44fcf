// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

#include <linelet/features/tensor_estimation.h>
#include <linelet/features/tensor_record.h>
#include <linelet/io/file_error.h>
#include <linelet/powerline/extract_power_lines.h>

namespace linelet::view {

namespace {

/** \brief The points that an analysis works on, and where its results belong. */
struct Part {
  Indices indices; ///< in the cloud; empty: all of it
  bool all = true;

  explicit Part(const Scene& scene, const std::optional<Box>& box)
  {
    if (!box)
      return;
    all = false;
    for (std::size_t i = 0; i < scene.points.size(); ++i)
      if (box->contains(scene.cloud.points[i]))
        indices.push_back(static_cast<Index>(i));
    if (indices.empty())
      throw std::invalid_argument(
          "no point lies in the preview box; move it to the cloud, or clear it");
  }

  template <class T>
  std::vector<T>
  of(const std::vector<T>& whole) const
  {
    if (all)
      return whole;
    std::vector<T> part;
    part.reserve(indices.size());
    for (const Index i : indices)
      part.push_back(whole[i]);
    return part;
  }

  template <class T>
  std::vector<T>
  spread(std::vector<T> part, std::size_t count, const T& elsewhere) const
  {
    if (all)
      return part;
    std::vector<T> whole(count, elsewhere);
    for (std::size_t k = 0; k < indices.size() && k < part.size(); ++k)
      whole[indices[k]] = std::move(part[k]);
    return whole;
  }
};

io::Cloud
cloudOf(const Scene& scene, const Part& part)
{
  io::Cloud cloud;
  cloud.shift = scene.cloud.shift;
  cloud.wkt = scene.cloud.wkt;
  cloud.points = part.of(scene.cloud.points);
  for (const char* name : {"classification", "withheld"})
    if (const io::Column* column = scene.cloud.find(name))
      std::visit(
          [&](const auto& values) {
            cloud.set({name, part.of(values), ""});
          },
          column->values);
  return cloud;
}

/** \brief The points of \a part that \a classes let take part; NaN for the others. */
Points
usablePoints(const Scene& scene, const Part& part, const io::ClassFilter& classes)
{
  const io::Cloud cloud = cloudOf(scene, part);
  return io::UsablePoints(cloud, nullptr, classes).points();
}

Points
finiteOnes(const Points& points)
{
  Points finite;
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite), [](auto& p) {
    return p.allFinite();
  });
  return finite;
}

/// Bytes of graphs that are kept.
constexpr std::size_t most_graphs = std::size_t{1} << 30;

/** \brief The shapes of \a points, in the steps of `multiscale --graphs`; their graphs
 * go to \a store, unless it is null or they would take too much room. */
MultiScaleShapes
measureScales(const Points& points,
              MultiScaleSettings settings,
              GraphStore* store,
              ProgressMonitor* monitor)
{
  const MultiScaleShapes plan = multiScaleRadii(points, settings, monitor);
  settings.radii = plan.radii;
  settings.stop_change = 0; // it has had its say
  settings.engine = chosenScaleEngine(points, points, plan.radii.back(), settings);
  const std::size_t scales = plan.radii.size();
  ShapeGraphSink sink;
  if (store != nullptr && points.size() * scales * sizeof(ScaleShape) <= most_graphs) {
    store->radii = plan.radii;
    store->shapes.resize(points.size() * scales);
    sink = [=](std::size_t point, const ShapeGraph& graph) {
      std::copy(graph.begin(),
                graph.end(),
                store->shapes.begin() + static_cast<std::ptrdiff_t>(point * scales));
    };
  }
  MultiScaleShapes result = multiScaleShapes(points, points, settings, sink, monitor);
  result.scale_unit = plan.scale_unit;
  return result;
}

/** \brief As the tool: 3 D where neither a radius nor a number is set. */
void
chooseRadius(TensorSettings& settings, double scale_unit)
{
  if (settings.radius > 0 || settings.k > 0)
    return;
  if (!(scale_unit > 0))
    throw std::invalid_argument("no radius can be chosen for points that are fewer "
                                "than two or share one place; set the radius");
  settings.radius = 3 * scale_unit;
}

} // namespace

void
Model::open(const std::vector<std::string>& paths, const std::string& truth)
{
  auto result = std::make_shared<std::shared_ptr<const Scene>>();
  analysis_.start(
      [=, options = settings.read, classes = settings.classes](
          ProgressMonitor* monitor) {
        *result = openScene(paths, truth, options, classes, monitor);
      },
      [this, result] { adopt(*result); });
}

void
Model::adopt(std::shared_ptr<const Scene> scene)
{
  probe_.cancel();
  imager_.cancel();
  select(std::nullopt);
  scene_ = std::move(scene);
  results_ = {};
  computed_with_ = {};
  preview_.reset();
  graphs_.reset();
  image_.reset();
  ladder_.reset();
  curve = scene_->curves.curves.empty() ? -1 : 0;
  wire_ = 0;
  reviews_.clear();
  changes_.scene = true;
  if (scene_->lines != nullptr)
    adoptLines(scene_->lines);
}

void
Model::setPreview(const std::optional<Box>& box)
{
  preview_ = box;
}

void
Model::compute(Analysis analysis)
{
  if (scene_->points.empty())
    throw std::invalid_argument("there are no points to work on; open a point cloud");
  const auto place = static_cast<std::size_t>(analysis);
  const std::string with = fingerprint(analysis);
  const auto remember = [this, place, with] {
    computed_with_[place] = with;
    changes_.results = true;
  };
  const auto scene = scene_;
  const Part part(*scene, preview_);
  const AnalysisSettings s = settings;
  const std::size_t count = scene->points.size();
  switch (analysis) {
  case Analysis::Tensor: {
    auto out = std::make_shared<std::vector<PointDistributionTensor>>();
    analysis_.start(
        [=](ProgressMonitor* monitor) {
          TensorSettings tensor = s.tensor;
          chooseRadius(tensor, scene->scale_unit);
          const Points points = usablePoints(*scene, part, s.classes);
          *out = part.spread(estimateTensors(points, points, tensor, {}, monitor),
                             count,
                             unknownTensor(0));
        },
        [=] {
          results_.tensors = out;
          remember();
        });
    break;
  }
  case Analysis::MultiScale: {
    auto out = std::make_shared<MultiScaleShapes>();
    auto store = std::make_shared<GraphStore>();
    analysis_.start(
        [=](ProgressMonitor* monitor) {
          const Points points = usablePoints(*scene, part, s.classes);
          *out = measureScales(
              points, s.scales, part.all ? store.get() : nullptr, monitor);
          out->shapes = part.spread(std::move(out->shapes), count, MultiScaleShape());
        },
        [=] {
          results_.shapes = out;
          results_.graphs = store->shapes.empty() ? nullptr : store;
          remember();
          if (selected_)
            beginGraphs();
        });
    break;
  }
  case Analysis::Curves: {
    auto out = std::make_shared<CurveNetwork>();
    analysis_.start(
        [=](ProgressMonitor* monitor) {
          *out = reconstructCurves(
              finiteOnes(usablePoints(*scene, part, s.classes)), s.curves, monitor);
        },
        [=] {
          results_.curves = out;
          curve = out->curves.empty() ? -1 : 0;
          remember();
        });
    break;
  }
  case Analysis::PowerLines: {
    auto out = std::make_shared<powerline::PowerLineNetwork>();
    analysis_.start(
        [=](ProgressMonitor* monitor) {
          powerline::PowerLineSettings wires = s.wires;
          wires.points = s.classes;
          *out = powerline::extractPowerLines(cloudOf(*scene, part), wires, monitor);
          out->classes = part.spread(std::move(out->classes), count, std::uint8_t{0});
          out->wire_id = part.spread(std::move(out->wire_id), count, 0);
          out->span_id = part.spread(std::move(out->span_id), count, 0);
          out->is_unexplained =
              part.spread(std::move(out->is_unexplained), count, std::uint8_t{0});
          out->wire_distance = part.spread(std::move(out->wire_distance),
                                           count,
                                           std::numeric_limits<float>::quiet_NaN());
        },
        [=] {
          const auto before = reviewedWires();
          results_.lines = out;
          adoptLines(out);
          const std::vector<int> matches = powerline::matchReviewed(*out, before);
          for (std::size_t i = 0; i < matches.size(); ++i)
            if (matches[i] >= 0)
              reviews_[i] = before[static_cast<std::size_t>(matches[i])].review;
          remember();
        });
    break;
  }
  }
}

void
Model::cancel()
{
  analysis_.cancel();
  probe_.cancel();
  imager_.cancel();
}

bool
Model::busy() const
{
  return analysis_.busy() || probe_.busy() || imager_.busy();
}

Progress
Model::progress() const
{
  return analysis_.busy() ? analysis_.progress() : Progress();
}

Model::Changes
Model::poll()
{
  std::string error;
  for (Worker* worker : {&analysis_, &probe_, &imager_})
    if (worker->poll(error) && !error.empty())
      changes_.error = error;
  return std::exchange(changes_, {});
}

Model::Changes
Model::wait()
{
  Changes all;
  while (true) {
    const bool was_busy = busy();
    const Changes some = poll();
    all.scene = all.scene || some.scene;
    all.results = all.results || some.results;
    all.probe = all.probe || some.probe;
    all.image = all.image || some.image;
    if (!some.error.empty())
      all.error = some.error;
    if (!was_busy)
      return all;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

AnalysisSettings
Model::withPreview() const
{
  AnalysisSettings with = settings;
  if (preview_) {
    const Point low = preview_->low + scene_->cloud.shift,
                high = preview_->high + scene_->cloud.shift;
    with.read.bounds_3d = {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  }
  return with;
}

std::string
Model::config(Analysis analysis) const
{
  return withPreview().config(analysis);
}

std::string
Model::fingerprint(Analysis analysis) const
{
  return config(analysis);
}

bool
Model::stale(Analysis analysis) const
{
  const std::string& with = computed_with_[static_cast<std::size_t>(analysis)];
  return !with.empty() && with != fingerprint(analysis);
}

std::string
Model::commandLine(Analysis analysis) const
{
  static constexpr const char* outputs[] = {
      "tensor.las", "multiscale.las", "curves.gpkg", "powerlines"};
  std::vector<std::string> inputs = scene_->inputs;
  if (inputs.empty())
    inputs.emplace_back("INPUT");
  return withPreview().commandLine(
      analysis, inputs, outputs[static_cast<std::size_t>(analysis)]);
}

void
Model::select(std::optional<Index> point)
{
  selected_ = point;
  graphs_.reset();
  changes_.probe = true;
  if (point)
    beginGraphs();
  else
    probe_.cancel();
}

void
Model::beginGraphs()
{
  auto graphs = std::make_shared<PointGraphs>();
  auto ladder = std::make_shared<Ladder>();
  probe_.start(
      [=,
       scene = scene_,
       known = ladder_,
       store = stale(Analysis::MultiScale) ? nullptr : results_.graphs,
       point = *selected_,
       s = settings.scales,
       of = settings.config(Analysis::MultiScale)](ProgressMonitor* monitor) {
        if (store != nullptr)
          *ladder = {of, store->radii};
        else if (known != nullptr && known->of == of)
          *ladder = *known;
        else
          *ladder = {of, multiScaleRadii(scene->points, s, monitor).radii};
        *graphs = graphsAt(*scene, point, ladder->radii, s, store.get(), monitor);
      },
      [=] {
        ladder_ = ladder;
        graphs_ = graphs;
        changes_.probe = true;
      });
}

double
Model::tensorRadius() const
{
  if (settings.tensor.radius > 0)
    return settings.tensor.radius;
  return graphs_ == nullptr ? 0 : graphs_->ownRadius();
}

std::optional<PointDistributionTensor>
Model::tensorAtSelection() const
{
  if (!selected_ || !(tensorRadius() > 0))
    return std::nullopt;
  return tensorAt(*scene_, *selected_, tensorRadius(), settings.tensor);
}

void
Model::imageAlong(Points line, std::size_t columns)
{
  auto image = std::make_shared<ScaleImage>();
  imager_.start(
      [=, scene = scene_, s = settings.scales](ProgressMonitor* monitor) {
        const auto radii = multiScaleRadii(scene->points, s, monitor).radii;
        *image = scaleImageAlong(*scene, line, columns, radii, s, monitor);
      },
      [=] {
        image_ = image;
        changes_.image = true;
      });
}

void
Model::imageAround(std::size_t columns)
{
  if (!selected_ || graphs_ == nullptr || graphs_->scale == LinearityGraph::none)
    throw std::invalid_argument(
        "select a point that has a scale of its own, to see its neighborhood");
  const ScaleShape& own = graphs_->graph[graphs_->scale];
  const Point axis(static_cast<double>(own.major_x),
                   static_cast<double>(own.major_y),
                   static_cast<double>(own.major_z));
  auto image = std::make_shared<ScaleImage>();
  imager_.start(
      [=, scene = scene_, point = *selected_, graphs = graphs_, s = settings.scales](
          ProgressMonitor* monitor) {
        *image = scaleImageAround(*scene,
                                  point,
                                  graphs->ownRadius(),
                                  axis,
                                  columns,
                                  graphs->radii,
                                  s,
                                  monitor);
      },
      [=] {
        image_ = image;
        changes_.image = true;
      });
}

} // namespace linelet::view
