// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <linelet/io/point_file.h>

#include "run_tool.h"

using namespace linelet;

namespace {

using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;
using testing::Not;

class Manual : public ToolTest {
protected:
  std::vector<std::string>
  commands() const
  {
    std::vector<std::string> names;
    std::istringstream lines(run("--list-commands").out);
    for (std::string line; std::getline(lines, line);)
      names.push_back(line);
    return names;
  }
};

// Everything in --help is in the manual page and in the completion, for every command.
TEST_F(Manual, NamesEveryOptionOfEveryCommand)
{
  const std::vector<std::string> names = commands();
  EXPECT_GT(names.size(), 10U);
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const std::string help = run(name + " --help").out;
    const Outcome page = run(name + " --help-manual"),
                  words = run(name + " --help-completion");
    ASSERT_EQ(page.code, 0);
    EXPECT_EQ(page.out.rfind(".\\\"", 0), 0U);
    EXPECT_THAT(page.out, HasSubstr("\n.SH SYNOPSIS\n"));
    std::size_t options = 0;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("  --", 0) != 0)
        continue;
      const std::string option = line.substr(2, line.find_first_of(" ,=", 4) - 2);
      std::string escaped;
      for (const char letter : option)
        escaped += letter == '-' ? std::string("\\-") : std::string(1, letter);
      EXPECT_THAT(page.out, HasSubstr(escaped));
      EXPECT_THAT(words.out, HasSubstr(option));
      ++options;
    }
    EXPECT_GT(options, 2U);
    EXPECT_THAT(page.out, Not(HasSubstr("\n\n"))); // an empty line breaks a paragraph
  }
}

TEST_F(Manual, BashCompletesCommandsOptionsAndWords)
{
  std::string script = run("--help-completion").out;
  for (const std::string& name : commands())
    script += run(name + " --help-completion").out;
  const std::string file = write("completion", script);
  const auto complete = [&](const std::string& words, int at) {
    const std::string test = write("ask",
                                   "source " + file + "\nCOMP_WORDS=(" + words +
                                       ")\nCOMP_CWORD=" + std::to_string(at) +
                                       "\n_linelet\necho \"${COMPREPLY[*]}\"\n");
    const std::string answer = path("answer");
    EXPECT_EQ(std::system(("bash " + test + " > " + answer + " 2>&1").c_str()), 0);
    return contents(answer);
  };
  EXPECT_EQ(complete("linelet power", 1), "powerlines\n");
  EXPECT_EQ(complete("linelet tensor --rad", 2), "--radius --radius-field\n");
  EXPECT_EQ(complete("linelet tensor --engine gr", 3), "grid\n");
  EXPECT_THAT(complete("linelet generate corridor --plan", 3), HasSubstr("--planted"));
}

class Features : public ToolTest {};

TEST_F(Features, AreTheRequestedOnes)
{
  ASSERT_EQ(run("generate circle " + path("in.ply") + " --points 200").code, 0);
  ASSERT_EQ(run("tensor " + path("in.ply") + " " + path("out.ply") +
                " --radius 0.5 --features verticality,linearity,surface_variation")
                .code,
            0);
  const io::Cloud out = io::readCloud(path("out.ply"));
  for (const char* name : {"verticality", "linearity", "surface_variation"})
    EXPECT_NE(out.find(name), nullptr) << name;
  for (const char* name : {"lambda1", "major_x", "neighbors", "omnivariance"})
    EXPECT_EQ(out.find(name), nullptr) << name;
  // The old output by default, and everything with all.
  ASSERT_EQ(
      run("tensor " + path("in.ply") + " " + path("out.ply") + " --radius 0.5").code,
      0);
  EXPECT_NE(io::readCloud(path("out.ply")).find("lambda1"), nullptr);
  EXPECT_EQ(io::readCloud(path("out.ply")).find("omnivariance"), nullptr);
  ASSERT_EQ(run("tensor " + path("in.ply") + " " + path("out.ply") +
                " --radius 0.5 --features all")
                .code,
            0);
  EXPECT_NE(io::readCloud(path("out.ply")).find("eigenentropy"), nullptr);
  const Outcome wrong =
      run("tensor " + path("in.ply") + " " + path("out.ply") + " --features roundness");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.error, HasSubstr("roundness"));
  EXPECT_THAT(wrong.error, HasSubstr("eigenentropy"));
}

} // namespace
