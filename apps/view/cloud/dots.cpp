// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "dots.h"

#include <algorithm>
#include <utility>

#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace linelet::view {

template <class T>
using Ptr = vtkSmartPointer<T>;

Dots::Dots()
{
  const auto mapper = Ptr<vtkPointGaussianMapper>::New();
  mapper->SetInputData(data);
  mapper->SetScaleFactor(0); // dots of the actor's size in pixels
  mapper->EmissiveOff();
  mapper->SetScalarModeToUsePointData();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
}

void
Dots::place(const Points& points, Indices chosen)
{
  indices = std::move(chosen);
  indices.erase(std::remove_if(indices.begin(),
                               indices.end(),
                               [&](Index i) { return !points[i].allFinite(); }),
                indices.end());
  const auto coordinates = Ptr<vtkFloatArray>::New();
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(indices.size()));
  float* to = coordinates->GetPointer(0);
  for (const Index i : indices)
    for (int axis = 0; axis < 3; ++axis)
      *to++ = static_cast<float>(points[i][axis]);
  const auto vtk_points = Ptr<vtkPoints>::New();
  vtk_points->SetData(coordinates);
  data->SetPoints(vtk_points);
  data->GetPointData()->SetScalars(nullptr);
}

void
Dots::color(const std::vector<std::uint8_t>& rgb)
{
  const auto colors = Ptr<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(indices.size()));
  unsigned char* to = colors->GetPointer(0);
  for (const Index i : indices)
    for (std::size_t c = 0; c < 3; ++c)
      *to++ = rgb[3 * static_cast<std::size_t>(i) + c];
  data->GetPointData()->SetScalars(colors);
  data->Modified();
}

} // namespace linelet::view
