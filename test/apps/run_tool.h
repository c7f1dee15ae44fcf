// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace linelet::test {

/** \brief The outcome of a run of the tool. */
struct Outcome {
  int code = -1;
  std::string out, error;
};

/** \brief A test that runs the tool as a user would, in its own folder. */
class ToolTest : public testing::Test {
protected:
  ToolTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("linelet_tool_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder_);
  }
  ~ToolTest() override { std::filesystem::remove_all(folder_); }

  std::string
  path(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  static std::string
  contents(const std::string& file)
  {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
  }

  /** \brief Writes a file into the folder. \return its path */
  std::string
  write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  static nlohmann::json
  json(const std::string& file)
  {
    return nlohmann::json::parse(contents(file));
  }

  Outcome
  run(const std::string& arguments) const
  {
    const std::string command = std::string(LINELET_TOOL) + " " + arguments + " > " +
                                path("stdout") + " 2> " + path("stderr");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            contents(path("stdout")),
            contents(path("stderr"))};
  }

  /** \brief Runs what must succeed; otherwise the test fails with its message. */
  Outcome
  runWell(const std::string& arguments) const
  {
    Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.error;
    return outcome;
  }

  /** \brief Runs what must fail with exit code 1 and one line that names \a name. */
  void
  expectOneLineOf(const std::string& arguments, const std::string& name) const
  {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1) << arguments;
    EXPECT_EQ(lines(outcome.error), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(name), std::string::npos) << outcome.error;
  }

  static std::ptrdiff_t
  lines(const std::string& text)
  {
    return std::count(text.begin(), text.end(), '\n');
  }

private:
  std::filesystem::path folder_;
};

} // namespace linelet::test
