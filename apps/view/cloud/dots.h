// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <linelet/support/points.h>

namespace linelet::view {

/** \brief A cloud of dots with given positions and colors. */
struct Dots {
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();
  Indices indices; ///< points of the cloud that are drawn

  Dots();

  /** \brief Shows those of \a points that are \a chosen. */
  void
  place(const Points& points, Indices chosen);

  /** \param[in] rgb of all points of the cloud */
  void
  color(const std::vector<std::uint8_t>& rgb);
};

} // namespace linelet::view
