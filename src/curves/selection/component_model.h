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

#include <linelet/curves/refined_settings.h>

#include "curves/mixture/em_fit.h"
#include "curves/mixture/model_score.h"
#include "curves/ridges/ridge_trace.h"

namespace linelet {

/** \brief Bandwidths of the ridges, in D: from the middle one down, then up from number
 * \ref first_upwards. */
constexpr std::array<double, 6> bandwidths = {1, 0.7, 0.5, 1.4, 2, 2.8};
constexpr std::size_t first_upwards = 3;
/** \brief If spacing or noise vary, these bandwidths are tried again, scaled
 * accordingly. */
constexpr std::array<std::size_t, 3> varied_bandwidths = {0, 1, 3};

/** \brief A fit and its settings. */
struct Fitted {
  EmFit fit;
  EmSettings settings;
  double score = 0;
};

/** \brief A connected component of a cloud while it is being fitted: its points,
 * settings, and best fit so far. */
class ComponentModel {
public:
  /** \param[in] points finite points; must outlive the component, as must \a user
   * \param[in] stop called in every iteration of a fit; if it returns true, Canceled is
   * thrown */
  ComponentModel(const Points& points,
                 double scale_unit,
                 const RefinedSettings& user,
                 const std::function<bool()>& stop);

  const Fitted&
  best() const
  {
    return best_;
  }
  /** \brief The fits of ridges and of the minimum spanning tree, in the order they were
   * made. */
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
  const CloudFrame&
  frame() const
  {
    return frame_;
  }
  int
  dimensions() const
  {
    return frame_.dimensions;
  }

  /** \brief The scale in D at which the component looks like curves: more than 1 if
   * they are thick compared with the point spacing; 0: none. */
  double
  curveSize() const;

  /** \brief Fits \a start; a fit that falls far behind the score \a rival is abandoned.
   */
  EmFit
  fit(const ModelCurves& start,
      const EmSettings& settings,
      double rival = std::numeric_limits<double>::infinity());

  /** \brief Keeps \a fit if it is better than the best by \a gain.
   * \return whether it was */
  bool
  take(EmFit fit, const EmSettings& settings, double gain = 0);

  /** \brief Fits \a start, and keeps the fit if it is better than the best by \a gain.
   * A start already tried with these settings is not fitted again.
   * \return whether it was better */
  bool
  improve(const ModelCurves& start, const EmSettings& settings, double gain);

  /** \brief From now on, lets bandwidth, spacing and noise vary with \a scales (if not
   * null, the same at every call), and with \a noise also the noise on its own. */
  void
  vary(const ScaleField* scales, bool noise);

  /** \brief Traces (once) and fits with bandwidth number \a k.
   * \return the score; the best score if there was nothing new to fit */
  double
  tryBandwidth(std::size_t k);

  /** \brief Fits curves along the minimum spanning tree of the points (\ref
   * spanningCurves), kept if they are clearly better. */
  void
  trySpanning();

  /** \brief The best fit of traces whose curves take another course than those of the
   * best fit overall, if its score is behind by at most \a most_behind. */
  std::optional<Fitted>
  runnerUp(double most_behind) const;

  /** \brief Makes \a fitted the best fit. */
  void
  goOnFrom(Fitted fitted)
  {
    best_ = std::move(fitted);
  }

  /** \brief Moves the best fit out; the component is done. */
  EmFit
  release()
  {
    best_.fit.evidence = 0.5 * (scoreOfNothing(frame_, points_.size()) - best_.score);
    return std::move(best_.fit);
  }

private:
  double
  unit() const;
  /** \brief Fits \a traces of bandwidth \a b, and keeps the fit if it is better by \a
   * gain.
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
  // Of each bandwidth, uniform or varying; varying noise is fitted along the same
  // ridges.
  std::array<std::array<std::optional<Traces>, bandwidths.size()>, 2> traces_;
  std::optional<Traces> spanning_;        // along the minimum spanning tree
  std::unordered_set<std::size_t> tried_; // starts of improve(), by their hash
};

} // namespace linelet
