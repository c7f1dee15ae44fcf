// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchmark_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.h"

namespace linelet::apps {

namespace {

using bench::RunSummary;
using bench::SummaryGroup;

/// Distinct for color-blind readers and in gray; repeated if there are more methods.
constexpr std::array<Color, 4> bar_colors = {
    {{0.16, 0.47, 0.84}, {0.95, 0.72, 0.25}, {0.55, 0.06, 0.10}, {0.45, 0.45, 0.48}}};

const Color&
barColor(std::size_t method)
{
  return bar_colors[method % bar_colors.size()];
}

struct Panel {
  double left, right, top, bottom;
};

/// Full names of the properties.
std::string
axisLabel(const std::string& title)
{
  if (title == "points")
    return "number of points N";
  if (title == "S_D")
    return "unevenness of the density S_D";
  if (title == "S_J")
    return "jitter S_J";
  if (title == "M / N")
    return "outliers per point M / N";
  return title == "n_R" ? "noise rate n_R" : title;
}

/// The entries of all methods, each once, in the order of the first method that has it.
std::vector<std::string>
entriesOf(const std::vector<SummaryGroup>& methods)
{
  std::vector<std::string> names;
  for (const SummaryGroup& group : methods)
    for (const auto& [name, summary] : group.entries)
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  if (methods.front().title != "geometry")
    std::sort(names.begin(), names.end());
  return names;
}

void
drawBar(Canvas& canvas,
        const Axis& y,
        double left,
        double width,
        const RunSummary& summary,
        const Color& color)
{
  const double top = y.pixel(summary.success);
  canvas.rectangle({left, top}, width, y.begin() - top, color);
  const double error = summary.standardError();
  if (!(error > 0))
    return;
  const double middle = left + width / 2;
  canvas.line({middle, y.pixel(std::min(1.0, summary.success + error))},
              {middle, y.pixel(std::max(0.0, summary.success - error))},
              1.5,
              ink::frame);
}

/// Smaller distances are drawn as 0.
constexpr double least_distance = 1e-3, most_distance = 10;

void
drawBox(Canvas& canvas,
        const Axis& y,
        double left,
        double width,
        const RunSummary& summary,
        const Color& color)
{
  std::array<double, 5> at{};
  for (std::size_t q = 0; q < at.size(); ++q) {
    if (!std::isfinite(summary.e_v_quantiles[q]))
      return;
    at[q] =
        y.pixel(std::clamp(summary.e_v_quantiles[q], least_distance, most_distance));
  }
  const double middle = left + width / 2;
  canvas.line({middle, at[0]}, {middle, at[4]}, 1.5, ink::frame);
  for (const double end : {at[0], at[4]})
    canvas.line({left + width / 4, end}, {left + 3 * width / 4, end}, 1.5, ink::frame);
  canvas.rectangle({left, at[3]}, width, at[1] - at[3], color);
  canvas.line({left, at[2]}, {left + width, at[2]}, 2.5, ink::text);
}

void
drawPanel(Canvas& canvas,
          const Panel& panel,
          const std::vector<SummaryGroup>& methods,
          BenchmarkView view)
{
  const bool boxes = view == BenchmarkView::Distances;
  const Axis y =
      boxes ? Axis(least_distance, most_distance, panel.bottom, panel.top, true)
            : Axis(0, 1, panel.bottom, panel.top, false);
  for (const double value : y.ticks()) {
    canvas.line(
        {panel.left, y.pixel(value)}, {panel.right, y.pixel(value)}, 1, ink::grid);
    canvas.text({panel.left - 8, y.pixel(value)},
                numberText(value),
                text_size - 2,
                ink::text,
                Align::Right);
  }
  const std::vector<std::string> names = entriesOf(methods);
  const double step = (panel.right - panel.left) / static_cast<double>(names.size());
  const double bar = .8 * step / static_cast<double>(methods.size());
  const bool crowded = std::any_of(names.begin(), names.end(), [&](const auto& name) {
    return Canvas::textWidth(name, text_size - 2) > step - 4;
  });
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double begin = panel.left + static_cast<double>(i) * step;
    for (std::size_t m = 0; m < methods.size(); ++m)
      for (const auto& [name, summary] : methods[m].entries)
        if (name == names[i])
          (boxes ? drawBox : drawBar)(canvas,
                                      y,
                                      begin + .1 * step + static_cast<double>(m) * bar,
                                      bar,
                                      summary,
                                      barColor(m));
    if (crowded)
      canvas.text({begin + step / 2, panel.bottom + 8},
                  names[i],
                  text_size - 2,
                  ink::text,
                  Align::Right,
                  true);
    else
      canvas.text({begin + step / 2, panel.bottom + 14},
                  names[i],
                  text_size - 2,
                  ink::text,
                  Align::Center);
  }
  canvas.line({panel.left, panel.bottom}, {panel.right, panel.bottom}, 1, ink::frame);
  canvas.text({(panel.left + panel.right) / 2, panel.top - 16},
              (boxes ? "E_V by " : "success by ") + axisLabel(methods.front().title),
              text_size,
              ink::text,
              Align::Center,
              false,
              true);
}

} // namespace

Canvas
drawBenchmark(const std::vector<MethodRows>& methods,
              BenchmarkView view,
              int width,
              int height)
{
  constexpr double head = 80, margin = 46, gap = 70, foot = 95, title = 34;
  constexpr int columns = 3, lines = 2;
  Canvas canvas(width, height);
  std::vector<std::pair<Color, std::string>> legend;
  std::vector<std::vector<SummaryGroup>> groups; // of each method
  for (const auto& [name, rows] : methods) {
    const RunSummary all = bench::summarize(rows);
    legend.emplace_back(barColor(legend.size()),
                        name + ": " + numberText(all.success, 3) + " of " +
                            std::to_string(all.runs) + " runs");
    groups.push_back(bench::summarizeByProperty(rows));
  }
  canvas.text({margin, 26},
              view == BenchmarkView::Success
                  ? "Success of reconstructions"
                  : "Mean distance E_V of reconstructions from their curves: median, "
                    "quartiles, 5 and 95 %",
              title_size,
              ink::text,
              Align::Left,
              false,
              true);
  drawLegend(canvas, {margin, 56}, legend);

  const double panel_width = (width - 2 * margin - (columns - 1) * gap) / columns;
  const double panel_height = (height - head) / lines;
  for (std::size_t property = 0; property < groups.front().size(); ++property) {
    std::vector<SummaryGroup> same;
    same.reserve(groups.size());
    for (const auto& group : groups)
      same.push_back(group[property]);
    const double left =
        margin + static_cast<double>(property % columns) * (panel_width + gap);
    const std::size_t line = property / columns;
    const double top = head + static_cast<double>(line) * panel_height;
    drawPanel(canvas,
              {left, left + panel_width, top + title, top + panel_height - foot},
              same,
              view);
  }
  return canvas;
}

} // namespace linelet::apps
