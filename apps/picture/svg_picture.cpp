// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "svg_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace linelet::apps {

namespace {

constexpr std::size_t most_points = 20000;
constexpr double margin = 24;
/// Position of the eye relative to the middle of the scene, in half diagonals.
constexpr double eye_distance = 3;

/// Curves, distinct for color-blind readers (Okabe, Ito 2008).
constexpr std::array<const char*, 5> palette = {
    "#d65f00", "#0073b3", "#cc78a6", "#009e73", "#e69e00"};

std::string
number(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

std::string
hex(const Color& color)
{
  std::array<char, 16> text{};
  const auto byte = [&](std::size_t k) {
    return static_cast<int>(std::lround(255 * std::clamp(color[k], 0.0, 1.0)));
  };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(0), byte(1), byte(2));
  return text.data();
}

std::string
escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
    result += c == '<'   ? std::string("&lt;")
              : c == '&' ? std::string("&amp;")
                         : std::string(1, c);
  return result;
}

/** \brief A position on the paper, and the scale there. */
struct Seen {
  double x, y;
  double scale; ///< pixels per unit
  double depth; ///< away from the eye
};

class Camera {
public:
  Camera(const CloudView& view, int width, int height)
      : perspective_(view.elevation < 90)
  {
    constexpr double degree = M_PI / 180;
    const double e = view.elevation * degree;
    // From above, north is up.
    const double a = (perspective_ ? view.azimuth : 180) * degree;
    const Point to_eye(
        std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e));
    axes_.row(0) = Point(-std::cos(a), std::sin(a), 0); // right
    axes_.row(2) = -to_eye;
    axes_.row(1) = axes_.row(2).cross(axes_.row(0)); // down

    Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
    forEachPlace(view, [&](const Point& p) {
      low = low.cwiseMin(axes_ * p);
      high = high.cwiseMax(axes_ * p);
    });
    if (!(low.array() <= high.array()).all())
      low = high = Point::Zero();
    middle_ = (low + high) / 2;
    distance_ = eye_distance * std::max((high - low).norm() / 2, 1e-9);

    // Center what is visible.
    double left = std::numeric_limits<double>::infinity(), top = left, right = -left,
           bottom = -left;
    forEachPlace(view, [&](const Point& p) {
      const Seen at = (*this)(p);
      left = std::min(left, at.x);
      right = std::max(right, at.x);
      top = std::min(top, at.y);
      bottom = std::max(bottom, at.y);
    });
    if (!(left <= right))
      return;
    const double head = view.title.empty() ? margin : 52;
    scale_ = std::min((width - 2 * margin) / std::max(right - left, 1e-12),
                      (height - head - margin) / std::max(bottom - top, 1e-12));
    if (!std::isfinite(scale_) || scale_ > 1e9)
      scale_ = 1;
    x_ = width / 2.0 - scale_ * (left + right) / 2;
    y_ = (head + height - margin) / 2 - scale_ * (top + bottom) / 2;
  }

  Seen
  operator()(const Point& point) const
  {
    const Point p = axes_ * point - middle_;
    const double depth = distance_ + p.z();
    const double scale = scale_ * (perspective_ ? distance_ / depth : 1);
    return {x_ + scale * p.x(), y_ + scale * p.y(), scale, depth};
  }

  bool
  perspective() const
  {
    return perspective_;
  }

  /** \brief The scale at the center. */
  double
  pixelsPerUnit() const
  {
    return scale_;
  }

  /** \brief The projected ellipse of a tensor. */
  Eigen::Matrix2d
  shadow(const Eigen::Matrix3d& tensor) const
  {
    return axes_.topRows<2>() * tensor * axes_.topRows<2>().transpose();
  }

private:
  template <class Visit>
  static void
  forEachPlace(const CloudView& view, const Visit& visit)
  {
    for (const Point& p : view.points)
      if (p.allFinite())
        visit(p);
    for (const Curve& curve : view.curves.curves)
      for (const Point& p : curve.points)
        visit(p);
  }

  bool perspective_;
  Eigen::Matrix3d axes_;
  Point middle_ = Point::Zero();
  double distance_ = 1, scale_ = 1, x_ = 0, y_ = 0;
};

std::string
pathOf(const std::vector<Spot>& spots, bool closed)
{
  std::string path;
  for (const Spot& spot : spots)
    path += (path.empty() ? "M" : " L") + number(spot.x) + " " + number(spot.y);
  return path + (closed ? " Z" : "");
}

/** \brief Unit vector to the left of the edge between two positions; zero if they
 * coincide. */
Spot
sideOf(const Seen& from, const Seen& to)
{
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  return length > 0 ? Spot{-dy / length, dx / length} : Spot{0, 0};
}

/** \brief The offset, on the paper, from each vertex to the side of the band that
 * represents a curve. It is longer at corners, so that edges keep their width. */
std::vector<Spot>
sides(const std::vector<Seen>& seen, double width, bool closed)
{
  constexpr double sharpest = 0.25; // corners that stick out farther are cut
  std::vector<Spot> result;
  const std::size_t n = seen.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0 && !closed, last = i + 1 == n && !closed;
    const Spot before =
        first ? Spot{0, 0} : sideOf(seen[i > 0 ? i - 1 : n - 1], seen[i]);
    const Spot after = last ? Spot{0, 0} : sideOf(seen[i], seen[i + 1 < n ? i + 1 : 0]);
    Spot way = {before.x + after.x, before.y + after.y};
    const double length = std::hypot(way.x, way.y);
    if (length > 0)
      way = {way.x / length, way.y / length};
    const double turn = std::max(way.x * before.x + way.y * before.y,
                                 way.x * after.x + way.y * after.y);
    const double half = width * seen[i].scale / 2 / std::max(sharpest, turn);
    result.push_back({way.x * half, way.y * half});
  }
  return result;
}

std::string
curveElement(const Curve& curve,
             const Camera& camera,
             double curve_width,
             const char* color)
{
  std::vector<Seen> seen;
  std::vector<Spot> spots;
  for (const Point& p : curve.points) {
    seen.push_back(camera(p));
    spots.push_back({seen.back().x, seen.back().y});
  }
  if (!camera.perspective())
    return "<path class=\"curve\" d=\"" + pathOf(spots, curve.closed) +
           "\" fill=\"none\" stroke=\"" + color + "\" stroke-width=\"" +
           number(curve_width) + "\" stroke-linejoin=\"round\"/>\n";
  const std::vector<Spot> side =
      sides(seen, curve_width / camera.pixelsPerUnit(), curve.closed);
  const auto edge = [&](double sign) {
    std::vector<Spot> line;
    for (std::size_t i = 0; i < spots.size(); ++i)
      line.push_back({spots[i].x + sign * side[i].x, spots[i].y + sign * side[i].y});
    return line;
  };
  const std::vector<Spot> one = edge(1);
  std::vector<Spot> other = edge(-1);
  std::string path;
  if (curve.closed) // a ring: two outlines, filled between
    path = pathOf(one, true) + " " + pathOf(other, true);
  else {
    std::vector<Spot> around = one;
    std::reverse(other.begin(), other.end());
    around.insert(around.end(), other.begin(), other.end());
    path = pathOf(around, true);
  }
  return "<path class=\"curve\" d=\"" + path + "\" fill=\"" + color +
         "\" fill-rule=\"evenodd\" stroke=\"#202024\" stroke-width=\"0.8\" "
         "stroke-linejoin=\"round\"/>\n";
}

/** \brief \a items sorted by depth, far ones first. */
std::vector<std::size_t>
farFirst(const std::vector<double>& depth)
{
  std::vector<std::size_t> order(depth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return depth[a] > depth[b];
  });
  return order;
}

std::string
ellipseElement(const Eigen::Matrix3d& tensor,
               const Color& color,
               double size,
               const Seen& at,
               const Camera& camera)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(camera.shadow(tensor));
  const auto radius = [&](int k) {
    return size * at.scale * std::sqrt(std::max(0.0, solver.eigenvalues()[k]));
  };
  const Eigen::Vector2d way = solver.eigenvectors().col(1);
  const double angle = std::atan2(way.y(), way.x()) * 180 / M_PI;
  return "<ellipse cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" rx=\"" +
         number(radius(1)) + "\" ry=\"" + number(radius(0)) + "\" transform=\"rotate(" +
         number(angle) + " " + number(at.x) + " " + number(at.y) + ")\" fill=\"" +
         hex(color) + "\" fill-opacity=\"0.6\" stroke=\"" +
         hex(mix(color, {0, 0, 0}, 0.5)) + "\" stroke-width=\"0.5\"/>\n";
}

/** \brief A square of \a color and its \a name, at the bottom of the paper. */
std::string
legendEntry(std::size_t x, int height, const std::string& color, const char* name)
{
  return "<rect x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(height - 26) +
         "\" width=\"14\" height=\"12\" fill=\"" + color + "\"/>\n<text x=\"" +
         std::to_string(x + 20) + "\" y=\"" + std::to_string(height - 16) +
         "\" font-size=\"13\">" + name + "</text>\n";
}

} // namespace

std::string
svgOfCloud(const CloudView& view,
           const SvgTensors& tensors,
           ShapeColors colors,
           int width,
           int height)
{
  const Camera camera(view, width, height);
  const std::string w = std::to_string(width), h = std::to_string(height);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w +
                     "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
                     "\" font-family=\"sans-serif\">\n<rect width=\"" + w +
                     "\" height=\"" + h + "\" fill=\"#ffffff\"/>\n";

  const bool drawn = view.points.size() <= most_points;
  std::vector<double> depth;
  for (const Point& p : view.points)
    depth.push_back(drawn && p.allFinite() ? camera(p).depth : 0);
  text += "<g class=\"points\">\n";
  for (const std::size_t i : farFirst(depth)) {
    if (!drawn || !view.points[i].allFinite())
      continue;
    const Seen at = camera(view.points[i]);
    if (!tensors.tensors.empty()) {
      if (tensors.tensors[i].allFinite())
        text += ellipseElement(
            tensors.tensors[i], tensors.colors[i], tensors.size, at, camera);
      continue;
    }
    const double size = view.point_size > 0 ? view.point_size : 2;
    text += "<circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"" +
            number(size / 2 * at.scale / camera.pixelsPerUnit()) + "\" fill=\"" +
            (view.colors.empty() ? "#9a9aa0" : hex(view.colors[i])) + "\"/>\n";
  }
  text += "</g>\n<g class=\"curves\">\n";
  std::vector<double> curve_depth;
  for (const Curve& curve : view.curves.curves) {
    double sum = 0;
    for (const Point& p : curve.points)
      sum += camera(p).depth;
    curve_depth.push_back(sum / std::max<double>(1, double(curve.points.size())));
  }
  for (const std::size_t i : farFirst(curve_depth))
    if (view.curves.curves[i].points.size() > 1)
      text += curveElement(
          view.curves.curves[i], camera, view.curve_width, palette[i % palette.size()]);
  text += "</g>\n";
  if (!view.title.empty())
    text += "<text x=\"24\" y=\"32\" font-size=\"18\" font-weight=\"bold\">" +
            escaped(view.title) + "</text>\n";
  if (!tensors.tensors.empty()) {
    const auto pure = shapeColors(colors);
    constexpr std::array<const char*, 3> names = {"linear", "planar", "spherical"};
    for (std::size_t k = 0; k < 3; ++k) {
      text += legendEntry(24 + 110 * k, height, hex(pure[k]), names[k]);
    }
  }
  return text + "</svg>\n";
}

} // namespace linelet::apps
