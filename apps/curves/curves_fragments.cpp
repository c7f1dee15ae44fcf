// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curves_job.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include <linelet/curves/curve_blocks.h>
#include <linelet/curves/refined_reconstruction.h>
#include <linelet/fragments/records.h>

#include "curves_part.h"
#include "traits_of_files.h"

namespace linelet::apps {

namespace {

CloudTraits
traitsIn(const Figures& measures)
{
  return {measures.at("scale_unit"),
          measures.at("linear_share"),
          measures.at("points"),
          {measures.at("low_x"), measures.at("low_y"), measures.at("low_z")},
          {measures.at("high_x"), measures.at("high_y"), measures.at("high_z")}};
}

} // namespace

Figures
CurvesJob::measures()
{
  const CloudTraits traits = traitsOfFiles(input_, frame_.threads, &frame_.monitor);
  warnOfOneBlock(traits);
  // Without D there are no curves.
  return {{"scale_unit", std::isfinite(traits.scale_unit) ? traits.scale_unit : 0},
          {"linear_share", traits.linear_share},
          {"points", traits.points},
          {"low_x", traits.low.x()},
          {"low_y", traits.low.y()},
          {"low_z", traits.low.z()},
          {"high_x", traits.high.x()},
          {"high_y", traits.high.y()},
          {"high_z", traits.high.z()}};
}

void
CurvesJob::warnOfOneBlock(const CloudTraits& traits)
{
  const double needed = traits.points * bytesPerPoint().in_one_piece;
  if (CurveBlocks(traits).count() > 1 || needed <= fragments_.memory.bytes())
    return;
  char text[300];
  std::snprintf(
      text,
      sizeof(text),
      "--memory cannot be honored: clouds of only curves, which cannot be divided, and "
      "clouds no larger than a block are processed in one piece; these %.0f "
      "points need about %.2g GB",
      traits.points,
      needed / 1e9);
  frame_.warn(text);
}

double
CurvesJob::ghost(const Figures& measures)
{
  return CurveBlocks(traitsIn(measures)).reach();
}

Figures
CurvesJob::compute(const FragmentTask& task)
{
  RefinedSettings settings = refinedSettings(settings_);
  settings.threads = frame_.threads; // of this worker
  settings.whole = traitsIn(task.plan.measures);
  const CurveBlocks blocks(settings.whole);
  std::vector<BlockPart> parts;
  for (std::size_t block = 0; block < blocks.count(); ++block) {
    const Point middle = blocks.middle(block) + task.plan.shift;
    if (task.plan.tiling.owner(middle.x(), middle.y()) == task.fragment.number)
      parts.push_back(
          {block, curvesOfBlock(task.fragment.points, block, settings, task.monitor)});
  }
  saveBlockParts(task.result, std::move(parts));
  return {};
}

Figures
CurvesJob::write(const OutputTask& task)
{
  const CloudTraits traits = traitsIn(task.plan.measures);
  std::vector<CurvePart> parts(CurveBlocks(traits).count());
  for (std::size_t f = 0; f < task.usable.size(); ++f)
    if (task.usable[f])
      for (BlockPart& part : loadBlockParts(fragments::resultPath(task.folder, f)))
        parts.at(part.block) = std::move(part.curves);
  std::string wkt;
  for (const io::FileSummary& file : input_.summaries())
    if (wkt.empty())
      wkt = file.wkt;
  finish(joinBlocks(std::move(parts), traits),
         traits.points,
         task.plan.shift,
         wkt,
         nullptr,
         task.monitor);
  return {};
}

} // namespace linelet::apps
