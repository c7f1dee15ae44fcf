// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <linelet/features/tensor_estimation.h>
#include <linelet/features/tensor_record.h>
#include <linelet/search/kd_tree.h>
#include <linelet/search/scale_unit.h>

#include "cloud_files.h"
#include "commands.h"
#include "device_engine.h"
#include "fragment_parts.h"
#include "fragment_run.h"
#include "frame.h"
#include "options.h"
#include "scale_cost.h"
#include "search_choice.h"
#include "tensor_features.h"

namespace linelet::apps {

namespace {

using Records = std::vector<PointDistributionTensor>;

/** \brief Fields of the cloud that size the neighborhoods point by point. */
struct SizeFields {
  std::string radius, knn; // names; empty: none

  const std::string&
  name() const
  {
    return radius.empty() ? knn : radius;
  }
};

/** \brief Sizes of neighborhoods from the values of \a fields, where there are any. */
NeighborhoodSizes
sizesFrom(const std::vector<double>& values, const SizeFields& fields)
{
  NeighborhoodSizes sizes;
  if (!fields.radius.empty())
    sizes.radii = values;
  if (!fields.knn.empty())
    for (const double k : values)
      sizes.counts.push_back(k >= 1 && k < 4e9 ? static_cast<unsigned>(k) : 0);
  return sizes;
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

/** \brief Who finds the neighbors, as asked for and then as it ran. */
struct Finder {
  EngineOption engine = EngineOption::Auto;
  SearchOption search = SearchOption::Auto;
  std::string device;

  /** \brief The engine, or the search of PCL that stood in its place. */
  std::string
  name() const
  {
    return std::string(isOfPcl(search) ? nameOf(search) : nameOf(engine));
  }
};

/** \brief Makes of --search what it says about the engine. */
void
settle(Finder& finder)
{
  if (finder.search == SearchOption::Auto)
    return;
  if (finder.engine != EngineOption::Auto)
    throw std::runtime_error("--search " + std::string(nameOf(finder.search)) +
                             " and --engine " + std::string(nameOf(finder.engine)) +
                             " both say who finds the neighbors; give one of them");
  finder.engine =
      finder.search == SearchOption::Grid ? EngineOption::Grid : EngineOption::Tree;
}

Records
run(const Points& points,
    const Points& queries,
    TensorSettings settings,
    const Finder& finder,
    const NeighborhoodSizes& sizes,
    Frame& frame)
{
  if (isOfPcl(finder.search))
    return estimateWithPcl(
        finder.search, points, queries, settings, sizes, &frame.monitor);
  settings.engine = finder.engine == EngineOption::Grid ? Engine::Grid : Engine::Tree;
  return finder.engine == EngineOption::OpenCL
             ? estimateOnDevice(finder.device, points, queries, settings, sizes, frame)
             : estimateTensors(points, queries, settings, sizes, &frame.monitor);
}

/** \brief Says of long work beforehand how long it will take: of all that may be, by
 * the number of neighbors, measured on a few points. */
void
announceTensors(const Points& points,
                const TensorSettings& settings,
                const Finder& finder,
                const NeighborhoodSizes& sizes,
                Frame& frame)
{
  constexpr double most_pairs = 1e9;
  const EngineWork work = engineWork(points, points, settings, sizes);
  if (work.neighbors * static_cast<double>(work.queries) < most_pairs)
    return;
  const bool grid = finder.engine != EngineOption::Tree && !work.nearest;
  const ScaleCost cost =
      measuredCost(points, grid ? 3200 : 160, [&](const Indices& chosen) {
        Points queries;
        NeighborhoodSizes some;
        for (const Index i : chosen) {
          queries.push_back(points[i]);
          if (!sizes.radii.empty())
            some.radii.push_back(sizes.radii[i]);
          if (!sizes.counts.empty())
            some.counts.push_back(sizes.counts[i]);
        }
        double neighbors = 0;
        for (const auto& record : run(points, queries, settings, finder, some, frame))
          neighbors += record.neighbors;
        return neighbors;
      });
  announce(
      cost, points.size(), "mean of some", work.nearest ? "--knn" : "--radius", frame);
}

/** \brief Runs the engine asked for. EngineOption::Auto becomes the one that ran; a
 * device that it chose and that fails is no reason to give up. */
Records
estimate(const Points& points,
         TensorSettings& settings,
         Finder& finder,
         const NeighborhoodSizes& sizes,
         Frame& frame)
{
  // Sizes that make no sense are refused before anything is made of them.
  validate(settings, sizes, points.size());
  EngineOption& engine = finder.engine;
  const bool automatic = engine == EngineOption::Auto;
  if (automatic) {
    const EngineWork work = engineWork(points, points, settings, sizes);
    engine = gpuIsCheapest(finder.device, work, settings.centroid)
                 ? EngineOption::OpenCL
             : cheapestEngine(work) == Engine::Grid ? EngineOption::Grid
                                                    : EngineOption::Tree;
  }
  try {
    announceTensors(points, settings, finder, sizes, frame);
    return run(points, points, settings, finder, sizes, frame);
  }
  catch (const Canceled&) {
    throw;
  }
  catch (const std::runtime_error& error) {
    if (!automatic || engine != EngineOption::OpenCL)
      throw;
    frame.warn(std::string(error.what()) + "; the engine grid runs instead");
  }
  engine = EngineOption::Grid;
  return run(points, points, settings, finder, sizes, frame);
}

/** \brief How far around the box of \a points their nearest points may be: no farther
 * than where the points alone have as many. */
double
nearestMargin(const Points& points,
              const TensorSettings& settings,
              const NeighborhoodSizes& sizes)
{
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  const KdTree tree(points);
  Point low = Point::Constant(everywhere), high = -low;
  for (const Point& point : points)
    if (point.allFinite()) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  double margin = 0;
  Indices found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      continue;
    const std::size_t k = settings.k > 0 ? settings.k : sizes.counts[i];
    const double radius = tree.nearest(points[i], k, found);
    if (found.size() < k)
      return everywhere;
    const double depth =
        std::min((points[i] - low).minCoeff(), (high - points[i]).minCoeff());
    margin = std::max(margin, radius - depth);
  }
  return margin * (1 + 1e-9); // a point at the very distance counts
}

/** \brief The records of the points of file \a number, whose neighbors may be in other
 * files. */
Records
estimateAmongOthers(CloudInput& input,
                    std::size_t number,
                    const io::Cloud& cloud,
                    const io::UsablePoints& usable,
                    TensorSettings& settings,
                    Finder& finder,
                    const SizeFields& fields,
                    Frame& frame)
{
  std::vector<double> values;
  if (!fields.name().empty())
    values = valuesOf(cloud, fields.name(), input.files()[number]);
  const NeighborhoodSizes own = sizesFrom(values, fields);
  if (input.files().size() == 1)
    return estimate(usable.points(), settings, finder, own, frame);

  validate(settings, own, cloud.points.size());
  const bool nearest = settings.k > 0 || !own.counts.empty();
  const double margin = nearest ? nearestMargin(usable.points(), settings, own)
                                : tensorMargin(settings, own);
  const CloudInput::Surroundings all =
      input.surroundings(number, cloud, usable, margin, fields.name());
  const NeighborhoodSizes sizes = sizesFrom(all.values, fields);
  if (finder.engine == EngineOption::Auto) {
    // The one that all files together would take, on the processor.
    EngineWork work = engineWork(all.points, all.points, settings, sizes);
    work.points = work.queries = 0;
    for (const io::FileSummary& file : input.summaries())
      work.points = work.queries += file.points;
    finder.engine =
        cheapestEngine(work) == Engine::Grid ? EngineOption::Grid : EngineOption::Tree;
  }
  announceTensors(all.points, settings, finder, sizes, frame);
  if (finder.engine == EngineOption::OpenCL || isOfPcl(finder.search)) {
    const Records records = run(all.points, all.points, settings, finder, sizes, frame);
    return {records.begin() + static_cast<std::ptrdiff_t>(all.piece.begin),
            records.begin() + static_cast<std::ptrdiff_t>(all.piece.end)};
  }
  settings.engine = finder.engine == EngineOption::Grid ? Engine::Grid : Engine::Tree;
  return pieceTensors(all.points, all.piece, settings, sizes, &frame.monitor);
}

std::string
describeSize(const TensorSettings& settings, const SizeFields& fields)
{
  char text[64];
  if (!fields.radius.empty())
    return "radius from field " + fields.radius;
  if (!fields.knn.empty())
    return "number of nearest points from field " + fields.knn;
  if (settings.k > 0)
    return std::to_string(settings.k) + " nearest points";
  std::snprintf(text, sizeof(text), "radius %.6g", settings.radius);
  return text;
}

/** \brief What the records of a cloud come to. */
struct Tally {
  std::size_t points = 0;
  std::size_t left_out = 0;  ///< of them, which take no part
  std::size_t unknown = 0;   ///< of the others, without a shape
  double mean_neighbors = 0; ///< of the others

  void
  add(const Tally& more)
  {
    const auto before = static_cast<double>(points - left_out);
    const auto behind = static_cast<double>(more.points - more.left_out);
    if (before + behind > 0)
      mean_neighbors =
          (mean_neighbors * before + more.mean_neighbors * behind) / (before + behind);
    points += more.points;
    left_out += more.left_out;
    unknown += more.unknown;
  }
};

Tally
tallyOf(const Records& records, std::size_t left_out)
{
  Tally tally;
  tally.points = records.size();
  tally.left_out = left_out;
  double neighbors = 0;
  for (const PointDistributionTensor& record : records) {
    tally.unknown += std::isnan(record.linearity) ? 1 : 0;
    neighbors += record.neighbors;
  }
  tally.unknown -= left_out;
  if (tally.points > left_out)
    tally.mean_neighbors = neighbors / static_cast<double>(tally.points - left_out);
  return tally;
}

/** \brief Says how many points have no shape; where they are many, a radius that would
 * give them one. */
void
printUnknown(const Tally& tally, double scale_unit, const Points& points)
{
  if (tally.unknown == 0)
    return;
  std::printf("%zu points have no shape: too few neighbors, or all in one place\n",
              tally.unknown);
  // One point in a hundred is no reason for another radius.
  if (tally.unknown * 100 <= tally.points - tally.left_out)
    return;
  if (std::isnan(scale_unit))
    scale_unit = scaleUnit(points);
  if (scale_unit > 0)
    std::printf("try --radius %.3g: three times the scale unit of this cloud\n",
                radiusFor(scale_unit));
}

void
summarize(nlohmann::ordered_json& summary,
          const Tally& tally,
          const TensorSettings& settings,
          const Finder& finder,
          const SizeFields& fields)
{
  summary["points"] = tally.points;
  if (settings.radius > 0)
    summary["radius"] = settings.radius;
  if (settings.k > 0)
    summary["knn"] = settings.k;
  if (!fields.radius.empty())
    summary["radius_field"] = fields.radius;
  if (!fields.knn.empty())
    summary["knn_field"] = fields.knn;
  summary["weight"] = settings.weighting.name();
  summary["centroid"] = nameOf(settings.centroid);
  summary["engine"] = finder.name();
  summary["mean_neighbors"] = tally.mean_neighbors;
  summary["unknown"] = tally.unknown;
}

/** \brief The command, with its options read. */
class TensorJob : public FragmentJob {
public:
  explicit TensorJob(const std::vector<std::string>& arguments);

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
  ghost() override;
  double
  bytesPerPoint(bool in_fragments) const override;
  std::map<std::string, double>
  compute(const fragments::Plan& plan,
          const fragments::Fragment& fragment,
          const std::string& result,
          ProgressMonitor* monitor) override;
  std::vector<std::size_t>
  needs(const fragments::Plan& plan, std::size_t number) override;
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
  Frame frame_{
      "tensor",
      "Measures the shape of every point's neighborhood: tensor, eigenvalues, "
      "major direction, normal, linearity, planarity, sphericity and number of "
      "neighbors, added to the attributes of the input. Without --radius, --knn "
      "or a field the radius is chosen: three times the scale unit D. Points flagged "
      "as withheld take no part and have no shape."};
  TensorSettings settings_;
  Finder finder_;
  SizeFields fields_;
  FeatureList features_{"shape"};
  FragmentOptions fragments_;
  CloudInput input_{frame_};
  CloudOutput output_{frame_};
};

TensorJob::TensorJob(const std::vector<std::string>& arguments)
{
  const OptionAdder add(frame_.app);
  // The tool knows one engine more than the settings do.
  describe(settings_, [&](const char* name, auto& value, const char* help) {
    if constexpr (std::is_same_v<decltype(value), Engine&>)
      add(name, finder_.engine, help);
    else
      add(name, value, help);
  });
  add("features",
      features_,
      "attributes to write: shape (tensor, eigenvalues, directions, shape factors, "
      "neighbors), all, or a list of names, with verticality, omnivariance, "
      "eigenentropy, "
      "surface_variation");
  add("radius-field", fields_.radius, "attribute that holds the radius of every point");
  add("knn-field",
      fields_.knn,
      "attribute that holds the number of nearest points of every point");
  add("search",
      finder_.search,
      "search that finds the neighbors, instead of --engine: linelet's kd-tree or "
      "grid, "
      "or PCL's searches; all find the same");
  add("device",
      finder_.device,
      "OpenCL device by number or part of its name; linelet devices lists them");
  addOptions(frame_.app, fragments_);
  frame_.parse(arguments);
  settings_.threads = frame_.threads;
  settle(finder_);
}

int
TensorJob::runWhole()
{
  output_.check(input_);
  Tally total;
  double scale_unit = std::nan("");
  std::size_t withheld = 0, ignored = 0;
  for (std::size_t i = 0; i < input_.files().size(); ++i) {
    io::Cloud cloud = input_.read(i);
    const io::UsablePoints usable = input_.usable(cloud);
    if (settings_.radius == 0 && settings_.k == 0 && fields_.radius.empty() &&
        fields_.knn.empty()) {
      scale_unit = scaleUnit(usable.points(), 1024, 1, frame_.threads);
      frame_.summary["scale_unit"] = scale_unit;
      settings_.radius = chooseRadius(scale_unit, input_.files()[i]);
    }
    const Records records = estimateAmongOthers(
        input_, i, cloud, usable, settings_, finder_, fields_, frame_);
    frame_.lap("tensor");
    addFeatures(cloud, records, features_);
    const std::string path = output_.pathFor(input_, i);
    output_.write(cloud, path);

    const Tally tally = tallyOf(records, usable.leftOut());
    std::printf("%s: %zu points, %s, %.1f neighbors on average, %s %s\n",
                path.c_str(),
                tally.points,
                describeSize(settings_, fields_).c_str(),
                tally.mean_neighbors,
                isOfPcl(finder_.search) ? "search" : "engine",
                finder_.name().c_str());
    printUnknown(tally, scale_unit, usable.points());
    total.add(tally);
    withheld += usable.withheld();
    ignored += usable.ignored();
  }
  summarize(frame_.summary, total, settings_, finder_, fields_);
  frame_.summary["withheld"] = withheld;
  frame_.summary["ignored"] = ignored;
  return frame_.finish();
}

void
TensorJob::check()
{
  if (!isRadius(settings_.radius) || settings_.k > 0 || !fields_.radius.empty() ||
      !fields_.knn.empty())
    throw std::runtime_error(
        "fragments know the neighbors within --radius; give that, or more --memory");
  validate(settings_, {}, 0);
  if (finder_.engine == EngineOption::Auto)
    finder_.engine = EngineOption::Grid; // what it is for clouds of any size
  checkPartsOutput(input_, output_);
}

double
TensorJob::ghost()
{
  return tensorMargin(settings_);
}

double
TensorJob::bytesPerPoint(bool in_fragments) const
{
  // Cloud, usable points, engine, records, and these as columns; or two fragments,
  // engine and records.
  return in_fragments ? 200 : 300;
}

std::map<std::string, double>
TensorJob::compute(const fragments::Plan& plan,
                   const fragments::Fragment& fragment,
                   const std::string& result,
                   ProgressMonitor* monitor)
{
  TensorSettings settings = settings_;
  settings.threads = frame_.threads; // of this worker
  settings.engine = finder_.engine == EngineOption::Grid ? Engine::Grid : Engine::Tree;
  const Points& points = fragment.points;
  Records records;
  if (finder_.engine == EngineOption::OpenCL || isOfPcl(finder_.search))
    records = run(points, points, settings, finder_, {}, frame_);
  else {
    records.resize(points.size());
    const CloudPiece piece = pieceOf(plan, fragment);
    const Records some = pieceTensors(points, piece, settings, {}, monitor);
    std::copy(some.begin(),
              some.end(),
              records.begin() + static_cast<std::ptrdiff_t>(piece.begin));
  }
  fragments::writeRecords(result, fragment, records.data(), sizeof(records[0]));
  return {};
}

std::vector<std::size_t>
TensorJob::needs(const fragments::Plan& plan, std::size_t number)
{
  return fragmentsOfInput(plan, number);
}

std::map<std::string, double>
TensorJob::write(const fragments::Plan& plan,
                 const std::string& folder,
                 std::size_t number,
                 const std::vector<bool>& usable,
                 ProgressMonitor* monitor)
{
  Tally total;
  const auto add = [&](io::Cloud& cloud, const Records& records, std::size_t left_out) {
    total.add(tallyOf(records, left_out));
    addFeatures(cloud, records, features_);
  };
  writeParts<PointDistributionTensor>({plan, folder, number, usable},
                                      input_,
                                      output_,
                                      unknownTensor(0),
                                      add,
                                      frame_,
                                      monitor);
  return {{"points", total.points},
          {"left_out", total.left_out},
          {"unknown", total.unknown},
          {"neighbors",
           total.mean_neighbors * static_cast<double>(total.points - total.left_out)}};
}

void
TensorJob::report(const std::map<std::string, double>& figures)
{
  Tally total;
  total.points = static_cast<std::size_t>(figures.at("points"));
  total.left_out = static_cast<std::size_t>(figures.at("left_out"));
  total.unknown = static_cast<std::size_t>(figures.at("unknown"));
  if (total.points > total.left_out)
    total.mean_neighbors =
        figures.at("neighbors") / static_cast<double>(total.points - total.left_out);
  std::printf("%s: %zu points, %s, %.1f neighbors on average, %s %s\n",
              output_.path().c_str(),
              total.points,
              describeSize(settings_, fields_).c_str(),
              total.mean_neighbors,
              isOfPcl(finder_.search) ? "search" : "engine",
              finder_.name().c_str());
  if (total.unknown > 0)
    std::printf("%zu points have no shape: too few neighbors, or all in one place\n",
                total.unknown);
  summarize(frame_.summary, total, settings_, finder_, fields_);
  frame_.summary["left_out"] = total.left_out;
}

} // namespace

std::unique_ptr<FragmentJob>
makeTensorJob(const std::vector<std::string>& arguments)
{
  return std::make_unique<TensorJob>(arguments);
}

int
runTensor(const std::vector<std::string>& arguments)
{
  TensorJob job(arguments);
  return runJob(job, "tensor", arguments);
}

} // namespace linelet::apps
