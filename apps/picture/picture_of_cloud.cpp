// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <linelet/features/fourth_order.h>
#include <linelet/features/tensor_estimation.h>
#include <linelet/search/scale_unit.h>
#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/shape_factors.h>

#include "axes.h"
#include "categories.h"
#include "cloud_view.h"
#include "pictures.h"
#include "plain_view.h"
#include "scale_cost.h"
#include "svg_picture.h"

namespace linelet::apps {

namespace {

double
median(std::vector<double>& values)
{
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median over the scales of each factor, mapped to a color.
std::vector<Color>
colorsByShape(const Points& points,
              MultiScaleSettings settings,
              ShapeColors colors,
              Frame& frame)
{
  std::vector<Color> result(points.size(), ink::grid);
  std::array<std::vector<double>, 3> factors;
  settings.radii = multiScaleRadii(points, settings, &frame.monitor).radii;
  settings.stop_change = 0; // already applied to the radii
  settings.engine = chosenScaleEngine(points, points, settings.radii.back(), settings);
  announceMultiScale(points, points, settings, frame);
  multiScaleShapes(
      points,
      points,
      settings,
      [&](std::size_t point, const ShapeGraph& graph) {
        for (auto& values : factors)
          values.clear();
        for (const ScaleShape& shape : graph)
          if (!std::isnan(shape.linearity)) {
            factors[0].push_back(static_cast<double>(shape.linearity));
            factors[1].push_back(static_cast<double>(shape.planarity));
            factors[2].push_back(static_cast<double>(shape.sphericity));
          }
        if (!factors[0].empty())
          result[point] = shapeColor(
              colors, median(factors[0]), median(factors[1]), median(factors[2]));
      },
      &frame.monitor);
  return result;
}

/// Values with the range that the colors span: nearly all values, but no outliers.
struct Scalars {
  std::string name;
  std::vector<double> values;
  double low = 0, high = 1;
  std::vector<std::pair<Color, std::string>> legend; // labels, which have no range
};

Scalars
scalars(const io::Cloud& cloud, const std::string& name, const std::string& file)
{
  Scalars result;
  result.name = name;
  const bool height = name == "height" || name == "gray";
  const io::Column* column = height ? nullptr : cloud.find(name);
  if (!height && column == nullptr) {
    std::string names;
    for (const io::Column& other : cloud.columns)
      names += " " + other.name;
    throw std::runtime_error(
        file + ": there is no attribute '" + name +
        "' to color by; use shape, height, gray, rgb, normal, shaded or one of its "
        "own:" +
        (names.empty() ? " none" : names));
  }
  std::vector<double> known;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    result.values.push_back(height ? cloud.points[i].z() + cloud.shift.z()
                                   : io::valueAt(*column, i));
    if (std::isfinite(result.values.back()))
      known.push_back(result.values.back());
  }
  if (known.empty())
    return result;
  std::sort(known.begin(), known.end());
  const auto quantile = [&](double part) {
    return known[static_cast<std::size_t>(part *
                                          static_cast<double>(known.size() - 1))];
  };
  result.low = quantile(0.01);
  result.high = quantile(0.99);
  if (!(result.high > result.low)) {
    result.low = known.front();
    result.high = known.back();
  }
  return result;
}

double
relative(const Scalars& scalars, double value)
{
  return scalars.high > scalars.low
             ? std::clamp(
                   (value - scalars.low) / (scalars.high - scalars.low), 0.0, 1.0)
             : 0.5;
}

std::vector<Color>
colorsByScalar(const Scalars& scalars, bool gray)
{
  std::vector<Color> colors;
  for (const double value : scalars.values) {
    const double t = relative(scalars, value);
    colors.push_back(!std::isfinite(value) ? ink::grid
                     : gray ? mix({0.62, 0.63, 0.66}, {0.90, 0.90, 0.92}, t)
                            : scalarColor(t));
  }
  return colors;
}

std::vector<Color>
colorsByRgb(const io::Cloud& cloud, const std::string& file)
{
  const io::Column* channels[3] = {
      cloud.find("red"), cloud.find("green"), cloud.find("blue")};
  double largest = 0;
  for (const io::Column* channel : channels) {
    if (channel == nullptr)
      throw std::runtime_error(file + ": there are no colors (red, green, blue); use "
                                      "--color height");
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      largest = std::max(largest, io::valueAt(*channel, i));
  }
  const double full =
      largest > 255 ? 65535 : 255; // LAS specifies 16 bits, but many files use 8
  std::vector<Color> colors(cloud.points.size());
  for (std::size_t i = 0; i < colors.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      colors[i][c] = io::valueAt(*channels[c], i) / full;
  return colors;
}

constexpr double legend_height = 58;

void
drawScalarLegend(Canvas& canvas, const Scalars& scalars)
{
  constexpr double left = 24, bar_width = 320, bar_height = 14;
  const double top = canvas.height() - 42;
  const Axis axis(scalars.low, scalars.high, left, left + bar_width, false);
  constexpr int steps = 160;
  for (int i = 0; i < steps; ++i)
    canvas.rectangle({left + bar_width * i / steps, top},
                     bar_width / steps,
                     bar_height,
                     scalarColor((i + 0.5) / steps));
  for (const double value : axis.ticks()) {
    canvas.line({axis.pixel(value), top + bar_height},
                {axis.pixel(value), top + bar_height + 4},
                1,
                ink::frame);
    canvas.text({axis.pixel(value), top + bar_height + 14},
                numberText(value),
                text_size - 2,
                ink::text,
                Align::Center);
  }
  canvas.text({left + bar_width + 16, top + bar_height / 2}, scalars.name, text_size);
}

/** The legend entries that fit side by side, and how many more there are. */
std::vector<std::pair<Color, std::string>>
asManyAsFit(std::vector<std::pair<Color, std::string>> entries, double width)
{
  constexpr double beside = 45, more = 90; // swatch and gaps of an entry; the last one
  double used = 0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    used += beside + Canvas::textWidth(entries[k].second, text_size);
    if (used > width - more && k + 1 < entries.size()) {
      const std::size_t left_out = entries.size() - k;
      entries.resize(k);
      entries.emplace_back(ink::grid, "and " + std::to_string(left_out) + " more");
    }
  }
  return entries;
}

Points
minorEigenvectors(const Points& points,
                  const PictureSettings& settings,
                  const std::string& file,
                  Frame& frame)
{
  TensorSettings tensors;
  tensors.radius = settings.radius > 0 ? settings.radius
                                       : 4 * scaleUnit(points, 1024, 1, frame.threads);
  if (!(tensors.radius > 0))
    throw std::runtime_error(file + ": no scale can be chosen; give --tensor-radius");
  tensors.weighting = Kernel::Const;
  tensors.threads = frame.threads;
  Points normals;
  for (const PointDistributionTensor& r :
       estimateTensors(points, points, tensors, {}, &frame.monitor))
    normals.emplace_back(r.normal_x, r.normal_y, r.normal_z);
  frame.lap("tensors");
  frame.summary["tensor_radius"] = tensors.radius;
  return normals;
}

/// The cloud as drawn, and the values that color it, if any.
CloudView
viewOf(const io::Cloud& cloud,
       const PictureSettings& settings,
       const MultiScaleSettings& shapes,
       const std::string& file,
       Frame& frame,
       Scalars& values)
{
  CloudView view = plainView(cloud, settings);
  view.point_size = settings.point_size;

  if (settings.color == "normal" || settings.color == "shaded") {
    view.pixels = settings.color == "normal" ? PixelColor::Normal : PixelColor::Shaded;
    view.normals = settings.normals;
    view.normals.threads = frame.threads;
  }
  else if (settings.color == "minor")
    view.point_normals = minorEigenvectors(cloud.points, settings, file, frame);
  else if (settings.color == "shape")
    view.colors = colorsByShape(cloud.points, shapes, settings.colors, frame);
  else if (settings.color == "rgb")
    view.colors = colorsByRgb(cloud, file);
  else if (const io::Column* named = cloud.find(settings.color);
           named != nullptr && isCategorical(*named)) {
    Categories categories = categoriesOf(*named);
    view.colors = std::move(categories.colors);
    values.legend = std::move(categories.legend);
  }
  else {
    values = scalars(cloud, settings.color, file);
    view.colors = colorsByScalar(values, settings.color == "gray");
  }
  return view;
}

/// The major eigentensors of the fourth-order tensors of all points, scaled to a
/// largest eigenvalue of 1, and their colors.
SvgTensors
majorEigentensors(const Points& points,
                  const MultiScaleSettings& shapes,
                  ShapeColors colors,
                  Frame& frame)
{
  SvgTensors result;
  const double unit = multiScaleRadii(points, shapes, &frame.monitor).scale_unit;
  result.size = unit > 0 ? unit : 1;
  for (const FourthOrderTensor& tensor : fourthOrderTensors(
           points, points, shapes, ScaleWeight::Linearity, &frame.monitor)) {
    const Eigen::Matrix3d major = tensor.eigenTensors().major();
    const EigenSystem system = eigenAnalysis(
        {major(0, 0), major(0, 1), major(0, 2), major(1, 1), major(1, 2), major(2, 2)});
    const ShapeFactors factors = shapeFactors(system.values);
    result.tensors.push_back(major / system.values[2]);
    result.colors.push_back(
        shapeColor(colors, factors.linearity, factors.planarity, factors.sphericity));
  }
  return result;
}

} // namespace

std::string
svgPictureOfCloud(const io::Cloud& cloud,
                  const PictureSettings& settings,
                  const MultiScaleSettings& shapes,
                  const std::string& file,
                  Frame& frame)
{
  Scalars values;
  const CloudView view = viewOf(cloud, settings, shapes, file, frame, values);
  if (view.pixels != PixelColor::OfPoints || !view.point_normals.empty())
    throw std::runtime_error(
        "--color " + settings.color +
        " needs pixels, which an .svg does not have; write a .png");
  SvgTensors tensors;
  if (settings.fourth_order)
    tensors = majorEigentensors(cloud.points, shapes, settings.colors, frame);
  return svgOfCloud(view,
                    tensors,
                    settings.colors,
                    static_cast<int>(settings.width),
                    static_cast<int>(settings.height));
}

Canvas
pictureOfCloud(const io::Cloud& cloud,
               const PictureSettings& settings,
               const MultiScaleSettings& shapes,
               const std::string& file,
               Frame& frame)
{
  const bool by_shape = settings.color == "shape", by_rgb = settings.color == "rgb";
  const bool gray = settings.color == "gray" || settings.color == "minor";
  Scalars values;
  const CloudView view = viewOf(cloud, settings, shapes, file, frame, values);
  const bool legend =
      by_shape || (!by_rgb && !gray && view.pixels == PixelColor::OfPoints);
  Canvas canvas = drawCloud(view,
                            static_cast<int>(settings.width),
                            static_cast<int>(settings.height),
                            legend ? legend_height : 8);
  if (by_shape) {
    const auto pure = shapeColors(settings.colors);
    drawLegend(canvas,
               {24, canvas.height() - 28.0},
               {{pure[0], "linear"},
                {pure[1], "planar"},
                {pure[2], "spherical, median over all radii"}});
  }
  else if (!values.legend.empty())
    drawLegend(canvas,
               {24, canvas.height() - 28.0},
               asManyAsFit(values.legend, canvas.width() - 48.0));
  else if (legend)
    drawScalarLegend(canvas, values);
  return canvas;
}

} // namespace linelet::apps
