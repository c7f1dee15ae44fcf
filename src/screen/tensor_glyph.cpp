// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/tensor_glyph.h>

#include <cstddef>

namespace linelet {

TensorGlyph
glyphOf(const Point& center,
        const EigenSystem& system,
        const ShapeFactors& shape,
        double size,
        const std::array<std::array<double, 3>, 3>& colors)
{
  TensorGlyph glyph;
  glyph.center = center;
  glyph.axes = system.vectors;
  glyph.half_lengths = (system.values / system.values[2]).cwiseSqrt() * size;
  glyph.shape = shape;
  for (std::size_t c = 0; c < 3; ++c)
    glyph.color[c] = static_cast<float>(shape.linearity * colors[0][c] +
                                        shape.planarity * colors[1][c] +
                                        shape.sphericity * colors[2][c]);
  return glyph;
}

} // namespace linelet
