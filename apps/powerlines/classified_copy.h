// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <linelet/io/point_file.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline_output/class_scheme.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::apps {

/** \brief Fills the per-point lists of \a found for the points of \a cloud, the next
 * ones of file number \a file. */
using LabelBlock = std::function<void(
    std::size_t file, const io::Cloud& cloud, powerline::PowerLineNetwork& found)>;

struct CopiedPoints {
  double points = 0;
  std::size_t unconfirmed = 0; ///< see powerline::classify
};

/** \brief Rewrites the points of \a files, block by block, with their classes and what
 * was found, without holding their attributes in memory.
 * \param[in] path .las or .laz
 * \param[in] options how to read them, with the shift of all, and threads
 * \param[in] wkt reference system, used if the first file has none
 * \param[in] wires of the network, whose reviews name classes
 * \throws io::PartsDiffer if they cannot be written this way; io::FileError */
CopiedPoints
copyClassified(const std::string& path,
               const std::vector<std::string>& files,
               const io::ReadOptions& options,
               const powerline::ClassScheme& classes,
               const std::string& wkt,
               const std::vector<powerline::Wire>& wires,
               const LabelBlock& label,
               std::vector<std::string>* warnings,
               ProgressMonitor* monitor);

} // namespace linelet::apps
