// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <linelet/io/input_list.h>
#include <linelet/io/merge.h>
#include <linelet/io/vector_file.h>
#include <linelet/search/scale_unit.h>

namespace linelet::view {

namespace {

std::string
endingOf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending;
}

/** \brief Whether a file holds curves rather than points: by its extension, or by its
 * first lines if the extension serves both. */
bool
holdsCurves(const std::string& path)
{
  const std::string ending = endingOf(path);
  for (const char* of_curves : {".geojson", ".gpkg", ".dxf", ".vtk"})
    if (ending == of_curves)
      return true;
  if (ending != ".obj" && ending != ".ply" && ending != ".csv")
    return false;
  std::ifstream in(path, std::ios::binary);
  std::string line;
  for (std::size_t number = 0; std::getline(in, line); ++number) {
    if (ending == ".csv")
      return line.find("curve") == 0;
    if (ending == ".ply" && line.find("end_header") == 0)
      return false;
    if (line.find(ending == ".ply" ? "element edge" : "l ") == 0)
      return true;
    if (ending == ".ply" && number > 1000)
      return false;
  }
  return false;
}

void
addPoints(Scene& scene,
          const std::vector<std::string>& files,
          io::ReadOptions& options,
          ProgressMonitor* monitor)
{
  for (const std::string& file : files) {
    io::Cloud cloud = io::readCloud(file, options, &scene.warnings, monitor);
    if (!options.shift)
      options.shift = cloud.shift;
    if (scene.cloud.points.empty() && scene.cloud.columns.empty())
      scene.cloud = std::move(cloud);
    else
      io::append(scene.cloud, cloud, &scene.warnings);
    throwIfCanceled(monitor);
  }
}

std::string
classifiedCloudOf(const std::string& folder)
{
  for (const char* name : {"classified.las", "classified.laz"}) {
    const auto path = std::filesystem::path(folder) / name;
    if (std::filesystem::exists(path))
      return path.string();
  }
  return {};
}

void
stretch(Box& box, const Point& p)
{
  if (!p.allFinite())
    return;
  box.low = box.low.cwiseMin(p);
  box.high = box.high.cwiseMax(p);
}

Box
boundsOf(const Scene& scene)
{
  Box box;
  box.low.setConstant(std::numeric_limits<double>::infinity());
  box.high = -box.low;
  for (const Point& p : scene.cloud.points)
    stretch(box, p);
  for (const CurveNetwork* network : {&scene.curves, &scene.truth})
    for (const Curve& curve : network->curves)
      for (const Point& p : curve.points)
        stretch(box, p);
  return (box.low.array() <= box.high.array()).all() ? box : Box();
}

/** \brief Width of rows in the search grid: about a neighborhood, or a thousandth of
 * the extent if the points have no scale. */
double
rowSize(const Scene& scene)
{
  const double extent = (scene.bounds.high - scene.bounds.low).maxCoeff();
  if (scene.scale_unit > 0)
    return std::max(2 * scene.scale_unit, 1e-6 * extent);
  return extent > 0 ? extent / 1000 : 1;
}

} // namespace

bool
isPowerLineFolder(const std::string& folder)
{
  return std::filesystem::is_directory(folder) &&
         std::filesystem::exists(std::filesystem::path(folder) / "summary.json") &&
         !classifiedCloudOf(folder).empty();
}

std::shared_ptr<const Scene>
openScene(const std::vector<std::string>& paths,
          const std::string& truth,
          const io::ReadOptions& options,
          const io::ClassFilter& classes,
          ProgressMonitor* monitor)
{
  auto scene = std::make_shared<Scene>();
  scene->inputs = paths;
  io::ReadOptions reading = options;
  std::vector<std::string> curves, points;
  for (const std::string& path : paths) {
    if (isPowerLineFolder(path)) {
      if (!scene->folder.empty())
        throw io::FileError(path + ": is a second folder of power lines besides " +
                            scene->folder + "; open one at a time");
      scene->folder = path;
      points.push_back(classifiedCloudOf(path));
    }
    else if (std::filesystem::is_regular_file(path) && holdsCurves(path))
      curves.push_back(path);
    else
      points.push_back(path);
  }
  if (!points.empty())
    addPoints(*scene, io::findInputs(points).files, reading, monitor);
  io::Cloud& cloud = scene->cloud;
  if (points.empty() && !curves.empty()) {
    const CurveNetwork first =
        io::readCurves(curves.front(), Point::Zero(), &cloud.wkt);
    if (!first.curves.empty())
      cloud.shift = first.curves.front().points.front().array().round().matrix();
  }
  for (const std::string& path : curves) {
    CurveNetwork network = io::readCurves(path, cloud.shift);
    std::move(network.curves.begin(),
              network.curves.end(),
              std::back_inserter(scene->curves.curves));
  }
  if (!truth.empty())
    scene->truth = io::readCurves(truth, cloud.shift);
  if (!scene->folder.empty())
    scene->lines = std::make_shared<const powerline::PowerLineNetwork>(
        readNetwork(scene->folder, cloud));
  throwIfCanceled(monitor);

  scene->points = io::UsablePoints(cloud, &scene->warnings, classes).points();
  scene->bounds = boundsOf(*scene);
  scene->scale_unit = scaleUnit(scene->points);
  throwIfCanceled(monitor);
  if (!scene->points.empty())
    scene->grid = std::make_unique<UniformGrid>(scene->points, rowSize(*scene));
  return scene;
}

} // namespace linelet::view
