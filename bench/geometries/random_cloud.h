// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <bench/geometries/random_shapes.h>
#include <bench/geometries/test_cloud.h>
#include <linelet/support/points.h>

namespace linelet::bench {

/** \brief How samples lie around their curve. */
enum class NoiseKind {
  FixedRadius, ///< all at the same distance from their source
  Normal,      ///< normal
  Student,     ///< Student, three degrees of freedom
  Varying      ///< normal, in some places nine times as wide as in others
};

} // namespace linelet::bench

namespace linelet {

template <>
struct Names<bench::NoiseKind> {
  using K = bench::NoiseKind;
  static constexpr std::string_view kind = "noise";
  static constexpr std::array<std::pair<K, std::string_view>, 4> table = {
      {{K::FixedRadius, "fixed-radius"},
       {K::Normal, "normal"},
       {K::Student, "student"},
       {K::Varying, "varying"}}};
};

} // namespace linelet

namespace linelet::bench {

/** \brief A kind of random clouds; all else follows from seed and sampling. */
struct RandomCloudKind {
  ShapeFamily family = ShapeFamily::Open;
  /// In a plane, as are outliers and noise, except noise of fixed radius, which would
  /// turn one curve into two there, and its outliers.
  bool flat = false;
  NoiseKind noise = NoiseKind::Normal;
};

/** \brief Such as "random-tree-2d-normal". */
std::string
kindName(const RandomCloudKind& kind);

/** \brief The kind that is called \a name, if any. */
std::optional<RandomCloudKind>
randomCloudKind(std::string_view name);

/** \brief Noisy samples of a random shape, and the curves that they come from. */
struct RandomCloud {
  Points points;
  CurveNetwork truth;
  double unit = 1; ///< the tenth part of the longest side of the shape's box
};

/** \brief A random shape of this kind, sampled, at a random position, rotation and
 * scale.
 *
 * \param[in] sampling points, distribution and seed are those of \ref sample. The
 * jitter is the root mean square of the displacements in the unit of the shape; where
 * the noise varies, at its widest. The outliers are even in a ball (in a plane: a disc)
 * whose diameter is 1.2 times the diagonal of the shape's box. hole and out_of_plane
 * are ignored. */
RandomCloud
randomCloud(const RandomCloudKind& kind, const SamplingSettings& sampling);

} // namespace linelet::bench
