// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vtkActor.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTensorGlyph.h>

#include <linelet/features/point_types.h>
#include <linelet/support/points.h>

namespace linelet::view {

/** \brief The ellipsoids of tensors: half axes are square roots of eigenvalues. */
struct Ellipsoids {
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkTensorGlyph> glyph = vtkSmartPointer<vtkTensorGlyph>::New();
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();
  vtkSmartPointer<vtkPoints> points;
  vtkSmartPointer<vtkDoubleArray> tensors;
  vtkSmartPointer<vtkFloatArray> linearity;

  Ellipsoids();

  void
  clear();
  /** \brief Adds that of \a tensor at a position; none if it is undefined. */
  void
  add(const Point& at, const PointDistributionTensor& tensor);
  /** \brief Shows what was added. */
  void
  done();
};

} // namespace linelet::view
