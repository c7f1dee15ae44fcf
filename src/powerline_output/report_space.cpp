// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "report_image.h"
#include "report_marks.h"

namespace linelet::powerline::report {

namespace {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t most_of_lines = 15000; ///< points of wires and supports
constexpr std::size_t most_of_others = 35000;
constexpr std::size_t most_still = 5000; ///< dots in the still picture

/** \brief How a point is drawn; indices into the palette of page/space.js. */
enum class Look : std::uint8_t { Ground, Low, Object, Tower, Wire, Insulator };

/** \brief The points to show, evenly thinned: those of lines, then the others. */
Indices
shownPoints(const Content& content)
{
  Indices lines, others;
  for (std::size_t i = 0; i < content.cloud.points.size(); ++i)
    if (content.point(i).allFinite()) {
      const std::uint8_t found = content.network.classes[i];
      (found == wire_class || found == pylon_class || found == connector_class ? lines
                                                                               : others)
          .push_back(static_cast<Index>(i));
    }
  Indices shown;
  const auto thin = [&](const Indices& all, std::size_t most) {
    const std::size_t kept = std::min(all.size(), most);
    for (std::size_t k = 0; k < kept; ++k)
      shown.push_back(all[k * all.size() / kept]);
  };
  thin(others, most_of_others);
  thin(lines, most_of_lines);
  return shown;
}

Look
lookOf(const Content& content, Index i)
{
  const std::uint8_t found = content.network.classes[i];
  if (found == wire_class)
    return Look::Wire;
  if (found == pylon_class)
    return Look::Tower;
  if (found == connector_class)
    return Look::Insulator;
  const Point p = content.point(i);
  const double height = p.z() - content.network.ground.heightAt(p.x(), p.y());
  return height > 2 ? Look::Object : height > 0.4 ? Look::Low : Look::Ground;
}

/** \brief The box around what is shown, and a cube around it with 16 bits per axis. */
struct SpaceFrame {
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  double step = 1; ///< meters

  void
  include(const Point& p)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }

  void
  close()
  {
    step = std::max((high - low).maxCoeff() / 65535, 1e-6);
  }

  void
  put(Bytes& out, const Point& p) const
  {
    for (int axis = 0; axis < 3; ++axis) {
      const auto place = static_cast<unsigned>(
          std::clamp(std::round((p[axis] - low[axis]) / step), 0.0, 65535.0));
      out.push_back(static_cast<std::uint8_t>(place & 0xff));
      out.push_back(static_cast<std::uint8_t>(place >> 8));
    }
  }

  Json
  local(const Point& p) const
  {
    Json xyz = Json::array();
    for (int axis = 0; axis < 3; ++axis)
      xyz.push_back(std::round((p[axis] - low[axis]) * 1000) / 1000);
    return xyz;
  }
};

/** \brief How a line is drawn; indices into the tints of page/space.js. */
enum class LineLook : std::uint8_t { Wire, Doubtful, Jumper };

/** \brief Wires and jumpers as runs of vertices: number, look, and positions, 16 bits
 * each. */
Bytes
lineBytes(const Content& content, const SpaceFrame& frame)
{
  Bytes out;
  const auto put = [&](const Points& line, LineLook look) {
    const auto count = static_cast<unsigned>(std::min<std::size_t>(line.size(), 65535));
    out.push_back(static_cast<std::uint8_t>(count & 0xff));
    out.push_back(static_cast<std::uint8_t>(count >> 8));
    out.push_back(static_cast<std::uint8_t>(look));
    out.push_back(0);
    for (unsigned k = 0; k < count; ++k)
      frame.put(out, line[k]);
  };
  for (const Wire& wire : content.network.wires)
    put(polyline(wire, 0.02),
        wire.reason.empty() ? LineLook::Wire : LineLook::Doubtful);
  for (const Jumper& jumper : content.network.jumpers)
    put(jumper.course, LineLook::Jumper);
  return out;
}

/** \brief The same view from the southwest and above, for browsers without WebGL 2. */
std::string
stillPicture(const Content& content, const SpaceFrame& frame, const Indices& shown)
{
  constexpr double width = 1060;
  const Point middle = (frame.low + frame.high) / 2;
  // Seen along azimuth 35 degrees, 30 degrees down.
  const double a = 35 * M_PI / 180, sine = 0.5, cosine = std::sqrt(0.75);
  const auto seen = [&](const Point& p) {
    const Point d = p - middle;
    const double across = d.x() * std::cos(a) - d.y() * std::sin(a);
    const double away = d.x() * std::sin(a) + d.y() * std::cos(a);
    return Eigen::Vector2d(across, -(away * sine + d.z() * cosine));
  };
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector2d at = seen({(corner & 1 ? frame.high : frame.low).x(),
                                     (corner & 2 ? frame.high : frame.low).y(),
                                     (corner & 4 ? frame.high : frame.low).z()});
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  const double scale = width / std::max(high.x() - low.x(), 1e-6);
  const double height = std::max(20.0, scale * (high.y() - low.y()));
  Markup page;
  page << "<svg class=\"still\" viewBox=\"0 0 " << width << " " << height
       << "\" role=\"img\" aria-label=\"The lines from the southwest\">\n";
  const auto put = [&](const Point& p) {
    const Eigen::Vector2d at = scale * (seen(p) - low);
    page << at.x() << " " << at.y();
  };
  const auto paint = [](Look look) {
    return look == Look::Insulator                     ? "insulator"
           : look == Look::Tower || look == Look::Wire ? "pylon"
                                                       : "other";
  };
  for (const std::string_view kind : {"other", "pylon", "insulator"}) {
    page << "<path class=\"dots " << std::string(kind) << "\" d=\"";
    const std::size_t stride = shown.size() / most_still + 1;
    for (std::size_t k = 0; k < shown.size(); k += stride) {
      if (paint(lookOf(content, shown[k])) != kind)
        continue;
      page << "M";
      put(content.point(shown[k]));
      page << "h0";
    }
    page << "\"/>\n";
  }
  const auto draw = [&](const Points& line) {
    const char* lead = "M";
    for (const Point& p : line) {
      page << lead;
      put(p);
      lead = "L";
    }
    page << "\"/>\n";
  };
  for (const Wire& wire : content.network.wires) {
    page << "<path class=\"line" << (wire.reason.empty() ? "" : " doubtful")
         << "\" stroke=\"" << wireColor(wire.number) << "\" d=\"";
    draw(polyline(wire, 0.1));
  }
  for (const Jumper& jumper : content.network.jumpers) {
    page << "<path class=\"jumper\" d=\"";
    draw(jumper.course);
  }
  page << "</svg>\n";
  return page.text();
}

} // namespace

Section
spaceSection(const Content& content)
{
  const Indices shown = shownPoints(content);
  SpaceFrame frame;
  for (const Index i : shown)
    frame.include(content.point(i));
  for (const Wire& wire : content.network.wires)
    for (const Point& p : polyline(wire, 0.1))
      frame.include(p);
  for (const Jumper& jumper : content.network.jumpers)
    for (const Point& p : jumper.course)
      frame.include(p);
  frame.close();
  Bytes places, looks;
  for (const Index i : shown) {
    frame.put(places, content.point(i));
    looks.push_back(static_cast<std::uint8_t>(lookOf(content, i)));
  }
  Json hazards = Json::array(), anchors = Json::array();
  for (const SpaceMark& mark : spaceMarks(content)) {
    hazards.push_back({{"key", mark.key},
                       {"from", frame.local(mark.from)},
                       {"to", frame.local(mark.to)},
                       {"text", mark.text}});
    anchors.push_back(spaceLink(mark.key).substr(1));
  }
  const Json data = {{"step", frame.step},
                     {"size", frame.local(frame.high)},
                     {"places", base64(places)},
                     {"looks", base64(looks)},
                     {"lines", base64(lineBytes(content, frame))},
                     {"hazards", std::move(hazards)}};
  return {"space",
          "3D view",
          {{"shown", shown.size()},
           {"points", content.cloud.points.size()},
           {"hazards", std::move(anchors)},
           {"still", stillPicture(content, frame, shown)},
           {"data", data.dump()}}};
}

} // namespace linelet::powerline::report
