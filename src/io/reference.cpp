// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reference.h"

#include <cmath>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <ogr_spatialref.h>

#include <linelet/io/cloud.h>

namespace linelet::io {

void
ReleaseReference::operator()(OGRSpatialReference* reference) const
{
  reference->Release();
}

namespace {

/** GDAL prints errors to stderr unless told not to; ours are said by exceptions. */
class Quiet {
public:
  Quiet() { CPLPushErrorHandler(CPLQuietErrorHandler); }
  ~Quiet() { CPLPopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet&
  operator=(const Quiet&) = delete;
};

std::string
wktOf(const OGRSpatialReference& reference)
{
  char* text = nullptr;
  std::string wkt;
  // LAS and most readers of WKT want the form of 2001.
  const char* const options[] = {"FORMAT=WKT1_GDAL", nullptr};
  if (reference.exportToWkt(&text, options) == OGRERR_NONE)
    wkt = text;
  CPLFree(text);
  return wkt;
}

} // namespace

Reference
parseReference(const std::string& wkt)
{
  const Quiet quiet;
  Reference reference(new OGRSpatialReference);
  if (wkt.empty() || reference->importFromWkt(wkt.c_str()) != OGRERR_NONE)
    return nullptr;
  reference->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

std::string
wktOfEpsg(int horizontal, int vertical)
{
  const Quiet quiet;
  OGRSpatialReference plane;
  if (plane.importFromEPSG(horizontal) != OGRERR_NONE)
    return {};
  if (vertical == 0)
    return wktOf(plane);
  OGRSpatialReference height, both;
  if (height.importFromEPSG(vertical) != OGRERR_NONE)
    return wktOf(plane);
  const std::string name = std::string(plane.GetName()) + " + " + height.GetName();
  if (both.SetCompoundCS(name.c_str(), &plane, &height) != OGRERR_NONE)
    return wktOf(plane);
  return wktOf(both);
}

std::string
referenceName(const std::string& wkt)
{
  const Reference reference = parseReference(wkt);
  if (reference == nullptr || reference->GetName() == nullptr)
    return {};
  return reference->GetName();
}

std::string
unitOtherThanMetre(const std::string& wkt)
{
  const Reference reference = parseReference(wkt);
  if (reference == nullptr)
    return {};
  const Quiet quiet;
  if (reference->IsGeographic() != 0)
    return "degree";
  constexpr double exactly = 1e-9;
  const char* name = nullptr;
  if (std::abs(reference->GetLinearUnits(&name) - 1) > exactly)
    return name != nullptr ? name : "unknown unit";
  if (reference->IsCompound() != 0 &&
      std::abs(reference->GetTargetLinearUnits("VERT_CS", &name) - 1) > exactly)
    return name != nullptr ? name : "unknown unit";
  return {};
}

} // namespace linelet::io
