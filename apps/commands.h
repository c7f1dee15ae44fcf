// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace linelet::apps {

/** \brief A command of the tool: gets the arguments behind its name, returns the exit
 * code; throws std::exception for what main reports in one line. */
struct Command {
  const char* name;
  const char* summary; ///< one line for `linelet --help`
  int (*run)(const std::vector<std::string>& arguments);
};

int
runInfo(const std::vector<std::string>& arguments);
int
runConvert(const std::vector<std::string>& arguments);
int
runTensor(const std::vector<std::string>& arguments);
int
runCluster(const std::vector<std::string>& arguments);
int
runMultiscale(const std::vector<std::string>& arguments);
int
runImage(const std::vector<std::string>& arguments);

/** \brief `generate corridor`: gets the arguments behind that name. */
int
runGenerateCorridor(const std::vector<std::string>& arguments);
/** \brief `generate scene`: gets the arguments behind that name. */
int
runGenerateScene(const std::vector<std::string>& arguments);

int
runCurves(const std::vector<std::string>& arguments);
int
runGenerate(const std::vector<std::string>& arguments);
int
runEvaluate(const std::vector<std::string>& arguments);
int
runBenchmark(const std::vector<std::string>& arguments);

int
runPowerlines(const std::vector<std::string>& arguments);

int
runPlan(const std::vector<std::string>& arguments);
int
runWork(const std::vector<std::string>& arguments);
int
runMerge(const std::vector<std::string>& arguments);
int
runStatus(const std::vector<std::string>& arguments);
int
runSchedule(const std::vector<std::string>& arguments);

int
runVpc(const std::vector<std::string>& arguments);

int
runDevices(const std::vector<std::string>& arguments);

/** \brief All commands, in the order of `linelet --help`. */
const std::vector<Command>&
commands();

} // namespace linelet::apps
