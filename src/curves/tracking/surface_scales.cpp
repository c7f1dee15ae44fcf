// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "surface_scales.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/neighborhood_tensor.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

namespace {

constexpr std::uint32_t least_planar = 8; // neighbors
constexpr double planar = 0.5, again_linear = 0.7;
// This many points of a surface are not even this linear by chance; widely scattered
// points of a curve are.
constexpr double hardly_linear = 0.55;
constexpr std::uint32_t many = 12;
// Of the cells of a disc that scattered points would occupy, a surface fills most, and
// lines side by side leave many empty.
constexpr double disc_radius = 6; // radii at which it is planar
constexpr std::size_t disc_cells = 12;
constexpr double least_filled = 0.6;
// Rows of scan lines leave cells empty, too; a few curves side by side leave most.
constexpr double hardly_filled = 0.25;
// Exponents by which the neighbors of a point of a surface grow with the radius.
constexpr double least_growth = 1.2, most_growth = 3;

/** \brief Whether the points around \a p fill a disc, rather than a few lines side by
 * side.
 * \param[in] radius at which the neighborhood becomes planar; the disc is larger
 * \param[in] filled least share of the cells that scattered points would occupy */
bool
fillsDisc(const UniformGrid& grid, const Point& p, double radius, double filled)
{
  Points near;
  grid.forEachOffsetWithin(
      p, disc_radius * radius, [&](const Point& v, double) { near.push_back(v); });
  const double reach = disc_radius * radius;
  const EigenSystem axes =
      eigenAnalysis(neighborhoodTensor(near, Point::Zero(), reach, Kernel::Const));
  if (shapeFactors(axes.values, reach).linearity >= linear_ball)
    return false; // a curve, whose scatter is flatter than wide
  std::array<char, disc_cells * disc_cells> occupied{};
  const auto cell = [&](double x) {
    const double place = (x / reach + 1) / 2 * disc_cells;
    return static_cast<std::size_t>(std::clamp(place, 0.0, disc_cells - 0.5));
  };
  double count = 0;
  for (const Point& v : near) {
    if (std::abs(axes.normal().dot(v)) > radius)
      continue;
    count += 1;
    occupied[cell(axes.vectors.col(1).dot(v)) * disc_cells +
             cell(axes.vectors.col(2).dot(v))] = 1;
  }
  const double cells = M_PI / 4 * disc_cells * disc_cells;
  const double random = cells * (1 - std::exp(-count / cells));
  return static_cast<double>(std::count(occupied.begin(), occupied.end(), 1)) >=
         filled * random;
}

} // namespace

SurfaceScales
surfaceScales(const ShapeGraph& graph, const std::vector<double>& radii)
{
  SurfaceScales result;
  int run = 0;
  bool linear_before = false, hardly_before = false;
  for (std::size_t k = 0; k < graph.size(); ++k) {
    const ScaleShape& shape = graph[k];
    const bool is_linear =
        shape.linearity >= linear_ball && shape.neighbors >= least_linear;
    const bool is_hardly = shape.linearity >= hardly_linear && shape.neighbors >= many;
    if (result.any)
      result.linear = result.linear || shape.linearity >= again_linear;
    else {
      linear_before = linear_before || is_linear;
      hardly_before = hardly_before || is_hardly;
    }
    if (!(shape.planarity >= planar) || shape.neighbors < least_planar) {
      run = 0;
      continue;
    }
    if (run > 0) {
      const double growth = std::log(double(shape.neighbors) / graph[k - 1].neighbors) /
                            std::log(radii[k] / radii[k - 1]);
      if (growth < least_growth || growth > most_growth)
        run = 0;
    }
    if (++run < 3 || result.any)
      continue;
    result.any = true;
    result.radius = radii[k - 2];
    result.density = graph[k - 2].neighbors / (M_PI * result.radius * result.radius);
    result.linear = linear_before;
    result.hardly = hardly_before;
  }
  return result;
}

double
reachOf(const SurfaceScales& scales)
{
  return scales.isDoubtful() ? disc_radius * scales.radius : 0;
}

bool
isSurface(const UniformGrid& grid, const Point& p, const SurfaceScales& scales)
{
  if (!scales.isDoubtful())
    return scales.any;
  return fillsDisc(
      grid, p, scales.radius, scales.linear ? least_filled : hardly_filled);
}

} // namespace linelet
