// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Explicit schemes that integrate a direction field, all but the last with a
 * constant step. */
enum class IntegrationScheme {
  Euler,         ///< order 1
  Rk32,          ///< order 3, the third-order formula of the Bogacki-Shampine pair
  Rk38,          ///< order 4, Kutta's 3/8 rule
  Rk4,           ///< order 4, the classical one
  Merson45,      ///< order 4, Merson
  Fehlberg45,    ///< order 5, Fehlberg
  Dopri5,        ///< order 5, Dormand & Prince 1980
  Dop853,        ///< order 8, Dormand & Prince (Hairer, Norsett, Wanner)
  Dop853Adaptive ///< the same with error-controlled steps, and dense output between
                 ///< them
};

template <>
struct Names<IntegrationScheme> {
  static constexpr std::string_view kind = "integration scheme";
  static constexpr std::array<std::pair<IntegrationScheme, std::string_view>, 9> table =
      {{{IntegrationScheme::Euler, "euler"},
        {IntegrationScheme::Rk32, "rk32"},
        {IntegrationScheme::Rk38, "rk38"},
        {IntegrationScheme::Rk4, "rk4"},
        {IntegrationScheme::Merson45, "merson45"},
        {IntegrationScheme::Fehlberg45, "fehlberg45"},
        {IntegrationScheme::Dopri5, "dopri5"},
        {IntegrationScheme::Dop853, "dop853"},
        {IntegrationScheme::Dop853Adaptive, "dop853-adaptive"}}};
};

/** \brief The Butcher table of an explicit Runge-Kutta scheme. */
struct ButcherTable {
  std::vector<std::vector<double>> a; ///< row i: weights of stages 0 .. i-1
  std::vector<double> b;              ///< weights of the step
  int order = 0;
};

/** \brief The table of \a scheme; for the adaptive one, that of a step. */
const ButcherTable&
butcherTable(IntegrationScheme scheme);

/** \brief One step of length \a h from \a x along \a field, where field(position)
 * returns a direction. The field does not depend on time.
 * \return the displacement */
template <class Field>
Point
integrationStep(const ButcherTable& table, const Point& x, double h, Field&& field)
{
  constexpr std::size_t most_stages = 12;
  Point k[most_stages];
  Point step = Point::Zero();
  for (std::size_t i = 0; i < table.b.size(); ++i) {
    Point at = x;
    for (std::size_t j = 0; j < i; ++j)
      if (table.a[i][j] != 0)
        at += h * table.a[i][j] * k[j];
    k[i] = field(at);
    step += h * table.b[i] * k[i];
  }
  return step;
}

} // namespace linelet
