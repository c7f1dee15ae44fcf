// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/multi_scale.h>

#include "graph_file.h"
#include "multiscale_job.h"
#include "noise_result.h"
#include "scale_cost.h"
#include "shape_columns.h"
#include "shifted_points.h"

namespace linelet::apps {

void
MultiscaleJob::runOne()
{
  io::Cloud cloud = input_.read();
  const io::UsablePoints usable = input_.usable(cloud);
  const Points points = shiftedPoints(cloud, usable, shift_, frame_);
  const MultiScaleShapes plan = multiScaleRadii(points, settings_, &frame_.monitor);
  settings_.radii = plan.radii;
  settings_.stop_change = 0; // already applied to the radii
  settings_.engine =
      chosenScaleEngine(points, points, settings_.radii.back(), settings_);
  announceMultiScale(points, points, settings_, frame_);
  const auto shapes = measure(points, settings_, graphs_, &frame_.monitor);
  const auto about_points =
      settings_.centroid == Centroid::QueryPoint
          ? shapes
          : measure(points, aboutPoints(settings_), {}, &frame_.monitor);
  frame_.lap("multiscale");
  addColumns(cloud, shapes);
  if (fourth_order_ != FourthOrderOption::None)
    addFourthOrder(cloud, points, settings_, fourth_order_, &frame_.monitor);
  const std::string path = output_.pathFor(input_, 0);
  output_.write(cloud, path);

  const NoiseResult result = resultOf(shapes, about_points, usable.leftOut());
  print(result, plan, settings_, path);
  frame_.summary["points"] = result.points;
  frame_.summary["withheld"] = usable.withheld();
  frame_.summary["ignored"] = usable.ignored();
  frame_.summary["scale_unit"] = plan.scale_unit;
  frame_.summary["radii"] = plan.radii;
  frame_.summary["engine"] = nameOf(settings_.engine);
  frame_.summary["noise_rate"] = result.noise_rate;
  frame_.summary["noise_width"] = result.noise_width;
  frame_.summary["unknown"] = result.unknown;
}

void
MultiscaleJob::runSeveral()
{
  MultiScaleShapes plan;
  std::size_t points = 0, withheld = 0, ignored = 0, unknown = 0;
  auto files = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < input_.files().size(); ++i) {
    io::Cloud cloud = input_.read(i);
    const io::UsablePoints usable = input_.usable(cloud);
    if (i == 0) {
      plan = multiScaleRadii(usable.points(), settings_, &frame_.monitor);
      settings_.radii = plan.radii;
    }
    const CloudInput::Surroundings all =
        input_.surroundings(i, cloud, usable, multiScaleMargin(settings_.radii));
    if (settings_.engine == ScaleEngine::Auto)
      settings_.engine =
          chosenScaleEngine(all.points, all.points, settings_.radii.back(), settings_);
    announceMultiScale(all.points, all.points, settings_, frame_);
    const auto measured = [&](const MultiScaleSettings& s) {
      return pieceShapes(all.points, all.piece, s, &frame_.monitor).shapes;
    };
    const auto shapes = measured(settings_);
    const auto about_points = settings_.centroid == Centroid::QueryPoint
                                  ? shapes
                                  : measured(aboutPoints(settings_));
    frame_.lap("multiscale");
    addColumns(cloud, shapes);
    const std::string path = output_.pathFor(input_, i);
    output_.write(cloud, path);

    const NoiseResult result = resultOf(shapes, about_points, usable.leftOut());
    print(result, plan, settings_, path);
    files.push_back({{"file", path},
                     {"points", result.points},
                     {"noise_rate", result.noise_rate},
                     {"noise_width", result.noise_width},
                     {"unknown", result.unknown}});
    points += result.points;
    unknown += result.unknown;
    withheld += usable.withheld();
    ignored += usable.ignored();
  }
  frame_.summary["points"] = points;
  frame_.summary["withheld"] = withheld;
  frame_.summary["ignored"] = ignored;
  frame_.summary["scale_unit"] = plan.scale_unit;
  frame_.summary["radii"] = plan.radii;
  frame_.summary["engine"] = nameOf(settings_.engine);
  frame_.summary["unknown"] = unknown;
  frame_.summary["files"] = files;
}

} // namespace linelet::apps
