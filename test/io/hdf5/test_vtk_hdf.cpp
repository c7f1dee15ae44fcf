// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// VTKHDF as read by VTK itself.

#include <algorithm>
#include <string>

#include <vtkDataArray.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include "io/hdf5/hdf5_test.h"

using namespace linelet;
using namespace linelet::test;

TEST_F(Hdf5, VtkReadsPlacesAndAttributes)
{
  for (const std::size_t count : {1u, 3u, 50000u}) {
    SCOPED_TRACE(count);
    const Cloud cloud = example(count);
    const std::string path = folder.file("cloud.vtkhdf");
    writeCloud(path, cloud);
    const vtkNew<vtkHDFReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    auto* seen = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
    ASSERT_NE(seen, nullptr);
    ASSERT_EQ(seen->GetNumberOfPoints(), static_cast<vtkIdType>(count));
    for (std::size_t i = 0; i < count; i += count / 50 + 1) {
      const Point p = cloud.shift + cloud.points[i];
      const double* place = seen->GetPoint(static_cast<vtkIdType>(i));
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(place[axis], p[axis]) << i;
    }
    ASSERT_EQ(seen->GetPointData()->GetNumberOfArrays(),
              static_cast<int>(cloud.columns.size()));
    for (const Column& column : cloud.columns) {
      std::string name = column.name;
      std::replace(name.begin(), name.end(), '/', '_'); // a link has no slash
      auto* values = seen->GetPointData()->GetArray(name.c_str());
      ASSERT_NE(values, nullptr) << column.name;
      for (std::size_t i = 0; i < count; i += count / 50 + 1)
        EXPECT_EQ(values->GetTuple1(static_cast<vtkIdType>(i)), valueAt(column, i))
            << column.name << i;
    }
  }
}

TEST_F(Hdf5, VtkFilesAreWrittenWholeAndNotRead)
{
  const std::string path = folder.file("cloud.vtkhdf");
  writeCloud(path, example(0)); // an empty cloud is a file, too
  EXPECT_THROW(readCloud(path), FileError);
  EXPECT_THROW(writeCloud(folder.file("none/cloud.vtkhdf"), example(3)), FileError);
}
