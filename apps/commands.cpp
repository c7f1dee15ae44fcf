// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "commands.h"

namespace linelet::apps {

const std::vector<Command>&
commands()
{
  static const std::vector<Command> all = {
      {"info", "show what a point file contains", runInfo},
      {"convert", "convert between point file formats", runConvert},
      {"tensor", "measure the shape of every point's neighborhood", runTensor},
      {"multiscale", "measure it at many radii and find the best one", runMultiscale},
      {"cluster", "thin a cloud to representatives of grid cells", runCluster},
      {"curves", "reconstruct curves from a point cloud", runCurves},
      {"powerlines", "find every wire of an airborne or UAV scan", runPowerlines},
      {"generate",
       "make test clouds of known curves, corridors or scenes",
       runGenerate},
      {"evaluate", "compare curves with the true ones", runEvaluate},
      {"benchmark", "reconstruct thousands of noisy test geometries", runBenchmark},
      {"image",
       "draw the cloud, its shape along a line, or graphs of a point",
       runImage},
      {"vpc", "list point files in a virtual point cloud", runVpc},
      {"plan", "plan a command in fragments, for clouds larger than memory", runPlan},
      {"work", "work on the fragments of a plan", runWork},
      {"merge", "write the results of a plan", runMerge},
      {"status", "show the progress of a plan", runStatus},
      {"schedule",
       "simulate five heuristics that assign fragments to devices",
       runSchedule},
      {"devices", "list the OpenCL devices of this machine", runDevices},
  };
  return all;
}

} // namespace linelet::apps
