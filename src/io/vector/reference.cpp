// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reference.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <ogr_spatialref.h>

#include <linelet/io/cloud.h>
#include <linelet/io/reference_system.h>
#include <linelet/support/visibility.h>

#include "io/reference_systems.h"

namespace linelet::io {

void
ReleaseReference::operator()(OGRSpatialReference* reference) const
{
  reference->Release();
}

namespace {

/** GDAL prints errors to stderr unless told not to; we throw exceptions instead. */
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
  // LAS and most readers expect WKT 1 (2001).
  const char* const options[] = {"FORMAT=WKT1_GDAL", nullptr};
  if (reference.exportToWkt(&text, options) == OGRERR_NONE)
    wkt = text;
  CPLFree(text);
  return wkt;
}

/** A unit of length that GeoTIFF keys name by its EPSG code. */
struct LengthUnit {
  int code;
  const char* name;
  double meters;
};
constexpr LengthUnit length_units[] = {{9001, "metre", 1},
                                       {9002, "foot", 0.3048},
                                       {9003, "US survey foot", 1200.0 / 3937}};
constexpr double exactly = 1e-9; // units in WKT are rounded

const LengthUnit*
unitOfCode(int code)
{
  for (const LengthUnit& unit : length_units)
    if (unit.code == code)
      return &unit;
  return nullptr;
}

/** The horizontal part; false if it is unknown. */
bool
makePlan(OGRSpatialReference& plan, const ReferenceCodes& codes)
{
  if (codes.plan == 0 || plan.importFromEPSG(codes.plan) != OGRERR_NONE)
    return false;
  const LengthUnit* unit = unitOfCode(codes.plan_unit);
  if (unit != nullptr && plan.IsProjected() != 0 &&
      std::abs(plan.GetLinearUnits() - unit->meters) > exactly)
    plan.SetLinearUnitsAndUpdateParameters(unit->name, unit->meters);
  return true;
}

/** The vertical part; false if it is unknown. */
bool
makeHeight(OGRSpatialReference& height, const ReferenceCodes& codes)
{
  const LengthUnit* unit = unitOfCode(codes.height_unit);
  const bool known =
      codes.height != 0 && height.importFromEPSG(codes.height) == OGRERR_NONE;
  if (unit == nullptr ||
      (known && std::abs(height.GetLinearUnits() - unit->meters) <= exactly))
    return known;
  const std::string name = known ? height.GetName() : "unknown height";
  height.Clear();
  height.SetVertCS(name.c_str(), "unknown", 2005);
  height.SetLinearUnits(unit->name, unit->meters);
  return true;
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

bool
toLongitudeLatitude(Points& points, const std::string& wkt)
{
  const Quiet quiet;
  const Reference from = parseReference(wkt);
  OGRSpatialReference to;
  if (from == nullptr || from->IsLocal() != 0 || to.importFromEPSG(4326) != OGRERR_NONE)
    return false;
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(from.get(), &to));
  if (transformation == nullptr)
    return false;
  for (Point& point : points)
    if (transformation->Transform(1, &point.x(), &point.y()) == 0)
      return false;
  return true;
}

std::string
wkt2Of(const std::string& wkt)
{
  const Quiet quiet;
  const Reference reference = parseReference(wkt);
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  std::string form = wkt;
  if (reference != nullptr && reference->exportToWkt(&text, options) == OGRERR_NONE)
    form = text;
  CPLFree(text);
  return form;
}

namespace {

std::string
wktOfCodes(const ReferenceCodes& codes)
{
  const Quiet quiet;
  OGRSpatialReference plan, height, both;
  if (!makePlan(plan, codes))
    return {};
  if (!makeHeight(height, codes))
    return wktOf(plan);
  const std::string name = std::string(plan.GetName()) + " + " + height.GetName();
  if (both.SetCompoundCS(name.c_str(), &plan, &height) != OGRERR_NONE)
    return wktOf(plan);
  return wktOf(both);
}

int
epsgOf(const std::string& wkt)
{
  const Reference reference = parseReference(wkt);
  const char* code =
      reference != nullptr ? reference->GetAuthorityCode(nullptr) : nullptr;
  if (code == nullptr && reference != nullptr)
    code = reference->GetAuthorityCode("PROJCS");
  return code != nullptr ? std::atoi(code) : 0;
}

std::string
wktOfText(const std::string& text)
{
  const Quiet quiet;
  std::string definition = text;
  if (std::ifstream file(text); file)
    definition.assign(std::istreambuf_iterator<char>(file), {});
  OGRSpatialReference reference;
  // SetFromUserInput would otherwise fetch URLs.
  const char* const options[] = {
      "ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
  if (reference.SetFromUserInput(definition.c_str(), options) != OGRERR_NONE)
    return {};
  return wktOf(reference);
}

std::string
wktOfUnit(int code)
{
  const LengthUnit* unit = unitOfCode(code);
  if (unit == nullptr || unit->meters == 1)
    return {};
  OGRSpatialReference local;
  local.SetLocalCS("unknown reference system");
  local.SetLinearUnits(unit->name, unit->meters);
  return wktOf(local);
}

bool
isUnderstood(const std::string& wkt)
{
  return parseReference(wkt) != nullptr;
}

constexpr ReferenceSystems systems = {
    isUnderstood, wktOfCodes, wktOfUnit, wktOfText, referenceName, epsgOf};

} // namespace

std::string
referenceName(const std::string& wkt)
{
  const Reference reference = parseReference(wkt);
  if (reference == nullptr || reference->GetName() == nullptr)
    return {};
  return reference->GetName();
}

Units
unitsOf(const std::string& wkt)
{
  Units units;
  const Reference reference = parseReference(wkt);
  if (reference == nullptr)
    return units;
  const Quiet quiet;
  const auto take = [](const char* given, double meters, std::string& name) {
    name = given != nullptr ? given : "unknown unit";
    return std::abs(meters - 1) <= exactly ? 1 : meters;
  };
  const char* name = nullptr;
  units.height_stated = reference->IsVertical() != 0;
  if (units.height_stated) {
    const double meters = reference->GetTargetLinearUnits("VERT_CS", &name);
    units.height = take(name, meters, units.height_name);
  }
  if (reference->IsGeographic() != 0 || reference->IsGeocentric() != 0) {
    units.plan = std::numeric_limits<double>::quiet_NaN();
    units.plan_name =
        reference->IsGeographic() != 0 ? "degree" : "metre from the Earth's center";
    return units;
  }
  const double meters = reference->GetLinearUnits(&name);
  units.plan = take(name, meters, units.plan_name);
  if (!units.height_stated) {
    units.height = units.plan;
    units.height_name = units.plan_name;
  }
  return units;
}

std::string
degreesIn(const Cloud& cloud)
{
  const Units units = unitsOf(cloud.wkt);
  if (std::isnan(units.plan))
    return "its reference system " + referenceName(cloud.wkt) + " has the unit " +
           units.plan_name;
  if (!cloud.wkt.empty() || cloud.points.size() < 2)
    return {};
  // Coordinates in degrees have hardly any extent in plan.
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Point& p : cloud.points)
    if (p.allFinite()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const Point extent = high - low;
  const Point world = cloud.shift + low;
  const bool alike = extent.head<2>().maxCoeff() < 0.5 && extent.z() > 2 &&
                     std::abs(world.x()) <= 360 && std::abs(world.y()) <= 90;
  return alike ? "its coordinates look like degrees" : "";
}

} // namespace linelet::io

// Linking linelet::vector references this symbol, which pulls in this object.
extern "C" LINELET_PUBLIC const bool linelet_reference_systems;
const bool linelet_reference_systems =
    (linelet::io::setReferenceSystems(&linelet::io::systems), true);
