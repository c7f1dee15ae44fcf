// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief An attribute of a vector feature. */
using Value = std::variant<std::int64_t, double, std::string>;

/** \brief Named attributes, in the order of columns. */
using Attributes = std::vector<std::pair<std::string, Value>>;

/** \brief A point (one vertex), a polyline or a polygon with named attributes. */
struct VectorFeature {
  Points vertices; ///< world coordinates; a closed line and the ring of a polygon
                   ///< repeat their first vertex
  Attributes attributes;
  /// Its layer in a DXF drawing; empty: named as the VectorLayer
  std::string drawing_layer;
  std::string label; ///< text beside it in a DXF drawing; empty: none
};

/** \brief Features of one kind, with a name. */
struct VectorLayer {
  enum class Kind { Points, Lines, Polygons };
  std::string name;
  Kind kind = Kind::Lines;
  std::vector<VectorFeature> features; ///< all with the same attribute names and types
  Attributes columns;       ///< those names and types, for a layer without features
  double text_height = 0.5; ///< of labels in a DXF drawing, in the unit of coordinates
};

/** \brief How vector files are written. */
struct VectorOptions {
  std::string output_crs; ///< EPSG:n, WKT or a WKT file; empty: that of the input
  bool keep_crs = false;  ///< GeoJSON in the system of the input, not in WGS 84
};

template <class Visit>
void
describe(VectorOptions& s, Visit&& visit)
{
  visit("output-crs",
        s.output_crs,
        "reference system of vector outputs: EPSG:n or a WKT file (heights are "
        "unchanged)");
  visit("keep-crs",
        s.keep_crs,
        "GeoJSON in the reference system of the input, named in the former crs member, "
        "instead of WGS 84 (RFC 7946)");
}

/** \brief Writes layers as .geojson, .gpkg, .dxf, a single one as .csv, or in any other
 * format that GDAL has a driver for (.kml, .fgb, .shz, ...): 3D, in full precision, in
 * the given reference system. An existing file is replaced; the same input gives the
 * same bytes.
 *
 * GeoJSON holds all layers in one collection, each feature with a property `layer`, in
 * degrees of WGS 84 with nine decimals (RFC 7946), as does KML; see \ref VectorOptions.
 * If the reference system is unknown, coordinates are written as they are. DXF holds no
 * attributes: there a feature has its VectorFeature::drawing_layer, and its label
 * becomes a text on the layer `labels`; a polygon is a closed line. CSV has the
 * attributes, unknown numbers left empty, and the geometry as WKT in the last column,
 * `WKT`.
 * \param[in] wkt reference system, empty: unknown
 * \param[out] warnings one sentence if readers will misinterpret the coordinates
 * \throws FileError, Canceled */
void
writeLayers(const std::string& path,
            const std::vector<VectorLayer>& layers,
            const std::string& wkt,
            std::vector<std::string>* warnings = nullptr,
            ProgressMonitor* monitor = nullptr,
            const VectorOptions& options = {});

/** \brief Writes \a network by the ending of \a path: .obj (v / l), .ply (edges), .vtk
 * (lines), .csv, .h5 (with junctions, see hdf5_file.h), or any format of \ref
 * writeLayers; only those are reprojected.
 * \param[in] shift added to every vertex: the output is in world coordinates
 * \param[in] wkt see \ref writeLayers, also for \a warnings
 * \throws FileError, Canceled */
void
writeCurves(const std::string& path,
            const CurveNetwork& network,
            const Point& shift = Point::Zero(),
            const std::string& wkt = {},
            std::vector<std::string>* warnings = nullptr,
            ProgressMonitor* monitor = nullptr,
            const VectorOptions& options = {});

/** \brief Reads the lines of a .geojson, .gpkg or .dxf file with their attributes,
 * layer by layer; layers without lines are left out. The features of a layer have one
 * attribute per column of the layer.
 * \throws FileError */
std::vector<VectorLayer>
readLayers(const std::string& path);

/** \brief Reads polylines back from any file of \ref writeCurves or \ref writeLayers,
 * by ending (.ply and .vtk in ASCII); a line whose last vertex is its first is closed.
 * \param[in] shift subtracted from every vertex
 * \param[out] wkt reference system, empty if the file has none; may be null
 * \throws FileError */
CurveNetwork
readCurves(const std::string& path,
           const Point& shift = Point::Zero(),
           std::string* wkt = nullptr);

} // namespace io
} // namespace linelet
