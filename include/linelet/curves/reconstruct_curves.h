// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>

#include <linelet/curves/curve_network.h>
#include <linelet/curves/refined_settings.h>
#include <linelet/curves/streamline_settings.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The methods of curve reconstruction. */
enum class Preset {
  Refined,       ///< ridges refitted as noisy polylines; the default
  Published,     ///< line-lets as published in 2021, the baseline of every benchmark
  PublishedQuick ///< the same with scales up to 10 D instead of 60, four times as fast
};

/** \brief Whether \a preset is the published method or a variant of it. */
inline bool
isPublished(Preset preset)
{
  return preset != Preset::Refined;
}

template <>
struct Names<Preset> {
  static constexpr std::string_view kind = "preset";
  static constexpr std::array<std::pair<Preset, std::string_view>, 3> table = {
      {{Preset::Refined, "refined"},
       {Preset::Published, "published"},
       {Preset::PublishedQuick, "published-quick"}}};
};

/** \brief How curves are reconstructed.
 *
 * start_points, max_iterations, distance_cutoff and threads apply to every preset; the
 * other parameters belong to the published presets. */
struct ReconstructionSettings : StreamlineSettings {
  Preset preset = Preset::Refined;
  CloudTraits whole; ///< traits of the cloud, if known; refined only
};

template <class Visit>
void
describe(ReconstructionSettings& settings, Visit&& visit)
{
  visit("preset", settings.preset, "method");
  describe(static_cast<StreamlineSettings&>(settings), visit);
}

/** \brief The settings that apply to the refined reconstruction. */
RefinedSettings
refinedSettings(const ReconstructionSettings& settings);

/** \brief Curves that run through \a points.
 * \param[in] points any points; those with a coordinate that is not finite are left out
 * \return the curves; may be none
 * \throws std::invalid_argument for a parameter out of range, Canceled */
CurveNetwork
reconstructCurves(const Points& points,
                  const ReconstructionSettings& settings = {},
                  ProgressMonitor* monitor = nullptr);

/** \brief The same, with neighbors from \a search over \a points, where the method
 * needs any. */
CurveNetwork
reconstructCurves(const NeighborSearch& search,
                  const Points& points,
                  const ReconstructionSettings& settings = {},
                  ProgressMonitor* monitor = nullptr);

} // namespace linelet
