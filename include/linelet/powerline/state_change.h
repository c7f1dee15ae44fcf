// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/powerline/conductor_types.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief A requested state of the conductors. */
struct ConductorState {
  std::string name;       ///< as it was given
  double temperature = 0; ///< of the conductor, degrees Celsius
  double ice = 0;         ///< radial thickness of the ice, millimeters
  double wind = 0;        ///< pressure on the diameter including ice, pascals
};

/** \brief Reads a state such as "75C" or "0C,ice=10mm,wind=400Pa".
 * \throws std::invalid_argument explaining the format */
ConductorState
parseState(const std::string& text);

/** \brief Weight and wind load per meter of conductor. */
struct ConductorLoad {
  double vertical = 0, horizontal = 0; ///< newtons per meter

  /** \brief Of both combined. */
  double
  resultant() const;

  /** \brief Angle of the resultant from the vertical, degrees. */
  double
  swing() const;
};

/** \brief The load in a state, with ice of 900 kg/m3 (EN 50341-1, glaze). */
ConductorLoad
loadOf(const Conductor& conductor, const ConductorState& state);

/** \brief One span of a section: horizontal length and difference of height of its
 * attachments, meters. */
struct SpanShape {
  double length = 0, rise = 0;
};

/** \brief The horizontal tension after a change of state in a section between two dead
 * ends, whose spans all share one tension.
 *
 * The unstretched length of the section changes only by warming. For every span it is
 * the catenary's length less its elastic elongation: with a = H / w, span l and rise h,
 * L^2 = h^2 + (2 a sinh(l / 2a))^2 and an elongation of H / (2 E A) (l + a sinh(l / a)
 * cosh(2 m / a)), tanh(m / a) = h / L. Level spans and small sags give the state
 * equation of the ruling span sqrt(sum l^3 / sum l) (CIGRE TB 324, 2007, 5.2).
 * \param[in] before, after the spans in the plane of the load at that state
 * \param[in] tension horizontal, newtons; \a load and \a new_load in newtons per meter
 * \param[in] warming kelvin, creep included
 * \throws std::invalid_argument if a quantity is not positive */
double
tensionAfter(const std::vector<SpanShape>& before,
             const std::vector<SpanShape>& after,
             const Conductor& conductor,
             double tension,
             double load,
             double new_load,
             double warming);

/** \brief sqrt(sum l^3 / sum l), meters. */
double
rulingSpan(const std::vector<SpanShape>& spans);

/** \brief The catenary with constant \a a between two points, swung out by \a swing
 * degrees (see Catenary::swing). */
Catenary
catenaryBetween(const Point& front, const Point& back, double a, double swing);

} // namespace powerline
} // namespace linelet
