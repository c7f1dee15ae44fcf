// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <chrono>
#include <cstdlib>
#include <set>
#include <sstream>
#include <thread>

#include <csignal>
#include <QImage>
#include <sys/wait.h>

#include "model_test.h"

namespace {

using namespace linelet;
using namespace linelet::view;

/** The window on its own offscreen display. */
class ViewWindow : public linelet::test::ModelTest {
protected:
  void
  SetUp() override
  {
    if (std::system("command -v Xvfb > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "no Xvfb, which would be the display";
    const std::string start = "Xvfb -displayfd 1 -screen 0 1600x1000x24 > " +
                              path("display") + " 2> /dev/null & echo $! > " +
                              path("server");
    ASSERT_EQ(std::system(start.c_str()), 0);
    server_ = std::stoi(contents("server"));
    while (contents("display").find('\n') == std::string::npos)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    display_ = ":" + contents("display");
    display_.pop_back();
    setenv("DISPLAY", display_.c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("XDG_RUNTIME_DIR", path("").c_str(), 1);
  }

  void
  TearDown() override
  {
    if (server_ > 0)
      kill(server_, SIGTERM);
  }

  std::string
  contents(const std::string& name) const
  {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

  /** Runs the viewer, with its output in said.txt. \return the exit code */
  int
  view(const std::string& arguments) const
  {
    const std::string command = "timeout 200 " + std::string(LINELET_VIEW) + " " +
                                arguments + " > " + path("said.txt") + " 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  nlohmann::json
  json(const std::string& name) const
  {
    return nlohmann::json::parse(contents(name));
  }

  /** The number of colors in the view of the cloud. */
  std::size_t
  colorsOf(const std::string& name, const nlohmann::json& state) const
  {
    const QImage image(QString::fromStdString(path(name)));
    EXPECT_FALSE(image.isNull());
    std::set<QRgb> colors;
    const auto& box = state["view"];
    for (int x = 0; x < box[2].get<int>(); ++x)
      for (int y = 0; y < box[3].get<int>(); ++y)
        colors.insert(image.pixel(box[0].get<int>() + x, box[1].get<int>() + y));
    return colors.size();
  }

  int server_ = 0;
  std::string display_;
};

TEST_F(ViewWindow, ScriptDoesWhatHandsDo)
{
  const std::string wire = writeWire();
  write("steps.txt",
        "# a wire\nopen " + wire + "\nset tensor radius 0.8\ncompute tensor\n" +
            "compute multiscale\nset multiscale max-radius 4\npoint 300\nnear 5\n" +
            "dump " + path("one.json") + "\nshot " + path("one.png") +
            "\nsave-options tensor " + path("tensor.toml") +
            "\ndeselect\nclick-point 300\npanel kernel\n");
  ASSERT_EQ(view("--script " + path("steps.txt") + " --shot " + path("two.png") +
                 " --dump " + path("two.json")),
            0)
      << contents("said.txt");
  const auto one = json("one.json"), two = json("two.json");
  EXPECT_EQ(one["points"], 2000);
  EXPECT_EQ(one["color"], "multiscale.shape");
  EXPECT_EQ(one["stale"], nlohmann::json::array({"multiscale"}));
  EXPECT_EQ(one["selection"]["point"], 300);
  EXPECT_EQ(one["selection"]["tensor"]["radius"], 0.8);
  // A click on a visible point selects it, or one in front of it.
  ASSERT_FALSE(two["selection"].is_null());
  const auto at = two["selection"]["at"];
  EXPECT_NEAR(at[0].get<double>(), one["selection"]["at"][0].get<double>(), 0.2);
  EXPECT_NEAR(at[2].get<double>(), 56, 0.2);
  EXPECT_EQ(two["panel"], "kernel_panel");
  // The same numbers as without a window.
  open(wire);
  model.settings.set(Analysis::MultiScale, "max-radius", "4");
  model.select(300);
  model.wait();
  const auto expected = nlohmann::json::parse(model.state().dump());
  EXPECT_EQ(one["selection"]["graphs"], expected["selection"]["graphs"]);
  model.settings.loadConfig(Analysis::Tensor, path("tensor.toml"));
  EXPECT_EQ(model.settings.tensor.radius, 0.8);
  // There is something to see.
  EXPECT_GT(colorsOf("one.png", one), 30u);
}

TEST_F(ViewWindow, RealClickSelectsThePointInTheMiddle)
{
  if (std::system("command -v xdotool > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "no xdotool, which would click";
  write("steps.txt",
        "open " + writeWire() + "\npoint 300\nnear 5\ndump " + path("before.json") +
            "\ndeselect\ndump " + path("ready.json") + "\nawait-click\n");
  int code = -1;
  std::thread window([&] {
    code = view("--script " + path("steps.txt") + " --dump " + path("after.json"));
  });
  for (int tries = 0; tries < 6000 && contents("ready.json").empty(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(contents("ready.json").empty());
  if (!contents("ready.json").empty()) {
    const auto ready = json("ready.json");
    EXPECT_TRUE(ready["selection"].is_null());
    const auto& box = ready["view"];
    const std::string click =
        "id=$(xdotool search --sync --onlyvisible --name '^linelet-view$' | head -1); "
        "xdotool mousemove --window $id " +
        std::to_string(box[0].get<int>() + box[2].get<int>() / 2) + " " +
        std::to_string(box[1].get<int>() + box[3].get<int>() / 2) + " click 1";
    EXPECT_EQ(std::system(click.c_str()), 0);
  }
  window.join();
  EXPECT_EQ(code, 0) << contents("said.txt");
  const auto before = json("before.json")["selection"]["at"],
             after = json("after.json")["selection"]["at"];
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(before[axis].get<double>(), after[axis].get<double>(), 0.2);
}

// A sentence and an exit code, not a crash.
TEST_F(ViewWindow, OddFilesAreReported)
{
  const std::string wire = writeWire();
  std::ostringstream bytes;
  bytes << std::ifstream(wire, std::ios::binary).rdbuf();
  for (const std::string& bad :
       {write("cut.las", bytes.str().substr(0, 20000)), write("empty.las", "")}) {
    EXPECT_EQ(view(bad + " --dump " + path("bad.json")), 1);
    const std::string said = contents("said.txt");
    EXPECT_NE(said.find(std::filesystem::path(bad).filename().string()),
              std::string::npos)
        << said;
  }
  write("one.xyz", "1 2 3\n");
  write("steps.txt",
        "open " + path("one.xyz") + "\ncolor height\nlook 10 20\nshot " +
            path("one.png") + "\n");
  EXPECT_EQ(view("--script " + path("steps.txt") + " --dump " + path("one.json")), 0)
      << contents("said.txt");
  EXPECT_EQ(json("one.json")["points"], 1);
  write("steps.txt", "open " + wire + "\nset tensor radius wide\n");
  EXPECT_EQ(view("--script " + path("steps.txt")), 1);
  EXPECT_NE(contents("said.txt").find("steps.txt, line 2"), std::string::npos);
}

} // namespace
