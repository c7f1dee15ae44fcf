// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model_curve.h"

#include <algorithm>
#include <cmath>

#include "scale_field.h"

namespace linelet {

double
length(const ModelCurve& curve)
{
  double sum = 0;
  for (std::size_t e = 0; e < curve.edges(); ++e)
    sum += (curve.to(e) - curve.from(e)).norm();
  return sum;
}

double
length(const ModelCurves& curves)
{
  double sum = 0;
  for (const ModelCurve& curve : curves)
    sum += length(curve);
  return sum;
}

namespace {

/** \brief \a curve with each of its pieces between hinges (or ends) treated by
 * \a resample; the ring begins at a hinge. */
template <class Resample>
ModelCurve
piecewise(const ModelCurve& curve, Resample&& resample)
{
  const std::size_t n = curve.nodes.size();
  ModelCurve result = curve;
  result.nodes.clear();
  result.hinges.clear();
  std::vector<std::size_t> stops = curve.hinges;
  stops.push_back(curve.closed ? curve.hinges.front() + n : n - 1);
  if (!curve.closed)
    stops.insert(stops.begin(), 0);
  for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
    ModelCurve piece;
    for (std::size_t i = stops[k]; i <= stops[k + 1]; ++i)
      piece.nodes.push_back(curve.nodes[i % n]);
    piece = resample(piece);
    if (curve.closed || k > 0)
      result.hinges.push_back(result.nodes.size());
    result.nodes.insert(result.nodes.end(), piece.nodes.begin(), piece.nodes.end() - 1);
  }
  if (!curve.closed)
    result.nodes.push_back(curve.nodes.back());
  return result;
}

} // namespace

double
squaredDistance(const ModelCurve& curve, std::size_t e, const Point& p)
{
  const Point& from = curve.from(e);
  const Point way = curve.to(e) - from;
  const double t =
      std::clamp(way.dot(p - from) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
  return (from + t * way - p).squaredNorm();
}

ModelCurve
resampled(const ModelCurve& curve, double spacing)
{
  if (!curve.hinges.empty())
    return piecewise(
        curve, [&](const ModelCurve& piece) { return resampled(piece, spacing); });
  ModelCurve result = curve;
  const double total = length(curve);
  if (curve.edges() == 0 || !(total > 0))
    return result;
  const double least = curve.closed ? 4 : 1;
  const auto count =
      static_cast<std::size_t>(std::max(least, std::round(total / spacing)));
  const double step = total / static_cast<double>(count);
  result.nodes.clear();
  result.nodes.reserve(count + 1);
  result.nodes.push_back(curve.nodes.front());
  double walked = 0; // arc length at the start of the current edge
  for (std::size_t e = 0; e < curve.edges() && result.nodes.size() < count; ++e) {
    const Point edge = curve.to(e) - curve.from(e);
    const double edge_length = edge.norm();
    while (result.nodes.size() < count) {
      const double want = step * static_cast<double>(result.nodes.size());
      if (want > walked + edge_length)
        break;
      const double t = edge_length > 0 ? (want - walked) / edge_length : 0;
      result.nodes.emplace_back(curve.from(e) + t * edge);
    }
    walked += edge_length;
  }
  while (result.nodes.size() < count) // rounding
    result.nodes.push_back(curve.closed ? curve.nodes.front() : curve.nodes.back());
  if (!curve.closed)
    result.nodes.push_back(curve.nodes.back());
  return result;
}

ModelCurve
resampled(const ModelCurve& curve,
          double spacing,
          const ScaleField& scales,
          double least_edges)
{
  if (!curve.hinges.empty())
    return piecewise(curve, [&](const ModelCurve& piece) {
      return resampled(piece, spacing, scales, 1);
    });
  // A fine polyline first, whose edges are measured relative to the local scale.
  const double fine_spacing = std::max(0.25 * spacing, length(curve) / 1e6);
  const ModelCurve fine =
      resampled(curve, std::min(fine_spacing, length(curve) / (4 * least_edges)));
  std::vector<double> walked{0};
  for (std::size_t e = 0; e < fine.edges(); ++e)
    walked.push_back(walked.back() + (fine.to(e) - fine.from(e)).norm() /
                                         scales.at(0.5 * (fine.from(e) + fine.to(e))));
  const double total = walked.back();
  if (!(total > 0))
    return curve;
  const auto count =
      static_cast<std::size_t>(std::max(least_edges, std::round(total / spacing)));
  ModelCurve result = curve;
  result.nodes.clear();
  std::size_t e = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double want = total * static_cast<double>(k) / static_cast<double>(count);
    while (e + 1 < fine.edges() && walked[e + 1] < want)
      ++e;
    const double width = walked[e + 1] - walked[e];
    const double t = width > 0 ? std::clamp((want - walked[e]) / width, 0.0, 1.0) : 0;
    result.nodes.emplace_back(fine.from(e) + t * (fine.to(e) - fine.from(e)));
  }
  if (!curve.closed)
    result.nodes.push_back(curve.nodes.back());
  return result;
}

Point
outwardDirection(const ModelCurve& curve, int end, double reach)
{
  const std::size_t n = curve.nodes.size();
  const auto node = [&](std::size_t k) -> const Point& {
    return curve.nodes[end == 0 ? k : n - 1 - k];
  };
  double walked = 0;
  std::size_t k = 0;
  while (k + 1 < n && walked < reach) {
    walked += (node(k + 1) - node(k)).norm();
    ++k;
  }
  const Point chord = node(0) - node(k);
  const double chord_length = chord.norm();
  return chord_length > 0 ? Point(chord / chord_length) : Point::Zero();
}

} // namespace linelet
