// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <bench/measures/measures.h>
#include <bench/measures/vertex_errors.h>
#include <CLI/CLI.hpp>

#include <linelet/io/output_file.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

/** \brief The curves of a file, with a warning if they are in degrees. */
CurveNetwork
readLengths(const std::string& path, Frame& frame)
{
  io::Cloud cloud; // of the vertices
  CurveNetwork network = io::readCurves(path, Point::Zero(), &cloud.wkt);
  for (const Curve& curve : network.curves)
    cloud.points.insert(cloud.points.end(), curve.points.begin(), curve.points.end());
  warnOfDegrees(cloud, path, frame);
  return network;
}

/** \brief One row per vertex of \a found; curves count from 1. */
void
writeVertexErrors(const std::string& path,
                  const CurveNetwork& found,
                  const CurveNetwork& truth)
{
  io::OutputFile file(path);
  file.write("curve,vertex,x,y,z,along,distance,angle\n");
  const bench::SegmentTree tree(truth);
  char row[256];
  for (std::size_t c = 0; c < found.curves.size(); ++c) {
    const auto errors = bench::vertexErrors(found.curves[c], tree);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const Point& p = found.curves[c].points[i];
      std::snprintf(row,
                    sizeof(row),
                    "%zu,%zu,%.10g,%.10g,%.10g,%.9g,%.9g,",
                    c + 1,
                    i,
                    p.x(),
                    p.y(),
                    p.z(),
                    errors[i].along,
                    errors[i].distance);
      file.write(row);
      // Readers interpret an empty cell as NaN.
      std::snprintf(row, sizeof(row), "%.7g\n", errors[i].angle);
      file.write(std::isnan(errors[i].angle) ? "\n" : row);
    }
  }
  file.commit();
}

} // namespace

int
runEvaluate(const std::vector<std::string>& arguments)
{
  Frame frame(
      "evaluate",
      "Measures how far reconstructed curves are from the true ones: largest distance "
      "(E_H), mean distance (E_V), length (E_Len) and covered length (E_Com) "
      "relative to the truth. The defaults suit curves of extent 10.");
  bench::MeasureSettings settings;
  std::string curves, truth, vertex_errors;
  frame.addArgument(
      "CURVES", curves, "reconstructed curves, in any format that linelet writes");
  frame.addArgument("TRUTH", truth, "true curves, likewise");
  frame.app.add_option("--vertex-errors",
                       vertex_errors,
                       "CSV file of the distance from the truth and the angle between "
                       "tangents (degrees) at every vertex");
  frame.writes(vertex_errors);
  frame.reads(curves);
  frame.reads(truth);
  addOptions(frame.app, settings);
  frame.parse(arguments);

  const CurveNetwork found = readLengths(curves, frame),
                     known = readLengths(truth, frame);
  const bench::Measures m = bench::measure(found, known, settings);
  if (!vertex_errors.empty())
    writeVertexErrors(vertex_errors, found, known);
  std::printf("E_H %.6g\nE_V %.6g\nE_Len %.6g\nE_Com %.6g\n%s\n",
              m.e_h,
              m.e_v,
              m.e_len,
              m.e_com,
              m.success ? "success" : "no success");
  frame.summary["e_h"] = m.e_h;
  frame.summary["e_v"] = m.e_v;
  frame.summary["e_len"] = m.e_len;
  frame.summary["e_com"] = m.e_com;
  frame.summary["success"] = m.success;
  return frame.finish();
}

} // namespace linelet::apps
