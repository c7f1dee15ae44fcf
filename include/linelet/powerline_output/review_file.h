// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/review.h>
#include <linelet/powerline_output/output_files.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Reads reviews of wires: the lines of a file like `wires.gpkg` whose
 * columns `review` (accepted, rejected or empty), `review_class` (-1: none) and
 * `review_note` the viewer, or a GIS, filled in. Lines without a review are read too.
 * \param[in] cloud the cloud whose network was reviewed; gives shift and units
 * \throws io::FileError if there is no such column, or if it holds something else */
std::vector<ReviewedWire>
readReview(const std::string& path, const io::Cloud& cloud);

/** \brief Writes the layers of \a network, with the reviews of its wires, to \a path
 * (.gpkg), completely or not at all. \throws io::FileError */
void
writeReview(const std::string& path,
            const io::Cloud& cloud,
            const PowerLineNetwork& network,
            const OutputOptions& options = {});

} // namespace powerline
} // namespace linelet
