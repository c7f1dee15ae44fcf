// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerlines_merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include <linelet/fragments/records.h>
#include <linelet/powerline/metric_frame.h>

#include "powerlines_part.h"

namespace linelet::apps {

using powerline::Ground;
using powerline::PowerLineNetwork;

namespace {

constexpr double most_cells = 1 << 27; // of the terrain, half a gigabyte
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/** An empty raster with cells of that side over all inputs. */
Ground
rasterOver(const fragments::Plan& plan,
           const powerline::MetricFrame& frame,
           double cell)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  Point low = Point::Constant(none), high = -low;
  for (const fragments::PlannedInput& input : plan.inputs) {
    if (!(input.extent.points > 0))
      continue;
    const fragments::Area& area = input.extent.area;
    for (const auto& corner : {area.low, area.high}) {
      const Point p =
          frame.meters(Point(corner[0], corner[1], plan.shift.z()) - plan.shift);
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  Ground ground;
  if (!(low.x() <= high.x()))
    return ground;
  // Cell centers at multiples of the cell size, as in the fragments.
  const auto first = [&](int axis) { return std::floor(low[axis] / cell + 0.5); };
  const auto cells = [&](int axis) {
    return std::floor(high[axis] / cell + 0.5) - first(axis) + 1;
  };
  while (cells(0) * cells(1) > most_cells)
    cell *= 2;
  ground.cell = cell;
  ground.x = first(0) * cell;
  ground.y = first(1) * cell;
  ground.columns = static_cast<int>(cells(0));
  ground.rows = static_cast<int>(cells(1));
  ground.heights.assign(static_cast<std::size_t>(ground.columns) *
                            static_cast<std::size_t>(ground.rows),
                        unknown);
  return ground;
}

/** The number of a point among all inputs. */
struct Place {
  std::uint32_t input, point;

  bool
  operator<(const Place& other) const
  {
    return std::tie(input, point) < std::tie(other.input, other.point);
  }
};

/** The number of points before each input. */
std::vector<std::uint32_t>
ranksOf(std::vector<Place> places)
{
  std::vector<std::uint32_t> order(places.size()), ranks(places.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return places[a] < places[b];
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    ranks[order[k]] = static_cast<std::uint32_t>(k);
  return ranks;
}

} // namespace

PowerlinesMerge::PowerlinesMerge(const fragments::Plan& plan,
                                 std::string folder,
                                 std::vector<bool> usable,
                                 const std::string& wkt)
    : plan_(plan), folder_(std::move(folder)), usable_(std::move(usable))
{
  pictures_.shift = plan.shift;
  pictures_.wkt = wkt;
  const powerline::MetricFrame frame(pictures_);
  std::vector<powerline::NetworkPart> parts(usable_.size());
  std::vector<Place> places;
  std::size_t shown = 0;
  for (std::size_t f = 0; f < usable_.size(); ++f) {
    if (usable_[f]) {
      PowerlinesPart part = loadPart(fragments::resultPath(folder_, f));
      parts[f] = std::move(part.network);
      shown += part.picture.size();
      for (std::size_t k = 0; k < part.surroundings.place.size(); ++k)
        places.push_back({part.surroundings.input[k], part.surroundings.place[k]});
    }
    parts[f].owns = [&plan, frame, f](double x, double y) {
      const Point world = frame.world({x, y, 0});
      return plan.tiling.owner(world.x(), world.y()) == f;
    };
  }
  network_ = powerline::mergeParts(parts, ids_);
  parts.clear();
  // Read again, so that only one fragment's points are in memory twice.
  const std::vector<std::uint32_t> ranks = ranksOf(std::move(places));
  surroundings_.points.resize(ranks.size());
  surroundings_.kinds.resize(ranks.size());
  surroundings_.support.resize(ranks.size());
  pictures_.points.reserve(shown);
  const std::uint32_t* next = ranks.data();
  for (std::size_t f = 0; f < usable_.size(); ++f)
    if (usable_[f]) {
      const PowerlinesPart part = loadPart(fragments::resultPath(folder_, f));
      addPictures(f, part.picture);
      addSurroundings(part.surroundings, ids_[f], next);
      next += part.surroundings.place.size();
    }
  joinTerrain();
}

void
PowerlinesMerge::addPictures(std::size_t fragment,
                             const std::vector<PicturePoint>& points)
{
  for (const PicturePoint& point : points) {
    const int wire = ids_[fragment].wires.at(static_cast<std::size_t>(point.wire));
    pictures_.points.emplace_back(point.x, point.y, point.z);
    network_.wire_id.push_back(wire);
    network_.span_id.push_back(
        wire > 0 ? network_.wires[static_cast<std::size_t>(wire) - 1].span : 0);
    network_.classes.push_back(point.number_of_class);
    network_.wire_distance.push_back(unknown);
    network_.is_unexplained.push_back(point.unexplained);
  }
}

void
PowerlinesMerge::addSurroundings(const OwnSurroundings& own,
                                 const powerline::PartIds& ids,
                                 const std::uint32_t* ranks)
{
  for (std::size_t k = 0; k < own.place.size(); ++k) {
    surroundings_.points[ranks[k]] = own.all.points[k];
    surroundings_.kinds[ranks[k]] = own.all.kinds[k];
    surroundings_.support[ranks[k]] =
        ids.supports.at(static_cast<std::size_t>(own.all.support[k]));
  }
}

void
PowerlinesMerge::joinTerrain()
{
  const powerline::MetricFrame frame(pictures_);
  Ground& all = network_.ground;
  bool any = false;
  for (std::size_t f = 0; f < usable_.size(); ++f) {
    if (!usable_[f])
      continue;
    const Ground part = loadGround(fragments::resultPath(folder_, f));
    if (part.heights.empty())
      continue;
    if (all.heights.empty())
      all = rasterOver(plan_, frame, part.cell);
    any = true;
    const auto range =
        [&](double from, int count, double cell, double start, int most) {
          const double first = (from - cell / 2 - start) / all.cell;
          const double last = (from + (count - 0.5) * cell - start) / all.cell;
          return std::pair(
              static_cast<int>(std::clamp(std::floor(first), 0.0, most - 1.0)),
              static_cast<int>(std::clamp(std::ceil(last), 0.0, most - 1.0)));
        };
    const auto columns = range(part.x, part.columns, part.cell, all.x, all.columns);
    const auto rows = range(part.y, part.rows, part.cell, all.y, all.rows);
    for (int r = rows.first; r <= rows.second; ++r)
      for (int c = columns.first; c <= columns.second; ++c) {
        const double x = all.x + c * all.cell, y = all.y + r * all.cell;
        const Point world = frame.world({x, y, 0});
        if (plan_.tiling.owner(world.x(), world.y()) == f)
          all.heights[static_cast<std::size_t>(r) *
                          static_cast<std::size_t>(all.columns) +
                      static_cast<std::size_t>(c)] =
              static_cast<float>(part.heightAt(x, y));
      }
  }
  if (!any)
    all = {};
}

void
PowerlinesMerge::label(const io::Cloud& cloud,
                       const std::vector<PointLabel>& labels,
                       PowerLineNetwork& found) const
{
  const powerline::MetricFrame frame(pictures_);
  const std::size_t count = labels.size();
  found.classes.resize(count);
  found.wire_id.assign(count, 0);
  found.span_id.assign(count, 0);
  found.wire_distance.assign(count, unknown);
  found.is_unexplained.resize(count);
  const Point offset = cloud.shift - plan_.shift;
  for (std::size_t i = 0; i < count; ++i) {
    const PointLabel& label = labels[i];
    found.classes[i] = label.number_of_class;
    found.is_unexplained[i] = label.unexplained;
    if (label.wire == 0)
      continue;
    const int id = ids_[label.fragment].wires.at(static_cast<std::size_t>(label.wire));
    if (id == 0) { // the owner did not find it
      found.classes[i] = powerline::unclassified;
      continue;
    }
    const powerline::Wire& wire = network_.wires[static_cast<std::size_t>(id) - 1];
    found.wire_id[i] = id;
    found.span_id[i] = wire.span;
    found.wire_distance[i] =
        static_cast<float>(wire.curve.distance(frame.meters(cloud.points[i] + offset)));
  }
}

CopiedPoints
PowerlinesMerge::writeClassified(const std::string& path,
                                 CloudInput& input,
                                 const powerline::ClassScheme& classes,
                                 std::vector<std::string>* warnings,
                                 ProgressMonitor* monitor) const
{
  io::ReadOptions options = input.readOptions();
  options.shift = plan_.shift;
  std::vector<std::string> files;
  for (const fragments::PlannedInput& planned : plan_.inputs)
    files.push_back(planned.path);
  std::optional<fragments::RecordStream> results;
  std::size_t last = files.size();
  const auto labelBlock =
      [&](std::size_t file, const io::Cloud& cloud, PowerLineNetwork& found) {
        if (file != last)
          results.emplace(plan_, folder_, file, sizeof(PointLabel), usable_);
        last = file;
        std::vector<PointLabel> labels(cloud.points.size());
        if (const io::Column* given = cloud.find("classification"))
          for (std::size_t k = 0; k < labels.size(); ++k) {
            const auto number = static_cast<std::uint8_t>(io::valueAt(*given, k));
            // For unused points, which no fragment owns.
            labels[k].number_of_class =
                number == powerline::wire_class || number == powerline::pylon_class
                    ? powerline::unclassified
                    : number;
          }
        results->next(labels.size(), labels.data());
        label(cloud, labels, found);
      };
  return copyClassified(path,
                        files,
                        options,
                        classes,
                        pictures_.wkt,
                        network_.wires,
                        labelBlock,
                        warnings,
                        monitor);
}

} // namespace linelet::apps
