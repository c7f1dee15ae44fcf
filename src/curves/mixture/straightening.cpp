// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "straightening.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace linelet {

namespace {

// The scale of the bending prior of a straight curve, relative to that of others.
constexpr double straight_bending = 1e-6;
constexpr double parameters_of_line = 2; // per coordinate across it

/** \brief Where the nodes of an open curve lie along it, from 0 to 1. */
std::vector<double>
placesAlong(const ModelCurve& curve)
{
  std::vector<double> places{0};
  for (std::size_t e = 0; e < curve.edges(); ++e)
    places.push_back(places.back() + (curve.to(e) - curve.from(e)).norm());
  for (double& place : places)
    place /= places.back();
  return places;
}

/** \brief The nodes at \a places on the segment to which the points pull them. */
Points
straightNodes(const std::vector<double>& places, const NodeSystem& system)
{
  // The normal equations of the ends of the segment.
  double at_front = 0, between = 0, at_back = 0;
  Point front = Point::Zero(), back = Point::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double t = places[i], s = 1 - t;
    at_front += s * s * system.data_diagonal[i];
    between += s * t * system.data_diagonal[i];
    at_back += t * t * system.data_diagonal[i];
    front += s * system.solution[i];
    back += t * system.solution[i];
    if (i + 1 == places.size())
      break;
    const double u = places[i + 1], r = 1 - u;
    at_front += 2 * s * r * system.data_next[i];
    between += (s * u + t * r) * system.data_next[i];
    at_back += 2 * t * u * system.data_next[i];
  }
  const double determinant = at_front * at_back - between * between;
  const Point begin = (at_back * front - between * back) / determinant;
  const Point end = (at_front * back - between * front) / determinant;
  Points nodes;
  for (const double t : places)
    nodes.push_back((1 - t) * begin + t * end);
  return nodes;
}

/** \brief How far the points of \a system pull back from \a nodes, up to a constant:
 * -2 log L in units of the noise. */
double
strainAt(const Points& nodes, const NodeSystem& system)
{
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sum += system.data_diagonal[i] * nodes[i].squaredNorm() -
           2 * system.solution[i].dot(nodes[i]);
    if (i + 1 < nodes.size())
      sum += 2 * system.data_next[i] * nodes[i].dot(nodes[i + 1]);
  }
  return sum;
}

} // namespace

void
straighten(const MixtureState& mixture, MixtureCurve& state, const NodeSystem& system)
{
  ModelCurve& curve = state.curve;
  if (state.straight || curve.closed || !curve.hinges.empty())
    return;
  Points straight = straightNodes(placesAlong(curve), system);
  const double loss = (strainAt(straight, system) - strainAt(curve.nodes, system)) /
                      (mixture.noise.deviation * mixture.noise.deviation);
  const double across = mixture.frame.dimensions - 1;
  const double saved =
      std::accumulate(state.node_freedom.begin(), state.node_freedom.end(), 0.0) +
      across * (state.mean_freedom - parameters_of_line);
  if (!(loss < saved * std::log(static_cast<double>(mixture.points))))
    return;
  curve.nodes = std::move(straight);
  state.straight = true;
  state.first_bending *= straight_bending;
  state.bending = state.first_bending;
}

} // namespace linelet
