// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/em_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace linelet {

namespace {

// Pairs of a point and an edge count up to this many standard deviations.
constexpr double pair_reach = 3.5;
// The pairs are collected anew when the noise has shrunk to this share.
constexpr double stale_share = 0.6;
constexpr double first_outlier_share = 0.1;
// Points per edge that the density along a curve is drawn towards its mean with, as a
// share of the mean.
constexpr double density_prior = 0.5;
constexpr double least_points = 2;
// Of the box of the outliers, beside the diagonal of the points.
constexpr double least_width = 0.4;
constexpr double tail = 3; // degrees of freedom of the bending prior
// Bends that the first guess of the prior's scale counts for.
constexpr double bending_prior = 3;

/** \brief Normal distribution function to 2e-4. */
double
normalBelow(double z)
{
  return 1 / (1 + std::exp(-z * (1.5976 + 0.07056 * z * z)));
}

} // namespace

CloudFrame
frameOf(const Points& points, double scale_unit)
{
  CloudFrame frame;
  frame.scale_unit = scale_unit;
  Point mean = Point::Zero(), low = points.front(), high = low;
  for (const Point& p : points) {
    mean += p;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  mean /= static_cast<double>(points.size());
  frame.diagonal = (high - low).norm();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Point& p : points)
    covariance += (p - mean) * (p - mean).transpose();
  covariance /= static_cast<double>(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  Point least = Point::Constant(std::numeric_limits<double>::infinity());
  Point most = -least;
  for (const Point& p : points) {
    const Point q = eigen.eigenvectors().transpose() * (p - mean);
    least = least.cwiseMin(q);
    most = most.cwiseMax(q);
  }
  const Point extent = most - least; // smallest first
  const double thin = 0.01 * scale_unit;
  frame.dimensions = extent.x() > thin ? 3 : 2;
  // A box that hugs a single straight tube of points would explain it as well as a
  // curve does, so outliers are given some width in every direction.
  const double width = least_width * frame.diagonal;
  frame.volume = std::max(extent.z(), width) * std::max(extent.y(), width);
  if (frame.dimensions == 3)
    frame.volume *= std::max(extent.x(), width);
  return frame;
}

EmFitter::EmFitter(const Points& points,
                   const UniformGrid& grid,
                   const CloudFrame& frame)
    : points_(points), grid_(grid), frame_(frame), density_(points.size())
{
}

EmFit
EmFitter::fit(const ModelCurves& curves, const EmSettings& settings)
{
  states_.clear();
  for (const ModelCurve& curve : curves)
    if (curve.edges() > 0) {
      states_.emplace_back();
      states_.back().curve = curve;
      states_.back().bending = states_.back().first_bending = settings.bending;
    }
  noise_ = std::max(settings.noise, settings.least_noise);
  outlier_share_ = first_outlier_share;
  freedom_ = 0;
  edge_count_.clear();
  resampleCurves(settings.spacing);
  for (int i = 0; i < settings.iterations; ++i) {
    if (i > 0 && i % settings.resample_every == 0) {
      expect();
      prune();
      extendEnds(settings.spacing);
      resampleCurves(settings.spacing);
    }
    else if (noise_ * pair_reach < stale_share * reach_)
      collectPairs();
    expect();
    maximise(settings);
  }
  expect();
  if (prune()) {
    resampleCurves(settings.spacing);
    for (int i = 0; i < 2; ++i) {
      expect();
      maximise(settings);
    }
    expect();
  }

  EmFit result;
  result.noise = noise_;
  result.outlier_share = outlier_share_;
  result.log_likelihood = log_likelihood_;
  result.freedom = freedom_;
  const double background = outlier_share_ / frame_.volume;
  result.outlier.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i)
    result.outlier[i] = background / density_[i];
  for (const CurveState& state : states_) {
    result.curves.push_back(state.curve);
    const auto begin =
        edge_count_.begin() + static_cast<std::ptrdiff_t>(state.first_edge);
    result.counts.emplace_back(
        begin, begin + static_cast<std::ptrdiff_t>(state.curve.edges()));
  }
  return result;
}

void
EmFitter::resampleCurves(double spacing)
{
  // Each curve keeps its share of the mixture, spread evenly over its new edges.
  std::vector<double> share(states_.size());
  double total = 0;
  std::size_t kept = 0;
  for (std::size_t c = 0; c < states_.size(); ++c) {
    if (edge_count_.empty())
      share[c] = length(states_[c].curve);
    else
      for (std::size_t e = 0; e < states_[c].curve.edges(); ++e)
        share[c] += edge_count_[states_[c].first_edge + e];
    // What has lost its points or its length is no curve any more.
    const bool lost = !edge_count_.empty() && share[c] < least_points;
    if (lost || length(states_[c].curve) < spacing)
      continue;
    total += share[c];
    if (kept != c) {
      states_[kept] = std::move(states_[c]);
      share[kept] = share[c];
    }
    ++kept;
  }
  states_.resize(kept);
  edges_.clear();
  for (std::size_t c = 0; c < states_.size(); ++c) {
    CurveState& state = states_[c];
    const double least_edges = state.curve.closed ? 8 : 2;
    state.curve =
        resampled(state.curve, std::min(spacing, length(state.curve) / least_edges));
    state.first_edge = edges_.size();
    state.bend_variance.clear();
    Edge edge;
    edge.weight = (1 - outlier_share_) * share[c] /
                  (std::max(total, 1e-300) * static_cast<double>(state.curve.edges()));
    edges_.insert(edges_.end(), state.curve.edges(), edge);
  }
  updateEdges();
  collectPairs();
}

bool
EmFitter::prune()
{
  bool changed = false;
  const double penalty = std::log(static_cast<double>(points_.size()));
  std::size_t kept = 0;
  for (std::size_t c = 0; c < states_.size(); ++c) {
    CurveState& state = states_[c];
    const std::size_t all = state.curve.edges();
    std::size_t cut[2] = {0, 0};
    for (int end = 0; end < 2; ++end) {
      if (state.curve.junction[static_cast<std::size_t>(end)] >= 0)
        continue;
      cut[end] = cheapestCut(state, end, penalty);
      if (cut[end] == all)
        break;
    }
    if (cut[0] == all || cut[1] == all || cut[0] + cut[1] + 2 > all) {
      changed = true;
      continue;
    }
    if (cut[0] + cut[1] > 0) {
      changed = true;
      Points& nodes = state.curve.nodes;
      const auto count =
          edge_count_.begin() + static_cast<std::ptrdiff_t>(state.first_edge);
      // The counts of the edges that stay move to where the first ones were.
      std::copy(count + static_cast<std::ptrdiff_t>(cut[0]),
                count + static_cast<std::ptrdiff_t>(all),
                count);
      nodes.erase(nodes.end() - static_cast<std::ptrdiff_t>(cut[1]), nodes.end());
      nodes.erase(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(cut[0]));
    }
    if (kept != c)
      states_[kept] = std::move(state);
    ++kept;
  }
  states_.resize(kept);
  return changed;
}

std::size_t
EmFitter::cheapestCut(const CurveState& state, int end, double penalty)
{
  const std::size_t edges = state.curve.edges();
  removed_.resize(points_.size(), 0);
  const auto n = static_cast<double>(points_.size());
  double loss = 0, weight = 0, freedom = 0, best = 0;
  std::size_t best_cut = 0;
  std::size_t done = 0;
  for (; done < edges; ++done) {
    const std::size_t e = end == 0 ? done : edges - 1 - done;
    const Edge& edge = edges_[state.first_edge + e];
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      double& gone = removed_[pair_point_[k]];
      const double before = std::log(std::max(1e-12, 1 - gone));
      gone += pair_density_[k];
      loss += std::log(std::max(1e-12, 1 - gone)) - before;
    }
    weight += edge.weight;
    freedom +=
        state.node_freedom[end == 0 ? done : state.node_freedom.size() - 1 - done];
    const bool whole = done + 1 == edges;
    // A part of a curve goes only where the likelihood alone gains by it.
    if ((state.curve.closed && !whole) || (whole && states_.size() == 1))
      continue;
    const double change = -2 * (loss - n * std::log(std::max(1e-12, 1 - weight))) -
                          (whole ? (freedom + 4) * penalty : 0);
    if (change < best) {
      best = change;
      best_cut = done + 1;
    }
  }
  for (std::size_t e = 0; e < edges; ++e) {
    const Edge& edge = edges_[state.first_edge + e];
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k)
      removed_[pair_point_[k]] = 0;
  }
  return best_cut;
}

void
EmFitter::extendEnds(double spacing)
{
  for (CurveState& state : states_)
    for (int end = 0; end < 2 && !state.curve.closed; ++end) {
      if (state.curve.junction[static_cast<std::size_t>(end)] >= 0)
        continue;
      Point& tip = end == 0 ? state.curve.nodes.front() : state.curve.nodes.back();
      tip += spacing * outwardDirection(state.curve, end, 3 * spacing);
    }
}

void
EmFitter::updateEdges()
{
  for (const CurveState& state : states_)
    for (std::size_t e = 0; e < state.curve.edges(); ++e) {
      Edge& edge = edges_[state.first_edge + e];
      edge.from = state.curve.from(e);
      const Point chord = state.curve.to(e) - edge.from;
      edge.length = std::max(chord.norm(), 1e-12 * frame_.diagonal);
      edge.direction = chord / edge.length;
    }
}

void
EmFitter::collectPairs()
{
  reach_ = pair_reach * noise_;
  const double margin = 0.3 * noise_;
  const double reach = reach_ + margin;
  pair_point_.clear();
  for (Edge& edge : edges_) {
    edge.pairs_begin = pair_point_.size();
    const Point middle = edge.from + 0.5 * edge.length * edge.direction;
    grid_.forEachWithin(middle, reach + 0.5 * edge.length, [&](Index i, double) {
      const Point v = points_[i] - edge.from;
      const double z = v.dot(edge.direction);
      const double over = z - std::clamp(z, 0.0, edge.length);
      if (v.squaredNorm() - z * z + over * over <= reach * reach)
        pair_point_.push_back(i);
    });
    edge.pairs_end = pair_point_.size();
  }
  pair_density_.resize(pair_point_.size());
  pair_place_.resize(pair_point_.size());
  pair_off_.resize(pair_point_.size());
}

void
EmFitter::expect()
{
  const double background = outlier_share_ / frame_.volume;
  std::fill(density_.begin(), density_.end(), background);
  const double variance = noise_ * noise_;
  const double across = std::pow(2 * M_PI * variance, -0.5 * (frame_.dimensions - 1));
  for (const Edge& edge : edges_) {
    // The integral of the normal density along the edge: where the edge is short beside
    // the noise, a normal density of its own.
    const bool is_short = edge.length < 1.2 * noise_;
    const double along = variance + edge.length * edge.length / 12;
    const double factor =
        edge.weight * across *
        (is_short ? 1 / std::sqrt(2 * M_PI * along) : 1 / edge.length);
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const Point v = points_[pair_point_[k]] - edge.from;
      const double z = v.dot(edge.direction);
      const double off = std::max(0.0, v.squaredNorm() - z * z);
      double density;
      if (is_short) {
        const double t = z - 0.5 * edge.length;
        density = factor * std::exp(-0.5 * (off / variance + t * t / along));
      }
      else
        density = factor * std::exp(-0.5 * off / variance) *
                  (normalBelow((edge.length - z) / noise_) - normalBelow(-z / noise_));
      pair_density_[k] = density;
      pair_place_[k] = z;
      pair_off_[k] = off;
      density_[pair_point_[k]] += density;
    }
  }

  log_likelihood_ = 0;
  double outliers = 0;
  for (double& density : density_) {
    density = std::max(density, 1e-300);
    log_likelihood_ += std::log(density);
    outliers += background / density;
  }
  edge_count_.assign(edges_.size(), 0);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (std::size_t k = edges_[e].pairs_begin; k < edges_[e].pairs_end; ++k) {
      pair_density_[k] /= density_[pair_point_[k]];
      edge_count_[e] += pair_density_[k];
    }
  const auto n = static_cast<double>(points_.size());
  outlier_share_ = std::clamp(outliers / n, 1e-3, 1 - 1e-3);
}

void
EmFitter::maximise(const EmSettings& settings)
{
  freedom_ = 0;
  for (CurveState& state : states_)
    maximiseCurve(state, settings);

  double square = 0, count = 0;
  for (const Edge& edge : edges_)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      square += pair_density_[k] * pair_off_[k];
      count += pair_density_[k];
    }
  if (count > 0) {
    const double spare = std::max(0.3 * count, count - freedom_);
    noise_ = std::max(std::sqrt(square / (spare * (frame_.dimensions - 1))),
                      settings.least_noise);
  }
  freedom_ *= frame_.dimensions - 1;
  updateWeights();
  updateEdges();
}

void
EmFitter::maximiseCurve(CurveState& state, const EmSettings& settings)
{
  ModelCurve& curve = state.curve;
  const std::size_t n = curve.nodes.size();
  system_.reset(n, curve.closed);
  solution_.assign(n, Point::Zero());
  data_diagonal_.assign(n, 0);
  data_next_.assign(n, 0);
  const double variance = noise_ * noise_;
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const Edge& edge = edges_[state.first_edge + e];
    const std::size_t a = e, b = e + 1 == n ? 0 : e + 1;
    // Where on the edge the point came from: uniform on the edge, normal around z.
    const double middle_weight = 12 / (edge.length * edge.length);
    const double spread = 1 / (1 / variance + middle_weight);
    const bool front = !curve.closed && e == 0;
    const bool back = !curve.closed && e + 1 == curve.edges();
    double aa = 0, ab = 0, bb = 0;
    Point at_a = Point::Zero(), at_b = Point::Zero();
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const double r = pair_density_[k];
      if (r < 1e-4)
        continue;
      const double z = pair_place_[k];
      const double place =
          std::clamp(spread * (z / variance + 0.5 * edge.length * middle_weight),
                     0.0,
                     edge.length);
      const double t = place / edge.length;
      Point x = points_[pair_point_[k]];
      // Along the curve only its ends are drawn by the points.
      if (!(front && z < 0) && !(back && z > edge.length))
        x -= (z - place) * edge.direction;
      aa += r * (1 - t) * (1 - t);
      ab += r * (1 - t) * t;
      bb += r * t * t;
      at_a += (r * (1 - t)) * x;
      at_b += (r * t) * x;
    }
    data_diagonal_[a] += aa;
    data_diagonal_[b] += bb;
    data_next_[e] += ab;
    solution_[a] += at_a;
    solution_[b] += at_b;
  }
  const double anchor = 1e-4;
  for (std::size_t i = 0; i < n; ++i) {
    system_.addDiagonal(i, data_diagonal_[i] + anchor);
    system_.addNext(i, data_next_[i]);
    solution_[i] += anchor * curve.nodes[i];
  }

  const double spacing = std::max(0.1 * settings.spacing,
                                  length(curve) / static_cast<double>(curve.edges()));
  const double rigidity = 1 / (state.bending * spacing * spacing * spacing);
  const auto ring = [n](std::size_t i) { return i < n ? i : i - n; };
  const std::size_t bends = curve.closed ? n : n < 3 ? 0 : n - 2;
  const bool known = state.bend_variance.size() == bends;
  const double across = frame_.dimensions - 1;
  bend_weight_.resize(bends);
  for (std::size_t i = 0; i < bends; ++i) {
    const std::size_t j = ring(i + 1), k = ring(i + 2);
    double bend = (curve.nodes[i] - 2 * curve.nodes[j] + curve.nodes[k]).squaredNorm();
    if (known)
      bend += across * state.bend_variance[i];
    bend_weight_[i] = (tail + across) / (tail + rigidity * bend);
    const double w = variance * rigidity * bend_weight_[i];
    system_.addDiagonal(i, w);
    system_.addDiagonal(j, 4 * w);
    system_.addDiagonal(k, w);
    system_.addNext(i, -2 * w);
    system_.addNext(j, -2 * w);
    system_.addAfterNext(i, w);
  }
  system_.solve(solution_);
  system_.inverseBand(inverse_diagonal_, inverse_next_, inverse_after_next_);
  state.node_freedom.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double freedom =
        inverse_diagonal_[i] * data_diagonal_[i] + 2 * inverse_next_[i] * data_next_[i];
    state.node_freedom[i] = (frame_.dimensions - 1) * freedom;
    freedom_ += freedom;
  }
  curve.nodes = solution_;

  // The scale of the prior, by expectation maximisation over the posterior of the
  // bends.
  double sum =
      bending_prior * across * state.first_bending * spacing * spacing * spacing;
  state.bend_variance.resize(bends);
  for (std::size_t i = 0; i < bends; ++i) {
    const std::size_t j = ring(i + 1), k = ring(i + 2);
    const double bend =
        (curve.nodes[i] - 2 * curve.nodes[j] + curve.nodes[k]).squaredNorm();
    state.bend_variance[i] =
        variance * std::max(0.0,
                            inverse_diagonal_[i] + 4 * inverse_diagonal_[j] +
                                inverse_diagonal_[k] - 4 * inverse_next_[i] -
                                4 * inverse_next_[j] + 2 * inverse_after_next_[i]);
    sum += bend_weight_[i] * (bend + across * state.bend_variance[i]);
  }
  state.bending = sum / ((bending_prior + static_cast<double>(bends)) * across *
                         spacing * spacing * spacing);
}

void
EmFitter::updateWeights()
{
  const double n = static_cast<double>(points_.size());
  for (const CurveState& state : states_) {
    const std::size_t edges = state.curve.edges();
    double total = 0;
    for (std::size_t e = 0; e < edges; ++e)
      total += edge_count_[state.first_edge + e];
    const double mean = total / static_cast<double>(edges);
    const double spacing = length(state.curve) / static_cast<double>(edges);
    const auto half = static_cast<std::size_t>(
        std::clamp(1.5 * frame_.scale_unit / std::max(spacing, 1e-300), 1.0, 50.0));
    double all = 0;
    for (std::size_t e = 0; e < edges; ++e) {
      double sum = 0, width = 0;
      for (std::size_t k = 0; k <= 2 * half; ++k) {
        std::size_t at = e + k;
        if (state.curve.closed)
          at = (at + edges - half % edges) % edges;
        else if (at < half || at - half >= edges)
          continue;
        else
          at -= half;
        sum += edge_count_[state.first_edge + at];
        width += 1;
      }
      Edge& edge = edges_[state.first_edge + e];
      edge.weight = sum / width + density_prior * mean;
      all += edge.weight;
    }
    for (std::size_t e = 0; e < edges; ++e)
      edges_[state.first_edge + e].weight *= total / (std::max(all, 1e-300) * n);
  }
}

} // namespace linelet
