// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "model/analysis_settings.h"

namespace {

using namespace linelet;
using namespace linelet::view;

const Parameter&
find(const std::vector<Parameter>& list, const std::string& name)
{
  for (const Parameter& p : list)
    if (p.name == name)
      return p;
  throw std::runtime_error("no parameter " + name);
}

class AnalysisSettingsTest : public testing::Test {
protected:
  AnalysisSettingsTest()
      : path((std::filesystem::temp_directory_path() /
              ("linelet_settings_" + std::to_string(getpid()) + ".toml"))
                 .string())
  {
  }
  ~AnalysisSettingsTest() override { std::filesystem::remove(path); }

  std::string path;
};

constexpr Analysis all[] = {
    Analysis::Tensor, Analysis::MultiScale, Analysis::Curves, Analysis::PowerLines};

// Every option has a meaning, and starts at its default.
TEST_F(AnalysisSettingsTest, EveryParameterIsDescribed)
{
  for (const Analysis analysis : all)
    for (const Parameter& p : AnalysisSettings().parameters(analysis)) {
      EXPECT_FALSE(p.meaning.empty()) << p.name;
      EXPECT_EQ(p.value, p.standard) << p.name;
    }
  const auto list = AnalysisSettings().parameters(Analysis::PowerLines);
  EXPECT_EQ(find(list, "max-gap").unit, "m");
  EXPECT_EQ(find(list, "max-gap").kind, Parameter::Kind::Number);
  const auto curves = AnalysisSettings().parameters(Analysis::Curves);
  EXPECT_EQ(find(curves, "branch-angle").heading, "published");
  EXPECT_EQ(find(curves, "preset").choices.size(), 3u);
}

// All digits of a number, lists, kernels with parameters, flags: what is written to a
// file is read back unchanged.
TEST_F(AnalysisSettingsTest, FilesKeepEverything)
{
  AnalysisSettings settings;
  settings.set(Analysis::MultiScale, "max-radius", "3.1415926535897931");
  settings.set(Analysis::MultiScale, "radii", "0.1,0.30000000000000004,2");
  settings.set(Analysis::MultiScale, "weight", "fermi-dirac:0.55,0.12");
  settings.set(Analysis::MultiScale, "centroid", "mean");
  settings.set(Analysis::MultiScale, "ignore-classes", "7,18,9");
  settings.set(Analysis::MultiScale, "lenient", "true");
  std::ofstream(path) << settings.config(Analysis::MultiScale);
  AnalysisSettings read;
  EXPECT_TRUE(read.loadConfig(Analysis::MultiScale, path).empty());
  EXPECT_EQ(read.scales.max_radius, 3.1415926535897931);
  EXPECT_EQ(read.scales.radii, (std::vector<double>{0.1, 0.30000000000000004, 2}));
  EXPECT_EQ(read.scales.weighting, Weighting::fermiDirac(0.55, 0.12));
  EXPECT_EQ(read.scales.centroid, Centroid::Mean);
  EXPECT_TRUE(read.read.lenient);
  EXPECT_EQ(read.config(Analysis::MultiScale), settings.config(Analysis::MultiScale));
}

TEST_F(AnalysisSettingsTest, EveryAnalysisSurvivesAFile)
{
  for (const Analysis analysis : all) {
    const AnalysisSettings settings;
    std::ofstream(path) << settings.config(analysis);
    AnalysisSettings read;
    EXPECT_NO_THROW(read.loadConfig(analysis, path)) << nameOf(analysis);
    EXPECT_EQ(read.config(analysis), settings.config(analysis));
  }
}

// A list can be emptied and a flag turned off.
TEST_F(AnalysisSettingsTest, ValuesCanBeTakenBack)
{
  AnalysisSettings settings;
  settings.set(Analysis::MultiScale, "radii", "1,2");
  settings.set(Analysis::MultiScale, "radii", "");
  EXPECT_TRUE(settings.scales.radii.empty());
  settings.set(Analysis::PowerLines, "use-classes", "true");
  settings.set(Analysis::PowerLines, "use-classes", "false");
  EXPECT_FALSE(settings.wires.use_classes);
}

// An error is reported and changes nothing.
TEST_F(AnalysisSettingsTest, WrongTextsAreRefused)
{
  AnalysisSettings settings;
  const std::string before = settings.config(Analysis::Curves);
  for (const auto& [name, text] : {std::pair("step", "wide"),
                                   std::pair("step", "-1"),
                                   std::pair("start-points", "-3"),
                                   std::pair("scheme", "euler!"),
                                   std::pair("weight", "fermi-dirac:1,-1"),
                                   std::pair("no-such-option", "1")})
    EXPECT_THROW(settings.set(Analysis::Curves, name, text), std::invalid_argument)
        << name << " " << text;
  EXPECT_EQ(settings.config(Analysis::Curves), before);
  EXPECT_THROW(settings.loadConfig(Analysis::Curves, path + ".missing"),
               std::invalid_argument);
}

TEST_F(AnalysisSettingsTest, CommandLineSaysWhatDiffers)
{
  AnalysisSettings settings;
  EXPECT_EQ(settings.commandLine(Analysis::Curves, {"a.las"}, "b.gpkg"),
            "linelet curves a.las b.gpkg");
  settings.set(Analysis::Curves, "preset", "published");
  settings.set(Analysis::Curves, "step", "0.25");
  EXPECT_EQ(settings.commandLine(Analysis::Curves, {"it's here.las"}, "b.gpkg"),
            "linelet curves --preset=published --step=0.25 'it'\\''s here.las' b.gpkg");
}

} // namespace
