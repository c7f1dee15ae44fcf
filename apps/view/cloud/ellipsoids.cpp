// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ellipsoids.h"

#include <cmath>

#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>

#include <linelet/tensor/eigen_analysis.h>

#include "picture/color.h"

namespace linelet::view {

template <class T>
using Ptr = vtkSmartPointer<T>;

Ellipsoids::Ellipsoids()
{
  const auto sphere = Ptr<vtkSphereSource>::New();
  sphere->SetRadius(1);
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(14);
  glyph->SetInputData(data);
  glyph->SetSourceConnection(sphere->GetOutputPort());
  glyph->ExtractEigenvaluesOn();
  glyph->ColorGlyphsOn();
  glyph->SetColorModeToScalars();
  const auto mapper = Ptr<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(glyph->GetOutputPort());
  mapper->SetScalarRange(0, 1);
  const auto table = Ptr<vtkLookupTable>::New();
  table->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i) {
    const apps::Color c = apps::scalarColor(i / 255.0);
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  mapper->SetLookupTable(table);
  actor->SetMapper(mapper);
  clear();
}

void
Ellipsoids::clear()
{
  points = Ptr<vtkPoints>::New();
  tensors = Ptr<vtkDoubleArray>::New();
  tensors->SetNumberOfComponents(9);
  linearity = Ptr<vtkFloatArray>::New();
}

void
Ellipsoids::add(const Point& at, const PointDistributionTensor& t)
{
  if (std::isnan(t.linearity))
    return;
  const EigenSystem system = eigenAnalysis({t.xx, t.xy, t.xz, t.yy, t.yz, t.zz});
  // A floor, so that a flat ellipsoid still has a surface to light.
  const Eigen::Vector3d axes =
      system.values.cwiseMax(1e-4 * system.values[2]).cwiseSqrt();
  const Eigen::Matrix3d root =
      system.vectors * axes.asDiagonal() * system.vectors.transpose();
  points->InsertNextPoint(at.x(), at.y(), at.z());
  tensors->InsertNextTuple(root.data());
  linearity->InsertNextValue(t.linearity);
}

void
Ellipsoids::done()
{
  data->SetPoints(points);
  data->GetPointData()->SetTensors(tensors);
  data->GetPointData()->SetScalars(linearity);
  data->Modified();
  actor->SetVisibility(points->GetNumberOfPoints() > 0 ? 1 : 0);
}

} // namespace linelet::view
