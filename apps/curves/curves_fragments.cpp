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
// rest.
constexpr double overlap = 100, noted = 20;
// Of D: pieces of one curve lie closer at a border.
constexpr double same_curve = 0.5;

CloudTraits
traitsIn(const std::map<std::string, double>& measures)
{
  return {measures.at("scale_unit"),
          measures.at("linear_share"),
          measures.at("points"),
          measures.at("extent")};
}

} // namespace

std::map<std::string, double>
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
CurvesJob::ghost(const std::map<std::string, double>& measures)
{
  return buffer_ > 0
             ? buffer_
             : overlap * traitsIn(measures).scale_unit + settings_.distance_cutoff;
}

double
CurvesJob::bytesPerPoint(bool in_fragments) const
{
  // Measured: 450 in one piece; the next fragment is loaded beside.
  return in_fragments ? 500 : 450;
}

std::map<std::string, double>
CurvesJob::compute(const fragments::Plan& plan,
                   const fragments::Fragment& fragment,
                   const std::string& result,
                   ProgressMonitor* monitor)
{
  ReconstructionSettings settings = settings_;
  settings.threads = frame_.threads; // of this worker
  settings.whole = traitsIn(plan.measures);
  const PartOwner owner = [&](const Point& p) {
    return plan.tiling.owner(p.x() + plan.shift.x(), p.y() + plan.shift.y());
  };
  CurveNetwork network;
  if (settings.whole.scale_unit > 0)
    network = reconstructCurves(fragment.points, settings, monitor);
  saveCurvePart(
      result,
      ownedBy(network, fragment.number, owner, noted * settings.whole.scale_unit));
  return {};
}

std::map<std::string, double>
CurvesJob::write(const fragments::Plan& plan,
                 const std::string& folder,
                 std::size_t /*number*/,
                 const std::vector<bool>& usable,
                 ProgressMonitor* monitor)
{
  std::vector<CurvePart> parts(usable.size());
  for (std::size_t f = 0; f < usable.size(); ++f)
    if (usable[f])
      parts[f] = loadCurvePart(fragments::resultPath(folder, f));
  const CloudTraits traits = traitsIn(plan.measures);
  std::string wkt;
  for (const io::FileSummary& file : input_.summaries())
    if (wkt.empty())
      wkt = file.wkt;
  finish(joinParts(std::move(parts), same_curve * traits.scale_unit),
         traits.points,
         plan.shift,
         wkt,
         nullptr,
         monitor);
  return {};
}

void
CurvesJob::report(const std::map<std::string, double>& /*figures*/)
{
}

} // namespace linelet::apps
