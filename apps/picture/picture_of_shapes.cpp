// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include <linelet/features/read_linearity_graph.h>
#include <linelet/io/vector_file.h>
#include <linelet/search/kd_tree.h>

#include "axes.h"
#include "pictures.h"
#include "scale_cost.h"
#include "shape_pictures.h"

namespace linelet::apps {

namespace {

/// \a count radii from the smallest to the largest, evenly spaced on a logarithmic
/// scale.
std::vector<double>
fineRadii(const std::vector<double>& radii, unsigned count)
{
  if (radii.size() < 2 || count < 2)
    return radii;
  std::vector<double> fine;
  const double ratio = std::log(radii.back() / radii.front());
  for (unsigned i = 0; i < count; ++i)
    fine.push_back(radii.front() * std::exp(ratio * i / (count - 1)));
  return fine;
}

/// The graphs of all queries at \a radii.
std::vector<ShapeGraph>
graphsAt(const Points& cloud,
         const Points& queries,
         MultiScaleSettings settings,
         const std::vector<double>& radii,
         ProgressMonitor* monitor)
{
  settings.radii = radii;
  settings.stop_change = 0;
  std::vector<ShapeGraph> graphs;
  multiScaleShapes(
      cloud,
      queries,
      settings,
      [&](std::size_t, const ShapeGraph& graph) { graphs.push_back(graph); },
      monitor);
  return graphs;
}

std::size_t
namedPoint(const io::Cloud& cloud,
           const std::vector<double>& name,
           const std::string& file)
{
  if (name.size() == 1) {
    if (!(name[0] >= 0) || !(name[0] < static_cast<double>(cloud.points.size())))
      throw std::runtime_error(file + ": there is no point number " +
                               numberText(name[0], 12) + "; numbers go from 0 to " +
                               std::to_string(cloud.points.size()) + " - 1");
    return static_cast<std::size_t>(name[0]);
  }
  if (name.size() != 3)
    throw std::runtime_error("--point takes one number or the coordinates x,y,z, not " +
                             std::to_string(name.size()) + " values");
  const Point place = Point(name[0], name[1], name[2]) - cloud.shift;
  std::size_t best = cloud.points.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (const double squared = (cloud.points[i] - place).squaredNorm();
        squared < least) {
      least = squared;
      best = i;
    }
  if (best == cloud.points.size())
    throw std::runtime_error(file + ": there is no finite point");
  return best;
}

std::string
worldText(const io::Cloud& cloud, const Point& point)
{
  std::string text;
  for (const double value : Point(point + cloud.shift)) {
    std::array<char, 40> digits{};
    std::snprintf(digits.data(), digits.size(), "%.2f", value);
    text += (text.empty() ? "(" : ", ") + std::string(digits.data());
  }
  return text + ")";
}

struct Probe {
  Points line;
  std::string title;
};

/// A straight line through a point, along its direction at the optimal scale.
Probe
probeThroughPoint(const io::Cloud& cloud,
                  const PictureSettings& settings,
                  const MultiScaleSettings& shapes,
                  const std::string& file)
{
  const Point point = cloud.points[namedPoint(cloud, settings.point, file)];
  const MultiScaleShapes result = multiScaleShapes(cloud.points, {point}, shapes);
  const MultiScaleShape& shape = result.shapes[0];
  if (std::isnan(shape.major_x))
    throw std::runtime_error(file + ": the point at " + worldText(cloud, point) +
                             " has too few neighbors for a direction; name another or "
                             "raise --max-radius");
  const Point direction = Eigen::Vector3f(shape.major_x, shape.major_y, shape.major_z)
                              .cast<double>()
                              .normalized();
  const double length = settings.length > 0 ? settings.length : 30 * result.scale_unit;
  return {{point - length / 2 * direction, point + length / 2 * direction},
          "Shape over scales through " + worldText(cloud, point)};
}

Probe
probeLine(const io::Cloud& cloud,
          const PictureSettings& settings,
          const MultiScaleSettings& shapes,
          const std::string& file)
{
  Probe probe;
  if (!settings.along.empty()) {
    const CurveNetwork network = io::readCurves(settings.along, cloud.shift);
    if (network.curves.empty())
      throw std::runtime_error(settings.along + ": there is no curve in it");
    const Curve& curve = network.curves.front();
    probe.line = curve.points;
    if (curve.closed)
      probe.line.push_back(curve.points.front());
    probe.title = "Shape over scales along " + settings.along;
  }
  else if (!settings.probe.empty()) {
    if (settings.probe.size() % 3 != 0 || settings.probe.size() < 6)
      throw std::runtime_error("--probe takes x,y,z of two or more places, not " +
                               std::to_string(settings.probe.size()) + " values");
    for (std::size_t i = 0; i < settings.probe.size(); i += 3)
      probe.line.push_back(
          Point(settings.probe[i], settings.probe[i + 1], settings.probe[i + 2]) -
          cloud.shift);
    probe.title = "Shape over scales along a probe line";
  }
  else if (!settings.point.empty())
    return probeThroughPoint(cloud, settings, shapes, file);
  else
    throw std::runtime_error("a profile needs its line: give --along FILE, --probe "
                             "x,y,z,x,y,z, --point x,y,z or --by-index");
  return probe;
}

/// \a count positions at equal arc lengths, and these arc lengths.
Points
resample(const Points& line, unsigned count, std::vector<double>& positions)
{
  std::vector<double> arc(1, 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    arc.push_back(arc.back() + (line[i] - line[i - 1]).norm());
  Points places;
  std::size_t segment = 1;
  for (unsigned i = 0; i < count; ++i) {
    const double s = arc.back() * i / (count - 1);
    while (segment + 1 < arc.size() && arc[segment] < s)
      ++segment;
    const double length = arc[segment] - arc[segment - 1];
    const double t = length > 0 ? (s - arc[segment - 1]) / length : 0;
    places.push_back(line[segment - 1] + t * (line[segment] - line[segment - 1]));
    positions.push_back(s);
  }
  return places;
}

/// Evenly spaced positions along the line given by the settings.
Points
placesOnLine(const io::Cloud& cloud,
             const PictureSettings& settings,
             const MultiScaleSettings& shapes,
             const std::string& file,
             ShapeProfile& profile)
{
  const Probe probe = probeLine(cloud, settings, shapes, file);
  if (settings.columns < 2 || probe.line.size() < 2)
    throw std::runtime_error("a profile needs a line of two places and 2 columns");
  profile.title = settings.title.empty() ? probe.title : settings.title;
  profile.position_label = "position along the line";
  Points places = resample(probe.line, settings.columns, profile.positions);
  if (!(profile.positions.back() > 0))
    throw std::runtime_error("the line of the profile has no length");
  return places;
}

/// The points of the cloud in file order; every n-th if there are more than columns.
Points
pointsInOrder(const io::Cloud& cloud,
              const PictureSettings& settings,
              const std::string& file,
              ShapeProfile& profile)
{
  if (settings.columns < 2 || cloud.points.size() < 2)
    throw std::runtime_error(file + ": a profile needs two points and 2 columns");
  const std::size_t step =
      (cloud.points.size() + settings.columns - 1) / settings.columns;
  Points places;
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    places.push_back(cloud.points[i]);
    profile.positions.push_back(static_cast<double>(i));
  }
  profile.title = settings.title.empty() ? "Shape over scales of the points of " + file
                                         : settings.title;
  profile.position_label = "number of the point";
  return places;
}

/// The graphs of the points around one, within its optimal radius; the nearest ones if
/// there are many.
std::vector<ShapeGraph>
graphsAround(const Points& cloud,
             const Point& point,
             double radius,
             const MultiScaleSettings& shapes,
             const std::vector<double>& radii,
             ProgressMonitor* monitor)
{
  constexpr std::size_t most = 256;
  Indices found;
  const KdTree tree(cloud);
  tree.within(point, radius, found);
  if (found.size() > most)
    tree.nearest(point, most, found);
  Points neighbors;
  for (const Index i : found)
    neighbors.push_back(cloud[i]);
  return graphsAt(cloud, neighbors, shapes, radii, monitor);
}

} // namespace

Canvas
pictureOfProfile(const io::Cloud& cloud,
                 const PictureSettings& settings,
                 const MultiScaleSettings& shapes,
                 const std::string& file,
                 Frame& frame)
{
  ShapeProfile profile;
  const Points places = settings.by_index
                            ? pointsInOrder(cloud, settings, file, profile)
                            : placesOnLine(cloud, settings, shapes, file, profile);

  ProgressMonitor* const monitor = &frame.monitor;
  MultiScaleSettings planned = shapes;
  planned.radii = multiScaleRadii(cloud.points, shapes, monitor).radii;
  planned.stop_change = 0; // already applied to the radii
  planned.engine =
      chosenScaleEngine(cloud.points, places, planned.radii.back(), planned);
  announceMultiScale(cloud.points, places, planned, frame);
  const MultiScaleShapes scales =
      multiScaleShapes(cloud.points, places, planned, {}, monitor);
  for (const MultiScaleShape& shape : scales.shapes) {
    profile.chosen.push_back(static_cast<double>(shape.optimal_radius));
    profile.sums.push_back(static_cast<double>(shape.linearity_sum));
  }
  profile.radii =
      shapes.radii.empty() ? fineRadii(scales.radii, settings.rows) : scales.radii;
  profile.graphs = graphsAt(cloud.points, places, shapes, profile.radii, monitor);
  return drawShapeProfile(profile,
                          settings.colors,
                          static_cast<int>(settings.width),
                          static_cast<int>(settings.height));
}

Canvas
pictureOfPoint(const io::Cloud& cloud,
               const PictureSettings& settings,
               const MultiScaleSettings& shapes,
               const std::string& file,
               Frame& frame)
{
  constexpr unsigned fine = 160;
  if (settings.point.empty())
    throw std::runtime_error(
        "graphs need their point: give --point x,y,z or its number");
  const Point point = cloud.points[namedPoint(cloud, settings.point, file)];
  PointGraphs picture;
  picture.title = settings.title.empty()
                      ? "Shape over scales at " + worldText(cloud, point)
                      : settings.title;
  picture.radii = multiScaleRadii(cloud.points, shapes, &frame.monitor).radii;
  picture.graph =
      graphsAt(cloud.points, {point}, shapes, picture.radii, &frame.monitor).front();
  picture.fine_radii = fineRadii(picture.radii, fine);
  picture.fine_graph =
      graphsAt(cloud.points, {point}, shapes, picture.fine_radii, &frame.monitor)
          .front();
  std::vector<double> linearity;
  std::vector<std::uint32_t> neighbors;
  for (const ScaleShape& shape : picture.graph) {
    linearity.push_back(static_cast<double>(shape.linearity));
    neighbors.push_back(shape.neighbors);
  }
  picture.analysis =
      readLinearityGraph(linearity, neighbors, picture.radii, shapes.graph);
  if (picture.analysis.scale() != LinearityGraph::none)
    picture.around = graphsAround(cloud.points,
                                  point,
                                  picture.radii[picture.analysis.scale()],
                                  shapes,
                                  picture.fine_radii,
                                  &frame.monitor);
  return drawPointGraphs(picture,
                         settings.colors,
                         static_cast<int>(settings.width),
                         static_cast<int>(settings.height));
}

} // namespace linelet::apps
