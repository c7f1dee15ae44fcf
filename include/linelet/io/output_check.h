// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Fails before long work if writeCloud to \a path would fail after it: because
 * its ending names no format that can be written, or because no file can be created
 * there. Leaves no file.
 * \throws FileError */
void
checkCloudOutput(const std::string& path);

/** \brief The same for writeCurves. \throws FileError */
void
checkCurvesOutput(const std::string& path);

/** \brief Whether \a one and \a other are the same file, under any names and links, or
 * would be once both exist. Never true for devices and pipes, which store nothing. */
bool
isSameFile(const std::string& one, const std::string& other);

/** \brief A key that is equal for all names of the same file (\ref isSameFile); empty
 * for devices and pipes. */
std::string
identityOf(const std::string& path);

} // namespace io
} // namespace linelet
