// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <string>
#include <vector>

#include <bench/geometries/geometries.h>
#include <bench/geometries/test_cloud.h>
#include <linelet/io/output_check.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

/** \brief ": a, b or c", the geometries there are. */
std::string
geometryNames()
{
  std::string names;
  for (const auto& entry : Names<bench::Geometry>::table)
    names += (names.empty() ? ": " : ", ") + std::string(entry.second);
  return names;
}

int
generateGeometry(const std::vector<std::string>& arguments)
{
  Frame frame(
      "generate",
      "Makes noisy samples of a known curve, for tests and measurements; or, "
      "as linelet generate corridor or linelet generate scene, which have options of "
      "their own (linelet generate scene --help), a scene with power lines.");
  bench::SamplingSettings settings;
  auto geometry = bench::Geometry::Circle;
  std::string truth;
  std::vector<double> hole;
  const OptionAdder add(frame.app);
  add.argument(
      "NAME", geometry, "the curve" + geometryNames() + "; or corridor; or scene");
  CloudOutput output(frame);
  add("truth", truth, "file for the true curves (.obj and others)");
  frame.writes(truth);
  frame.app
      .add_option(
          "--hole", hole, "no samples between these parts of the length, 0 to 1")
      ->delimiter(',')
      ->expected(2)
      ->type_name("A,B");
  addOptions(frame.app, settings);
  frame.parse(arguments);
  output.check();
  if (!truth.empty())
    io::checkCurvesOutput(truth);

  if (!hole.empty())
    settings.hole = {hole[0], hole[1]};
  io::Cloud cloud;
  cloud.points = bench::sample(geometry, settings, &frame.monitor);
  const CurveNetwork network = bench::truthOf(geometry, settings.out_of_plane);
  frame.lap("generate");
  output.write(cloud);
  if (!truth.empty())
    io::writeCurves(truth, network, Point::Zero(), {}, nullptr, &frame.monitor);

  std::printf("%s: %zu points of %s, length %.6g\n",
              output.path().c_str(),
              cloud.points.size(),
              std::string(nameOf(geometry)).c_str(),
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
  if (!arguments.empty() && arguments.front() == "scene")
    return runGenerateScene({arguments.begin() + 1, arguments.end()});
  return generateGeometry(arguments);
}

} // namespace linelet::apps
