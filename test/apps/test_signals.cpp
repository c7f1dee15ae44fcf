// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// When told to stop, the tool stops, whatever it is doing, and leaves nothing
// half-done.

#include <chrono>
#include <csignal>
#include <random>
#include <set>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>

#include <linelet/io/point_file.h>

#include "run_tool.h"

namespace linelet::test {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

class Signals : public ToolTest {
protected:
  /** \brief A cloud that keeps every command busy for longer than any test waits. */
  std::string
  bigCloud() const
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> plan(0, 400), height(0, 20);
    io::Cloud cloud;
    for (int i = 0; i < 250000; ++i)
      cloud.points.emplace_back(plan(random), plan(random), height(random));
    io::writeCloud(path("big.las"), cloud);
    return path("big.las");
  }

  /** \brief A mesh of noisy lines, which takes a long time to disentangle. */
  std::string
  net() const
  {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> along(0, 400);
    std::normal_distribution<double> noise(0, 0.2);
    io::Cloud cloud;
    for (int i = 0; i < 250000; ++i) {
      const double u = along(random), v = 4 * (i % 100);
      cloud.points.emplace_back((i % 2 == 0 ? u : v) + noise(random),
                                (i % 2 == 0 ? v : u) + noise(random),
                                noise(random));
    }
    io::writeCloud(path("net.las"), cloud);
    return path("net.las");
  }

  /** \brief A pipe that never delivers anything. */
  std::string
  pipe(const std::string& name) const
  {
    EXPECT_EQ(mkfifo(path(name).c_str(), 0600), 0);
    return path(name);
  }

  std::set<std::string>
  files() const
  {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("")))
      if (!entry.is_directory())
        names.insert(entry.path().lexically_relative(path("")));
    return names;
  }

  pid_t
  start(const std::vector<std::string>& arguments) const
  {
    const pid_t child = fork();
    if (child != 0)
      return child;
    const int out = open(path("said").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    std::vector<char*> words;
    const std::string tool = LINELET_TOOL;
    words.push_back(const_cast<char*>(tool.c_str()));
    for (const std::string& word : arguments)
      words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execv(tool.c_str(), words.data());
    _exit(127);
  }

  /** \brief Sends \a signal to the command once it has worked for a while.
   * \param[in] kept files that it may leave */
  void
  expectEnds(const std::vector<std::string>& arguments,
             int signal,
             const std::set<std::string>& kept = {})
  {
    std::string trace;
    for (const std::string& word : arguments)
      trace += word + " ";
    SCOPED_TRACE(trace + "signal " + std::to_string(signal));
    write("said", "");
    std::set<std::string> expected = files();
    const pid_t child = start(arguments);
    std::this_thread::sleep_for(milliseconds(600));
    int status = 0;
    if (waitpid(child, &status, WNOHANG) != 0) {
      ADD_FAILURE() << "ended before it was told to: " << contents(path("said"));
      return;
    }
    kill(child, signal);
    const Clock::time_point told = Clock::now();
    constexpr milliseconds most(4000); // 2000 are promised, but machines are busy
    while (waitpid(child, &status, WNOHANG) == 0) {
      if (Clock::now() - told > most) {
        ADD_FAILURE() << "does not end";
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        return;
      }
      std::this_thread::sleep_for(milliseconds(10));
    }
    EXPECT_TRUE(WIFEXITED(status)) << "killed by the signal itself";
    EXPECT_EQ(WEXITSTATUS(status), 1) << contents(path("said"));
    EXPECT_NE(contents(path("said")).find("canceled"), std::string::npos);
    std::set<std::string> left = files();
    for (const std::string& name : kept) {
      left.erase(name);
      expected.erase(name);
    }
    EXPECT_EQ(left, expected);
  }

  void
  expectEndsByBoth(const std::vector<std::string>& arguments,
                   const std::set<std::string>& kept = {})
  {
    for (const int signal : {SIGINT, SIGTERM})
      expectEnds(arguments, signal, kept);
  }
};

} // namespace

TEST_F(Signals, EndReading)
{
  const std::string points = pipe("pipe.xyz"), curves = pipe("pipe.obj");
  // The other ends stay open, so that reading blocks.
  const int first = open(points.c_str(), O_RDWR), second = open(curves.c_str(), O_RDWR);
  expectEndsByBoth({"info", points});
  expectEndsByBoth({"convert", points, path("out.las")});
  expectEndsByBoth({"evaluate", curves, curves});
  close(first);
  close(second);
}

TEST_F(Signals, EndTensors)
{
  const std::string cloud = bigCloud(), out = path("out.las");
  for (const std::string engine : {"grid", "tree"})
    expectEndsByBoth({"tensor", cloud, out, "--radius", "1000", "--engine", engine});
  expectEnds({"tensor", cloud, out, "--knn", "200000"}, SIGTERM);
  expectEnds({"tensor", cloud, out, "--radius", "100", "--centroid", "median"}, SIGINT);
  if (run("devices").out.find("compute units") != std::string::npos)
    expectEnds({"tensor", cloud, out, "--radius", "1000", "--engine", "opencl"},
               SIGTERM);
}

TEST_F(Signals, EndMultiScaleShapes)
{
  const std::string cloud = bigCloud();
  expectEndsByBoth({"multiscale",
                    cloud,
                    path("out.las"),
                    "--max-radius",
                    "100",
                    "--graphs",
                    path("graphs.csv")});
  expectEndsByBoth({"image", cloud, path("out.png"), "--max-radius", "100"});
  expectEnds({"image",
              cloud,
              path("out.png"),
              "--max-radius",
              "1000",
              "--columns",
              "5000",
              "--probe",
              "0,0,0,100,100,0"},
             SIGTERM);
}

TEST_F(Signals, EndCurves)
{
  const std::string cloud = net();
  expectEndsByBoth({"curves", cloud, path("out.gpkg")});
  expectEndsByBoth({"curves", cloud, path("out.obj"), "--preset", "published"});
  expectEndsByBoth({"benchmark", "--sample", "20000", "--out", path("rows.csv")},
                   {"rows.csv"});
}

TEST_F(Signals, EndScenes)
{
  const std::string out = path("out.las");
  expectEndsByBoth({"generate",
                    "corridor",
                    out,
                    "--length",
                    "20000",
                    "--density",
                    "50",
                    "--truth",
                    path("truth.gpkg")});
  expectEnds({"generate", "helix", path("out.csv"), "--points", "6000000"}, SIGTERM);
  runWell("generate corridor " + path("scene.las") + " --length 3000");
  expectEndsByBoth({"powerlines", path("scene.las"), path("folder")});
}

// If the reader of a pipe is gone, the tool must not die and leave files.
TEST_F(Signals, AClosedPipeIsAnErrorOfWriting)
{
  const std::string cloud = write("in.xyz", "0 0 0\n1 0 0\n2 0 0\n");
  const std::string command = std::string(LINELET_TOOL) + " info " + cloud +
                              " | true; " + LINELET_TOOL + " convert " + cloud + " " +
                              path("out.las");
  EXPECT_EQ(std::system((command + " > " + path("stdout")).c_str()), 0);
  EXPECT_TRUE(std::filesystem::exists(path("out.las")));
}

// As `ulimit -f` in a shell.
TEST_F(Signals, AFileBeyondTheSizeLimitIsOneSentence)
{
  const std::string cloud = bigCloud();
  const std::set<std::string> before = files();
  const std::string command = std::string("ulimit -f 100; exec ") + LINELET_TOOL +
                              " convert " + cloud + " " + path("out.las") + " 2> " +
                              path("said");
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_EQ(lines(contents(path("said"))), 1) << contents(path("said"));
  std::set<std::string> left = files();
  left.erase("said");
  EXPECT_EQ(left, before);
}

} // namespace linelet::test
