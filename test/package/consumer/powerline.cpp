// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/point_file.h>
#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline_output/output_files.h>

int
main()
{
  const linelet::io::Cloud cloud = linelet::io::readCloud(DATA "/corridor.las");
  const auto network = linelet::powerline::extractPowerLines(cloud, {});
  return network.wires.empty() ? 1 : 0;
}
