// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "overlays.h"

#include <cmath>

#include "model/picking.h"

namespace linelet::view {

namespace {

constexpr std::size_t most_ellipsoids = 3000;

} // namespace

void
showCurves(const Model& model, Polylines& lines, Polylines& chosen)
{
  using Verdict = powerline::Review::Verdict;
  constexpr apps::Color found = {0.0, 0.35, 0.75}, doubtful = {0.95, 0.55, 0.0},
                        accepted = {0.05, 0.6, 0.25}, rejected = {0.75, 0.75, 0.78},
                        curve = {0.75, 0.1, 0.55}, truth = {0.1, 0.1, 0.1},
                        support = {0.3, 0.3, 0.35}, mark = {1.0, 0.1, 0.6},
                        unexplained = {0.85, 0.1, 0.1}, jumper = {0.05, 0.55, 0.45},
                        insulator = {0.72, 0.35, 0.1};
  lines.clear();
  chosen.clear();
  for (const Curve& one : model.scene().truth.curves)
    lines.add(one.points, one.closed, truth);
  const CurveNetwork& curves = model.curves();
  for (std::size_t i = 0; i < curves.curves.size(); ++i)
    (static_cast<int>(i) == model.curve ? chosen : lines)
        .add(curves.curves[i].points,
             curves.curves[i].closed,
             static_cast<int>(i) == model.curve ? mark : curve);
  if (const auto* network = model.lines(); network != nullptr) {
    for (const powerline::Wire& wire : network->wires) {
      Points line = powerline::polyline(wire, 0.02);
      for (Point& p : line)
        p = model.toCloud(p);
      const Verdict verdict = model.review(wire.id).verdict;
      const apps::Color& color = verdict == Verdict::Accepted   ? accepted
                                 : verdict == Verdict::Rejected ? rejected
                                 : wire.reason.empty()          ? found
                                                                : doubtful;
      const bool is_chosen = wire.id == model.wire();
      (is_chosen ? chosen : lines).add(line, false, is_chosen ? mark : color);
    }
    const auto addCourse = [&](Points line, const apps::Color& color) {
      for (Point& p : line)
        p = model.toCloud(p);
      lines.add(line, false, color);
    };
    for (const powerline::UnexplainedLine& one : network->unexplained)
      addCourse(one.course, unexplained);
    for (const powerline::Jumper& one : network->jumpers)
      addCourse(one.course, jumper);
    for (const powerline::InsulatorString& one : network->insulators)
      addCourse({one.structure, one.live}, insulator);
    for (const powerline::Support& one : network->supports)
      lines.add({model.toCloud(one.base), model.toCloud(one.top)}, false, support);
  }
  lines.done();
  chosen.done();
}

void
showSelection(const Model& model,
              const Points& drawn_line,
              Polylines& marks,
              Ellipsoids& own)
{
  marks.clear();
  own.clear();
  constexpr apps::Color red = {0.9, 0.1, 0.1}, gray = {0.4, 0.4, 0.45};
  if (const auto selected = model.selected()) {
    const Point at = model.scene().cloud.points[*selected];
    const double size = model.tensorRadius() > 0       ? model.tensorRadius()
                        : model.scene().scale_unit > 0 ? 5 * model.scene().scale_unit
                                                       : 1;
    for (int axis = 0; axis < 3; ++axis) {
      const Point arm = size * Point::Unit(axis);
      marks.add({at - arm, at + arm}, false, red);
    }
    if (const auto tensor = model.tensorAtSelection())
      own.add(at, *tensor);
  }
  if (const auto& box = model.preview()) {
    const auto corner = [&](int i) {
      return Point((i & 1 ? box->high : box->low).x(),
                   (i & 2 ? box->high : box->low).y(),
                   (i & 4 ? box->high : box->low).z());
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if ((i & bit) == 0)
          marks.add({corner(i), corner(i | bit)}, false, gray);
  }
  marks.add(drawn_line, false, red);
  marks.done();
  own.done();
}

void
showTensors(const Model& model, bool everywhere, Ellipsoids& ellipsoids)
{
  ellipsoids.clear();
  const auto& tensors = model.results().tensors;
  if (everywhere && tensors != nullptr) {
    Indices known;
    for (std::size_t i = 0; i < tensors->size(); ++i)
      if (!std::isnan((*tensors)[i].linearity))
        known.push_back(static_cast<Index>(i));
    for (const Index k : randomSubset(known.size(), most_ellipsoids))
      ellipsoids.add(model.scene().cloud.points[known[k]], (*tensors)[known[k]]);
  }
  ellipsoids.done();
}

} // namespace linelet::view
