// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "polylines.h"

#include <vtkCellData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace linelet::view {

template <class T>
using Ptr = vtkSmartPointer<T>;

Polylines::Polylines(double width)
{
  const auto mapper = Ptr<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  mapper->SetScalarModeToUseCellData();
  // In front of nearby points.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -200);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  clear();
}

void
Polylines::clear()
{
  points = Ptr<vtkPoints>::New();
  points->SetDataTypeToDouble();
  cells = Ptr<vtkCellArray>::New();
  colors = Ptr<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
}

void
Polylines::add(const Points& line, bool closed, const apps::Color& color)
{
  if (line.size() < 2)
    return;
  cells->InsertNextCell(static_cast<int>(line.size() + (closed ? 1 : 0)));
  const vtkIdType first = points->GetNumberOfPoints();
  for (const Point& p : line)
    cells->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), p.z()));
  if (closed)
    cells->InsertCellPoint(first);
  colors->InsertNextTuple3(255 * color[0], 255 * color[1], 255 * color[2]);
}

void
Polylines::done()
{
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetCellData()->SetScalars(colors);
  data->Modified();
}

} // namespace linelet::view
