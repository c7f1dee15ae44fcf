// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Fails at once if writeCloud to \a path would fail after long work: because
 * its ending names no format that can be written, or no file can be created there.
 * Leaves no file.
 * \throws FileError */
void
checkCloudOutput(const std::string& path);

/** \brief The same for writeCurves. \throws FileError */
void
checkCurvesOutput(const std::string& path);

/** \brief Whether \a one and \a other are the same file, under any names and links, or
 * would be once both exist. Devices and pipes, which hold nothing, never are. */
bool
isSameFile(const std::string& one, const std::string& other);

/** \brief A key that is equal for all names of the same file (\ref isSameFile); empty
 * for devices and pipes. */
std::string
identityOf(const std::string& path);

} // namespace io
} // namespace linelet
