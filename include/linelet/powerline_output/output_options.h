// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <linelet/io/usable_points.h>
#include <linelet/io/vector_file.h>
#include <linelet/powerline/hazards.h>
#include <linelet/powerline_output/class_scheme.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Provenance of results: what a reader needs to reproduce them. */
struct Provenance {
  std::string program;             ///< name and version; may be empty
  std::string date;                ///< of the run, as text; may be empty
  std::vector<std::string> inputs; ///< files
  std::vector<std::pair<std::string, std::string>> settings; ///< name and value
};

/** \brief Size and bounds, which identify an input. */
struct InputExtent {
  std::size_t points = 0;
  Point low = Point::Zero(), high = Point::Zero(); ///< world coordinates
};

/** \brief What the outputs contain besides the network itself. */
struct OutputOptions {
  std::string source;   ///< name of the input, for headings; may be empty
  double clearance = 5; ///< a clearance below this is a hazard, meters
  ClassScheme classes;
  io::ClassFilter points;    ///< which points of the cloud were used
  io::VectorOptions vectors; ///< of all vector files
  bool compress = false;     ///< classified.laz instead of classified.las
  unsigned threads = 0;      ///< for writing; 0: all
  Provenance provenance;     ///< for the report
  /// Extent of the whole input, if the cloud holds only part of it
  std::optional<InputExtent> input;
  std::vector<Hazards> hazards; ///< in each state of the wires, first as scanned;
                                ///< empty: not searched for
};

} // namespace powerline
} // namespace linelet
