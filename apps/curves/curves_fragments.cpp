// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curves_job.h"

#include <cmath>
#include <utility>

#include <linelet/fragments/records.h>

#include "curves_part.h"
#include "traits_of_files.h"

namespace linelet::apps {

namespace {

// In D: how far fragments overlap beside the longest gap, and how far cut curves are
// noted beyond the border. The shape of a point takes 17, the evidence of a curve the
// rest: with 100, one tiling in seven told one curve more in a bundle at a border.
constexpr double overlap = 200, noted = 20;
// Of D: pieces of one curve lie closer at a border.
constexpr double same_curve = 0.5;

CloudTraits
traitsIn(const Figures& measures)
{
  return {measures.at("scale_unit"),
          measures.at("linear_share"),
          measures.at("points"),
          measures.at("extent")};
}

} // namespace

Figures
CurvesJob::measures()
{
  const CloudTraits traits = traitsOfFiles(input_, frame_.threads, &frame_.monitor);
  // Where there is no D, there are no curves.
  return {{"scale_unit", std::isfinite(traits.scale_unit) ? traits.scale_unit : 0},
          {"linear_share", traits.linear_share},
          {"points", traits.points},
          {"extent", traits.extent}};
}

double
CurvesJob::ghost(const Figures& measures)
{
  return buffer_ > 0
             ? buffer_
             : overlap * traitsIn(measures).scale_unit + settings_.distance_cutoff;
}

Figures
CurvesJob::compute(const FragmentTask& task)
{
  ReconstructionSettings settings = settings_;
  settings.threads = frame_.threads; // of this worker
  settings.whole = traitsIn(task.plan.measures);
  const PartOwner owner = [&](const Point& p) {
    return task.plan.tiling.owner(p.x() + task.plan.shift.x(),
                                  p.y() + task.plan.shift.y());
  };
  CurveNetwork network;
  if (settings.whole.scale_unit > 0)
    network = reconstructCurves(task.fragment.points, settings, task.monitor);
  saveCurvePart(
      task.result,
      ownedBy(network, task.fragment.number, owner, noted * settings.whole.scale_unit));
  return {};
}

Figures
CurvesJob::write(const OutputTask& task)
{
  std::vector<CurvePart> parts(task.usable.size());
  for (std::size_t f = 0; f < task.usable.size(); ++f)
    if (task.usable[f])
      parts[f] = loadCurvePart(fragments::resultPath(task.folder, f));
  const CloudTraits traits = traitsIn(task.plan.measures);
  std::string wkt;
  for (const io::FileSummary& file : input_.summaries())
    if (wkt.empty())
      wkt = file.wkt;
  finish(joinParts(std::move(parts), same_curve * traits.scale_unit),
         traits.points,
         task.plan.shift,
         wkt,
         nullptr,
         task.monitor);
  return {};
}

} // namespace linelet::apps
