// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <bench/geometries/geometries.h>
#include <bench/geometries/test_cloud.h>
#include <CLI/CLI.hpp>

#include <linelet/io/output_check.h>
#include <linelet/io/vector_file.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

/** \brief ": a, b or c", the names of all geometries. */
std::string
geometryNames()
{
  std::string names;
  for (const auto& entry : Names<bench::Geometry>::table)
    names += (names.empty() ? ": " : ", ") + std::string(entry.second);
  return names;
}

std::optional<bench::Geometry>
geometryCalled(const std::string& name)
{
  for (const auto& [geometry, known] : Names<bench::Geometry>::table)
    if (name == known)
      return geometry;
  return {};
}

/** \brief The curves of a built-in geometry, or of a file. */
CurveNetwork
curvesCalled(const std::string& name, double out_of_plane, Frame& frame)
{
  if (const auto geometry = geometryCalled(name))
    return bench::truthOf(*geometry, out_of_plane);
  const CurveNetwork network = io::readCurves(name);
  if (!(length(network) > 0))
    throw std::runtime_error(name + ": there are no curves in it to sample");
  frame.summary["curves_from"] = name;
  return bench::bentOutOfPlane(network, out_of_plane);
}

int
generateGeometry(const std::vector<std::string>& arguments)
{
  Frame frame(
      "generate",
      "Makes noisy samples of a known curve, for tests and measurements. linelet "
      "generate corridor and linelet generate scene make scenes with power lines; they "
      "have their own options (linelet generate scene --help).");
  bench::SamplingSettings settings;
  std::string name, truth;
  std::vector<double> hole;
  const OptionAdder add(frame.app);
  frame.app
      .add_option("NAME",
                  name,
                  "the curve" + geometryNames() +
                      "; a file of curves (.obj and others); corridor; or scene")
      ->required()
      ->check([](const std::string& text) {
        return geometryCalled(text) || text.find('.') != std::string::npos
                   ? std::string()
                   : "there is no geometry '" + text + "'; there are" +
                         geometryNames().substr(1) + ", or name a file of curves";
      });
  frame.reads(name);
  CloudOutput output(frame, CloudOutput::Inputs::None);
  add("truth", truth, "file for the true curves (.obj and others)");
  frame.writes(truth);
  frame.app
      .add_option(
          "--hole", hole, "no samples between these fractions of the length, 0 to 1")
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
  const CurveNetwork network = curvesCalled(name, settings.out_of_plane, frame);
  const auto geometry = geometryCalled(name);
  io::Cloud cloud;
  cloud.points = geometry ? bench::sample(*geometry, settings, &frame.monitor)
                          : bench::sample(network, settings, &frame.monitor);
  frame.lap("generate");
  output.write(cloud);
  if (!truth.empty())
    io::writeCurves(truth, network, Point::Zero(), {}, nullptr, &frame.monitor);

  std::printf("%s: %zu points of %s, length %.6g\n",
              output.path().c_str(),
              cloud.points.size(),
              name.c_str(),
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
