// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/support/camera.h>

namespace linelet::apps {

/** \brief Reads a camera from JSON: `eye` and `target` (x, y, z in the coordinates of
 * the cloud's file), and optionally `up`, `field_of_view` (vertical, degrees), `width`,
 * `height` (pixels), `near` and `far` (depths).
 * \param[in] shift of the cloud, subtracted from the eye
 * \throws std::runtime_error naming the file and what is wrong */
Camera
readCamera(const std::string& path, const Point& shift);

} // namespace linelet::apps
