// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "commands.h"
#include "frame.h"
#include "help.h"
#include "manual.h"
#include "signals.h"
#include "version.h"

using namespace linelet::apps;

namespace {

void
printHelp(std::FILE* out)
{
  std::fprintf(out,
               "linelet %s: curves from raw 3D point clouds\n\n"
               "linelet COMMAND [options] INPUT OUTPUT\n\n",
               LINELET_VERSION);
  for (const Command& command : commands())
    std::fprintf(out, "  %-12s %s\n", command.name, command.summary);
  std::fprintf(out, "\nlinelet COMMAND --help lists its options.\n");
}

} // namespace

int
main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty()) {
    printHelp(stderr);
    return 2;
  }
  const std::string& name = arguments.front();
  if (name == "--help" || name == "-h") {
    printHelp(stdout);
    return 0;
  }
  if (name == "--version") {
    std::printf("linelet %s\n", LINELET_VERSION);
    return 0;
  }
  // Hidden commands: the build makes manual pages and bash completion from them.
  if (name == "--help-manual" || name == "--help-completion") {
    std::fputs((name == "--help-manual" ? manualOfTool() : completionOfTool()).c_str(),
               stdout);
    return 0;
  }
  if (name == "--list-commands") {
    for (const std::string& known : commandNames())
      std::puts(known.c_str());
    return 0;
  }
  for (const Command& command : commands()) {
    if (name != command.name)
      continue;
    watchSignals(command.name);
    try {
      return command.run({arguments.begin() + 1, arguments.end()});
    }
    catch (const Exit& exit) {
      return exit.code;
    }
    catch (const std::bad_alloc&) {
      std::fprintf(
          stderr, "linelet %s: not enough memory for this input\n", command.name);
    }
    catch (const std::exception& error) {
      // Interrupted work may end in some other error.
      const char* what = stopRequested() ? linelet::Canceled().what() : error.what();
      std::fprintf(stderr, "linelet %s: %s\n", command.name, what);
    }
    return 1;
  }
  std::vector<std::string> known;
  for (const Command& command : commands())
    known.push_back(command.name);
  std::fprintf(stderr,
               "linelet: there is no command '%s'%s; linelet --help lists them\n",
               name.c_str(),
               didYouMean(name, known).c_str());
  return 2;
}
