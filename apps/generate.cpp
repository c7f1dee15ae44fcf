// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <linelet/evaluation/geometries.h>
#include <linelet/evaluation/test_cloud.h>
#include <linelet/io/output_check.h>
#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

int
generateGeometry(const std::vector<std::string>& arguments)
{
  std::string names;
  for (const auto& entry : Names<evaluation::Geometry>::table)
    names += " " + std::string(entry.second);
  Frame frame("generate",
              "Noisy samples of a known curve, for tests and measurements. NAME is one "
              "of:" +
                  names +
                  "; or corridor, a scene with power lines, which has options of "
                  "its own (linelet generate corridor --help).");
  evaluation::SamplingSettings settings;
  std::string name, output, truth;
  std::vector<double> hole;
  frame.app.add_option("NAME", name, "what to generate")->required();
  frame.app.add_option("OUTPUT", output, "point file to write")->required();
  frame.app.add_option("--truth", truth, "file for the true curves (.obj and others)");
  frame.app
      .add_option("--hole", hole, "A,B: no samples between these parts of the length")
      ->delimiter(',')
      ->expected(2);
  addOptions(frame.app, settings);
  frame.parse(arguments);
  io::checkCloudOutput(output);
  if (!truth.empty())
    io::checkCurvesOutput(truth);

  const auto geometry = fromName<evaluation::Geometry>(name);
  if (!hole.empty())
    settings.hole = {hole[0], hole[1]};
  io::Cloud cloud;
  cloud.points = evaluation::sample(geometry, settings);
  const CurveNetwork network = evaluation::truthOf(geometry, settings.out_of_plane);
  std::vector<std::string> warnings;
  io::writeCloud(output, cloud, {}, &warnings, &frame.monitor);
  if (!truth.empty())
    io::writeCurves(truth, network);
  frame.warn(warnings);

  std::printf("%s: %zu points of %s, %zu curves of length %.6g\n",
              output.c_str(),
              cloud.points.size(),
              name.c_str(),
              network.curves.size(),
              length(network));
  frame.summary["points"] = cloud.points.size();
  frame.summary["curves"] = network.curves.size();
  frame.summary["length"] = length(network);
  return frame.finish();
}

} // namespace

int
runGenerate(const std::vector<std::string>& arguments)
{
  if (!arguments.empty() && arguments.front() == "corridor")
    return runGenerateCorridor({arguments.begin() + 1, arguments.end()});
  return generateGeometry(arguments);
}

} // namespace linelet::apps
