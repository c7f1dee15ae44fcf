// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes as VTK reads them.

#include <filesystem>

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>

#include <linelet/io/file_error.h>
#include <linelet/io/mesh_file.h>

#include "file_helpers.h"

using namespace linelet;
using namespace linelet::test;

namespace {

TEST(MeshFile, FacesAndTheirCornersAreWhatVtkReads)
{
  const Folder folder;
  // Two triangles that share an edge, and a separate pentagon.
  std::vector<Face> faces(3);
  faces[0].corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
  faces[1].corners = {{1, 0, 0}, {1, 1, 1}, {0, 1, 0.5}};
  faces[2].corners = {{5, 0, 0}, {6, 0, 0}, {6.5, 1, 0}, {5.5, 2, 0}, {4.5, 1, 0}};
  const Point shift(1000, -2000, 64);
  io::writeMesh(folder.file("mesh.ply"), faces, shift);
  const vtkNew<vtkPLYReader> reader;
  reader->SetFileName(folder.file("mesh.ply").c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  EXPECT_EQ(mesh->GetNumberOfPoints(), 4 + 5) << "shared corners once";
  ASSERT_EQ(mesh->GetNumberOfPolys(), 3);
  for (vtkIdType k = 0; k < 3; ++k) {
    const Points& corners = faces[static_cast<std::size_t>(k)].corners;
    const vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(k, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), static_cast<vtkIdType>(corners.size()));
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      const Point at(mesh->GetPoint(ids->GetId(i)));
      // VTK keeps floats.
      EXPECT_LT((at - shift - corners[static_cast<std::size_t>(i)]).norm(), 1e-3);
    }
  }
}

TEST(MeshFile, AnEmptyMeshIsValidAndAWrongPathIsAnError)
{
  const Folder folder;
  io::writeMesh(folder.file("none.ply"), {}, Point::Zero());
  EXPECT_GT(std::filesystem::file_size(folder.file("none.ply")), 0u);
  EXPECT_THROW(io::writeMesh(folder.file("no/folder/mesh.ply"), {}, Point::Zero()),
               io::FileError);
}

} // namespace
