// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cross_section.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "curve_frames.h"

namespace linelet {

namespace {

using Offset = Eigen::Vector2d;

constexpr double point_reach = 5; // standard deviations, of points from their curve
constexpr double uneven_parameters = 2; // direction and width of the scatter
constexpr double line_parameters = 3;   // two offsets and the share of the points
constexpr double least_strays = 0.01;   // share of points that belong to no line
constexpr int modes_iterations = 20;

/** \brief Offsets of the points from the curve that they lie nearest to, per curve. */
std::vector<std::vector<Offset>>
offsetsOf(const EmFit& fit, const Points& points, const UniformGrid& grid)
{
  struct Nearest {
    double squared = std::numeric_limits<double>::infinity();
    std::size_t curve = 0;
    Offset offset = Offset::Zero();
  };
  std::vector<Nearest> nearest(points.size());
  const double distance = point_reach * fit.noise;
  for (std::size_t c = 0; c < fit.curves.size(); ++c) {
    const ModelCurve& curve = fit.curves[c];
    const CurveFrames frames = framesOf(curve);
    for (std::size_t e = 0; e < curve.edges(); ++e) {
      const Point middle = 0.5 * (curve.from(e) + curve.to(e));
      const double half = 0.5 * (curve.to(e) - curve.from(e)).norm();
      grid.forEachWithin(middle, std::hypot(distance, half), [&](Index i, double) {
        const double squared = squaredDistance(curve, e, points[i]);
        if (squared < nearest[i].squared)
          nearest[i] = {squared, c, offsetAcross(curve, frames, e, points[i])};
      });
    }
  }
  std::vector<std::vector<Offset>> offsets(fit.curves.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (fit.outlier[i] < 0.5 && nearest[i].squared <= distance * distance)
      offsets[nearest[i].curve].push_back(nearest[i].offset);
  return offsets;
}

double
logNormal(double x, double deviation)
{
  return -0.5 * x * x / (deviation * deviation) -
         std::log(deviation * std::sqrt(2 * M_PI));
}

/** \brief Logarithm of the density at \a x of even scatter over +-\a half with noise of
 * \a deviation. */
double
logEven(double x, double half, double deviation)
{
  const double s = std::sqrt(2.0) * deviation;
  // From the far side, to keep digits.
  const double a = (std::abs(x) - half) / s, b = (std::abs(x) + half) / s;
  const double share = 0.5 * (std::erfc(a) - std::erfc(b));
  return std::log(std::max(share, std::numeric_limits<double>::min()) / (2 * half));
}

/** \brief Directions and widths of the scatter of offsets. */
struct Scatter {
  Offset mean;
  Eigen::Matrix2d axes; ///< columns: along the narrow and the wide direction
  double narrow, wide;  ///< standard deviations

  Offset
  along(const Offset& o) const
  {
    return axes.transpose() * (o - mean);
  }
};

Scatter
scatterAbout(const Offset& mean, const Eigen::Matrix2d& squares, double least_noise)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(squares);
  const double narrow =
      std::max(std::sqrt(std::max(solver.eigenvalues()[0], 0.0)), least_noise);
  const double wide =
      std::max(std::sqrt(std::max(solver.eigenvalues()[1], 0.0)), narrow);
  return {mean, solver.eigenvectors(), narrow, wide};
}

double
logNormal(const Offset& along, const Scatter& scatter)
{
  return logNormal(along[0], scatter.narrow) + logNormal(along[1], scatter.wide);
}

/** \brief Sum over \a offsets of the logarithm of their density, a mixture of \a stray
 * with weight \a strays and exp(\a log_density). */
template <class LogDensity>
double
logLikelihood(const std::vector<Offset>& offsets,
              double strays,
              double stray,
              const LogDensity& log_density)
{
  double sum = 0;
  for (const Offset& o : offsets)
    sum += std::log(strays * stray + (1 - strays) * std::exp(log_density(o)));
  return sum;
}

/** \brief Best log-likelihood of \a offsets as a ribbon of \a scatter, with even or
 * normal scatter in its plane. */
double
ribbonLikelihood(const std::vector<Offset>& offsets,
                 const Scatter& scatter,
                 double strays,
                 double stray)
{
  double best = logLikelihood(offsets, strays, stray, [&](const Offset& o) {
    return logNormal(scatter.along(o), scatter);
  });
  // Even scatter over +-half and noise add up to the variance; strays inflate it.
  const double even =
      std::sqrt(3 * (scatter.wide * scatter.wide - scatter.narrow * scatter.narrow));
  for (const double share : {0.8, 0.9, 1.0, 1.1})
    for (const double blur : {1.0, 2.0})
      if (even > 0)
        best =
            std::max(best, logLikelihood(offsets, strays, stray, [&](const Offset& o) {
                       const Offset along = scatter.along(o);
                       return logNormal(along[0], scatter.narrow) +
                              logEven(along[1], share * even, blur * scatter.narrow);
                     }));
  return best;
}

/** \brief Best log-likelihood of \a offsets as normal scatter about \a means, by
 * expectation maximization; the scatter is the same about all. */
double
modesLikelihood(const std::vector<Offset>& offsets,
                std::vector<Offset> means,
                double least_noise,
                double strays,
                double stray)
{
  const std::size_t k = means.size();
  std::vector<double> share(k, 1 / static_cast<double>(k)), density(k);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = 0; b < a; ++b)
      nearest = std::min(nearest, (means[a] - means[b]).squaredNorm());
  Scatter scatter = scatterAbout(
      Offset::Zero(), nearest / 16 * Eigen::Matrix2d::Identity(), least_noise);
  double sum = 0;
  for (int iteration = 0; iteration < modes_iterations; ++iteration) {
    sum = 0;
    double total = 0;
    std::vector<double> count(k, 0);
    std::vector<Offset> moved(k, Offset::Zero());
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const Offset& o : offsets) {
      double all = strays * stray;
      for (std::size_t c = 0; c < k; ++c)
        all += density[c] = (1 - strays) * share[c] *
                            std::exp(logNormal(scatter.along(o - means[c]), scatter));
      sum += std::log(all);
      for (std::size_t c = 0; c < k; ++c) {
        const double weight = density[c] / all;
        count[c] += weight;
        moved[c] += weight * o;
        squares += weight * (o - means[c]) * (o - means[c]).transpose();
        total += weight;
      }
    }
    if (!(total > 0))
      break;
    for (std::size_t c = 0; c < k; ++c) {
      share[c] = count[c] / total;
      if (count[c] > 0)
        means[c] = moved[c] / count[c];
    }
    scatter = scatterAbout(Offset::Zero(), squares / total, least_noise);
  }
  return sum;
}

/** \brief Gain of uneven scatter about a curve over \a noise. */
double
gainOf(const std::vector<Offset>& offsets, double noise, double least_noise)
{
  if (offsets.empty())
    return 0;
  const auto count = static_cast<double>(offsets.size());
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  double same = 0;
  for (const Offset& o : offsets) {
    squares += o * o.transpose() / count;
    same += logNormal(o[0], noise) + logNormal(o[1], noise);
  }
  const double uneven =
      ribbonLikelihood(offsets,
                       scatterAbout(Offset::Zero(), squares, least_noise),
                       least_strays,
                       1 / (M_PI * point_reach * point_reach * noise * noise));
  return std::max(0.0, uneven - same - 0.5 * uneven_parameters * std::log(count));
}

} // namespace

double
unevenScatterGain(const EmFit& fit,
                  const Points& points,
                  const UniformGrid& grid,
                  double least_noise)
{
  double gain = 0;
  for (const std::vector<Offset>& offsets : offsetsOf(fit, points, grid))
    gain += gainOf(offsets, fit.noise, least_noise);
  return gain;
}

double
modesGain(const EmFit& one,
          const std::vector<Eigen::Vector2d>& offsets,
          const Points& points,
          const UniformGrid& grid,
          double least_noise)
{
  const std::vector<Offset> all = offsetsOf(one, points, grid).front();
  if (all.empty())
    return 0;
  const auto count = static_cast<double>(all.size());
  Offset mean = Offset::Zero();
  for (const Offset& o : all)
    mean += o / count;
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const Offset& o : all)
    squares += (o - mean) * (o - mean).transpose() / count;
  const double strays = std::max(least_strays, one.outlier_share);
  const double radius = point_reach * one.noise, stray = 1 / (M_PI * radius * radius);
  const double ribbon =
      ribbonLikelihood(all, scatterAbout(mean, squares, least_noise), strays, stray);
  const double modes = modesLikelihood(all, offsets, least_noise, strays, stray);
  const double extra = line_parameters * (static_cast<double>(offsets.size()) - 1);
  return modes - ribbon - 0.5 * extra * std::log(count);
}

} // namespace linelet
