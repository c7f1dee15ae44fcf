// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <string>
#include <vector>

#include <bench/measures/measures.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

/** \brief The curves of a file; a warning where they are in degrees. */
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

} // namespace

int
runEvaluate(const std::vector<std::string>& arguments)
{
  Frame frame(
      "evaluate",
      "Tells how far reconstructed curves are from the true ones: largest distance "
      "(E_H), mean distance (E_V), length (E_Len) and covered length (E_Com) "
      "relative to the truth. The defaults suit curves of extent 10.");
  bench::MeasureSettings settings;
  std::string curves, truth;
  frame.app
      .add_option(
          "CURVES", curves, "reconstructed curves, in any format that linelet writes")
      ->required();
  frame.app.add_option("TRUTH", truth, "true curves, likewise")->required();
  frame.reads(curves);
  frame.reads(truth);
  addOptions(frame.app, settings);
  frame.parse(arguments);

  const CurveNetwork found = readLengths(curves, frame),
                     known = readLengths(truth, frame);
  const bench::Measures m = bench::measure(found, known, settings);
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
