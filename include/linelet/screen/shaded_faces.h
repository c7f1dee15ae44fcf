// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

#include <linelet/screen/glyph_image.h>
#include <linelet/support/camera.h>
#include <linelet/support/face.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The faces, opaque and lit from beside the eye, like the ellipsoids; where
 * they overlap, the nearest is visible. Faces with a corner that is not finite, or not
 * between the camera's near and far depth, are left out.
 * \param[in] colors of the parts that the faces belong to: red, green, blue in [0, 1]
 */
GlyphImage
drawFaces(const std::vector<Face>& faces,
          const std::vector<std::array<float, 3>>& colors,
          const Camera& camera,
          unsigned threads = 0);

} // namespace linelet
