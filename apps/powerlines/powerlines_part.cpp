// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerlines_part.h"

#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include <linelet/fragments/records.h>
#include <linelet/powerline/metric_frame.h>

#include "fragments/part_archive.h"

namespace linelet::apps {

using powerline::LooseWire;
using powerline::PowerLineNetwork;
using powerline::Wire;

namespace {

constexpr double around = 8;              // meters, shown in pictures of spans
constexpr std::size_t beside_wire = 8000; // such points per wire, besides its own

std::string
partPath(const std::string& result)
{
  return result + ".part";
}

std::string
groundPath(const std::string& result)
{
  return result + ".ground";
}

/** \brief Cells of the plan that wires cross. */
class WireCells {
public:
  explicit WireCells(const std::vector<Wire>& wires)
  {
    for (const Wire& wire : wires) {
      const int steps = static_cast<int>(wire.span_length / around) + 1;
      for (int k = 0; k <= steps; ++k) {
        const auto [x, y] =
            cell(wire.front + (wire.back - wire.front) * k / double(steps));
        for (int i = -1; i <= 1; ++i)
          for (int j = -1; j <= 1; ++j)
            cells_.insert({x + i, y + j});
      }
    }
  }

  bool
  hold(const Point& p) const
  {
    return cells_.count(cell(p)) > 0;
  }

private:
  using Cell = std::pair<std::int64_t, std::int64_t>;

  static Cell
  cell(const Point& p)
  {
    return {std::llround(p.x() / around), std::llround(p.y() / around)};
  }

  std::set<Cell> cells_;
};

/** \brief Keeps at most \a most of \a points, evenly chosen. */
void
thin(std::vector<PicturePoint>& points, std::size_t most)
{
  if (points.size() <= most)
    return;
  for (std::size_t k = 0; k < most; ++k)
    points[k] = points[k * points.size() / most];
  points.resize(most);
}

template <class Archive>
void
pass(Archive& archive, powerline::Clearance& c)
{
  archive.all(c.distance, c.wire, c.other);
}

template <class Archive>
void
pass(Archive& archive, Wire& w)
{
  archive.all(w.id, w.span, w.circuit, w.number);
  archive.all(w.curve.lowest, w.curve.a, w.curve.azimuth, w.curve.swing);
  archive.all(w.curve.from, w.curve.to, w.front, w.back);
  archive.all(w.front_support, w.back_support, w.conductors, w.points, w.rms);
  archive.all(w.length, w.span_length, w.sag, w.largest_gap, w.confidence);
  archive.all(w.reason);
  pass(archive, w.ground);
  pass(archive, w.vegetation);
}

template <class Archive>
void
pass(Archive& archive, LooseWire& loose)
{
  pass(archive, loose.wire);
  for (double& value : loose.course)
    archive.all(value);
  for (LooseWire::End& end : loose.ends)
    archive.all(end.place, end.partner, end.partner_end, end.support, end.fixed);
  archive.list(loose.points, [&](Point& p) { archive.all(p); });
}

template <class Archive>
void
pass(Archive& archive, powerline::Support& s)
{
  archive.all(s.id, s.kind, s.base, s.top, s.height, s.points, s.confidence);
}

template <class Archive>
void
pass(Archive& archive, powerline::Jumper& j)
{
  archive.all(j.id, j.support, j.from_wire, j.to_wire, j.length, j.sag, j.rms);
  archive.all(j.points);
  archive.list(j.course, [&](Point& p) { archive.all(p); });
}

template <class Archive>
void
pass(Archive& archive, powerline::InsulatorString& s)
{
  archive.all(s.id, s.kind, s.support, s.wire, s.jumper, s.structure, s.live);
  archive.all(s.length, s.points);
}

template <class Archive>
void
pass(Archive& archive, powerline::UnexplainedLine& line)
{
  archive.all(line.id, line.length, line.width, line.points);
  archive.list(line.course, [&](Point& p) { archive.all(p); });
}

template <class Archive>
void
pass(Archive& archive, PowerlinesPart& part)
{
  const auto each = [&](auto& one) { pass(archive, one); };
  const auto plain = [&](auto& one) { archive.all(one); };
  archive.list(part.network.wires, each);
  archive.list(part.network.supports, each);
  archive.list(part.network.jumpers, each);
  archive.list(part.network.insulators, each);
  archive.list(part.network.unexplained, each);
  OwnSurroundings& own = part.surroundings;
  archive.list(own.all.points, plain);
  archive.list(own.all.kinds, plain);
  archive.list(own.all.support, plain);
  archive.list(own.input, plain);
  archive.list(own.place, plain);
  archive.list(part.picture, plain);
}

template <class Archive>
void
pass(Archive& archive, powerline::Ground& ground)
{
  archive.all(ground.cell, ground.x, ground.y, ground.columns, ground.rows);
  archive.list(ground.heights, [&](float& height) { archive.all(height); });
}

} // namespace

std::vector<PicturePoint>
picturePoints(const fragments::Fragment& fragment,
              const io::Cloud& cloud,
              const PowerLineNetwork& network,
              std::size_t most)
{
  const powerline::MetricFrame frame(cloud);
  const WireCells cells(network.wires);
  std::vector<PicturePoint> lines, others;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!fragment.core[i])
      continue;
    const Point& p = cloud.points[i];
    const PicturePoint point{p.x(),
                             p.y(),
                             p.z(),
                             network.wire_id[i],
                             network.classes[i],
                             network.is_unexplained[i],
                             0};
    const std::uint8_t number = point.number_of_class;
    if (point.wire > 0 || number == powerline::wire_class ||
        number == powerline::pylon_class || number == powerline::connector_class)
      lines.push_back(point);
    else if (cells.hold(frame.meters(p)))
      others.push_back(point);
  }
  thin(others, beside_wire * (network.wires.size() + 1));
  if (most > 0) {
    thin(lines, most);
    thin(others, most - lines.size());
  }
  lines.insert(lines.end(), others.begin(), others.end());
  return lines;
}

OwnSurroundings
ownSurroundings(const fragments::Fragment& fragment,
                const io::Cloud& cloud,
                const powerline::Surroundings& found)
{
  const powerline::MetricFrame frame(cloud);
  OwnSurroundings own;
  std::size_t i = 0, section = 0;
  for (std::size_t k = 0; k < found.points.size(); ++k) {
    while (frame.meters(cloud.points[i]) != found.points[k])
      ++i; // they keep the order of the cloud
    const std::size_t place = i++;
    if (!fragment.core[place])
      continue;
    const auto& sections = fragment.sections;
    while (place >= sections[section].first + sections[section].count)
      ++section;
    own.all.points.push_back(found.points[k]);
    own.all.kinds.push_back(found.kinds[k]);
    own.all.support.push_back(found.support[k]);
    own.input.push_back(static_cast<std::uint32_t>(sections[section].input));
    own.place.push_back(fragment.places[place]);
  }
  return own;
}

void
savePart(const std::string& result,
         const fragments::Fragment& fragment,
         const PowerLineNetwork& network,
         PowerlinesPart part)
{
  std::error_code ignored; // writing the files reports it
  std::filesystem::create_directories(std::filesystem::path(result).parent_path(),
                                      ignored);
  std::vector<PointLabel> labels(network.classes.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i].fragment = static_cast<std::uint32_t>(fragment.number);
    labels[i].wire = network.wire_id[i];
    labels[i].number_of_class = network.classes[i];
    labels[i].unexplained = network.is_unexplained[i];
  }
  Saver text;
  pass(text, part);
  text.save(partPath(result));
  Saver terrain;
  powerline::Ground ground = network.ground;
  pass(terrain, ground);
  terrain.save(groundPath(result));
  fragments::writeRecords(result, fragment, labels.data(), sizeof(PointLabel));
}

PowerlinesPart
loadPart(const std::string& result)
{
  Loader loader(partPath(result));
  PowerlinesPart part;
  pass(loader, part);
  return part;
}

powerline::Ground
loadGround(const std::string& result)
{
  Loader loader(groundPath(result));
  powerline::Ground ground;
  pass(loader, ground);
  return ground;
}

} // namespace linelet::apps
