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
#include "fragment_parts.h"
#include "fragment_run.h"
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

/** \brief The command, with its options read. */
class MultiscaleJob : public FragmentJob {
public:
  explicit MultiscaleJob(const std::vector<std::string>& arguments);

  Frame&
  frame() override
  {
    return frame_;
  }
  CloudInput&
  input() override
  {
    return input_;
  }
  const FragmentOptions&
  options() const override
  {
    return fragments_;
  }
  const std::string&
  place() const override
  {
    return output_.path();
  }
  void
  check() override;
  double
  ghost() override
  {
    return multiScaleMargin(settings_.radii);
  }
  double
  bytesPerPoint(bool in_fragments) const override
  {
    // Two fragments, engine and shapes; or cloud, usable points, engine, shapes, and
    // these as columns.
    return in_fragments ? 220 : 300;
  }
  std::map<std::string, double>
  compute(const fragments::Plan& plan,
          const fragments::Fragment& fragment,
          const std::string& result,
          ProgressMonitor* monitor) override;
  std::vector<std::size_t>
  needs(const fragments::Plan& plan, std::size_t number) override
  {
    return fragmentsOfInput(plan, number);
  }
  std::map<std::string, double>
  write(const fragments::Plan& plan,
        const std::string& folder,
        std::size_t number,
        const std::vector<bool>& usable,
        ProgressMonitor* monitor) override;
  void
  report(const std::map<std::string, double>& figures) override;
  int
  runWhole() override;

private:
  bool
  looksAtOneCloud() const
  {
    return !graphs_.empty() || shift_.radius != 0 || settings_.stop_change > 0 ||
           fourth_order_ != FourthOrderOption::None;
  }

  Frame frame_{
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
      "--scale-unit say them; neighbors are found across their borders."};
  MultiScaleSettings settings_;
  CentroidShiftSettings shift_;
  std::string graphs_;
  FourthOrderOption fourth_order_ = FourthOrderOption::None;
  FragmentOptions fragments_;
  CloudInput input_{frame_};
  CloudOutput output_{frame_};
};

MultiscaleJob::MultiscaleJob(const std::vector<std::string>& arguments)
{
  addOptions(frame_.app, settings_);
  const OptionAdder add(frame_.app);
  add("graphs", graphs_, "CSV file for the graphs of every point");
  frame_.writes(graphs_);
  add("fourth-order",
      fourth_order_,
      "also write the fourth-order tensor over all radii, weighted by this factor, and "
      "its major eigentensor");
  describe(shift_, "centroid-shift", "shift-", add);
  addOptions(frame_.app, fragments_);
  frame_.parse(arguments);
  settings_.threads = shift_.threads = frame_.threads;
}

int
MultiscaleJob::runWhole()
{
  const bool several = input_.files().size() > 1;
  if (several && looksAtOneCloud())
    throw std::runtime_error("--graphs, --centroid-shift, --fourth-order and "
                             "--stop-change look at one cloud; give one input, or "
                             "leave them out");
  output_.check(input_);
  if (!graphs_.empty())
    io::checkWritable(graphs_);
  if (several)
    runSeveral(input_, output_, settings_, frame_);
  else
    runOne(input_, output_, settings_, shift_, graphs_, fourth_order_, frame_);
  return frame_.finish();
}

void
MultiscaleJob::check()
{
  if (looksAtOneCloud())
    throw std::runtime_error("--graphs, --centroid-shift, --fourth-order and "
                             "--stop-change look at one cloud; leave them out, or give "
                             "more --memory");
  if (settings_.radii.empty() && !(settings_.scale_unit > 0))
    throw std::runtime_error("fragments do not tell the scale unit of the whole cloud; "
                             "give --radii or --scale-unit, or more --memory");
  settings_.radii = multiScaleRadii(Points(), settings_).radii;
  if (settings_.engine == ScaleEngine::Auto)
    settings_.engine = ScaleEngine::Grid; // what it is for large clouds
  checkPartsOutput(input_, output_);
}

std::map<std::string, double>
MultiscaleJob::compute(const fragments::Plan& plan,
                       const fragments::Fragment& fragment,
                       const std::string& result,
                       ProgressMonitor* monitor)
{
  std::vector<MultiScaleShape> shapes(fragment.points.size());
  settings_.threads = frame_.threads; // of this worker
  const CloudPiece piece = pieceOf(plan, fragment);
  const auto first = shapes.begin() + static_cast<std::ptrdiff_t>(piece.begin);
  const auto measured = [&](const MultiScaleSettings& settings) {
    const auto some = pieceShapes(fragment.points, piece, settings, monitor).shapes;
    std::copy(some.begin(), some.end(), first);
  };
  double sum = 0, count = 0;
  const auto addNoise = [&] {
    for (std::size_t i = 0; i < shapes.size(); ++i)
      if (fragment.core[i] && !std::isnan(shapes[i].min_sphericity)) {
        sum += static_cast<double>(shapes[i].min_sphericity);
        ++count;
      }
  };
  if (settings_.centroid != Centroid::QueryPoint && piece.end > piece.begin) {
    measured(aboutPoints(settings_));
    addNoise();
  }
  if (piece.end > piece.begin)
    measured(settings_);
  if (settings_.centroid == Centroid::QueryPoint)
    addNoise();
  fragments::writeRecords(result, fragment, shapes.data(), sizeof(shapes[0]));
  return {{"sphericity", sum}, {"spheres", count}};
}

std::map<std::string, double>
MultiscaleJob::write(const fragments::Plan& plan,
                     const std::string& folder,
                     std::size_t number,
                     const std::vector<bool>& usable,
                     ProgressMonitor* monitor)
{
  double points = 0, unknown = 0, left_out = 0;
  const auto add = [&](io::Cloud& cloud,
                       const std::vector<MultiScaleShape>& shapes,
                       std::size_t without) {
    points += static_cast<double>(shapes.size());
    left_out += static_cast<double>(without);
    for (const MultiScaleShape& shape : shapes)
      unknown += shape.scale < 0 ? 1 : 0;
    addColumns(cloud, shapes);
  };
  // What a point that is not finite gets.
  const Points nowhere = {Point::Constant(std::nan(""))};
  MultiScaleSettings settings = settings_;
  settings.engine = ScaleEngine::Sweep;
  const auto none = multiScaleShapes(nowhere, nowhere, settings).shapes;
  writeParts<MultiScaleShape>({plan, folder, number, usable},
                              input_,
                              output_,
                              none.front(),
                              add,
                              frame_,
                              monitor);
  return {{"points", points}, {"left_out", left_out}, {"unknown", unknown - left_out}};
}

void
MultiscaleJob::report(const std::map<std::string, double>& figures)
{
  const double rate = 3.15 * figures.at("sphericity") / figures.at("spheres");
  std::printf("%s: %.0f points, %zu radii from %.6g to %.6g\nnoise rate %.4f\n",
              output_.path().c_str(),
              figures.at("points"),
              settings_.radii.size(),
              settings_.radii.front(),
              settings_.radii.back(),
              rate);
  if (figures.at("unknown") > 0)
    std::printf("%.0f points have no optimal scale: fewer than %u points within the "
                "largest radius\n",
                figures.at("unknown"),
                settings_.graph.min_neighbors);
  frame_.summary["points"] = figures.at("points");
  frame_.summary["left_out"] = figures.at("left_out");
  frame_.summary["radii"] = settings_.radii;
  frame_.summary["engine"] = nameOf(settings_.engine);
  frame_.summary["noise_rate"] = rate;
  frame_.summary["unknown"] = figures.at("unknown");
}

} // namespace

std::unique_ptr<FragmentJob>
makeMultiscaleJob(const std::vector<std::string>& arguments)
{
  return std::make_unique<MultiscaleJob>(arguments);
}

int
runMultiscale(const std::vector<std::string>& arguments)
{
  MultiscaleJob job(arguments);
  return runJob(job, "multiscale", arguments);
}

} // namespace linelet::apps
