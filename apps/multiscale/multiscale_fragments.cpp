// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "fragments/fragment_parts.h"
#include "multiscale_job.h"
#include "noise_result.h"
#include "shape_columns.h"

namespace linelet::apps {

void
MultiscaleJob::check()
{
  if (looksAtOneCloud())
    throw std::runtime_error("--graphs, --centroid-shift, --fourth-order and "
                             "--stop-change need the whole cloud; omit them, or give "
                             "more --memory");
  if (settings_.radii.empty() && !(settings_.scale_unit > 0))
    throw std::runtime_error(
        "the scale unit of the whole cloud is unknown in fragments; "
        "give --radii or --scale-unit, or more --memory");
  settings_.radii = multiScaleRadii(Points(), settings_).radii;
  if (settings_.engine == ScaleEngine::Auto)
    settings_.engine = ScaleEngine::Grid; // what Auto chooses for large clouds
  checkPartsOutput(input_, output_);
}

Figures
MultiscaleJob::compute(const FragmentTask& task)
{
  std::vector<MultiScaleShape> shapes; // of the piece
  settings_.threads = frame_.threads;  // of this worker
  const CloudPiece piece = pieceOf(task.plan, task.fragment);
  const auto measured = [&](const MultiScaleSettings& settings) {
    shapes = pieceShapes(task.fragment.points, piece, settings, task.monitor).shapes;
  };
  double sum = 0, count = 0;
  const auto addNoise = [&] {
    for (std::size_t i = 0; i < shapes.size(); ++i)
      if (task.fragment.core[piece.begin + i] &&
          !std::isnan(shapes[i].min_sphericity)) {
        sum += static_cast<double>(shapes[i].min_sphericity);
        ++count;
      }
  };
  if (settings_.centroid != Centroid::QueryPoint && piece.end > piece.begin) {
    measured(aboutPoints(settings_));
    addNoise();
  }
  if (piece.end > piece.begin)
    measured(settings_);
  if (settings_.centroid == Centroid::QueryPoint)
    addNoise();
  fragments::writeRecords(
      task.result, task.fragment, shapes.data(), sizeof(shapes[0]), piece.begin);
  return {{"sphericity", sum}, {"spheres", count}};
}

Figures
MultiscaleJob::write(const OutputTask& task)
{
  double points = 0, unknown = 0, left_out = 0;
  const auto add = [&](io::Cloud& cloud,
                       const std::vector<MultiScaleShape>& shapes,
                       std::size_t without) {
    points += static_cast<double>(shapes.size());
    left_out += static_cast<double>(without);
    for (const MultiScaleShape& shape : shapes)
      unknown += shape.scale < 0 ? 1 : 0;
    addColumns(cloud, shapes);
  };
  // The record of a point that is not finite.
  const Points nowhere = {Point::Constant(std::nan(""))};
  MultiScaleSettings settings = settings_;
  settings.engine = ScaleEngine::Sweep;
  const auto none = multiScaleShapes(nowhere, nowhere, settings).shapes;
  writeParts<MultiScaleShape>(task, input_, output_, none.front(), add, frame_);
  return {{"points", points}, {"left_out", left_out}, {"unknown", unknown - left_out}};
}

void
MultiscaleJob::report(const Figures& figures)
{
  const double rate = 3.15 * figures.at("sphericity") / figures.at("spheres");
  std::printf("%s: %.0f points, %zu radii from %.6g to %.6g\nnoise rate %.4f\n",
              output_.path().c_str(),
              figures.at("points"),
              settings_.radii.size(),
              settings_.radii.front(),
              settings_.radii.back(),
              rate);
  printUnknown(static_cast<std::size_t>(figures.at("unknown")), settings_);
  frame_.summary["points"] = figures.at("points");
  frame_.summary["left_out"] = figures.at("left_out");
  frame_.summary["radii"] = settings_.radii;
  frame_.summary["engine"] = nameOf(settings_.engine);
  frame_.summary["noise_rate"] = rate;
  frame_.summary["unknown"] = figures.at("unknown");
}

} // namespace linelet::apps
