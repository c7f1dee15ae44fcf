// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include <linelet/support/points.h>

class OGRSpatialReference;

namespace linelet::io {

struct ReleaseReference {
  void
  operator()(OGRSpatialReference* reference) const;
};
using Reference = std::unique_ptr<OGRSpatialReference, ReleaseReference>;

/** \brief The reference system that \a wkt describes, east before north; null if it is
 * empty or not understood. */
Reference
parseReference(const std::string& wkt);

/** \brief Converts x and y of \a points from the system \a wkt to longitude and
 * latitude (WGS 84); false if that is impossible. */
bool
toLongitudeLatitude(Points& points, const std::string& wkt);

/** \brief \a wkt as WKT 2 (2019). */
std::string
wkt2Of(const std::string& wkt);

} // namespace linelet::io
