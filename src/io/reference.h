// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

class OGRSpatialReference;

namespace linelet::io {

struct ReleaseReference {
  void
  operator()(OGRSpatialReference* reference) const;
};
using Reference = std::unique_ptr<OGRSpatialReference, ReleaseReference>;

/** \brief The reference system that \a wkt describes, east before north; null where it
 * is empty or cannot be understood. */
Reference
parseReference(const std::string& wkt);

/** \brief What the GeoTIFF keys of a file say of its reference system: EPSG codes of
 * its parts and of their units, 0 where not given. */
struct ReferenceCodes {
  int plan = 0, height = 0;
  int plan_unit = 0, height_unit = 0;
};

/** \brief WKT of the system with these codes; a unit that is given counts more than
 * that of the system. Empty where PROJ does not know the horizontal part. */
std::string
wktOfCodes(const ReferenceCodes& codes);

/** \brief WKT of a system of which nothing but the unit is known; empty for meters and
 * for units that are none of length. */
std::string
wktOfUnit(int code);

} // namespace linelet::io
