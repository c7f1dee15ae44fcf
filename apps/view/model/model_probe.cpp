// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <stdexcept>
#include <utility>

#include "model.h"

namespace linelet::view {

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
  auto radii = std::make_shared<KnownRadii>();
  probe_.start(
      [=,
       scene = scene_,
       known = known_radii_,
       store = stale(Analysis::MultiScale) ? nullptr : results_.graphs,
       point = *selected_,
       s = settings.scales,
       of = settings.config(Analysis::MultiScale)](ProgressMonitor* monitor) {
        if (store != nullptr)
          *radii = {of, store->radii};
        else if (known != nullptr && known->of == of)
          *radii = *known;
        else
          *radii = {of, multiScaleRadii(scene->points, s, monitor).radii};
        *graphs = graphsAt(*scene, point, radii->radii, s, store.get(), monitor);
      },
      [=] {
        known_radii_ = radii;
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
        "select a point with an optimal scale to see its neighborhood");
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
