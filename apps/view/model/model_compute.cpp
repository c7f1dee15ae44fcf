// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include <linelet/features/tensor_estimation.h>
#include <linelet/features/tensor_record.h>
#include <linelet/powerline/extract_power_lines.h>

#include "measure_scales.h"
#include "model.h"
#include "part.h"

namespace linelet::view {

namespace {

Points
finiteOnes(const Points& points)
{
  Points finite;
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite), [](auto& p) {
    return p.allFinite();
  });
  return finite;
}

/** \brief As in the tool: 3 D if neither a radius nor a number is set. */
void
chooseRadius(TensorSettings& settings, double scale_unit)
{
  if (settings.radius > 0 || settings.k > 0)
    return;
  if (!(scale_unit > 0))
    throw std::invalid_argument("no radius can be chosen for fewer than two points, "
                                "or coincident ones; set the radius");
  settings.radius = 3 * scale_unit;
}

} // namespace

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

} // namespace linelet::view
