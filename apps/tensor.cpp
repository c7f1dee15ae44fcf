// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/features/tensor_estimation.h>
#include <linelet/io/output_check.h>
#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>
#include <linelet/search/scale_unit.h>

#include "commands.h"
#include "device_engine.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

using Records = std::vector<PointDistributionTensor>;

/** \brief Seconds since the last call, or since it was made. */
class StopWatch {
public:
  double
  lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - since_;
    since_ = now;
    return passed.count();
  }

private:
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

const io::Column&
fieldOf(const io::Cloud& cloud, const std::string& name, const std::string& file)
{
  if (const io::Column* column = cloud.find(name))
    return *column;
  std::string names;
  for (const io::Column& column : cloud.columns)
    names += " " + column.name;
  throw std::runtime_error(file + ": there is no field '" + name + "'; it has" +
                           (names.empty() ? " none" : names));
}

/** \brief Sizes of neighbourhoods from fields of the cloud, where they were asked for.
 */
NeighbourhoodSizes
sizesFrom(const io::Cloud& cloud,
          const std::string& radius_field,
          const std::string& knn_field,
          const std::string& file)
{
  NeighbourhoodSizes sizes;
  if (!radius_field.empty()) {
    const io::Column& column = fieldOf(cloud, radius_field, file);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      sizes.radii.push_back(io::valueAt(column, i));
  }
  if (!knn_field.empty()) {
    const io::Column& column = fieldOf(cloud, knn_field, file);
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      const double k = io::valueAt(column, i);
      sizes.counts.push_back(k >= 1 && k < 4e9 ? static_cast<unsigned>(k) : 0);
    }
  }
  return sizes;
}

template <class T>
void
addColumn(io::Cloud& cloud,
          const Records& records,
          const char* name,
          T PointDistributionTensor::*member,
          const char* description)
{
  std::vector<T> values;
  values.reserve(records.size());
  for (const PointDistributionTensor& record : records)
    values.push_back(record.*member);
  cloud.set({name, std::move(values), description});
}

/** \brief The fields of the records as attributes of the points. */
void
addColumns(io::Cloud& cloud, const Records& records)
{
  using R = PointDistributionTensor;
  const auto add = [&](const char* name, auto member, const char* description) {
    addColumn(cloud, records, name, member, description);
  };
  add("xx", &R::xx, "neighbourhood tensor");
  add("xy", &R::xy, "neighbourhood tensor");
  add("xz", &R::xz, "neighbourhood tensor");
  add("yy", &R::yy, "neighbourhood tensor");
  add("yz", &R::yz, "neighbourhood tensor");
  add("zz", &R::zz, "neighbourhood tensor");
  add("lambda1", &R::lambda1, "smallest eigenvalue");
  add("lambda2", &R::lambda2, "middle eigenvalue");
  add("lambda3", &R::lambda3, "largest eigenvalue");
  add("major_x", &R::major_x, "along the largest extent");
  add("major_y", &R::major_y, "along the largest extent");
  add("major_z", &R::major_z, "along the largest extent");
  add("normal_x", &R::normal_x, "along the smallest extent");
  add("normal_y", &R::normal_y, "along the smallest extent");
  add("normal_z", &R::normal_z, "along the smallest extent");
  add("linearity", &R::linearity, "shape factor CL, 0 to 1");
  add("planarity", &R::planarity, "shape factor CP, 0 to 1");
  add("sphericity", &R::sphericity, "shape factor CS, 0 to 1");
  add("neighbors", &R::neighbors, "points in the neighbourhood");
}

/** \brief A radius for points of which nothing else is known. */
double
radiusFor(double scale_unit)
{
  return 3 * scale_unit;
}

/** \brief A radius where none was given. */
double
chooseRadius(double scale_unit, const std::string& file)
{
  if (!(scale_unit > 0))
    throw std::runtime_error(file +
                             ": no radius can be chosen for points that are fewer "
                             "than two or share one place; give --radius");
  return radiusFor(scale_unit);
}

/** \brief Runs the engine asked for. Engine::Auto becomes the one that ran; a device
 * that it chose and that fails is no reason to give up. */
Records
estimate(const Points& points,
         TensorSettings& settings,
         const NeighbourhoodSizes& sizes,
         const std::string& device,
         Frame& frame)
{
  // Sizes that make no sense are refused before anything is made of them.
  validate(settings, sizes, points.size());
  const bool automatic = settings.engine == Engine::Auto;
  if (automatic) {
    const auto gpu = gpuCost(device, engineWork(points, points, settings, sizes));
    settings.engine =
        chosenEngine(points, points, settings, sizes, gpu ? &*gpu : nullptr);
  }
  if (settings.engine == Engine::OpenCL) {
    try {
      return estimateOnDevice(device, points, settings, sizes, frame);
    }
    catch (const Cancelled&) {
      throw;
    }
    catch (const std::runtime_error& error) {
      if (!automatic)
        throw;
      frame.warn(std::string(error.what()) + "; the engine grid runs instead");
      settings.engine = Engine::Grid;
    }
  }
  return estimateTensors(points, points, settings, sizes, &frame.monitor);
}

std::string
describeSize(const TensorSettings& settings,
             const std::string& radius_field,
             const std::string& knn_field)
{
  char text[64];
  if (!radius_field.empty())
    return "radius from field " + radius_field;
  if (!knn_field.empty())
    return "number of nearest points from field " + knn_field;
  if (settings.k > 0)
    return std::to_string(settings.k) + " nearest points";
  std::snprintf(text, sizeof(text), "radius %.6g", settings.radius);
  return text;
}

} // namespace

int
runTensor(const std::vector<std::string>& arguments)
{
  Frame frame(
      "tensor",
      "Measures the shape of every point's neighbourhood: tensor, eigenvalues, "
      "major direction, normal, linearity, planarity, sphericity and number of "
      "neighbours, added to the attributes of the input. Without --radius, --knn "
      "or a field the radius is chosen: three times the scale unit D. Points flagged "
      "as withheld take no part and have no shape.");
  TensorSettings settings;
  io::ReadOptions reading;
  io::WriteOptions writing;
  std::string input, output, radius_field, knn_field, device;
  frame.app.add_option("INPUT", input, "point file")->required();
  frame.app.add_option("OUTPUT", output, "point file, format by ending")->required();
  addOptions(frame.app, settings);
  frame.app.add_option(
      "--radius-field", radius_field, "attribute that holds the radius of every point");
  frame.app.add_option(
      "--knn-field",
      knn_field,
      "attribute that holds the number of nearest points of every point");
  frame.app.add_option("--device",
                       device,
                       "OpenCL device by number or part of its name; linelet devices "
                       "lists them");
  addOptions(frame.app, reading);
  addOptions(frame.app, writing);
  frame.parse(arguments);
  settings.threads = frame.threads;
  io::checkCloudOutput(output);

  StopWatch watch;
  std::vector<std::string> warnings;
  io::Cloud cloud = io::readCloud(input, reading, &warnings, &frame.monitor);
  const io::UsablePoints usable(cloud, &warnings);
  const Points& points = usable.points();
  frame.warn(warnings);
  const double read_seconds = watch.lap();

  const NeighbourhoodSizes sizes = sizesFrom(cloud, radius_field, knn_field, input);
  double scale_unit = std::nan("");
  if (settings.radius == 0 && settings.k == 0 && radius_field.empty() &&
      knn_field.empty()) {
    scale_unit = scaleUnit(points, 1024, 1, frame.threads);
    settings.radius = chooseRadius(scale_unit, input);
  }
  const Records records = estimate(points, settings, sizes, device, frame);
  const double tensor_seconds = watch.lap();

  std::size_t unknown = 0;
  double neighbors = 0;
  for (const PointDistributionTensor& record : records) {
    unknown += std::isnan(record.linearity);
    neighbors += record.neighbors;
  }
  unknown -= usable.withheld();
  const auto count = static_cast<double>(records.size() - usable.withheld());
  // One point in a hundred is no reason for another radius.
  if (static_cast<double>(unknown) > 0.01 * count && std::isnan(scale_unit))
    scale_unit = scaleUnit(points, 1024, 1, frame.threads);

  addColumns(cloud, records);
  watch.lap();
  warnings.clear();
  io::writeCloud(output, cloud, writing, &warnings, &frame.monitor);
  frame.warn(warnings);
  const double write_seconds = watch.lap();

  const std::string size = describeSize(settings, radius_field, knn_field);
  const std::string engine(nameOf(settings.engine));
  std::printf("%s: %zu points, %s, %.1f neighbors on average, engine %s\n",
              output.c_str(),
              records.size(),
              size.c_str(),
              count > 0 ? neighbors / count : 0.0,
              engine.c_str());
  if (unknown > 0) {
    std::printf("%zu points have no shape: too few neighbors, or all in one place\n",
                unknown);
    if (scale_unit > 0 && static_cast<double>(unknown) > 0.01 * count)
      std::printf("try --radius %.3g: three times the scale unit of this cloud\n",
                  radiusFor(scale_unit));
  }

  frame.summary["points"] = records.size();
  if (settings.radius > 0)
    frame.summary["radius"] = settings.radius;
  if (settings.k > 0)
    frame.summary["knn"] = settings.k;
  if (!radius_field.empty())
    frame.summary["radius_field"] = radius_field;
  if (!knn_field.empty())
    frame.summary["knn_field"] = knn_field;
  if (!std::isnan(scale_unit))
    frame.summary["scale_unit"] = scale_unit;
  frame.summary["weight"] = settings.weighting.name();
  frame.summary["centroid"] = nameOf(settings.centroid);
  frame.summary["engine"] = engine;
  frame.summary["mean_neighbors"] = count > 0 ? neighbors / count : 0.0;
  frame.summary["unknown"] = unknown;
  frame.summary["withheld"] = usable.withheld();
  frame.summary["seconds"] = {
      {"read", read_seconds}, {"tensor", tensor_seconds}, {"write", write_seconds}};
  return frame.finish();
}

} // namespace linelet::apps
