// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fstream>

#include <linelet/io/point_file.h>

int
main()
{
  std::ofstream("three.pcd") << "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                                "COUNT 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\n"
                                "DATA ascii\n0 0 0\n1 0 0\n2 0 0\n";
  if (linelet::io::readCloud("three.pcd").points.size() != 3)
    return 1;
  // Without linelet::vector, the reference system of a file is kept as it is.
  if (linelet::io::readCloud(DATA "/corridor.las").wkt.empty())
    return 2;
  try {
    linelet::io::readCloud("missing.pcd");
    return 3;
  }
  catch (const linelet::io::FileError&) {
    return 0;
  }
}
