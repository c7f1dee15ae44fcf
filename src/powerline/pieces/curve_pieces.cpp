// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/curve_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>

#include <linelet/curves/refined_reconstruction.h>

#include "powerline/line_priors.h"
#include "powerline/pieces/bend.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/profile.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/tube_radius.h"
#include "support/parallel_chunks.h"

namespace linelet::powerline {

namespace {

// Conductors come in bundles from 220 kV on; those stay at least 6.7 m above ground
// where they hang lowest (EN 50341-1, 5.9), and higher on average.
constexpr double bundle_height = 8;
constexpr std::size_t fewest = 8; // points of a part

/** A candidate beside a curve. */
struct BesideCurve {
  double place;    ///< position of its foot along the curve in plan, meters
  double distance; ///< from the curve
  Index index;
};

// The free candidates within reach of a curve, each with its nearest place on it.
std::vector<BesideCurve>
pointsBeside(const Curve& curve, const Growth& growth)
{
  std::vector<BesideCurve> all;
  double begin = 0;
  for (std::size_t v = 1; v < curve.points.size(); ++v) {
    const Point &from = curve.points[v - 1], edge = curve.points[v] - from;
    const double flat = edge.head<2>().norm(), squared = edge.squaredNorm();
    if (squared > 0)
      growth.candidates().grid.forEachWithin(
          from + edge / 2,
          std::hypot(edge.norm() / 2, widest_tube_seen),
          [&](Index i, double) {
            if (growth.owner(i) != Growth::nobody)
              return;
            const Point offset = growth.candidates().points[i] - from;
            const double s = std::clamp(offset.dot(edge) / squared, 0.0, 1.0);
            const double d = (offset - s * edge).norm();
            if (d <= widest_tube_seen)
              all.push_back({begin + s * flat, d, i});
          });
    begin += flat;
  }
  std::sort(all.begin(), all.end(), [](const BesideCurve& a, const BesideCurve& b) {
    return a.index != b.index ? a.index < b.index : a.distance < b.distance;
  });
  all.erase(std::unique(all.begin(),
                        all.end(),
                        [](const BesideCurve& a, const BesideCurve& b) {
                          return a.index == b.index;
                        }),
            all.end());
  std::sort(all.begin(), all.end(), [](const BesideCurve& a, const BesideCurve& b) {
    return a.place != b.place ? a.place < b.place : a.index < b.index;
  });
  return all;
}

/** Sums for parabolas of all three coordinates over the length in plan. */
struct PointMoments {
  std::array<Moments, 3> axes;

  PointMoments
  operator-(const PointMoments& other) const
  {
    return {
        {axes[0] - other.axes[0], axes[1] - other.axes[1], axes[2] - other.axes[2]}};
  }

  double
  squares() const
  {
    return axes[0].solve().second + axes[1].solve().second + axes[2].solve().second;
  }
};

class Splitter {
public:
  Splitter(const std::vector<BesideCurve>& along, const Points& points)
      : along_(along), before_(along.size() + 1)
  {
    const Point origin = along.empty() ? Point::Zero() : points[along.front().index];
    for (std::size_t i = 0; i < along.size(); ++i) {
      before_[i + 1] = before_[i];
      const Point p = points[along[i].index] - origin;
      for (int axis = 0; axis < 3; ++axis)
        before_[i + 1].axes[static_cast<std::size_t>(axis)].add(along[i].place,
                                                                p[axis]);
    }
  }

  /** Appends the ends of the parts of [from, to). */
  void
  split(std::size_t from, std::size_t to, std::vector<std::size_t>& ends) const
  {
    const double n = static_cast<double>(to - from);
    const double floor = n * least_residual * least_residual;
    const double whole = squares(from, to) + floor;
    double best = whole;
    std::size_t place = to;
    const std::size_t stride = std::max<std::size_t>(1, (to - from) / 200);
    for (std::size_t i = from + fewest; i + fewest <= to; i += stride) {
      const double both = squares(from, i) + squares(i, to) + floor;
      if (both < best) {
        best = both;
        place = i;
      }
    }
    // Nine more coefficients and a breakpoint, by the Bayesian information criterion.
    if (place == to || n * std::log(whole / best) < 10 * std::log(n)) {
      ends.push_back(to);
      return;
    }
    split(from, place, ends);
    split(place, to, ends);
  }

private:
  double
  squares(std::size_t from, std::size_t to) const
  {
    return (before_[to] - before_[from]).squares();
  }

  const std::vector<BesideCurve>& along_;
  std::vector<PointMoments> before_;
};

// For each curve, the free candidates that are nearer to it than to the others.
std::vector<std::vector<BesideCurve>>
pointsOf(const std::vector<Curve>& curves, const Growth& growth, unsigned threads)
{
  std::vector<std::vector<BesideCurve>> all(curves.size());
  forEachChunk(curves.size(), 1, threads, [&](std::size_t k, std::size_t) {
    all[k] = pointsBeside(curves[k], growth);
  });
  std::vector<double> nearest(growth.candidates().points.size(),
                              std::numeric_limits<double>::infinity());
  for (const std::vector<BesideCurve>& along : all)
    for (const BesideCurve& p : along)
      nearest[p.index] = std::min(nearest[p.index], p.distance);
  for (std::vector<BesideCurve>& along : all)
    along.erase(std::remove_if(along.begin(),
                               along.end(),
                               [&](const BesideCurve& p) {
                                 return p.distance > nearest[p.index];
                               }),
                along.end());
  return all;
}

// Parts of the curve of \a along that hang as one parabola each, fitted to its points
// that are free. Half of what stands out from the surroundings lies within the median
// distance; a curve wider than single wires are is a bundle.
std::vector<Piece>
piecesAlong(std::vector<BesideCurve> along, const Growth& growth)
{
  const Points& points = growth.candidates().points;
  along.erase(std::remove_if(along.begin(),
                             along.end(),
                             [&](const BesideCurve& p) {
                               return growth.owner(p.index) != Growth::nobody;
                             }),
              along.end());
  std::vector<double> distances;
  for (const BesideCurve& p : along)
    distances.push_back(p.distance);
  const double reach = tubeRadius(std::move(distances));
  along.erase(std::remove_if(along.begin(),
                             along.end(),
                             [&](const BesideCurve& p) { return p.distance > reach; }),
              along.end());
  std::vector<Piece> pieces;
  if (along.size() < fewest)
    return pieces;
  std::vector<std::size_t> ends;
  Splitter(along, points).split(0, along.size(), ends);
  std::size_t from = 0;
  for (const std::size_t to : ends) {
    Piece piece;
    for (std::size_t i = from; i < to; ++i)
      piece.members.push_back(along[i].index);
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Index i : piece.members)
      mean += points[i].head<2>() / static_cast<double>(piece.members.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Index i : piece.members) {
      const Eigen::Vector2d v = points[i].head<2>() - mean;
      spread += v * v.transpose();
    }
    SpanModel& m = piece.model;
    m.origin = mean;
    m.direction =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
    piece.thickness = reach;
    from = to;
    // Twice: the first time, distances are not known yet.
    if (!fit(m, points, piece.members, std::numeric_limits<double>::infinity()) ||
        !fit(m, points, piece.members, piece.cut()))
      continue;
    if (reach <= widest_wire)
      piece.thickness = 0;
    updateExtent(piece, points);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

double
density(const Piece& piece)
{
  return static_cast<double>(piece.members.size()) / piece.model.length();
}

// Whether a bundle is only what a denser wire in it has left over.
bool
isRemainder(const Piece& bundle, const std::vector<Piece>& wires)
{
  return std::any_of(wires.begin(), wires.end(), [&](const Piece& wire) {
    const Parallel parallel = compare(bundle.model, wire.model);
    return parallel.overlap > 0 &&
           parallel.distance <= bundle.tolerance() + wire.tolerance() &&
           density(wire) >= density(bundle);
  });
}

// Whether points too few to cover a wire show one. Rows of other points line up, too,
// but they do not hang.
bool
isSparseWire(const Piece& piece, const Evidence& evidence, const Points& points)
{
  return evidence.even && evidence.likelihood >= priors.alone &&
         bendOf(piece, points).isAbove(flattest);
}

} // namespace

std::vector<Curve>
curvesOf(const Candidates& candidates,
         const PowerLineSettings& settings,
         ProgressMonitor* monitor)
{
  const Points& points = candidates.points;
  if (points.size() < fewest ||
      std::all_of(points.begin(), points.end(), [&](const Point& p) {
        return p == points.front();
      }))
    return {};
  RefinedSettings curve_settings;
  curve_settings.threads = settings.threads;
  curve_settings.only_stiff = true;       // as wires are
  curve_settings.may_be_straight = false; // they sag
  std::vector<Curve> curves =
      reconstructRefined(points, curve_settings, monitor).curves;
  std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
    return length(a) > length(b);
  });
  return curves;
}

void
forEachPieceAlong(const std::vector<Curve>& curves,
                  const Growth& growth,
                  unsigned threads,
                  const std::function<void(Piece&)>& visit)
{
  for (std::vector<BesideCurve>& along : pointsOf(curves, growth, threads))
    for (Piece& part : piecesAlong(std::move(along), growth))
      for (Piece& piece : growth.betweenSupports(std::move(part)))
        visit(piece);
}

void
growAlong(const std::vector<Curve>& curves,
          Growth& growth,
          std::vector<Piece>& wires,
          const PowerLineSettings& settings)
{
  forEachPieceAlong(curves, growth, settings.threads, [&](Piece& piece) {
    const Evidence evidence = weigh(growth, piece, settings);
    if ((!evidence.accepted &&
         !isSparseWire(piece, evidence, growth.candidates().points)) ||
        (piece.thickness > 0 &&
         (evidence.height < bundle_height || isRemainder(piece, wires))))
      return;
    growth.claim(piece, static_cast<int>(wires.size()));
    wires.push_back(std::move(piece));
  });
}

} // namespace linelet::powerline
