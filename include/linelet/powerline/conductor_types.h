// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Properties of a conductor on which its sag depends. */
struct Conductor {
  std::string name;
  double area = 0;      ///< square millimeters, all metals
  double diameter = 0;  ///< millimeters
  double mass = 0;      ///< kilograms per kilometer
  double modulus = 0;   ///< final modulus of elasticity, gigapascals
  double expansion = 0; ///< 1e-6 per kelvin
  double creep = 0; ///< elongation still to come, as warming that causes the same, K
};

/** \brief Common types: ACSR by ASTM B 232 (E and expansion by stranding as in DIN
 * 48204, CIGRE TB 324 and catalogs), Al/St by DIN 48204 (EN 50182), and AAAC by ASTM B
 * 399. Areas, diameters and masses are those of manufacturers' catalogs (Nexans, Bare
 * Overhead Conductors; Oman Cables, Overhead Line Conductors). */
const std::vector<Conductor>&
knownConductors();

/** \brief A type by its name ("Drake", "240/40"), or from a file: lines "KEY VALUE"
 * with the keys area (mm2), diameter (mm), mass (kg/km), modulus (GPa), expansion
 * (1e-6/K), and optionally name and creep (K); # begins a comment.
 * \throws std::invalid_argument naming the line and value; io::FileError */
Conductor
readConductor(const std::string& name_or_file);

} // namespace powerline
} // namespace linelet
