// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/support/names.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief How the radii of the scales grow. */
enum class RadiusGrowth {
  Exponential, ///< r_k = D 1.5^k
  Linear       ///< r_k = D (k + 1)
};

template <>
struct Names<RadiusGrowth> {
  static constexpr std::string_view kind = "growth";
  static constexpr std::array<std::pair<RadiusGrowth, std::string_view>, 2> table = {
      {{RadiusGrowth::Exponential, "exponential"}, {RadiusGrowth::Linear, "linear"}}};
};

/** \brief The default largest radius, in units of D. */
constexpr double default_largest_radius = 60;

/** \brief The radii r_0 = D, r_1, ... up to a largest one.
 * \param[in] growth how they grow
 * \param[in] scale_unit D, positive
 * \param[in] max_radius none is larger; 0: 60 D
 * \return at least one radius, ascending
 * \throws std::invalid_argument where \a scale_unit is not positive and finite, where
 * \a max_radius is not finite or smaller than D, or where there would be more than
 * 4096 radii */
std::vector<double>
radiusSequence(RadiusGrowth growth, double scale_unit, double max_radius = 0);

/** \brief Checks radii that a user gave.
 * \throws std::invalid_argument unless they are 1 to 4096 positive, finite, ascending
 * numbers */
void
checkRadii(const std::vector<double>& radii);

} // namespace linelet
