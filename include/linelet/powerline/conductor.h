// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <linelet/powerline/power_line_network.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief What a wire is made of, as far as its sag depends on it. */
struct Conductor {
  std::string name;
  double area = 0;      ///< square millimeters, all metals
  double diameter = 0;  ///< millimeters
  double mass = 0;      ///< kilograms per kilometer
  double modulus = 0;   ///< final modulus of elasticity, gigapascal
  double expansion = 0; ///< 1e-6 per kelvin
  double creep = 0; ///< elongation still to come, as the warming that gives as much, K
};

/** \brief Common types: ACSR by ASTM B 232 (E and expansion by stranding as in DIN
 * 48204, which CIGRE TB 324 and catalogs give alike), Al/St by DIN 48204 (EN 50182),
 * and AAAC by ASTM B 399. Areas, diameters and masses as manufacturers' catalogs print
 * them (Nexans, Bare Overhead Conductors; Oman Cables, Overhead Line Conductors). */
const std::vector<Conductor>&
knownConductors();

/** \brief A type by its name ("Drake", "240/40"), or from a file: lines "KEY VALUE"
 * with the keys area (mm2), diameter (mm), mass (kg/km), modulus (GPa), expansion
 * (1e-6/K), and, if need be, name and creep (K); # begins a comment.
 * \throws std::invalid_argument that names line and value; io::FileError */
Conductor
readConductor(const std::string& name_or_file);

/** \brief A state of the conductors that is asked for. */
struct ConductorState {
  std::string name;       ///< as it was given
  double temperature = 0; ///< of the conductor, degrees Celsius
  double ice = 0;         ///< thickness of a sleeve of ice, millimeters
  double wind = 0;        ///< pressure on the diameter with its ice, pascal
};

/** \brief "75C", "0C,ice=10mm,wind=400Pa".
 * \throws std::invalid_argument that explains the format */
ConductorState
parseState(const std::string& text);

/** \brief Weight and wind on a meter of conductor. */
struct ConductorLoad {
  double vertical = 0, horizontal = 0; ///< newton per meter

  /** \brief Of both together. */
  double
  resultant() const;

  /** \brief How far out of the vertical it pulls, degrees. */
  double
  swing() const;
};

/** \brief With ice of 900 kg/m3 (EN 50341-1, glaze). */
ConductorLoad
loadOf(const Conductor& conductor, const ConductorState& state);

/** \brief One span of a section: horizontal length and difference of height of its
 * attachments, meters. */
struct SpanShape {
  double length = 0, rise = 0;
};

/** \brief The horizontal tension after a change of state of a section between two dead
 * ends, whose spans all have the same.
 *
 * The unstretched length of the section is what does not change but by warming. For
 * every span it is the catenary's length less its elastic elongation: with a = H / w,
 * span l and rise h, L^2 = h^2 + (2 a sinh(l / 2a))^2 and an elongation of H / (2 E A)
 * (l + a sinh(l / a) cosh(2 m / a)), tanh(m / a) = h / L. Level spans and small sags
 * give the state equation of the ruling span sqrt(sum l^3 / sum l) (CIGRE TB 324, 2007,
 * 5.2).
 * \param[in] before, after the spans in the plane of the load at that state
 * \param[in] tension horizontal, newton; \a load and \a new_load in newton per meter
 * \param[in] warming kelvin, creep included
 * \throws std::invalid_argument where a quantity is not positive */
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

/** \brief The catenary of constant \a a that hangs between two points, with the swing
 * \a swing of Catenary::swing. */
Catenary
catenaryBetween(const Point& front, const Point& back, double a, double swing);

/** \brief A conductor from dead end to dead end, and what becomes of it. */
struct StrainSection {
  int circuit = 0;
  std::vector<int> wires;              ///< ids, in order
  double ruling_span = 0;              ///< meters
  double tension = 0, new_tension = 0; ///< horizontal, newton
};

/** \brief The wires of a network in another state. */
struct StateOfWires {
  std::vector<Wire> wires; ///< as many as the network has, with clearances unknown
  std::vector<StrainSection> sections;
};

/** \brief How wires are brought to another state. */
struct StateSettings {
  Conductor conductor;
  double measured_temperature = 15; ///< of the conductor during the scan, Celsius
  double dead_end_angle = 10;       ///< a line that turns by more ends at its support
  std::vector<int> dead_ends;       ///< ids of supports that are dead ends in any case
};

/** \brief Brings every wire of \a network to \a state, section by section.
 *
 * A section is a chain of wires from attachment to attachment. It ends where the line
 * ends, turns by more than \ref StateSettings::dead_end_angle, at the supports that are
 * named, and where the catenary constants on both sides differ by more than four times
 * what the scatter of their points explains: insulators that hang let tensions become
 * equal. Attachments stay where they are; every wire keeps its own ratio to the
 * section's mean, so that no change of state changes no curve.
 * \param[in] side 1 or -1: wind blows to the right or to the left of the wires
 * \throws std::invalid_argument */
StateOfWires
moveToState(const PowerLineNetwork& network,
            const StateSettings& settings,
            const ConductorState& state,
            double side = 1);

} // namespace powerline
} // namespace linelet
