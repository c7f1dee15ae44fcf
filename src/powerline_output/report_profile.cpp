// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report_span_frame.h"

namespace linelet::powerline::report {

namespace {

constexpr double left = 46, widest = 1004, top = 14, deepest = 300; ///< pixels
constexpr double narrow_chart = 420; ///< pixels; its caption goes beside it

/** Maps meters along and up to pixels. */
struct View {
  double from, to, low, high; ///< meters
  double x_scale, y_scale;    ///< pixels per meter
  double world;               ///< added to heights in labels

  double
  x(double s) const
  {
    return left + (s - from) * x_scale;
  }

  double
  y(double z) const
  {
    return top + (high - z) * y_scale;
  }

  double
  right() const
  {
    return x(to);
  }

  double
  bottom() const
  {
    return y(low);
  }
};

View
viewOf(const Content& content, const Span& span, const SpanFrame& frame)
{
  View view{0, frame.length, 1e300, -1e300, 1, 1, content.metric.metersAbove(0)};
  for (const int id : span.wires) {
    const Wire& wire = content.wire(id);
    for (const Point& p : polyline(wire)) {
      view.from = std::min(view.from, frame.along(p));
      view.to = std::max(view.to, frame.along(p));
      view.low = std::min(view.low, p.z());
      view.high = std::max(view.high, p.z());
    }
  }
  const double rim = std::max(2.0, 0.02 * (view.to - view.from));
  view.from -= rim;
  view.to += rim;
  for (int i = 0; i <= 100; ++i) {
    const Point p = frame.at(view.from + (view.to - view.from) * i / 100);
    const double ground = content.network.ground.heightAt(p.x(), p.y());
    if (std::isfinite(ground))
      view.low = std::min(view.low, ground);
  }
  view.high += 2;
  view.low -= 2;
  view.x_scale = std::min(widest / (view.to - view.from),
                          deepest / (view.high - view.low)); // a short span stays small
  // To scale, or heights stretched by a whole number, as large as the space allows.
  const double most = deepest / ((view.high - view.low) * view.x_scale);
  view.y_scale = view.x_scale * std::clamp(std::floor(most + 1e-9), 1.0, 5.0);
  return view;
}

void
addAxes(Markup& page, const View& view)
{
  const double up = roundStep(view.high - view.low, 6);
  for (double z = std::ceil((view.low + view.world) / up) * up;
       z < view.high + view.world;
       z += up)
    page << "<path class=\"grid\" d=\"M" << left << " " << view.y(z - view.world)
         << " H" << view.right() << "\"/><text class=\"tick end\" x=\"" << left - 5
         << "\" y=\"" << view.y(z - view.world) + 4 << "\">" << number(z, 0)
         << "</text>\n";
  // Fewer ticks for a short span, which is drawn small, lest their labels overlap.
  const double ticks = std::clamp((view.right() - left) / 45.0, 2.0, 10.0);
  const double on = roundStep(view.to - view.from, static_cast<int>(ticks));
  for (double s = std::ceil(view.from / on) * on; s < view.to; s += on)
    page << "<path class=\"grid\" d=\"M" << view.x(s) << " " << top << " V"
         << view.bottom() << "\"/><text class=\"tick middle\" x=\"" << view.x(s)
         << "\" y=\"" << view.bottom() + 14 << "\">" << number(s, on < 1 ? 1 : 0)
         << "</text>\n";
}

void
addGround(Markup& page,
          const Content& content,
          const SpanFrame& frame,
          const View& view)
{
  Markup edge;
  bool any = false;
  double last = view.from;
  for (int i = 0; i <= 200; ++i) {
    const double s = view.from + (view.to - view.from) * i / 200;
    const Point p = frame.at(s);
    const double z = content.network.ground.heightAt(p.x(), p.y());
    if (!std::isfinite(z))
      continue;
    if (!any)
      edge << "M" << view.x(s) << " " << view.bottom();
    edge << " L" << view.x(s) << " " << view.y(z);
    any = true;
    last = s;
  }
  if (any)
    page << "<path class=\"ground\" d=\"" << edge.text() << " L" << view.x(last) << " "
         << view.bottom() << " z\"/>\n";
}

/** The points, as one path of dots per kind. */
void
addPoints(Markup& page,
          const Content& content,
          const SpanFrame& frame,
          const View& view,
          const Indices& points)
{
  Markup wires, pylons, insulators, others;
  for (const Index i : points) {
    const Point p = content.point(i);
    const double s = frame.along(p);
    if (s < view.from || s > view.to || p.z() < view.low || p.z() > view.high)
      continue;
    const std::uint8_t kind = content.network.classes[i];
    Markup& dots = content.network.wire_id[i] > 0 || kind == wire_class ? wires
                   : kind == connector_class                            ? insulators
                   : kind == pylon_class                                ? pylons
                                                                        : others;
    dots << "M" << view.x(s) << " " << view.y(p.z()) << "h0";
  }
  page << "<path class=\"dots other\" d=\"" << others.text() << "\"/>\n"
       << "<path class=\"dots pylon\" d=\"" << pylons.text() << "\"/>\n"
       << "<path class=\"dots insulator\" d=\"" << insulators.text() << "\"/>\n"
       << "<path class=\"dots onwire\" d=\"" << wires.text() << "\"/>\n";
}

/** The vertices of a line, as the `d` of a path. */
void
addCourse(Markup& page, const SpanFrame& frame, const View& view, const Points& line)
{
  const char* lead = "M";
  for (const Point& p : line) {
    page << lead << view.x(frame.along(p)) << " " << view.y(p.z());
    lead = " L";
  }
}

void
addWireCurves(Markup& page,
              const Content& content,
              const Span& span,
              const SpanFrame& frame,
              const View& view)
{
  for (const int id : span.wires) {
    const Wire& wire = content.wire(id);
    page << "<path class=\"curve" << (wire.reason.empty() ? "" : " doubtful")
         << "\" stroke=\"" << wireColor(wire.number) << "\" d=\"";
    addCourse(page, frame, view, polyline(wire));
    page << "\"><title>wire " << wire.number << "</title></path>\n";
    for (const Point& end : {wire.front, wire.back})
      page << "<circle fill=\"" << wireColor(wire.number) << "\" cx=\""
           << view.x(frame.along(end)) << "\" cy=\"" << view.y(end.z())
           << "\" r=\"2.6\"><title>wire " << wire.number << " at "
           << number(end.z() + view.world, 2) << " m</title></circle>\n";
  }
}

/** The jumpers at both supports. */
void
addJumpers(Markup& page,
           const Content& content,
           const Span& span,
           const SpanFrame& frame,
           const View& view)
{
  for (const Jumper& jumper : content.network.jumpers) {
    if (jumper.support == 0 ||
        (jumper.support != span.from_support && jumper.support != span.to_support))
      continue;
    Points shown; // it continues into the next span
    for (const Point& p : jumper.course)
      if (const double s = frame.along(p); s >= view.from && s <= view.to)
        shown.push_back(p);
    page << "<path class=\"jumper\" d=\"";
    addCourse(page, frame, view, shown);
    page << "\"><title>jumper " << jumper.id << "</title></path>\n";
  }
}

/** Stretches of the scanned state along the wires, each linked to its row. */
void
addStretches(Markup& page,
             const Content& content,
             const Span& span,
             const SpanFrame& frame,
             const View& view)
{
  if (content.options.hazards.empty())
    return;
  for (const Encroachment& one : content.options.hazards.front().clearances) {
    if (one.span != span.id)
      continue;
    page << "<a href=\"#hazard" << one.id << "\"><path class=\"stretch "
         << std::string(nameOf(one.severity)) << "\" d=\"";
    addCourse(page, frame, view, one.line);
    page << "\"><title>hazard " << one.id << ", " << std::string(nameOf(one.kind))
         << " " << content.length(one.nearest.distance, 2) << " m</title></path></a>\n";
  }
}

/** The lowest clearance of the span: a line from the wire to what is below it. */
void
addClearance(Markup& page,
             const Content& content,
             const Span& span,
             const SpanFrame& frame,
             const View& view)
{
  const auto draw = [&](const Clearance& found, const char* what) {
    const bool bad = found.distance < content.options.clearance;
    const double x = view.x(frame.along(found.wire));
    const double y1 = view.y(found.wire.z()), y2 = view.y(found.other.z());
    page << "<path class=\"clear" << (bad ? " bad" : "") << "\" d=\"M" << x << " " << y1
         << " L" << view.x(frame.along(found.other)) << " " << y2 << "\"/>"
         << "<text class=\"tick" << (bad ? " bad" : "") << "\" x=\"" << x + 5
         << "\" y=\"" << 0.5 * (y1 + y2) + 4 << "\">" << number(found.distance, 1)
         << " m " << what << "</text>\n";
  };
  const Clearance *ground = nullptr, *vegetation = nullptr;
  const auto keep = [](const Clearance*& lowest, const Clearance& found) {
    if (found.known() && (lowest == nullptr || found.distance < lowest->distance))
      lowest = &found;
  };
  for (const int id : span.wires) {
    keep(ground, content.wire(id).ground);
    keep(vegetation, content.wire(id).vegetation);
  }
  if (ground != nullptr)
    draw(*ground, "to ground");
  if (vegetation != nullptr && vegetation->distance < 2 * content.options.clearance)
    draw(*vegetation, "to objects");
}

} // namespace

void
addProfile(Markup& page,
           const Content& content,
           const Span& span,
           const Indices& points)
{
  if (span.wires.empty())
    return;
  const SpanFrame frame(content, span);
  const View view = viewOf(content, span, frame);
  page << "<svg class=\"profile\" viewBox=\"0 0 1060 " << view.bottom() + 34
       << "\" role=\"img\" aria-label=\"Profile of span " << span.id << "\">\n";
  addAxes(page, view);
  addGround(page, content, frame, view);
  addPoints(page, content, frame, view, points);
  addWireCurves(page, content, span, frame, view);
  addJumpers(page, content, span, frame, view);
  addStretches(page, content, span, frame, view);
  addClearance(page, content, span, frame, view);
  const double factor = view.y_scale / view.x_scale;
  const bool narrow = view.right() - left < narrow_chart;
  page << "<text class=\"tick\" x=\"" << left << "\" y=\"" << view.bottom() + 29
       << "\">" << content.supportName(span.from_support) << "</text><text class=\"tick"
       << (narrow ? "" : " middle") << "\" x=\""
       << (narrow ? view.right() + 40 : 0.5 * (left + view.right())) << "\" y=\""
       << view.bottom() + 29 << "\">meters along the span, heights in meters"
       << (std::abs(factor - 1) < 0.01
               ? std::string(", to scale")
               : ", heights stretched × " + number(factor, factor < 1 ? 2 : 0))
       << "</text><text class=\"tick end\" x=\"" << view.right() << "\" y=\""
       << view.bottom() + 29 << "\">" << content.supportName(span.to_support)
       << "</text>\n</svg>\n";
}

} // namespace linelet::powerline::report
