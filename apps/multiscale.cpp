// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/features/centroid_shift.h>
#include <linelet/features/multi_scale.h>
#include <linelet/features/noise_rate.h>
#include <linelet/io/output_file.h>
#include <linelet/search/grid_search.h>

#include "cloud_files.h"
#include "commands.h"
#include "fourth_order_columns.h"
#include "frame.h"
#include "options.h"
#include "scale_cost.h"

namespace linelet::apps {

namespace {

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
  add("first_neighbors", &S::first_neighbors, "neighbors, smallest scale");
  add("scale", &S::scale, "number of the optimal scale");
}

/** \brief The noise measures are defined for shapes about the query points. */
MultiScaleSettings
aboutPoints(MultiScaleSettings settings)
{
  settings.centroid = Centroid::QueryPoint;
  return settings;
}

/** \brief The shapes of \a points; their graphs go to the file \a graphs, if any. */
std::vector<MultiScaleShape>
measure(const Points& points,
        const MultiScaleSettings& settings,
        const std::string& graphs,
        ProgressMonitor* monitor)
{
  if (graphs.empty())
    return multiScaleShapes(points, points, settings, {}, monitor).shapes;
  io::OutputFile file(graphs);
  file.write(graph_header);
  const auto write = [&](std::size_t point, const ShapeGraph& graph) {
    file.write(rowsOf(point, graph, settings.radii));
  };
  auto shapes = multiScaleShapes(points, points, settings, write, monitor).shapes;
  file.commit();
  return shapes;
}

/** \brief Says of a long shift beforehand how long it will take, measured on a few
 * points. */
void
announceShift(const Points& points, const CentroidShiftSettings& shift, Frame& frame)
{
  if (!(shift.radius > 0 && std::isfinite(shift.radius)))
    return; // refused by whoever makes it
  const GridSearch search(points, shift.radius);
  const ScaleCost cost = measuredCost(points, 160, [&](const Indices& chosen) {
    Points some;
    for (const Index i : chosen)
      some.push_back(points[i]);
    shiftToCentroids(search, some, shift, &frame.monitor);
    double neighbors = 0;
    Indices found;
    for (const Point& p : some) {
      search.within(p, shift.radius, found);
      neighbors += static_cast<double>(found.size());
    }
    return neighbors;
  });
  announce(cost, points.size(), "centroid shift", "--centroid-shift", frame);
}

/** \brief The usable points of \a cloud, moved to the centroids of their neighbors
 * where \a shift has a radius, which moves them in \a cloud as well. */
Points
shiftedPoints(io::Cloud& cloud,
              const io::UsablePoints& usable,
              const CentroidShiftSettings& shift,
              Frame& frame)
{
  if (shift.radius == 0)
    return usable.points();
  announceShift(usable.points(), shift, frame);
  Points points = shiftToCentroids(usable.points(), shift, &frame.monitor);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      cloud.points[i] = points[i];
  return points;
}

/** \brief What was found in a file: how far the points are from their curves, and how
 * many points have no scale. */
struct Result {
  double noise_rate, noise_width;
  std::size_t points, left_out, unknown;
};

Result
resultOf(const std::vector<MultiScaleShape>& shapes,
         const std::vector<MultiScaleShape>& about_points,
         std::size_t left_out)
{
  const auto without_scale =
      std::count_if(shapes.begin(), shapes.end(), [](const MultiScaleShape& shape) {
        return shape.scale < 0;
      });
  return {noiseRate(about_points),
          noiseWidth(about_points),
          shapes.size(),
          left_out,
          static_cast<std::size_t>(without_scale) - left_out};
}

void
print(const Result& result,
      const MultiScaleShapes& plan,
      const MultiScaleSettings& settings,
      const std::string& file)
{
  std::printf("%s: %zu points, scale unit D %.6g, %zu radii from %.6g to %.6g\n"
              "noise rate %.4f, noise width %.4g\n",
              file.c_str(),
              result.points,
              plan.scale_unit,
              plan.radii.size(),
              plan.radii.front(),
              plan.radii.back(),
              result.noise_rate,
              result.noise_width);
  if (result.unknown > 0)
    std::printf("%zu points have no optimal scale: fewer than %u points within the "
                "largest radius\n",
                result.unknown,
                settings.graph.min_neighbors);
}

/** \brief One input: all its options. */
void
runOne(CloudInput& input,
       CloudOutput& output,
       MultiScaleSettings& settings,
       const CentroidShiftSettings& shift,
       const std::string& graphs,
       FourthOrderOption fourth_order,
       Frame& frame)
{
  io::Cloud cloud = input.read();
  const io::UsablePoints usable = input.usable(cloud);
  const Points points = shiftedPoints(cloud, usable, shift, frame);
  const MultiScaleShapes plan = multiScaleRadii(points, settings, &frame.monitor);
  settings.radii = plan.radii;
  settings.stop_change = 0; // it has had its say
  settings.engine = chosenScaleEngine(points, points, settings.radii.back(), settings);
  announceMultiScale(points, points, settings, frame);
  const auto shapes = measure(points, settings, graphs, &frame.monitor);
  const auto about_points =
      settings.centroid == Centroid::QueryPoint
          ? shapes
          : measure(points, aboutPoints(settings), {}, &frame.monitor);
  frame.lap("multiscale");
  addColumns(cloud, shapes);
  if (fourth_order != FourthOrderOption::None)
    addFourthOrder(cloud, points, settings, fourth_order, &frame.monitor);
  const std::string path = output.pathFor(input, 0);
  output.write(cloud, path);

  const Result result = resultOf(shapes, about_points, usable.leftOut());
  print(result, plan, settings, path);
  frame.summary["points"] = result.points;
  frame.summary["withheld"] = usable.withheld();
  frame.summary["ignored"] = usable.ignored();
  frame.summary["scale_unit"] = plan.scale_unit;
  frame.summary["radii"] = plan.radii;
  frame.summary["engine"] = nameOf(settings.engine);
  frame.summary["noise_rate"] = result.noise_rate;
  frame.summary["noise_width"] = result.noise_width;
  frame.summary["unknown"] = result.unknown;
}

/** \brief Several inputs: the radii of the first for all, and neighbors across their
 * borders. */
void
runSeveral(CloudInput& input,
           CloudOutput& output,
           MultiScaleSettings& settings,
           Frame& frame)
{
  MultiScaleShapes plan;
  std::size_t points = 0, withheld = 0, ignored = 0, unknown = 0;
  auto files = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < input.files().size(); ++i) {
    io::Cloud cloud = input.read(i);
    const io::UsablePoints usable = input.usable(cloud);
    if (i == 0) {
      plan = multiScaleRadii(usable.points(), settings, &frame.monitor);
      settings.radii = plan.radii;
    }
    const CloudInput::Surroundings all =
        input.surroundings(i, cloud, usable, multiScaleMargin(settings.radii));
    if (settings.engine == ScaleEngine::Auto)
      settings.engine =
          chosenScaleEngine(all.points, all.points, settings.radii.back(), settings);
    announceMultiScale(all.points, all.points, settings, frame);
    const auto measured = [&](const MultiScaleSettings& s) {
      return pieceShapes(all.points, all.piece, s, &frame.monitor).shapes;
    };
    const auto shapes = measured(settings);
    const auto about_points = settings.centroid == Centroid::QueryPoint
                                  ? shapes
                                  : measured(aboutPoints(settings));
    frame.lap("multiscale");
    addColumns(cloud, shapes);
    const std::string path = output.pathFor(input, i);
    output.write(cloud, path);

    const Result result = resultOf(shapes, about_points, usable.leftOut());
    print(result, plan, settings, path);
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
  frame.summary["points"] = points;
  frame.summary["withheld"] = withheld;
  frame.summary["ignored"] = ignored;
  frame.summary["scale_unit"] = plan.scale_unit;
  frame.summary["radii"] = plan.radii;
  frame.summary["engine"] = nameOf(settings.engine);
  frame.summary["unknown"] = unknown;
  frame.summary["files"] = files;
}

} // namespace

int
runMultiscale(const std::vector<std::string>& arguments)
{
  Frame frame(
      "multiscale",
      "Measures the shape of every point's neighborhood over many radii and "
      "chooses the one that shows a curve best. Adds the shape, direction and "
      "radius of the optimal scale and what the graphs of linearity and "
      "sphericity come to; prints the noise rate. All attributes of the input "
      "are kept; points flagged as withheld take no part and have no shape.\n"
      "Time grows with the number of points within the largest radius: on wires "
      "in proportion to it, on surfaces to its square. A job of more than a few "
      "seconds says before it starts how many neighbors a point has and how "
      "long it will take. Several inputs take the radii of the first, unless --radii "
      "or "
      "--scale-unit say them; neighbors are found across their borders.");
  MultiScaleSettings settings;
  CentroidShiftSettings shift;
  std::string graphs;
  auto fourth_order = FourthOrderOption::None;
  CloudInput input(frame);
  CloudOutput output(frame);
  addOptions(frame.app, settings);
  const OptionAdder add(frame.app);
  add("graphs", graphs, "CSV file for the graphs of every point");
  frame.writes(graphs);
  add("fourth-order",
      fourth_order,
      "also write the fourth-order tensor over all radii, weighted by this factor, and "
      "its major eigentensor");
  describe(shift, "centroid-shift", "shift-", add);
  frame.parse(arguments);
  settings.threads = shift.threads = frame.threads;
  const bool several = input.files().size() > 1;
  if (several && (!graphs.empty() || shift.radius != 0 || settings.stop_change > 0 ||
                  fourth_order != FourthOrderOption::None))
    throw std::runtime_error("--graphs, --centroid-shift, --fourth-order and "
                             "--stop-change look at one cloud; give one input, or "
                             "leave them out");
  output.check(input);
  if (!graphs.empty())
    io::checkWritable(graphs);
  if (several)
    runSeveral(input, output, settings, frame);
  else
    runOne(input, output, settings, shift, graphs, fourth_order, frame);
  return frame.finish();
}

} // namespace linelet::apps
