// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <sys/stat.h>

#include <gmock/gmock.h>

#include "run_tool.h"

using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

namespace {

const std::vector<std::string> all_commands = {"info",
                                               "convert",
                                               "tensor",
                                               "multiscale",
                                               "curves",
                                               "powerlines",
                                               "generate",
                                               "generate corridor",
                                               "generate scene",
                                               "evaluate",
                                               "benchmark",
                                               "image",
                                               "devices"};

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
    EXPECT_THAT(help.out, StartsWith("Usage: linelet " + command + " [OPTIONS]"));
    EXPECT_THAT(help.out, HasSubstr("\nEvery command:\n"));
    EXPECT_THAT(help.out, HasSubstr("  --threads N=0 "));
    EXPECT_EQ(help.error, "");
    std::istringstream text(help.out);
    for (std::string line; std::getline(text, line);)
      EXPECT_LE(line.size(), 80u) << line;
  }
  const std::string curves = runWell("curves --help").out;
  EXPECT_THAT(curves, HasSubstr("--preset NAME=refined"));
  // Options used by one preset only are listed under its name, after the general ones.
  EXPECT_LT(curves.find("--distance-cutoff X=0"), curves.find("\npublished:\n"));
  EXPECT_GT(curves.find("--branch-angle X=70"), curves.find("\npublished:\n"));
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
  EXPECT_EQ(run("generate oval out.xyz").code, 2);
}

TEST_F(Usage, TyposGetASuggestion)
{
  EXPECT_THAT(run("curvse in.xyz out.obj").error, HasSubstr("did you mean curves?"));
  // The value after it is not mistaken for a file.
  EXPECT_THAT(run("curves --distance-cutof 3 in.xyz out.obj").error,
              StartsWith("linelet curves: there is no option --distance-cutof, did you "
                         "mean --distance-cutoff?;"));
  // Nor does a missing argument hide it.
  EXPECT_THAT(run("curves --hlep").error, HasSubstr("did you mean --help?"));
  EXPECT_THAT(run("tensor in.xyz out.xyz --radus=3").error,
              HasSubstr("did you mean --radius?"));
  EXPECT_THAT(run("info in.xyz --frobnicate").error, Not(HasSubstr("did you mean")));
}

TEST_F(Usage, MessagesShowNumbersAsTheyWereGiven)
{
  const std::string cloud = path("circle.xyz");
  runWell("generate circle " + cloud);
  expectOneLineOf("curves " + cloud + " " + path("c.obj") + " --distance-cutoff -1",
                  "distance-cutoff is -1 ");
  expectOneLineOf("multiscale " + cloud + " " + path("m.las") + " --scale-unit -1e-9",
                  "scale unit -1e-09 ");
}

TEST_F(Usage, NoNumberOfThreadsIsTooLarge)
{
  const std::string cloud = path("helix.xyz");
  runWell("generate helix " + cloud + " --points 3000");
  for (const char* threads : {"99999", "4294967295"})
    runWell("tensor " + cloud + " " + path("shapes.las") + " --threads " + threads);
}

TEST_F(Usage, EverySummaryHasTimesAndWarnings)
{
  const std::string cloud = write("in.csv", "x,y,z,code\n0,0,0,1\n1,0,0,1\n2,0,0,2\n");
  runWell("convert " + cloud + " " + path("out.obj") + " --json " + path("out.json"));
  const auto summary = json(path("out.json"));
  EXPECT_GE(summary["seconds"]["read"], 0);
  EXPECT_GE(summary["seconds"]["write"], 0);
  ASSERT_EQ(summary["warnings"].size(), 1u); // the attribute that OBJ cannot hold
  EXPECT_THAT(summary["warnings"][0].get<std::string>(), HasSubstr("1 attribute"));
  runWell("devices --json " + path("out.json"));
  EXPECT_TRUE(json(path("out.json"))["warnings"].is_array());
}

TEST_F(Usage, AnInterruptedRunLeavesNoFiles)
{
  runWell("generate helix " + path("helix.xyz") + " --points 3000");
  // Through a pipe, which shows when the tool is ready for the signal.
  const std::string pipe = path("pipe.xyz"), error = path("ended");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const char* signal : {"INT", "TERM"}) {
    SCOPED_TRACE(signal);
    const std::string commands = std::string(LINELET_TOOL) + " multiscale " + pipe +
                                 " " + path("out.las") + " --graphs " +
                                 path("graphs.csv") + " 2> " + error + " & exec 3> " +
                                 pipe + "; kill -" + signal + " $!; cat " +
                                 path("helix.xyz") + " >&3; exec 3>&-; wait $!";
    EXPECT_EQ(WEXITSTATUS(std::system(commands.c_str())), 1);
    EXPECT_EQ(contents(error), "linelet multiscale: canceled\n");
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(path("")))
      left.push_back(entry.path().filename());
    EXPECT_THAT(
        left,
        UnorderedElementsAre("helix.xyz", "pipe.xyz", "ended", "stdout", "stderr"));
  }
}

TEST_F(Usage, MisuseIsReportedInOneLine)
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
  EXPECT_THAT(run("curves in.xyz out.obj --distance-cutoff far").error,
              HasSubstr("--distance-cutoff = far is not a valid number"));
  EXPECT_THAT(run("curves in.xyz out.obj --config " + wrong).error,
              StartsWith("linelet curves: " + wrong + ": "));
}

TEST_F(Usage, OptionsCanBePrintedBeforeThereAreFiles)
{
  for (const std::string& command : all_commands) {
    SCOPED_TRACE(command);
    EXPECT_THAT(runWell(command + " --print-config").out, HasSubstr("threads=0\n"));
  }
  // The option file then works for any input.
  write("options.ini", runWell("generate --points 33 --print-config").out);
  EXPECT_THAT(runWell("generate circle " + path("circle.xyz") + " --config " +
                      path("options.ini"))
                  .out,
              HasSubstr(" 33 points"));
}

TEST_F(Usage, OptionsOfAnotherPresetAreNotIgnoredSilently)
{
  runWell("generate circle " + path("in.xyz") + " --points 64");
  const std::string call = "curves " + path("in.xyz") + " " + path("out.obj");
  const Outcome ignored =
      runWell(call + " --step 0.4 --centroid mean --start-points 1");
  EXPECT_THAT(ignored.error, HasSubstr("--step has no effect"));
  EXPECT_THAT(ignored.error, HasSubstr("--centroid has no effect"));
  EXPECT_EQ(lines(ignored.error), 2) << ignored.error;
  EXPECT_EQ(runWell(call + " --step 0.4 --preset published").error, "");
  // An option file with every default ignores nothing that was requested.
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
      {"curves", "in.las out.obj --keep-classes 14,15 --preset published"},
      {"powerlines", "in.las out --max-gap 12.5"},
      {"generate", "helix out.xyz --hole 0.2,0.3 --seed 7"},
      {"generate corridor", "out.las"},
      {"generate scene", "quad out.las --noise 0.05"},
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

TEST_F(Usage, OptionsOfAFileAreObeyedAndUnknownOnesRefused)
{
  const std::string file = write("options.ini", "points=99\nseed=4\n");
  const std::string generate = "generate circle " + path("c.xyz") + " --config ";
  EXPECT_THAT(runWell(generate + file).out, HasSubstr(" 99 points"));
  // The command line overrides the file.
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
