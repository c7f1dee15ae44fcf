// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_plan.h"

#include <algorithm>
#include <cmath>

#include <linelet/powerline_output/below_clearance.h>

#include "report_image.h"

namespace linelet::powerline::report {

namespace {

constexpr double widest_plan = 1060, highest_plan = 760; ///< pixels

/** Position, rotation and scale of the plan. */
struct PlanFrame {
  Point u = Point::UnitX(), v = Point::UnitY(); ///< right and up on the page
  Point low = Point::Constant(1e300), high = Point::Constant(-1e300); ///< along u, v
  double scale = 1; ///< pixels per meter

  Point
  turned(const Point& p) const
  {
    return {u.dot(p), v.dot(p), 0};
  }

  void
  take(const Point& p)
  {
    low = low.cwiseMin(turned(p));
    high = high.cwiseMax(turned(p));
  }

  double
  x(const Point& p) const
  {
    return (u.dot(p) - low.x()) * scale;
  }

  double
  y(const Point& p) const
  {
    return (high.y() - v.dot(p)) * scale;
  }

  double
  width() const
  {
    return (high.x() - low.x()) * scale;
  }

  double
  height() const
  {
    return (high.y() - low.y()) * scale;
  }
};

/** Lays a long line across the page, with north in the upper half. */
void
layAcross(PlanFrame& frame, const std::vector<Wire>& wires)
{
  double xx = 0, xy = 0, yy = 0;
  Point mean = Point::Zero();
  for (const Wire& wire : wires)
    mean += 0.5 * (wire.front + wire.back) / static_cast<double>(wires.size());
  for (const Wire& wire : wires)
    for (const Point& end : {wire.front, wire.back}) {
      const Point d = end - mean;
      xx += d.x() * d.x();
      xy += d.x() * d.y();
      yy += d.y() * d.y();
    }
  // Ratio of the two variances: only lines much longer than wide are turned.
  const double root = std::hypot(xx - yy, 2 * xy);
  if (!(xx + yy + root > 9 * (xx + yy - root)))
    return;
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy); // in [-90, 90] degrees
  frame.u = Point(std::cos(angle), std::sin(angle), 0);
  frame.v = Point(-std::sin(angle), std::cos(angle), 0);
}

/** The frame around all lines and all of the cloud. */
PlanFrame
frameOf(const Content& content)
{
  PlanFrame frame;
  layAcross(frame, content.network.wires);
  for (std::size_t i = 0; i < content.cloud.points.size(); ++i)
    if (const Point p = content.point(i); p.allFinite())
      frame.take(p);
  const Point rim = Point::Constant(8);
  for (const Wire& wire : content.network.wires)
    for (const Point& end : {wire.front, wire.back}) {
      frame.take(end - rim);
      frame.take(end + rim);
    }
  for (const Support& support : content.network.supports)
    frame.take(support.base);
  const Point size = frame.high - frame.low;
  frame.scale = std::min(widest_plan / std::max(size.x(), 1.0),
                         highest_plan / std::max(size.y(), 1.0));
  return frame;
}

/** Gives pixels without points the highest adjacent shade, twice, so that sparse clouds
 * have no holes. */
void
fillHoles(std::vector<std::uint8_t>& pixels, std::size_t columns, std::size_t rows)
{
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<std::uint8_t> before = pixels;
    for (std::size_t row = 1; row + 1 < rows; ++row)
      for (std::size_t column = 1; column + 1 < columns; ++column) {
        const std::size_t i = row * columns + column;
        if (before[i] == 0)
          pixels[i] = std::max(std::max(before[i - 1], before[i + 1]),
                               std::max(before[i - columns], before[i + columns]));
      }
  }
}

/** Height above ground of the highest point of every cell, as a picture. */
void
addPicture(Markup& page, const Content& content, const PlanFrame& frame)
{
  const Point size = frame.high - frame.low;
  const double cell = std::max(0.75, std::max(size.x(), size.y()) / 800);
  const auto columns = static_cast<std::size_t>(std::ceil(size.x() / cell));
  const auto rows = static_cast<std::size_t>(std::ceil(size.y() / cell));
  if (columns == 0 || rows == 0)
    return;
  // 0: no point; 1 to 24: every meter above ground, from sand to dark green.
  std::vector<std::array<std::uint8_t, 3>> palette = {{255, 255, 255}};
  for (int i = 0; i < 24; ++i) {
    const double t = std::sqrt(i / 23.0);
    const auto mix = [&](double from, double to) {
      return static_cast<std::uint8_t>(from + t * (to - from));
    };
    palette.push_back({mix(240, 120), mix(236, 150), mix(226, 125)});
  }
  std::vector<std::uint8_t> pixels(columns * rows, 0);
  const auto& network = content.network;
  for (std::size_t i = 0; i < content.cloud.points.size(); ++i) {
    const Point p = content.point(i);
    if (!p.allFinite() || network.classes[i] == wire_class ||
        network.classes[i] == pylon_class || network.classes[i] == connector_class)
      continue;
    const double column = frame.x(p) / (frame.scale * cell);
    const double row = frame.y(p) / (frame.scale * cell);
    if (column < 0 || row < 0 || column >= static_cast<double>(columns) ||
        row >= static_cast<double>(rows))
      continue;
    const double above = p.z() - network.ground.heightAt(p.x(), p.y());
    const auto shade =
        static_cast<std::uint8_t>(1 + std::clamp(above > 0 ? above : 0, 0.0, 23.0));
    std::uint8_t& pixel = pixels[static_cast<std::size_t>(row) * columns +
                                 static_cast<std::size_t>(column)];
    pixel = std::max(pixel, shade);
  }
  fillHoles(pixels, columns, rows);
  page << "<image x=\"0\" y=\"0\" width=\""
       << static_cast<double>(columns) * cell * frame.scale << "\" height=\""
       << static_cast<double>(rows) * cell * frame.scale
       << "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,"
       << pngBase64(columns, rows, pixels, palette) << "\"/>\n";
}

void
addWires(Markup& page, const Content& content, const PlanFrame& frame)
{
  for (const Wire& wire : content.network.wires) {
    const bool bad = belowClearance(wire, content.options.clearance);
    page << "<path class=\"wire\" stroke=\"" << wireColor(wire.number) << "\" d=\"M";
    for (const Point& p : {wire.front, wire.back})
      page << frame.x(p) << " " << frame.y(p) << " ";
    page << "\"><title>wire " << wire.number << ", span " << wire.span
         << "</title></path>\n";
    if (!bad || !content.options.hazards.empty())
      continue;
    const Clearance& worst = wire.vegetation.distance < content.options.clearance
                                 ? wire.vegetation
                                 : wire.ground;
    page << "<circle class=\"hazard\" cx=\"" << frame.x(worst.wire) << "\" cy=\""
         << frame.y(worst.wire) << "\" r=\"6\"/>\n";
  }
}

/** Lines that nothing found explains. */
void
addUnexplained(Markup& page, const Content& content, const PlanFrame& frame)
{
  for (const UnexplainedLine& line : content.network.unexplained) {
    page << "<path class=\"unexplained\" d=\"";
    bool first = true;
    for (const Point& p : line.course) {
      page << (first ? "M" : " L") << frame.x(p) << " " << frame.y(p);
      first = false;
    }
    page << "\"><title>unexplained line " << line.id << "</title></path>\n";
  }
}

/** Stretches and trees of the scanned state, each linked to its row. */
void
addHazardMarks(Markup& page, const Content& content, const PlanFrame& frame)
{
  if (content.options.hazards.empty())
    return;
  const Hazards& hazards = content.options.hazards.front();
  // Severe ones on top.
  for (const Severity severity : {Severity::Low, Severity::Medium, Severity::High}) {
    const std::string look(nameOf(severity));
    for (const Encroachment& one : hazards.clearances) {
      if (one.severity != severity || one.line.empty())
        continue;
      page << "<a href=\"#hazard" << one.id << "\" id=\"plan" << one.id
           << "\"><path class=\"stretch " << look << "\" d=\"M";
      for (const Point& p : {one.line.front(), one.line.back()})
        page << frame.x(p) << " " << frame.y(p) << " ";
      page << "\"><title>hazard " << one.id << ", " << std::string(nameOf(one.kind))
           << " " << content.length(one.nearest.distance, 2)
           << " m</title></path></a>\n";
    }
    for (const FallIn& one : hazards.fall_in)
      if (one.severity == severity)
        page << "<a href=\"#tree" << one.id << "\" id=\"plantree" << one.id
             << "\"><path class=\"tree " << look << "\" d=\"M" << frame.x(one.top)
             << " " << frame.y(one.top) - 4 << " l4 7 h-8 z\"><title>tree " << one.id
             << "</title></path></a>\n";
  }
}

void
addNames(Markup& page, const Content& content, const PlanFrame& frame)
{
  for (const Span& span : content.network.spans) {
    Point middle = Point::Zero();
    for (const int id : span.wires)
      middle += 0.5 * (content.wire(id).front + content.wire(id).back) /
                static_cast<double>(span.wires.size());
    if (!span.wires.empty())
      page << "<a href=\"#span" << span.id << "\"><circle class=\"badge\" cx=\""
           << frame.x(middle) << "\" cy=\"" << frame.y(middle)
           << "\" r=\"9\"/><text class=\"name\" x=\"" << frame.x(middle) << "\" y=\""
           << frame.y(middle) + 4 << "\">" << span.id << "</text></a>\n";
  }
  for (const Support& support : content.network.supports) {
    const double x = frame.x(support.base), y = frame.y(support.base);
    if (support.kind == Support::Kind::Pole)
      page << "<circle class=\"support\" cx=\"" << x << "\" cy=\"" << y
           << "\" r=\"3\"/>";
    else
      page << "<rect class=\"support\" x=\"" << x - 4.5 << "\" y=\"" << y - 4.5
           << "\" width=\"9\" height=\"9\"/>";
    page << "<text class=\"small\" x=\"" << x + 8 << "\" y=\"" << y + 12 << "\">"
         << content.supportName(support.id) << "</text>\n";
  }
}

void
addScaleAndNorth(Markup& page, const PlanFrame& frame)
{
  const double meters = roundStep(frame.width() / frame.scale, 5);
  const double length = meters * frame.scale, y = frame.height() + 32;
  page << "<path class=\"ink\" d=\"M1 " << y - 5 << " v5 h" << length << " v-5\"/>"
       << "<text x=\"" << length + 8 << "\" y=\"" << y + 1 << "\">"
       << number(meters, meters < 1 ? 2 : 0) << " m</text>\n";
  // The arrow is rotated about its center to point north on the page.
  const double x = frame.width() - 30, turn = std::atan2(frame.u.y(), frame.v.y());
  page << "<g transform=\"translate(" << x << " " << y - 6 << ") rotate("
       << turn * 180 / M_PI
       << ")\"><path class=\"north\" d=\"M0 -12 l6 22 l-6 -5 l-6 5 z\"/>"
          "<text class=\"middle\" x=\"0\" y=\"-15\">N</text></g>\n";
}

} // namespace

void
addPlan(Markup& page, const Content& content)
{
  const PlanFrame frame = frameOf(content);
  if (frame.low.x() > frame.high.x())
    return; // neither points nor wires
  const double width = std::max(frame.width(), 240.0);
  page << "<svg class=\"plan\" viewBox=\"-2 -2 " << width + 4 << " "
       << frame.height() + 48 << "\" style=\"max-width:" << width + 4
       << "px\" role=\"img\" aria-label=\"Plan\">\n";
  addPicture(page, content, frame);
  addUnexplained(page, content, frame);
  addWires(page, content, frame);
  addHazardMarks(page, content, frame);
  addNames(page, content, frame);
  addScaleAndNorth(page, frame);
  page << "</svg>\n";
}

} // namespace linelet::powerline::report
