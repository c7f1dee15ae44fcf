// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_around.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/support/text.h>

#include "box_kernels.h"

namespace linelet::clustering {

namespace {

struct Range {
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;

  bool
  empty() const
  {
    return !(low.x() <= high.x());
  }

  void
  add(const Range& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
};

/** \brief The box of what \a place makes of the points; NaN makes it no larger. */
template <class Place>
Range
rangeOf(const Points& points, int threads, const Place& place)
{
  Range whole;
#pragma omp parallel num_threads(threads)
  {
    Range range;
#pragma omp for schedule(static) nowait
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(points.size()); ++i) {
      const Point at = place(points[static_cast<std::size_t>(i)]);
      if (!at.allFinite())
        continue;
      range.low = range.low.cwiseMin(at);
      range.high = range.high.cwiseMax(at);
    }
#pragma omp critical
    whole.add(range);
  }
  return whole;
}

/** \brief The box of the points. */
Range
rangeOf(const Points& points, int threads)
{
  Range whole;
  const BoxKernels kernels = boxKernels();
  const auto parts = static_cast<std::size_t>(threads);
#pragma omp parallel for num_threads(threads)
  for (int part = 0; part < threads; ++part) {
    Range range;
    const auto number = static_cast<std::size_t>(part);
    const std::size_t begin = points.size() * number / parts;
    kernels.extend(points.data() + begin,
                   points.size() * (number + 1) / parts - begin,
                   {range.low.data(), range.high.data()});
#pragma omp critical
    whole.add(range);
  }
  return whole;
}

[[noreturn]] void
refuse()
{
  throw std::invalid_argument("there would be more than 2^40 cells; choose larger or "
                              "fewer cells");
}

void
checkNumber(const Cell& cells)
{
  constexpr double most = 1099511627776.; // 2^40
  if (static_cast<double>(cells[0]) * cells[1] * cells[2] > most)
    refuse();
}

Cell
cellsOf(const std::vector<double>& counts)
{
  Cell cells{};
  for (std::size_t a = 0; a < 3; ++a)
    cells[a] = static_cast<std::int32_t>(counts[a]);
  checkNumber(cells);
  return cells;
}

CellFrame
boxes(const Points& points, const ClusterSettings& settings, double leaf, int threads)
{
  CellFrame frame;
  const Range range = rangeOf(points, threads);
  if (range.empty())
    return frame;
  frame.low = range.low;
  const Point extent = range.high - range.low;
  if (leaf > 0) {
    constexpr double most_along = 1e9;
    frame.size.setConstant(leaf);
    for (std::size_t a = 0; a < 3; ++a) {
      const double number = std::floor(extent[static_cast<Eigen::Index>(a)] / leaf) + 1;
      if (!(number < most_along))
        refuse();
      frame.cells[a] = static_cast<std::int32_t>(number);
    }
    checkNumber(frame.cells);
  }
  else {
    frame.cells = cellsOf(settings.cells);
    for (Eigen::Index a = 0; a < 3; ++a)
      frame.size[a] = extent[a] > 0
                          ? extent[a] / frame.cells[static_cast<std::size_t>(a)]
                          : 1; // a flat cloud fills one layer of them
  }
  frame.inverse = frame.size.cwiseInverse();
  if (!frame.inverse.allFinite() || !extent.allFinite())
    throw std::invalid_argument("the cloud is too small or too large for such cells");
  return frame;
}

CellFrame
pieces(const Points& points, const ClusterSettings& settings, int threads)
{
  const Camera& camera = *settings.camera;
  CellFrame frame;
  frame.perspective = true;
  frame.cells = cellsOf(settings.cells);
  frame.eye = camera.eye;
  frame.axes = camera.axes;
  frame.tangent_y = camera.halfHeight();
  frame.tangent_x = frame.tangent_y * camera.width / camera.height;
  frame.scale_x = frame.cells[0] / (2 * frame.tangent_x);
  frame.scale_y = frame.cells[1] / (2 * frame.tangent_y);
  double near = camera.near, far = camera.far;
  if (!(near > 0) || !std::isfinite(far)) {
    // The depths of the points in view.
    const auto depth = [&](const Point& point) -> Point {
      const Point at = frame.axes * (point - frame.eye);
      const bool seen = at.z() > 0 && std::abs(at.x()) <= frame.tangent_x * at.z() &&
                        std::abs(at.y()) <= frame.tangent_y * at.z();
      return Point::Constant(seen ? at.z() : std::nan(""));
    };
    const Range range = rangeOf(points, threads, depth);
    // Rounding must not put the outermost points outside.
    constexpr double sliver = 1e-9;
    if (!(near > 0))
      near = range.empty() ? 1 : range.low.x() * (1 - sliver);
    if (!std::isfinite(far))
      far = range.empty() ? 2 * near : range.high.x() * (1 + sliver);
  }
  if (!(far > near))
    throw std::invalid_argument("the camera's far depth " + textOf(far) +
                                " is not beyond its near depth " + textOf(near));
  const int layers = frame.cells[2];
  for (int k = 0; k <= layers; ++k)
    frame.depths.push_back(near *
                           std::pow(far / near, static_cast<double>(k) / layers));
  frame.depths.front() = near;
  frame.depths.back() = far;
  return frame;
}

} // namespace

CellFrame
frameAround(const Points& points,
            const ClusterSettings& settings,
            double leaf,
            int threads)
{
  return settings.camera ? pieces(points, settings, threads)
                         : boxes(points, settings, leaf, threads);
}

} // namespace linelet::clustering
