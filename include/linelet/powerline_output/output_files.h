// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/usable_points.h>
#include <linelet/io/vector_file.h>
#include <linelet/powerline/hazards.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/support/names.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief What becomes of points that came with the class of a wire or tower but are
 * none of those found. */
enum class ExistingClasses {
  Keep, ///< they stay what they were
  Reset ///< they become unclassified (1)
};

/** \brief The classes that a classified cloud gets. */
struct ClassScheme {
  unsigned wire = wire_class, tower = pylon_class; ///< 0 to 255
  ExistingClasses existing = ExistingClasses::Keep;
};

template <class Visit>
void
describe(ClassScheme& s, Visit&& visit)
{
  visit("wire-class", s.wire, "class of wires in classified.las (ASPRS: 14)");
  visit("tower-class", s.tower, "class of towers and poles there (ASPRS: 15)");
  visit("existing-classes",
        s.existing,
        "what becomes of points that came with one of these classes and are none of "
        "those found; reset: unclassified (1)");
}

/** \throws std::invalid_argument where a class is above 255 or both are the same */
void
check(const ClassScheme& scheme);

/** \brief Where results come from: what a reader needs to get them again. */
struct Provenance {
  std::string program;             ///< name and version; may be empty
  std::string date;                ///< of the run, as it is to be read; may be empty
  std::vector<std::string> inputs; ///< files
  std::vector<std::pair<std::string, std::string>> settings; ///< name and value
};

/** \brief What an input is told by. */
struct InputExtent {
  std::size_t points = 0;
  Point low = Point::Zero(), high = Point::Zero(); ///< world coordinates
};

/** \brief What the outputs say beside the network itself. */
struct OutputOptions {
  std::string source;   ///< name of the input, for headings; may be empty
  double clearance = 5; ///< a clearance below this is a hazard, meters
  ClassScheme classes;
  io::ClassFilter points;    ///< which of the cloud took part
  io::VectorOptions vectors; ///< of all vector files
  bool compress = false;     ///< classified.laz instead of classified.las
  unsigned threads = 0;      ///< to write in; 0: all
  Provenance provenance;     ///< for the report
  /// Of all of the input, where the cloud holds but a part of it.
  std::optional<InputExtent> input;
  std::vector<Hazards> hazards; ///< at each state of the wires, first as scanned;
                                ///< empty: not looked for
};

/** \brief Whether a clearance of \a wire, to the ground or to vegetation, is known and
 * below \a limit. */
bool
belowClearance(const Wire& wire, double limit);

/** \brief Gives \a cloud what was found: the classes of \a scheme in `classification`,
 * and the columns `wire_id` and `span_id` (0: none), `wire_distance` (meters, NaN:
 * none) and `unexplained` (1: part of PowerLineNetwork::unexplained). Every other class
 * and attribute stays as it is.
 * \return how many points had one of these classes but are none of those found
 * \throws std::invalid_argument unless the network belongs to the cloud, and see
 * \ref check */
std::size_t
classify(io::Cloud& cloud,
         const PowerLineNetwork& network,
         const ClassScheme& scheme = {});

/** \brief The network as layers in world coordinates: `wires` (lines), `pylons`
 * (points at the foot) and `unexplained` (lines), each with its attributes; also
 * without a feature. In a drawing every wire is a layer
 * `wires_circuit_1_span_2_wire_3`, with its main attributes as a text on the layer
 * `labels`. Coordinates are in the units of \a cloud, lengths in meters. */
std::vector<io::VectorLayer>
powerLineLayers(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options);

/** \brief The hazards of all states as layers in world coordinates: `clearances` (lines
 * along the wires), `clearance_areas` (polygons in plan, the same attributes),
 * `crossings` (from the upper wire to the lower, where they are closest) and `fall_in`
 * (from the top of the tree to the wire), each feature with its ids, distances,
 * severity and the coordinates of both ends; also without a feature. */
std::vector<io::VectorLayer>
hazardLayers(const io::Cloud& cloud, const std::vector<Hazards>& states);

/** \brief The network as JSON text: totals, circuits, spans, wires, pylons; keys in
 * snake_case, null for what is unknown, world coordinates in the units of \a cloud,
 * lengths in meters. */
std::string
powerLineSummary(const io::Cloud& cloud,
                 const PowerLineNetwork& network,
                 const OutputOptions& options);

/** \brief The network as one HTML page that needs nothing else: totals, plan, hazards,
 * and for every span its profile and its wires. The same input gives the same text. */
std::string
powerLineReport(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options,
                const ProgressMonitor* monitor = nullptr);

/** \brief The files of \a folder that \ref writePowerLineFiles writes, in its order. */
std::vector<std::string>
powerLineFiles(const std::string& folder, bool compress = false);

/** \brief Whose results \a folder holds, by its summary, where it holds any that are
 * not of \a cloud called \a source: a name, or "an unknown input". Else empty. */
std::string
otherResultsIn(const std::string& folder,
               const io::Cloud& cloud,
               const std::string& source);

/** \brief The same, of an input of that extent. */
std::string
otherResultsIn(const std::string& folder,
               const InputExtent& input,
               const std::string& source);

/** \brief Makes \a folder if need be and makes sure that files can be written there, so
 * that this fails before long work.
 * \throws io::FileError */
void
makeOutputFolder(const std::string& folder, bool compress = false);

/** \brief Writes `classified.las` (or `.laz`), wires and hazards as .geojson, .gpkg and
 * .dxf, `clearances.csv`, `crossings.csv`, `fall_in.csv`, `summary.json` and
 * `report.html` into \a folder, which is made if need be. An empty network gives the
 * same files, valid and without wires.
 * \param[in] folder where to; older files of these names are replaced
 * \param[in] cloud what the network was extracted from; move it in to save memory
 * \param[out] warnings one sentence for everything that a format cannot hold
 * \return the paths of the files, in the order above
 * \throws io::FileError */
std::vector<std::string>
writePowerLineFiles(const std::string& folder,
                    io::Cloud cloud,
                    const PowerLineNetwork& network,
                    const OutputOptions& options = {},
                    std::vector<std::string>* warnings = nullptr,
                    ProgressMonitor* monitor = nullptr);

/** \brief Writes the same files but the classified cloud; \a cloud may be but those
 * points of the input that pictures are to show, with \ref OutputOptions::input. */
std::vector<std::string>
writeNetworkFiles(const std::string& folder,
                  const io::Cloud& cloud,
                  const PowerLineNetwork& network,
                  const OutputOptions& options = {},
                  std::vector<std::string>* warnings = nullptr,
                  ProgressMonitor* monitor = nullptr);

/** \brief What to say of \a unconfirmed points, see \ref classify, and of what the
 * network does not explain. */
void
warnOfDoubts(const PowerLineNetwork& network,
             std::size_t unconfirmed,
             const ClassScheme& classes,
             std::vector<std::string>* warnings);

} // namespace powerline

template <>
struct Names<powerline::ExistingClasses> {
  static constexpr std::string_view kind = "treatment of existing classes";
  static constexpr std::array<std::pair<powerline::ExistingClasses, std::string_view>,
                              2>
      table = {{{powerline::ExistingClasses::Keep, "keep"},
                {powerline::ExistingClasses::Reset, "reset"}}};
};

} // namespace linelet
