// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_view.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "axes.h"

namespace linelet::apps {

namespace {

constexpr double far_away = std::numeric_limits<double>::infinity();

/// Parallel projection: x to the right, y down in fine pixels, z away from the eye.
class Projection {
public:
  Projection(const CloudView& view, int width, int height, double bottom)
  {
    constexpr double degree = M_PI / 180;
    const double a = view.azimuth * degree, e = view.elevation * degree;
    const Point to_eye(
        std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e));
    axes_.row(0) = Point(-std::cos(a), std::sin(a), 0); // right
    axes_.row(2) = -to_eye;
    axes_.row(1) = axes_.row(2).cross(axes_.row(0)); // down

    Point low = Point::Constant(far_away), high = -low;
    const auto extend = [&](const Point& point) {
      if (point.allFinite()) {
        low = low.cwiseMin(axes_ * point);
        high = high.cwiseMax(axes_ * point);
      }
    };
    std::for_each(view.points.begin(), view.points.end(), extend);
    for (const Curve& curve : view.curves.curves)
      std::for_each(curve.points.begin(), curve.points.end(), extend);
    if (!(low.array() <= high.array()).all())
      low = high = Point::Zero();

    const double margin = 24, top = view.title.empty() ? margin : 52;
    const double free_width = width - 2 * margin;
    const double free_height = height - top - bottom - margin;
    scale_ = std::min(free_width / std::max(high.x() - low.x(), 1e-12),
                      free_height / std::max(high.y() - low.y(), 1e-12));
    if (!std::isfinite(scale_) || scale_ > 1e9)
      scale_ = 1;
    origin_ = (low + high) / 2;
    center_ = Point(width / 2.0, top + free_height / 2, 0);
  }

  /// In output pixels.
  Point
  operator()(const Point& point) const
  {
    return (axes_ * point - origin_) * scale_ + center_;
  }

  double
  pixelsPerUnit() const
  {
    return scale_;
  }

  /// The same view with \a fineness pixels per output pixel.
  Camera
  camera(int width, int height, int fineness = 1) const
  {
    Camera camera;
    camera.axes = axes_;
    camera.eye = axes_.transpose() *
                 (origin_ + (Point(width / 2.0, height / 2.0, 0) - center_) / scale_);
    camera.field_of_view = 0;
    camera.view_height = height / scale_;
    camera.width = width * fineness;
    camera.height = height * fineness;
    camera.near = -far_away;
    return camera;
  }

private:
  Eigen::Matrix3d axes_;
  Point origin_, center_;
  double scale_ = 1;
};

/// Nearest point of every fine pixel.
struct DepthImage {
  int width, height;
  std::vector<double> depth;
  std::vector<Color> color;

  std::size_t
  at(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

void
splat(DepthImage& image, const Point& center, double radius, const Color& color)
{
  const int left = std::max(0, static_cast<int>(std::floor(center.x() - radius)));
  const int right =
      std::min(image.width - 1, static_cast<int>(std::ceil(center.x() + radius)));
  const int top = std::max(0, static_cast<int>(std::floor(center.y() - radius)));
  const int bottom =
      std::min(image.height - 1, static_cast<int>(std::ceil(center.y() + radius)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      if (std::hypot(x + 0.5 - center.x(), y + 0.5 - center.y()) <= radius &&
          center.z() < image.depth[image.at(x, y)]) {
        image.depth[image.at(x, y)] = center.z();
        image.color[image.at(x, y)] = color;
      }
}

/// How much light reaches a pixel: less where its surroundings are nearer to the eye
/// (eye-dome lighting, after Boucheny 2009).
double
light(const DepthImage& image, int x, int y, int reach)
{
  constexpr std::array<std::array<int, 2>, 8> ways = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  const double here = image.depth[image.at(x, y)];
  double shade = 0;
  for (const auto& way : ways) {
    const int u = x + reach * way[0], v = y + reach * way[1];
    if (u < 0 || v < 0 || u >= image.width || v >= image.height)
      continue;
    const double there = image.depth[image.at(u, v)];
    if (there < here)
      shade += std::min(1.0, (here - there) / (8.0 * reach));
  }
  return std::max(0.45, std::exp(-1.8 * shade / ways.size()));
}

/// The color of a normal that faces the eye, from its components to the right, up, and
/// toward the eye; or shading by light from above the eye's left shoulder.
Color
colorOfNormal(const Point& normal, PixelColor by)
{
  if (!normal.allFinite())
    return ink::grid;
  if (by == PixelColor::Normal)
    return {0.5 + 0.5 * normal.x(), 0.5 - 0.5 * normal.y(), 0.5 - 0.5 * normal.z()};
  const Point light = Point(-0.5, -0.6, -0.62).normalized();
  const double bright = 0.22 + 0.76 * std::max(0.0, normal.dot(light));
  return {bright, bright, bright};
}

/// Light on a point by its normal, on either side.
Color
lit(const Point& normal, const Eigen::Matrix3d& axes)
{
  const Point seen = axes * normal; // right, down, away
  return colorOfNormal(seen.z() > 0 ? Point(-seen) : seen, PixelColor::Shaded);
}

/// Colors every fine pixel that sees something by the normal there.
void
colorByNormals(DepthImage& image,
               const Canvas& canvas,
               const CloudView& view,
               const Projection& project,
               double point_size)
{
  const Camera camera = project.camera(canvas.width(), canvas.height());
  const SampleLayers samples =
      sampleLayers(view.points, camera, point_size, 0, 8, view.normals.threads);
  const double behind = camera.height / project.pixelsPerUnit() * 1e3;
  const Point eye = camera.axes.row(2).transpose() * -behind;
  const NormalImage normals = screenNormals(samples, eye.cast<float>(), view.normals);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      if (!(image.depth[image.at(x, y)] < far_away))
        continue;
      const std::size_t k = samples.at(x / Canvas::fineness, y / Canvas::fineness);
      const Point normal = camera.axes * Point(static_cast<double>(normals.x[k]),
                                               static_cast<double>(normals.y[k]),
                                               static_cast<double>(normals.z[k]));
      image.color[image.at(x, y)] = colorOfNormal(normal, view.pixels);
    }
}

void
drawPoints(Canvas& canvas, const CloudView& view, const Projection& project)
{
  DepthImage image = {canvas.fineWidth(), canvas.fineHeight(), {}, {}};
  const std::size_t count =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.depth.assign(count, far_away);
  image.color.resize(count);
  double size = view.point_size;
  if (!(size > 0)) {
    // So large that points cover half of the paper if evenly spread; for normals, many
    // times all of it.
    const bool own = view.pixels == PixelColor::OfPoints;
    const double count = std::max<double>(1, static_cast<double>(view.points.size()));
    size = std::clamp(
        std::sqrt((own ? 0.5 : 6) * canvas.width() * canvas.height() / count),
        own ? 1.4 : 3,
        own ? 6.0 : 9);
  }
  const double radius = size / 2 * Canvas::fineness;
  const Eigen::Matrix3d axes = project.camera(canvas.width(), canvas.height()).axes;
  for (std::size_t i = 0; i < view.points.size(); ++i)
    if (view.points[i].allFinite())
      splat(image,
            project(view.points[i]) * Canvas::fineness,
            radius,
            !view.point_normals.empty() ? lit(view.point_normals[i], axes)
            : view.colors.empty()       ? ink::grid
                                        : view.colors[i]);
  if (view.pixels != PixelColor::OfPoints)
    colorByNormals(image, canvas, view, project, size);
  const int reach = std::max(2, static_cast<int>(std::lround(1.3 * Canvas::fineness)));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.depth[image.at(x, y)] < far_away)
        canvas.setFine(
            x,
            y,
            mix({0.05, 0.05, 0.08},
                image.color[image.at(x, y)],
                view.pixels == PixelColor::Normal ? 1 : light(image, x, y, reach)));
}

void
drawCurves(Canvas& canvas, const CloudView& view, const Projection& project)
{
  // Distinct for color-blind readers (Okabe, Ito 2008), bright ones first.
  constexpr std::array<Color, 5> palette = {{{0.84, 0.37, 0.00},
                                             {0.00, 0.45, 0.70},
                                             {0.80, 0.47, 0.65},
                                             {0.00, 0.62, 0.45},
                                             {0.90, 0.62, 0.00}}};
  for (const bool halo : {true, false})
    for (std::size_t i = 0; i < view.curves.curves.size(); ++i) {
      const Curve& curve = view.curves.curves[i];
      std::vector<Spot> spots;
      for (const Point& point : curve.points) {
        const Point at = project(point);
        spots.push_back({at.x(), at.y()});
      }
      if (curve.closed && !spots.empty())
        spots.push_back(spots.front());
      canvas.polyline(spots,
                      view.curve_width + (halo ? 2 : 0),
                      halo ? ink::paper : palette[i % palette.size()]);
    }
}

void
drawScaleBar(Canvas& canvas,
             const CloudView& view,
             double pixels_per_unit,
             double bottom)
{
  const double longest = canvas.width() / 5.0 / pixels_per_unit;
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  double length = power;
  for (const double step : {2.0, 5.0})
    if (step * power <= longest)
      length = step * power;
  const double pixels = length * pixels_per_unit;
  const Spot left = {24, canvas.height() - bottom - 14};
  canvas.line(left, {left.x + pixels, left.y}, 3, ink::text);
  canvas.line({left.x, left.y - 5}, {left.x, left.y + 5}, 2, ink::text);
  canvas.line(
      {left.x + pixels, left.y - 5}, {left.x + pixels, left.y + 5}, 2, ink::text);
  canvas.text({left.x + pixels + 9, left.y},
              numberText(length) + (view.unit.empty() ? "" : " " + view.unit),
              text_size);
}

} // namespace

Canvas
drawCloud(const CloudView& view, int width, int height, double bottom)
{
  Canvas canvas(width, height);
  const Projection project(view, width, height, bottom + 20);
  drawPoints(canvas, view, project);
  drawCurves(canvas, view, project);
  drawScaleBar(canvas, view, project.pixelsPerUnit(), bottom);
  if (!view.title.empty())
    canvas.text({24, 26}, view.title, title_size, ink::text, Align::Left, false, true);
  return canvas;
}

Canvas
drawImage(
    const CloudView& view, const DrawImage& draw, int width, int height, double bottom)
{
  Canvas canvas(width, height);
  const Projection project(view, width, height, bottom + 20);
  const GlyphImage image = draw(project.camera(width, height, Canvas::fineness));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::array<float, 4>& pixel = image.at(x, y);
      Color color{};
      for (std::size_t c = 0; c < 3; ++c)
        color[c] = static_cast<double>(pixel[c]) +
                   (1 - static_cast<double>(pixel[3])) * ink::paper[c];
      canvas.setFine(x, y, color);
    }
  drawCurves(canvas, view, project);
  drawScaleBar(canvas, view, project.pixelsPerUnit(), bottom);
  if (!view.title.empty())
    canvas.text({24, 26}, view.title, title_size, ink::text, Align::Left, false, true);
  return canvas;
}

} // namespace linelet::apps
