// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief What the GeoTIFF keys of a file state about its reference system: EPSG codes
 * of its parts and their units, 0 if not given. */
struct ReferenceCodes {
  int plan = 0, height = 0;
  int plan_unit = 0, height_unit = 0;
};

/** \brief What readers of point files need from reference systems. GDAL provides it, in
 * linelet::vector; a program linked without it takes WKT as it is. */
struct ReferenceSystems {
  /** \brief Whether \a wkt describes a system. */
  bool (*isUnderstood)(const std::string& wkt);

  /** \brief WKT of the system with these codes; a given unit takes precedence over that
   * of the system. Empty if PROJ does not know the horizontal part. */
  std::string (*wktOfCodes)(const ReferenceCodes& codes);

  /** \brief WKT of a system with a known unit and nothing else; empty for meters and
   * for units that are not lengths. */
  std::string (*wktOfUnit)(int code);

  /** \brief WKT of the system that \a text names: EPSG:n, WKT, or a file of WKT; empty
   * if it names none. */
  std::string (*wktOfText)(const std::string& text);

  /** \brief See \ref referenceName. */
  std::string (*nameOf)(const std::string& wkt);

  /** \brief EPSG code of the system \a wkt; 0 if it states none. */
  int (*epsgOf)(const std::string& wkt);
};

/** \brief The implementation that the program was linked with, or null. */
const ReferenceSystems*
referenceSystems();

/** \brief WKT of the reference system that a user declares: EPSG:n, WKT, or a file of
 * WKT.
 * \param[in] the command line option, for messages
 * \throws FileError if it is none of these, or without linelet::vector */
std::string
declaredReference(const std::string& text, const std::string& option = "--crs");

/** \brief Called once, when linelet::vector is loaded. */
void
setReferenceSystems(const ReferenceSystems* systems);

} // namespace io
} // namespace linelet
