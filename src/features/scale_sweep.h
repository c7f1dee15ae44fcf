// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/features/multi_scale_settings.h>
#include <linelet/support/points.h>
#include <linelet/tensor/neighborhood_tensor.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

/** \brief Tensors and shape factors of one neighborhood at every radius, from one list
 * of neighbors. Holds buffers: make one per thread and use it for many points. */
class ScaleSweep {
public:
  /** \param[in] radii ascending
   * \param[in] settings weighting and centroid are used */
  ScaleSweep(const std::vector<double>& radii, const MultiScaleSettings& settings);

  /** \brief Begins a new neighborhood. */
  void
  clear();

  /** \brief Adds a neighbor within the largest radius, in any order.
   * \param[in] offset from the query point
   * \param[in] squared its squared length as the search computed it */
  void
  add(const Point& offset, double squared);

  /** \brief Computes all that follows. */
  void
  run()
  {
    run(radii_.size());
  }

  /** \brief The same for the \a scales smallest radii alone. */
  void
  run(std::size_t scales);

  /** \brief CL at each scale, NaN where not defined. */
  const std::vector<double>&
  linearity() const
  {
    return linearity_;
  }

  /** \brief All three factors at each scale. */
  const std::vector<ShapeFactors>&
  factors() const
  {
    return factors_;
  }

  /** \brief Neighbors at each scale, the query point included. */
  const std::vector<std::uint32_t>&
  neighbors() const
  {
    return neighbors_;
  }

  /** \brief Neighbors at each scale that lie away from the query point. */
  const std::vector<std::uint32_t>&
  neighborsBeside() const
  {
    return beside_;
  }

  /** \brief e3 at each scale; NaN where not defined. */
  const Points&
  majors() const
  {
    return majors_;
  }

  /** \brief The tensor at each scale; NaN where not defined. */
  const std::vector<SymmetricTensor>&
  tensors() const
  {
    return tensors_;
  }

private:
  void
  sortByScale();

  void
  prefixMoments(std::size_t scales);

  void
  weightedTensors(std::size_t scales);

  std::vector<double> radii_, squared_radii_;
  Weighting weighting_, centroid_weighting_;
  Centroid centroid_;

  Points arrived_, sorted_; // neighbors as added, and by rising scale
  std::vector<double> squared_, distance_;
  std::vector<std::uint16_t> scale_; // smallest scale of each neighbor as added

  std::vector<double> linearity_, farthest_;
  std::vector<ShapeFactors> factors_;
  std::vector<std::uint32_t> neighbors_, beside_;
  std::vector<SymmetricTensor> tensors_;
  Points majors_;
};

} // namespace linelet
