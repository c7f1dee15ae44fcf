// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shape_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axes.h"

namespace linelet::apps {

namespace {

constexpr double left_margin = 90, right_margin = 30, top_margin = 92,
                 bottom_margin = 66;

/// The lines of the graphs: the map's colors, dark enough for white paper.
Color
lineColor(ShapeColors colors, std::size_t factor)
{
  const Color color = shapeColors(colors)[factor];
  return factor == 0 ? mix(color, {0.2, 0.2, 0.2}, 0.55) : color;
}

double
factorOf(const ScaleShape& shape, std::size_t factor)
{
  return static_cast<double>(factor == 0   ? shape.linearity
                             : factor == 1 ? shape.planarity
                                           : shape.sphericity);
}

void
drawShapeLegend(Canvas& canvas, Spot at, ShapeColors colors)
{
  const auto pure = shapeColors(colors);
  drawLegend(canvas,
             at,
             {{pure[0], "linearity CL"},
              {pure[1], "planarity CP"},
              {pure[2], "sphericity CS"}});
}

/// Borders halfway (in the axis' own scale) between neighboring values.
std::vector<double>
borders(const Axis& axis, const std::vector<double>& values)
{
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < values.size(); ++i)
    result.push_back((axis.pixel(values[i]) + axis.pixel(values[i + 1])) / 2);
  result.insert(result.begin(), axis.begin());
  result.push_back(axis.end());
  return result;
}

/// Distinct from all shape colors, in gray as well.
constexpr Color sum_color = {0.75, 0.10, 0.55};

double
largestOf(const std::vector<double>& values)
{
  double largest = 0;
  for (const double value : values)
    largest = std::fmax(largest, value);
  return largest;
}

/// The linearity sums of the columns as a line over the whole height.
void
drawSums(Canvas& canvas,
         const std::vector<double>& sums,
         const std::vector<double>& columns,
         const Axis& y)
{
  const double largest = largestOf(sums);
  std::vector<Spot> line;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (std::isnan(sums[i]) || !(largest > 0)) {
      canvas.polyline(line, 2, sum_color);
      line.clear();
      continue;
    }
    line.push_back({(columns[i] + columns[i + 1]) / 2,
                    y.begin() + (y.end() - y.begin()) * sums[i] / largest});
  }
  canvas.polyline(line, 2, sum_color);
}

/// Mean and standard deviation of a factor over some graphs at scale \a k; NaN if fewer
/// than two have it.
std::pair<double, double>
spreadOf(const std::vector<ShapeGraph>& graphs, std::size_t k, std::size_t factor)
{
  double sum = 0, squares = 0, count = 0;
  for (const ShapeGraph& graph : graphs)
    if (const double value = factorOf(graph[k], factor); !std::isnan(value)) {
      sum += value;
      squares += value * value;
      ++count;
    }
  if (count < 2) {
    const double nan = std::nan("");
    return {nan, nan};
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, (squares - sum * mean) / (count - 1)))};
}

/// Light lines one standard deviation above and below the mean of the neighbors.
void
drawSpread(Canvas& canvas,
           const PointGraphs& graphs,
           ShapeColors colors,
           const Axis& x,
           const Axis& y)
{
  for (std::size_t factor = 0; factor < 3; ++factor)
    for (const double sign : {-1.0, 1.0}) {
      const Color color = mix(lineColor(colors, factor), ink::paper, 0.55);
      std::vector<Spot> line;
      for (std::size_t k = 0; k < graphs.fine_radii.size(); ++k) {
        const auto [mean, deviation] = spreadOf(graphs.around, k, factor);
        const double value = std::clamp(mean + sign * deviation, 0.0, 1.0);
        if (std::isnan(mean)) {
          canvas.polyline(line, 1.2, color);
          line.clear();
        }
        else
          line.push_back({x.pixel(graphs.fine_radii[k]), y.pixel(value)});
      }
      canvas.polyline(line, 1.2, color);
    }
}

} // namespace

Canvas
drawShapeProfile(const ShapeProfile& profile, ShapeColors colors, int width, int height)
{
  Canvas canvas(width, height);
  const Axis x(profile.positions.front(),
               profile.positions.back(),
               left_margin,
               width - right_margin,
               false);
  const Axis y(profile.radii.front(),
               profile.radii.back(),
               height - bottom_margin,
               top_margin,
               true);
  const std::vector<double> columns = borders(x, profile.positions);
  const std::vector<double> rows = borders(y, profile.radii);
  for (std::size_t i = 0; i < profile.graphs.size(); ++i)
    for (std::size_t k = 0; k < profile.radii.size(); ++k) {
      const ScaleShape& shape = profile.graphs[i][k];
      const Color color =
          std::isnan(shape.linearity)
              ? ink::unknown
              : shapeColor(
                    colors, factorOf(shape, 0), factorOf(shape, 1), factorOf(shape, 2));
      canvas.rectangle({columns[i], rows[k + 1]},
                       columns[i + 1] - columns[i],
                       rows[k] - rows[k + 1],
                       color);
    }
  for (std::size_t i = 0; i < profile.chosen.size(); ++i)
    if (!std::isnan(profile.chosen[i])) {
      const Spot at = {(columns[i] + columns[i + 1]) / 2, y.pixel(profile.chosen[i])};
      canvas.disc(at, 2.2, ink::paper);
      canvas.disc(at, 1.5, ink::text);
    }
  drawSums(canvas, profile.sums, columns, y);
  drawAxes(canvas, x, profile.position_label, y, "radius r", false);
  canvas.text({left_margin, 26},
              profile.title,
              title_size,
              ink::text,
              Align::Left,
              false,
              true);
  drawShapeLegend(canvas, {left_margin, 62}, colors);
  if (!profile.chosen.empty()) {
    canvas.disc({left_margin + 487, 62}, 3, ink::text);
    canvas.text({left_margin + 500, 62}, "optimal radius", text_size);
  }
  if (!profile.sums.empty()) {
    canvas.line({left_margin + 640, 62}, {left_margin + 664, 62}, 2, sum_color);
    canvas.text({left_margin + 671, 62},
                "sum of CL, 0 to " + numberText(largestOf(profile.sums), 3),
                text_size);
  }
  return canvas;
}

Canvas
drawPointGraphs(const PointGraphs& graphs, ShapeColors colors, int width, int height)
{
  Canvas canvas(width, height);
  const Axis x(graphs.radii.front(),
               graphs.radii.back(),
               left_margin,
               width - right_margin,
               true);
  const Axis y(0, 1, height - bottom_margin, top_margin, false);
  drawAxes(canvas, x, "radius r (logarithmic)", y, "shape factor", true);

  const LinearityGraph& analysis = graphs.analysis;
  if (analysis.scale() != LinearityGraph::none) {
    const double radius = graphs.radii[analysis.scale()];
    const double at = x.pixel(radius);
    canvas.line({at, y.begin()}, {at, y.end()}, 2, ink::mark);
    const bool left = at > (x.begin() + x.end()) / 2;
    canvas.text({at + (left ? -8 : 8), y.end() + 14},
                "optimal r = " + numberText(radius, 3) + ", blend " +
                    numberText(analysis.blend, 2),
                text_size,
                ink::mark,
                left ? Align::Right : Align::Left);
  }
  drawSpread(canvas, graphs, colors, x, y);
  for (std::size_t factor = 3; factor-- > 0;) {
    const Color color = lineColor(colors, factor);
    std::vector<Spot> line;
    for (std::size_t k = 0; k < graphs.fine_radii.size(); ++k) {
      const double value = factorOf(graphs.fine_graph[k], factor);
      if (std::isnan(value)) {
        canvas.polyline(line, 2, color);
        line.clear();
      }
      else
        line.push_back({x.pixel(graphs.fine_radii[k]), y.pixel(value)});
    }
    canvas.polyline(line, 2, color);
    for (std::size_t k = 0; k < graphs.radii.size(); ++k)
      if (const double value = factorOf(graphs.graph[k], factor); !std::isnan(value))
        canvas.disc({x.pixel(graphs.radii[k]), y.pixel(value)}, 3.5, color);
  }
  const auto markAt = [&](std::size_t scale) {
    return Spot{x.pixel(graphs.radii[scale]),
                y.pixel(factorOf(graphs.graph[scale], 0))};
  };
  for (const GraphMaximum& maximum : analysis.maxima) {
    const Spot at = markAt(maximum.scale);
    canvas.disc(at, 7, ink::mark);
    canvas.text({at.x + 11, at.y + (at.y < y.end() + 20 ? 16 : -12)},
                "score " + numberText(maximum.score, 3),
                text_size - 2,
                ink::mark);
  }
  for (const std::size_t minimum : analysis.minima)
    canvas.ring(markAt(minimum), 8, 2.5, ink::mark);

  canvas.text(
      {left_margin, 26}, graphs.title, title_size, ink::text, Align::Left, false, true);
  drawLegend(canvas,
             {left_margin, 62},
             {{lineColor(colors, 0), "linearity CL"},
              {lineColor(colors, 1), "planarity CP"},
              {lineColor(colors, 2), "sphericity CS"}});
  const double marks = left_margin + 487;
  canvas.disc({marks, 62}, 6, ink::mark);
  canvas.text({marks + 13, 62}, "maximum of CL", text_size);
  canvas.ring({marks + 150, 62}, 7, 2.5, ink::mark);
  canvas.text({marks + 164, 62}, "minimum", text_size);
  return canvas;
}

} // namespace linelet::apps
