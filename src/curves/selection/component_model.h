// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include <linelet/curves/refined_reconstruction.h>

#include "curves/mixture/em_fit.h"
#include "curves/ridges/ridge_trace.h"

namespace linelet {

/** \brief Bandwidths of the ridges, in D: from the middle down, then up from number
 * \ref first_upwards. */
constexpr std::array<double, 6> bandwidths = {1, 0.7, 0.5, 1.4, 2, 2.8};
constexpr std::size_t first_upwards = 3;
/** \brief Where spacing or noise vary, these bandwidths are tried once more, varying
 * with them. */
constexpr std::array<std::size_t, 3> varied_bandwidths = {0, 1, 3};

/** \brief A fit and what it was made with. */
struct Fitted {
  EmFit fit;
  EmSettings settings;
  double score = 0;
};

/** \brief A connected component of a cloud while it is worked on: its points, how it is
 * fitted, and the best fit so far. */
class ComponentModel {
public:
  /** \param[in] points finite points; must outlive the component, as must \a user
   * \param[in] stop asked in every iteration of a fit; true: Canceled is thrown */
  ComponentModel(const Points& points,
                 double scale_unit,
                 const RefinedSettings& user,
                 const std::function<bool()>& stop);

  const Fitted&
  best() const
  {
    return best_;
  }
  /** \brief The fits of ridges and of the shortest tree, as they came. */
  const std::vector<Fitted>&
  traced() const
  {
    return traced_;
  }
  const Points&
  points() const
  {
    return points_;
  }
  const UniformGrid&
  grid() const
  {
    return grid_;
  }
  double
  scaleUnit() const
  {
    return scale_unit_;
  }
  int
  dimensions() const
  {
    return frame_.dimensions;
  }

  /** \brief The size in D on which the component looks like curves: more than 1 where
   * they are thick beside the spacing of the points; 0: on none. */
  double
  curveSize() const;

  /** \brief Fits \a start; what falls far behind the score \a rival is given up. */
  EmFit
  fit(const ModelCurves& start,
      const EmSettings& settings,
      double rival = std::numeric_limits<double>::infinity());

  /** \brief Keeps \a fit if it is better than the best by \a gain.
   * \return whether it was */
  bool
  take(EmFit fit, const EmSettings& settings, double gain = 0);

  /** \brief Fits \a start, and keeps the fit if it is better than the best by \a gain.
   * What has been tried before with such settings is not fitted again.
   * \return whether it was better */
  bool
  improve(const ModelCurves& start, const EmSettings& settings, double gain);

  /** \brief From here on lets bandwidth, spacing and noise vary by \a scales (the same
   * ones whenever they are not null), and the noise by itself. */
  void
  vary(const ScaleField* scales, bool noise);

  /** \brief Traces (once) and fits with bandwidth number \a k.
   * \return the score; where nothing new was to be fitted, that of the best */
  double
  tryBandwidth(std::size_t k);

  /** \brief Fits curves along the shortest tree of the points (\ref spanningCurves),
   * kept where they are clearly better. */
  void
  trySpanning();

  /** \brief The best fit of traces whose curves take another course than those of the
   * best of all, if its score is behind by at most \a most_behind. */
  std::optional<Fitted>
  runnerUp(double most_behind) const;

  /** \brief From here on \a fitted is the best. */
  void
  goOnFrom(Fitted fitted)
  {
    best_ = std::move(fitted);
  }

  /** \brief Hands the best fit out; the component is done. */
  EmFit
  release()
  {
    return std::move(best_.fit);
  }

private:
  double
  unit() const;
  /** \brief Fits \a traces of bandwidth \a b, kept where better by \a gain.
   * \return as \ref tryBandwidth does */
  double
  tryTraces(const Traces& traces, double b, double gain = 0);

  const Points& points_;
  double scale_unit_;
  CloudFrame frame_;
  UniformGrid grid_;
  EmFitter fitter_;
  const RefinedSettings& user_;
  const ScaleField* scales_ = nullptr;
  bool varied_noise_ = false;
  Fitted best_;
  std::vector<Fitted> traced_;
  // Of each bandwidth, the same everywhere or varying: noise that varies is fitted
  // along the same ridges.
  std::array<std::array<std::optional<Traces>, bandwidths.size()>, 2> traces_;
  std::optional<Traces> spanning_;        // along the shortest tree
  std::unordered_set<std::size_t> tried_; // starts of improve(), by their hash
};

} // namespace linelet
