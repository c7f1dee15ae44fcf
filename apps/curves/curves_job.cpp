// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curves_job.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include <linelet/curves/curve_blocks.h>
#include <linelet/io/hdf5_file.h>
#include <linelet/io/output_check.h>

#include "commands.h"
#include "fragments/run_job.h"
#include "given_tensors.h"
#include "options.h"
#include "traits_of_files.h"

namespace linelet::apps {

namespace {

bool
isHdf5(const std::string& path)
{
  return path.size() > 3 && path.compare(path.size() - 3, 3, ".h5") == 0;
}

/** \brief The measures of each curve; unknown ones are null. */
nlohmann::ordered_json
measuresOf(const CurveNetwork& network)
{
  auto result = nlohmann::ordered_json::array();
  for (const Curve& curve : network.curves)
    result.push_back({{"length", length(curve)},
                      {"closed", curve.closed},
                      {"noise", curve.noise},
                      {"density", curve.density},
                      {"evidence", curve.evidence}});
  return result;
}

} // namespace

CurvesJob::CurvesJob(const std::vector<std::string>& arguments)
    : FragmentJob(
          "curves",
          "Reconstructs the curves that run through a point cloud: wires, edges, "
          "outlines. The ending of OUTPUT chooses the format: .obj .ply .vtk .csv "
          ".gpkg "
          ".dxf .fgb .shz, .geojson and .kml (in WGS 84), .h5 (with the points), or "
          "any "
          "other that GDAL writes. Points flagged as withheld "
          "are ignored.",
          {500, 450}) // measured: 450 in one piece
{
  frame_.addOutput("OUTPUT", output_, "file for the curves");
  const OptionAdder add(frame_.app);
  add("simplify",
      simplify_,
      "drop vertices as long as curves stay within this distance, in the unit of "
      "the cloud; auto: a tenth of each curve's noise; 0: keep all");
  addOptions(frame_.app, settings_);
  add("tensors",
      tensors_,
      "published: follow the tensors of the file (attributes xx, xy, xz, yy, yz, zz), "
      "for example of a diffusion tensor image, instead of measuring shapes");
  addOptions(frame_.app, vectors_);
  addOptions(frame_.app, fragments_);
  frame_.parse(arguments);
  settings_.threads = frame_.threads;
}

void
CurvesJob::warnOfUnusedOptions()
{
  if (!isPublished(settings_.preset))
    for (const std::string& option : frame_.changedOptions("published"))
      frame_.warn(option + " has no effect without --preset published");
}

int
CurvesJob::runWhole()
{
  io::checkCurvesOutput(output_);
  warnOfUnusedOptions();
  if (!isHdf5(output_))
    input_.readOnly(tensors_ ? tensorAttributes() : std::vector<std::string>());
  const io::Cloud cloud = input_.read();
  const io::UsablePoints usable = input_.usable(cloud);
  // Unused points become NaN, so that --start counts as the file does.
  const Points& points = usable.points();
  const auto count = std::count_if(
      points.begin(), points.end(), [](const Point& p) { return p.allFinite(); });
  if (tensors_ && isPublished(settings_.preset))
    settings_.tensors = givenTensors(cloud, input_.path());
  const bool is_published = isPublished(settings_.preset);
  if (!is_published) // as in fragments
    settings_.whole = traitsOfCloud(input_, points, cloud.shift, frame_.threads);
  CurveNetwork network = reconstructCurves(points, settings_, &frame_.monitor);
  if (!is_published && CurveBlocks(settings_.whole).count() == 1)
    network = inOrderOfPlaces(network);
  frame_.lap("curves");
  frame_.summary["withheld"] = usable.withheld();
  frame_.summary["ignored"] = usable.ignored();
  finish(std::move(network),
         static_cast<double>(count),
         cloud.shift,
         cloud.wkt,
         isHdf5(output_) ? &cloud : nullptr,
         &frame_.monitor);
  return frame_.finish();
}

void
CurvesJob::finish(CurveNetwork network,
                  double points,
                  const Point& shift,
                  const std::string& wkt,
                  const io::Cloud* beside,
                  ProgressMonitor* monitor)
{
  double tolerance = 0; // the largest
  for (const Curve& curve : network.curves)
    tolerance = std::max(tolerance, simplify_.of(curve));
  network = simplified(std::move(network), simplify_);
  std::vector<std::string> warnings;
  if (beside != nullptr)
    io::writeHdf5(output_, *beside, network, monitor);
  else
    io::writeCurves(output_, network, shift, wkt, &warnings, monitor, vectors_);
  frame_.warn(warnings);
  frame_.lap("write");

  const auto count = static_cast<std::size_t>(points);
  const auto closed = static_cast<std::size_t>(
      std::count_if(network.curves.begin(), network.curves.end(), [](const Curve& c) {
        return c.closed;
      }));
  if (network.curves.empty())
    frame_.warn("no curve found in the " + std::to_string(count) +
                " points; the output is empty");
  std::printf(
      "%s: %zu curves (%zu closed), %zu junctions, length %.6g, from %zu points\n",
      output_.c_str(),
      network.curves.size(),
      closed,
      network.junctions.size(),
      length(network),
      count);
  frame_.summary["points"] = count;
  frame_.summary["curves"] = network.curves.size();
  frame_.summary["closed"] = closed;
  frame_.summary["junctions"] = network.junctions.size();
  frame_.summary["vertices"] = std::accumulate(
      network.curves.begin(),
      network.curves.end(),
      std::size_t{0},
      [](std::size_t sum, const Curve& c) { return sum + c.points.size(); });
  frame_.summary["simplify_tolerance"] = tolerance;
  frame_.summary["length"] = length(network);
  frame_.summary["measures"] = measuresOf(network);
}

void
CurvesJob::check()
{
  io::checkCurvesOutput(output_);
  if (isPublished(settings_.preset))
    throw std::runtime_error("--preset published does not work in fragments; leave it "
                             "out, or give more --memory");
  if (isHdf5(output_))
    throw io::FileError(output_ + ": holds all points, which are not written in "
                                  "fragments; name .gpkg or another ending, or give "
                                  "more --memory");
  warnOfUnusedOptions();
}

std::unique_ptr<FragmentJob>
makeCurvesJob(const std::vector<std::string>& arguments)
{
  return std::make_unique<CurvesJob>(arguments);
}

int
runCurves(const std::vector<std::string>& arguments)
{
  CurvesJob job(arguments);
  return runJob(job, "curves", arguments);
}

} // namespace linelet::apps
