// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves in text formats, word for word.

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "io/vector/curve_example.h"

using namespace linelet;
using namespace linelet::test;

TEST(CurveFiles, ObjIsReadBackToTheLastBit)
{
  const Folder folder;
  const CurveNetwork before = example();
  writeCurves(folder.file("a.obj"), before);
  const CurveNetwork after = readCurves(folder.file("a.obj"));
  ASSERT_EQ(after.curves.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(after.curves[i].points, before.curves[i].points);
    EXPECT_EQ(after.curves[i].closed, before.curves[i].closed);
  }
}

TEST(CurveFiles, ObjMistakesAreNamedByLine)
{
  const Folder folder;
  for (const auto& [text, what] :
       std::map<std::string, std::string>{{"v 0 0 0\nl 1 2\n", "line 2: '2'"},
                                          {"v 0 0\n", "line 1"},
                                          {"v 0 0 0\nl 1\n", "two vertices"},
                                          {"v 0 0 0\nl 1 0\n", "line 2: '0'"}}) {
    writeBytes(folder.file("a.obj"), text);
    try {
      readCurves(folder.file("a.obj"));
      ADD_FAILURE() << text;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos)
          << error.what();
    }
  }
  writeBytes(folder.file("a.obj"), "v 0 0 0\nv 1 0 0\nl -2/1 -1/2\n");
  EXPECT_EQ(readCurves(folder.file("a.obj")).curves.at(0).points.size(), 2U);
}

TEST(CurveFiles, PlyHasEdgesBetweenVertices)
{
  const Folder folder;
  writeCurves(folder.file("a.ply"), example(), utm_shift);
  const std::string text = bytesOf(folder.file("a.ply"));
  EXPECT_NE(text.find("element vertex 7\n"), std::string::npos);
  EXPECT_NE(text.find("element edge 6\nproperty int vertex1\nproperty int vertex2\n"),
            std::string::npos);
  EXPECT_NE(text.find("\n6 3 1\n"), std::string::npos); // closes the second curve
  EXPECT_EQ(readCloud(folder.file("a.ply")).points.size(), 7U);
}

TEST(CurveFiles, VtkLinesCountWhatTheyHold)
{
  const Folder folder;
  writeCurves(folder.file("a.vtk"), example());
  const std::string text = bytesOf(folder.file("a.vtk"));
  // 3 vertices, and 4 with the first repeated, each after its count
  EXPECT_NE(text.find("LINES 2 10\n3 0 1 2\n5 3 4 5 6 3\n"), std::string::npos);
}

TEST(CurveFiles, CsvHasARowForEachVertex)
{
  const Folder folder;
  writeCurves(folder.file("a.csv"), example(), utm_shift);
  std::istringstream lines(bytesOf(folder.file("a.csv")));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);)
    rows.push_back(line);
  ASSERT_EQ(rows.size(), 8U);
  EXPECT_EQ(rows.front(),
            "curve,vertex,x,y,z,closed,length,front,back,noise,density,evidence");
  EXPECT_EQ(rows.back(), "1,3,689012,5527516,211,1,4,loop,loop,,,");
}

TEST(CurveFiles, UnknownEndingsAreRefused)
{
  EXPECT_THROW(writeCurves("a.abc", {}), FileError);
  EXPECT_THROW(writeLayers("a.shp", {}, {}), FileError);
  EXPECT_THROW(readCurves("a.ply"), FileError);
}
