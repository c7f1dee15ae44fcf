// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <linelet/features/centroid_shift.h>
#include <linelet/features/multi_scale.h>
#include <linelet/features/noise_rate.h>
#include <linelet/io/output_check.h>
#include <linelet/io/output_file.h>
#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>

#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

double
now()
{
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/** \brief What the largest radius costs, measured on a few points. */
struct Cost {
  double neighbors = 0; ///< of a point within the largest radius, on average
  double seconds = 0;   ///< for all points
};

/** \brief Points in some neighbourhoods: engines gain from queries that lie together.
 */
Points
clusters(const Points& points, std::size_t centers, std::size_t size)
{
  Points sample;
  for (std::size_t c = 0; c < centers; ++c) {
    const Point center = points[points.size() * (2 * c + 1) / (2 * centers)];
    Points sorted = points;
    size = std::min(size, points.size());
    std::nth_element(sorted.begin(),
                     sorted.begin() + static_cast<std::ptrdiff_t>(size - 1),
                     sorted.end(),
                     [&](const Point& a, const Point& b) {
                       return (a - center).squaredNorm() < (b - center).squaredNorm();
                     });
    sample.insert(sample.end(),
                  sorted.begin(),
                  sorted.begin() + static_cast<std::ptrdiff_t>(size));
  }
  return sample;
}

Cost
estimateCost(const Points& points, const MultiScaleSettings& settings)
{
  constexpr std::size_t centers = 3;
  // The grid shares its lists among the queries of a block; medians are slow by
  // themselves.
  const bool median = settings.centroid == Centroid::Median ||
                      settings.centroid == Centroid::WeightedMedian;
  const std::size_t size = settings.engine == ScaleEngine::Grid && !median ? 3000 : 100;
  if (!std::all_of(points.begin(), points.end(), [](const Point& point) {
        return point.allFinite();
      }))
    return {};
  const Points few = clusters(points, centers, 1),
               many = clusters(points, centers, size);
  Cost cost;
  const double begin = now();
  multiScaleShapes(points, few, settings);
  const double prepared = now();
  multiScaleShapes(points, many, settings, [&](std::size_t, const ShapeGraph& graph) {
    cost.neighbors += graph.back().neighbors;
  });
  cost.neighbors /= static_cast<double>(many.size());
  // Preparation takes the same for few and many.
  const double preparation = prepared - begin;
  const double of_one =
      std::max(0.0, now() - prepared - preparation) / static_cast<double>(many.size());
  cost.seconds = preparation + of_one * static_cast<double>(points.size());
  return cost;
}

constexpr const char* graph_header =
    "point,scale,radius,neighbors,linearity,planarity,sphericity,"
    "major_x,major_y,major_z\n";

/** \brief The rows of one point in the file of graphs. */
std::string
rowsOf(std::size_t point, const ShapeGraph& graph, const std::vector<double>& radii)
{
  std::string rows;
  char cell[64];
  for (std::size_t k = 0; k < graph.size(); ++k) {
    const ScaleShape& s = graph[k];
    std::snprintf(
        cell, sizeof(cell), "%zu,%zu,%.9g,%u", point, k, radii[k], s.neighbors);
    rows += cell;
    for (const float value :
         {s.linearity, s.planarity, s.sphericity, s.major_x, s.major_y, s.major_z}) {
      // An empty cell is what readers take for NaN.
      std::snprintf(cell, sizeof(cell), ",%.7g", static_cast<double>(value));
      rows += std::isnan(value) ? "," : cell;
    }
    rows += '\n';
  }
  return rows;
}

template <class T>
void
addColumn(io::Cloud& cloud,
          const std::vector<MultiScaleShape>& shapes,
          const char* name,
          T MultiScaleShape::*member,
          const char* description)
{
  std::vector<T> values;
  values.reserve(shapes.size());
  for (const MultiScaleShape& shape : shapes)
    values.push_back(shape.*member);
  cloud.set({name, std::move(values), description});
}

void
addColumns(io::Cloud& cloud, const std::vector<MultiScaleShape>& shapes)
{
  using S = MultiScaleShape;
  const auto add = [&](const char* name, auto member, const char* description) {
    addColumn(cloud, shapes, name, member, description);
  };
  add("linearity", &S::linearity, "CL at the optimal scale");
  add("planarity", &S::planarity, "CP at the optimal scale");
  add("sphericity", &S::sphericity, "CS at the optimal scale");
  add("optimal_radius", &S::optimal_radius, "radius of the optimal scale");
  add("blend", &S::blend, "trust in the eigenvector");
  add("linearity_sum", &S::linearity_sum, "area under linearity graph");
  add("linearity_max", &S::linearity_max, "largest CL of all scales");
  add("min_sphericity", &S::min_sphericity, "smallest CS of all scales");
  add("major_x", &S::major_x, "direction, optimal scale");
  add("major_y", &S::major_y, "direction, optimal scale");
  add("major_z", &S::major_z, "direction, optimal scale");
  add("neighbors", &S::neighbors, "points within optimal radius");
  add("first_neighbors", &S::first_neighbors, "neighbours, smallest scale");
  add("scale", &S::scale, "number of the optimal scale");
}

/** \brief The noise measures are defined for shapes about the query points. */
MultiScaleSettings
aboutPoints(MultiScaleSettings settings)
{
  settings.centroid = Centroid::QueryPoint;
  return settings;
}

/** \brief JSON has no NaN. */
nlohmann::ordered_json
numberOrNull(double value)
{
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
}

} // namespace

int
runMultiscale(const std::vector<std::string>& arguments)
{
  Frame frame(
      "multiscale",
      "Measures the shape of every point's neighbourhood over many radii and "
      "chooses the one that shows a curve best. Adds the shape, direction and "
      "radius of the optimal scale and what the graphs of linearity and "
      "sphericity come to; prints the noise rate. All attributes of the input "
      "are kept; points flagged as withheld take no part and have no shape.\n"
      "Time grows with the number of points within the largest radius: on wires "
      "in proportion to it, on surfaces to its square. A job of more than a few "
      "seconds says before it starts how many neighbours a point has and how "
      "long it will take.");
  MultiScaleSettings settings;
  CentroidShiftSettings shift;
  io::ReadOptions reading;
  io::WriteOptions writing;
  std::string input, output, graphs;
  frame.app.add_option("INPUT", input, "point file")->required();
  frame.app.add_option("OUTPUT", output, "point file, format by ending")->required();
  addOptions(frame.app, settings);
  frame.app.add_option("--graphs", graphs, "CSV file for the graphs of every point");
  frame.app.add_option("--centroid-shift",
                       shift.radius,
                       "first move every point to the mean of its neighbours within "
                       "this radius (the output has the moved points); 0: do not");
  addOptions(frame.app, reading);
  addOptions(frame.app, writing);
  frame.parse(arguments);
  settings.threads = shift.threads = frame.threads;
  io::checkCloudOutput(output);
  if (!graphs.empty())
    io::checkWritable(graphs);

  std::vector<std::string> warnings;
  io::Cloud cloud = io::readCloud(input, reading, &warnings, &frame.monitor);
  const io::UsablePoints usable(cloud, &warnings);
  frame.warn(warnings);
  Points points = usable.points();
  if (shift.radius != 0) {
    points = shiftToCentroids(points, shift, &frame.monitor);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].allFinite())
        cloud.points[i] = points[i];
  }

  MultiScaleShapes result = multiScaleRadii(points, settings, &frame.monitor);
  const double scale_unit = result.scale_unit;
  MultiScaleSettings planned = settings;
  planned.radii = result.radii;
  planned.stop_change = 0;
  if (!points.empty()) {
    planned.engine = chosenScaleEngine(points, points, planned.radii.back(), planned);
    Cost cost = estimateCost(points, planned);
    if (planned.centroid != Centroid::QueryPoint)
      cost.seconds += estimateCost(points, aboutPoints(planned)).seconds;
    if (cost.seconds > 3)
      std::fprintf(stderr,
                   "linelet multiscale: largest radius %.4g holds %.0f neighbours a "
                   "point; about %.0f s for %zu points, less with a smaller "
                   "--max-radius\n",
                   result.radii.back(),
                   cost.neighbors,
                   cost.seconds,
                   cloud.points.size());
  }

  if (graphs.empty())
    result = multiScaleShapes(points, points, planned, {}, &frame.monitor);
  else {
    io::OutputFile file(graphs);
    file.write(graph_header);
    result = multiScaleShapes(
        points,
        points,
        planned,
        [&](std::size_t point, const ShapeGraph& graph) {
          file.write(rowsOf(point, graph, planned.radii));
        },
        &frame.monitor);
    file.commit();
  }
  const std::vector<MultiScaleShape> about_points =
      settings.centroid == Centroid::QueryPoint
          ? result.shapes
          : multiScaleShapes(points, points, aboutPoints(planned), {}, &frame.monitor)
                .shapes;
  const double noise_rate = noiseRate(about_points);
  const double noise_width = noiseWidth(about_points);

  std::size_t unknown = 0;
  for (const MultiScaleShape& shape : result.shapes)
    unknown += shape.scale < 0 ? 1 : 0;
  unknown -= usable.withheld();
  addColumns(cloud, result.shapes);
  warnings.clear();
  io::writeCloud(output, cloud, writing, &warnings, &frame.monitor);
  frame.warn(warnings);

  std::printf("%s: %zu points, scale unit D %.6g, %zu radii from %.6g to %.6g\n"
              "noise rate %.4f, noise width %.4g\n",
              output.c_str(),
              cloud.points.size(),
              scale_unit,
              result.radii.size(),
              result.radii.front(),
              result.radii.back(),
              noise_rate,
              noise_width);
  if (unknown > 0)
    std::printf("%zu points have no optimal scale: fewer than %u points within the "
                "largest radius\n",
                unknown,
                settings.graph.min_neighbors);
  frame.summary["points"] = cloud.points.size();
  frame.summary["scale_unit"] = numberOrNull(scale_unit);
  frame.summary["radii"] = result.radii;
  frame.summary["engine"] = nameOf(planned.engine);
  frame.summary["noise_rate"] = numberOrNull(noise_rate);
  frame.summary["noise_width"] = numberOrNull(noise_width);
  frame.summary["unknown"] = unknown;
  frame.summary["withheld"] = usable.withheld();
  return frame.finish();
}

} // namespace linelet::apps
