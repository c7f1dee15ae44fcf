// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <linelet/support/points.h>

#include "picture/color.h"

namespace linelet::view {

/** \brief Polylines, each in its own color. */
struct Polylines {
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();
  vtkSmartPointer<vtkPoints> points;
  vtkSmartPointer<vtkCellArray> cells;
  vtkSmartPointer<vtkUnsignedCharArray> colors;

  /** \param[in] width in pixels */
  explicit Polylines(double width);

  void
  clear();
  void
  add(const Points& line, bool closed, const apps::Color& color);
  /** \brief Shows what was added. */
  void
  done();
};

} // namespace linelet::view
