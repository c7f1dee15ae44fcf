// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/mesh_file.h>

#include <array>
#include <cstdint>
#include <map>

#include <linelet/io/output_file.h>

#include "io/source.h"

namespace linelet::io {

namespace {

template <class T>
void
append(std::string& bytes, T value)
{
  const std::size_t place = bytes.size();
  bytes.resize(place + sizeof(T));
  store(bytes.data() + place, value);
}

} // namespace

void
writeMesh(const std::string& path, const std::vector<Face>& faces, const Point& shift)
{
  std::map<std::array<double, 3>, std::int32_t> numbers;
  std::string vertices, rows;
  for (const Face& face : faces) {
    append(rows, static_cast<std::uint8_t>(face.corners.size()));
    for (const Point& corner : face.corners) {
      const auto [known, fresh] =
          numbers.try_emplace({corner.x(), corner.y(), corner.z()},
                              static_cast<std::int32_t>(numbers.size()));
      append(rows, known->second);
      for (Eigen::Index a = 0; fresh && a < 3; ++a)
        append(vertices, shift[a] + corner[a]);
    }
    for (Eigen::Index a = 0; a < 3; ++a)
      append(rows, static_cast<float>(face.normal[a]));
    append(rows, static_cast<std::int32_t>(face.part));
  }
  OutputFile file(path);
  file.write("ply\nformat binary_little_endian 1.0\nelement vertex " +
             std::to_string(numbers.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\n"
             "element face " +
             std::to_string(faces.size()) +
             "\nproperty list uchar int vertex_indices\nproperty float nx\n"
             "property float ny\nproperty float nz\nproperty int part\nend_header\n");
  file.write(vertices);
  file.write(rows);
  file.commit();
}

} // namespace linelet::io
