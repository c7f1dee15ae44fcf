// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "bending_prior.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace linelet {

namespace {

constexpr double tail = 3; // degrees of freedom of the bending prior
// Number of bends that the first guess of the prior's scale is worth.
constexpr double bending_prior = 3;
// Bends are similar over this share of a curve.
constexpr double even_share = 0.25;

/** \brief Inverse variance of the second differences under the prior. */
double
rigidityOf(double bending, double spacing)
{
  return 1 / (bending * spacing * spacing * spacing);
}

/** \brief Number of bends; bend i lies over node i and the two after it. */
std::size_t
bendsOf(const ModelCurve& curve)
{
  const std::size_t n = curve.nodes.size();
  return curve.closed ? n : n < 3 ? 0 : n - 2;
}

/** \brief The two nodes after node \a i, around the ring. */
std::pair<std::size_t, std::size_t>
nextNodes(const ModelCurve& curve, std::size_t i)
{
  const std::size_t n = curve.nodes.size();
  return {i + 1 < n ? i + 1 : i + 1 - n, i + 2 < n ? i + 2 : i + 2 - n};
}

/** \brief Whether \a curve may turn sharply at node \a i. */
bool
isHinge(const ModelCurve& curve, std::size_t i)
{
  return std::binary_search(curve.hinges.begin(), curve.hinges.end(), i);
}

/** \brief The second difference at bend \a i. */
Point
bendOf(const ModelCurve& curve, std::size_t i)
{
  const auto [j, k] = nextNodes(curve, i);
  return curve.nodes[i] - 2 * curve.nodes[j] + curve.nodes[k];
}

/** \brief The direction of the curve at bend \a i. */
Point
tangentOf(const ModelCurve& curve, std::size_t i)
{
  return (curve.nodes[nextNodes(curve, i).second] - curve.nodes[i]).stableNormalized();
}

/** \brief The vector \a v, perpendicular to \a from, turned by the smallest rotation of
 * the unit vector \a from to \a to. */
Point
turned(const Point& v, const Point& from, const Point& to)
{
  return v - v.dot(to) / std::max(1 + from.dot(to), 1e-9) * (from + to);
}

/** \brief The factor that makes the square of bend \a i one at scale 1. */
double
bendUnit(const MixtureState& mixture, const MixtureCurve& state, std::size_t i)
{
  const double scale = mixture.edges[state.first_edge + i].scale;
  return 1 / (scale * scale);
}

/** \brief Posterior variance of bend \a i, per coordinate. */
double
bendVariance(const MixtureState& mixture,
             const ModelCurve& curve,
             std::size_t i,
             const NodeSystem& system)
{
  const auto [j, k] = nextNodes(curve, i);
  return mixture.noise.deviation * mixture.noise.deviation *
         std::max(0.0,
                  system.inverse_diagonal[i] + 4 * system.inverse_diagonal[j] +
                      system.inverse_diagonal[k] - 4 * system.inverse_next[i] -
                      4 * system.inverse_next[j] + 2 * system.inverse_after_next[i]);
}

} // namespace

/** \brief The mean of the bends around each, as the prior expects them to be.
 *
 * A curve of even curvature (a circle, an arc, a turn of a spiral) is very unlikely
 * under a prior of independent bends around zero, which charges it as many effective
 * parameters as a winding curve. So the mean is learned: bends fade with distance,
 * count by their weights in the Student distribution (corners hardly count), and are
 * carried along the curve by the smallest rotation of its direction. If the true mean
 * is zero, a mean b of weight s varies by 1 / (rigidity s) per coordinate, so b is
 * shrunk by the James-Stein factor, 1 - across / (rigidity s |b|^2), to zero where it
 * is not significant. What a bend contributes to its own mean is the mean's share of
 * the effective parameters. */
void
measureEvenCurvature(const MixtureState& mixture, MixtureCurve& state, double spacing)
{
  const ModelCurve& curve = state.curve;
  const std::size_t bends = bendsOf(curve);
  const bool known = state.bend_weight.size() == bends;
  std::vector<double> weight(bends), total(bends);
  Points tangent(bends), bend(bends);
  for (std::size_t i = 0; i < bends; ++i) {
    weight[i] = isHinge(curve, nextNodes(curve, i).first) ? 0
                : known                                   ? state.bend_weight[i]
                                                          : 1;
    tangent[i] = tangentOf(curve, i);
    bend[i] = std::sqrt(bendUnit(mixture, state, i)) * bendOf(curve, i);
    state.bend_mean[i] = weight[i] * bend[i];
    total[i] = weight[i];
  }
  // Adds the bends before each, in this order; a ring is traversed twice.
  const double keep = std::exp(-1 / (even_share * static_cast<double>(bends)));
  const auto addBefore = [&](auto place) {
    Point sum = Point::Zero();
    double weights = 0;
    const std::size_t rounds = curve.closed ? 2 : 1;
    for (std::size_t step = 0; step < rounds * bends; ++step) {
      const std::size_t i = place(step % bends);
      if (step > 0)
        sum = keep * turned(sum, tangent[place((step - 1) % bends)], tangent[i]);
      weights *= keep;
      if (step >= (rounds - 1) * bends) {
        state.bend_mean[i] += sum;
        total[i] += weights;
      }
      sum += weight[i] * bend[i];
      weights += weight[i];
    }
  };
  addBefore([](std::size_t step) { return step; });
  addBefore([bends](std::size_t step) { return bends - 1 - step; });

  const double rigidity = rigidityOf(state.bending, spacing);
  const double across = mixture.frame.dimensions - 1;
  for (std::size_t i = 0; i < bends; ++i) {
    Point& mean = state.bend_mean[i];
    mean /= std::max(total[i], 1e-300);
    const double square = rigidity * total[i] * mean.squaredNorm();
    const double kept = square > across ? 1 - across / square : 0;
    mean *= kept / std::sqrt(bendUnit(mixture, state, i));
    if (kept > 0)
      state.mean_freedom += kept * weight[i] / total[i];
  }
}

void
stiffen(const MixtureState& mixture,
        MixtureCurve& state,
        double spacing,
        NodeSystem& system)
{
  const ModelCurve& curve = state.curve;
  const double rigidity = rigidityOf(state.bending, spacing);
  const std::size_t bends = bendsOf(curve);
  const bool known = state.bend_variance.size() == bends;
  const double across = mixture.frame.dimensions - 1;
  state.bend_weight.resize(bends);
  for (std::size_t i = 0; i < bends; ++i) {
    const auto [j, k] = nextNodes(curve, i);
    if (isHinge(curve, j)) {
      state.bend_weight[i] = 0;
      continue;
    }
    const double unit = bendUnit(mixture, state, i);
    const Point& mean = state.bend_mean[i];
    double square = (bendOf(curve, i) - mean).squaredNorm();
    if (known)
      square += across * state.bend_variance[i];
    // A Student distribution is a normal one whose width grows with the bend.
    state.bend_weight[i] = (tail + across) / (tail + rigidity * square * unit);
    const double w = mixture.noise.deviation * mixture.noise.deviation * rigidity *
                     state.bend_weight[i] * unit;
    system.matrix.addDiagonal(i, w);
    system.matrix.addDiagonal(j, 4 * w);
    system.matrix.addDiagonal(k, w);
    system.matrix.addNext(i, -2 * w);
    system.matrix.addNext(j, -2 * w);
    system.matrix.addAfterNext(i, w);
    system.solution[i] += w * mean;
    system.solution[j] -= 2 * w * mean;
    system.solution[k] += w * mean;
  }
}

void
measureBending(const MixtureState& mixture,
               MixtureCurve& state,
               double spacing,
               const NodeSystem& system)
{
  // The scale of the prior that matches the bends and their uncertainty (MacKay's fixed
  // point). Expectation maximization has the same fixed point but converges slowly.
  const double rigidity = rigidityOf(state.bending, spacing);
  const std::size_t bends = bendsOf(state.curve);
  const double across = mixture.frame.dimensions - 1;
  const double first_square = bending_prior * across * state.first_bending;
  double square = 0, known_bends = bending_prior;
  state.bend_variance.resize(bends);
  for (std::size_t i = 0; i < bends; ++i) {
    const double unit = bendUnit(mixture, state, i), weight = state.bend_weight[i];
    const double variance = bendVariance(mixture, state.curve, i, system);
    state.bend_variance[i] = variance;
    square +=
        weight * (bendOf(state.curve, i) - state.bend_mean[i]).squaredNorm() * unit;
    if (weight > 0)
      known_bends += std::max(0.0, 1 - rigidity * weight * variance * unit);
  }
  state.bending =
      (first_square + square / (spacing * spacing * spacing)) / (known_bends * across);
}

} // namespace linelet
