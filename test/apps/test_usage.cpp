// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "run_tool.h"

using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

namespace {

const std::vector<std::string> all_commands = {"info",
                                               "convert",
                                               "tensor",
                                               "multiscale",
                                               "curves",
                                               "powerlines",
                                               "generate",
                                               "generate corridor",
                                               "evaluate",
                                               "benchmark",
                                               "devices",
                                               "image"};

class Usage : public ToolTest {};

} // namespace

TEST_F(Usage, HelpListsEveryCommand)
{
  const Outcome help = runWell("--help");
  for (const std::string& command : all_commands)
    EXPECT_THAT(help.out, HasSubstr("\n  " + command.substr(0, command.find(' '))));
  EXPECT_EQ(help.error, "");
  EXPECT_THAT(runWell("--version").out, MatchesRegex("linelet [0-9]+\\.[0-9.]+\n"));
}

TEST_F(Usage, EveryCommandExplainsItsOptionsAndDefaults)
{
  for (const std::string& command : all_commands) {
    SCOPED_TRACE(command);
    const Outcome help = runWell(command + " --help");
    EXPECT_THAT(help.out, HasSubstr("Usage: linelet " + command));
    EXPECT_THAT(help.out, HasSubstr("--threads UINT=0"));
    EXPECT_EQ(help.error, "");
  }
  EXPECT_THAT(runWell("curves --help").out, HasSubstr("--preset TEXT=refined"));
}

TEST_F(Usage, MisuseExitsWithTwo)
{
  const Outcome nothing = run("");
  EXPECT_EQ(nothing.code, 2);
  EXPECT_THAT(nothing.error, HasSubstr("linelet COMMAND"));
  const Outcome unknown = run("curve in.las out.obj");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.error, HasSubstr("no command 'curve'"));
  const std::string cloud = write("in.xyz", "1 2 3\n");
  const Outcome option = run("info " + cloud + " --frobnicate");
  EXPECT_EQ(option.code, 2);
  EXPECT_THAT(option.error, HasSubstr("--frobnicate"));
  EXPECT_EQ(run("benchmark --frobnicate").code, 2);
  for (const char* number : {"-4", "many", "1.5"})
    EXPECT_EQ(run("generate circle out.xyz --points " + std::string(number)).code, 2);
  EXPECT_EQ(run("info").code, 2);
  EXPECT_EQ(run("convert " + cloud).code, 2);
  EXPECT_EQ(run("curves " + cloud + " out.obj --preset newest").code, 2);
}

TEST_F(Usage, MisuseIsToldInOneLine)
{
  const std::string wrong = write("wrong.ini", "pionts=99\n");
  for (const char* call : {"curves",
                           "curves in.xyz out.obj --frobnicate",
                           "curves in.xyz out.obj --distance-cutoff far",
                           "curves in.xyz out.obj --preset newest"}) {
    const Outcome outcome = run(call);
    EXPECT_EQ(outcome.code, 2) << call;
    EXPECT_EQ(lines(outcome.error), 1) << outcome.error;
    EXPECT_THAT(outcome.error, StartsWith("linelet curves: "));
    EXPECT_THAT(outcome.error, HasSubstr("linelet curves --help"));
  }
  EXPECT_THAT(run("curves in.xyz out.obj --config " + wrong).error,
              StartsWith("linelet curves: " + wrong + ": "));
}

TEST_F(Usage, OptionsCanBePrintedBeforeThereAreFiles)
{
  for (const std::string& command : all_commands) {
    SCOPED_TRACE(command);
    EXPECT_THAT(runWell(command + " --print-config").out, HasSubstr("threads=0\n"));
  }
  // And serve any file afterwards.
  write("options.ini", runWell("generate --points 33 --print-config").out);
  EXPECT_THAT(runWell("generate circle " + path("circle.xyz") + " --config " +
                      path("options.ini"))
                  .out,
              HasSubstr(" 33 points"));
}

TEST_F(Usage, OptionsOfAnotherPresetAreNotIgnoredInSilence)
{
  runWell("generate circle " + path("in.xyz") + " --points 64");
  const std::string call = "curves " + path("in.xyz") + " " + path("out.obj");
  const Outcome ignored =
      runWell(call + " --step 0.4 --centroid mean --start-points 1");
  EXPECT_THAT(ignored.error, HasSubstr("--step has no effect"));
  EXPECT_THAT(ignored.error, HasSubstr("--centroid has no effect"));
  EXPECT_EQ(lines(ignored.error), 2) << ignored.error;
  EXPECT_EQ(runWell(call + " --step 0.4 --preset published").error, "");
  // An option file with every default ignores nothing that was asked for.
  write("options.ini", runWell(call + " --print-config").out);
  EXPECT_EQ(runWell(call + " --config " + path("options.ini")).error, "");
}

TEST_F(Usage, PrintedOptionsCanBeReadBack)
{
  const std::vector<std::pair<std::string, std::string>> calls = {
      {"info", "in.las --lenient"},
      {"tensor", "in.las out.las --radius 0.7 --weight step:0.5"},
      {"multiscale", "in.las out.las"},
      {"multiscale", "in.las out.las --radii 0.5,1,2.25"},
      {"curves", "in.las out.obj --classes 14,15 --preset published"},
      {"powerlines", "in.las out --max-gap 12.5"},
      {"generate", "helix out.xyz --hole 0.2,0.3 --seed 7"},
      {"generate corridor", "out.las"},
      {"evaluate", "found.obj truth.obj"},
      {"benchmark", "--sample 20"},
      {"benchmark", "--geometries circle,helix"},
      {"image", "in.las out.png --point 1,2,3 --title 'one, two'"}};
  for (const auto& [command, options] : calls) {
    SCOPED_TRACE(command + " " + options);
    const Outcome first = runWell(command + " " + options + " --print-config");
    const std::string file = write("options.ini", first.out);
    const Outcome second = runWell(command + " --config " + file + " --print-config");
    EXPECT_EQ(first.out, second.out);
  }
  const Outcome given = runWell("multiscale a.las b.las --radii 0.5,1 --print-config");
  EXPECT_THAT(given.out, HasSubstr("radii=[0.5, 1]"));
}

TEST_F(Usage, OptionsOfAFileAreObeyedAndMisspeltOnesRefused)
{
  const std::string file = write("options.ini", "points=99\nseed=4\n");
  const std::string generate = "generate circle " + path("c.xyz") + " --config ";
  EXPECT_THAT(runWell(generate + file).out, HasSubstr(" 99 points"));
  // The command line has the last word.
  EXPECT_THAT(runWell(generate + file + " --points 50").out, HasSubstr(" 50 points"));

  std::filesystem::remove(path("c.xyz"));
  const Outcome misspelt = run(generate + write("wrong.ini", "pionts=99\n"));
  EXPECT_EQ(misspelt.code, 2);
  EXPECT_THAT(misspelt.error, HasSubstr("pionts"));
  EXPECT_EQ(run(generate + path("none.ini")).code, 2);
  EXPECT_FALSE(std::filesystem::exists(path("c.xyz")));
}

TEST_F(Usage, AnOptionFileDrawsWhatItsCommandDraws)
{
  runWell("generate circle " + path("circle.xyz") + " --points 64");
  const std::string call = "image " + path("circle.xyz") + " " + path("direct.png") +
                           " --point 3 --width 300 --height 200";
  const std::string file = write("options.ini", runWell(call + " --print-config").out);
  EXPECT_THAT(runWell(call).out, HasSubstr("graphs"));
  const std::string direct = contents(path("direct.png"));
  std::filesystem::remove(path("direct.png"));
  EXPECT_THAT(runWell("image --config " + file).out, HasSubstr("graphs"));
  EXPECT_TRUE(direct == contents(path("direct.png")));
}

TEST_F(Usage, DevicesAreListed)
{
  runWell("devices --json " + path("devices.json"));
  EXPECT_TRUE(json(path("devices.json"))["devices"].is_array());
}
