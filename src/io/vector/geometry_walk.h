// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "dataset.h"

namespace linelet::io {

/** \brief Calls \a take with every point (OGRPoint), line and ring (OGRLineString) of
 * \a geometry, which has no arcs. */
template <class Take>
void
forEachStraightPart(const OGRGeometry& geometry, Take& take)
{
  const auto type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPoint)
    take(*geometry.toPoint());
  else if (OGR_GT_IsSubClassOf(type, wkbLineString) != 0)
    take(*geometry.toLineString());
  else if (OGR_GT_IsSubClassOf(type, wkbPolygon) != 0)
    for (const OGRLinearRing* ring : *geometry.toPolygon())
      take(*ring);
  else if (OGR_GT_IsSubClassOf(type, wkbPolyhedralSurface) != 0)
    for (const OGRPolygon* face : *geometry.toPolyhedralSurface())
      forEachStraightPart(*face, take);
  else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0)
    for (const OGRGeometry* part : *geometry.toGeometryCollection())
      forEachStraightPart(*part, take);
}

/** \brief The same for any geometry or none; arcs become chords as fine as GDAL's
 * default. */
template <class Take>
void
forEachPart(const OGRGeometry* geometry, Take& take)
{
  if (geometry != nullptr)
    forEachStraightPart(
        *std::unique_ptr<const OGRGeometry>(geometry->getLinearGeometry()), take);
}

} // namespace linelet::io
