// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <linelet/support/points.h>

#include "io/source.h"
#include "io/values.h"

namespace linelet::io {

/** \brief The kind of samples in a volume. */
enum class SampleKind {
  Number,
  Symmetric,       ///< xx xy xz yy yz zz
  MaskedSymmetric, ///< the mask, then these
  Matrix           ///< row by row
};

/** \brief Where the samples of a volume lie in a file and in space. */
struct NrrdHeader {
  ValueType type = ValueType::Float32;
  bool big_endian = false;
  std::string encoding;
  SampleKind kind = SampleKind::Number;
  std::size_t components = 1, component_step = 1; ///< of a sample, in numbers
  std::array<std::size_t, 3> sizes{};             ///< samples along the spatial axes
  std::array<std::size_t, 3> steps{};             ///< between samples, in numbers
  Point origin = Point::Zero();                   ///< of the first sample
  Eigen::Matrix3d directions =
      Eigen::Matrix3d::Identity();                     ///< columns: a step in space
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity(); ///< columns: axes of the tensors
  std::string_view data;

  std::size_t
  numbers() const
  {
    return components * sizes[0] * sizes[1] * sizes[2];
  }
};

/** \brief Reads the header. The product of its sizes fits into a size_t; the reader of
 * the data checks it against the file. */
NrrdHeader
readNrrdHeader(const Source& source);

} // namespace linelet::io
