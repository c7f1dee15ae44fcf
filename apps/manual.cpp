// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "manual.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <CLI/CLI.hpp>

#include "commands.h"
#include "help.h"
#include "version.h"

namespace linelet::apps {

namespace {

/** Text for troff, escaped so that nothing in it is a request. */
std::string
troff(const std::string& text)
{
  std::string out;
  for (const char letter : text) {
    if (letter == '\\')
      out += "\\e";
    else if (letter == '-')
      out += "\\-";
    else if ((letter == '.' || letter == '\'') && (out.empty() || out.back() == '\n'))
      out += std::string("\\&") + letter;
    else
      out += letter;
  }
  return out;
}

/** "linelet-generate-corridor" for "linelet generate corridor". */
std::string
pageName(std::string command)
{
  std::replace(command.begin(), command.end(), ' ', '-');
  return command;
}

std::string
head(const std::string& command, const std::string& summary)
{
  std::string name = pageName(command), upper = name;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  return ".\\\" Made by linelet itself from the descriptions of its options.\n.TH " +
         troff(upper) +
         " 1 \"\" \"linelet " LINELET_VERSION "\" \"User Commands\"\n.SH NAME\n" +
         troff(name) + " \\- " + troff(summary) + "\n";
}

std::string
summaryOf(const std::string& command)
{
  for (const Command& known : commands())
    if (command == std::string("linelet ") + known.name)
      return known.summary;
  return "make a scene with power lines"; // generate corridor, generate scene
}

std::string
entry(const std::string& name, const std::string& value, const std::string& meaning)
{
  return ".TP\n.B " + troff(name) +
         (value.empty() ? "" : " \\fI" + troff(value) + "\\fR") + "\n" +
         troff(meaning) + "\n";
}

std::string
optionsManual(const CLI::App& app, const std::string& group)
{
  std::string out;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->nonpositional() || option->get_group() != group)
      continue;
    const bool flag = option->get_type_size() == 0;
    std::string meaning = option->get_description();
    if (const std::string value = option->get_default_str();
        !flag && !value.empty() && value != "[]")
      meaning += " [" + value + "]";
    out += entry(
        option->get_name(false, true), flag ? "" : option->get_type_name(), meaning);
  }
  return out.empty() ? out : ".SH " + troff(group) + "\n" + out;
}

/** The words listed at the end of an option's meaning: "(a, b, c)". */
std::string
choicesOf(const CLI::Option& option)
{
  const std::string& meaning = option.get_description();
  const std::size_t begin = meaning.rfind('(');
  if (begin == std::string::npos || meaning.back() != ')' ||
      option.get_type_name() != "NAME")
    return {};
  std::string words = meaning.substr(begin + 1, meaning.size() - begin - 2);
  words.erase(std::remove(words.begin(), words.end(), ','), words.end());
  return words.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_ ") ==
                 std::string::npos
             ? words
             : std::string();
}

std::string
keyOf(const CLI::App& app)
{
  return app.get_name().substr(std::string("linelet ").size());
}

/** \brief An array entry of the completion script. */
std::string
assignment(const char* array, const std::string& key, const std::string& words)
{
  return "_linelet_" + std::string(array) + "[\"" + key + "\"]=\"" + words + "\"\n";
}

} // namespace

std::vector<std::string>
commandNames()
{
  std::vector<std::string> names;
  for (const Command& command : commands())
    names.emplace_back(command.name);
  if (std::count(names.begin(), names.end(), "generate") > 0)
    names.insert(names.end(), {"generate corridor", "generate scene"});
  return names;
}

std::string
manualOf(const CLI::App& app)
{
  const std::string& command = app.get_name();
  std::string usage = ".B " + troff(command) + "\n[\\fIOPTIONS\\fR]", arguments;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) {
      usage += " \\fI" + troff(option->get_name(true)) + "\\fR";
      arguments += entry(option->get_name(true), "", option->get_description());
    }
  std::string out = head(command, summaryOf(command)) + ".SH SYNOPSIS\n" + usage +
                    "\n.SH DESCRIPTION\n" + troff(app.get_description()) + "\n" +
                    arguments;
  for (const std::string& group : app.get_groups())
    if (group != common_options)
      out += optionsManual(app, group);
  return out + optionsManual(app, common_options) +
         ".SH EXIT STATUS\n0: done, 1: failed, with one line that says what and what "
         "to "
         "do, 2: wrong usage.\n.SH SEE ALSO\n.BR linelet (1)\n";
}

std::string
manualOfTool()
{
  std::string out = head("linelet", "curves from raw 3D point clouds") +
                    ".SH SYNOPSIS\n.B linelet\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] "
                    "\\fIINPUT\\fR \\fIOUTPUT\\fR\n.SH COMMANDS\n";
  for (const Command& command : commands())
    out += entry(command.name, "", command.summary);
  out += ".SH SEE ALSO\n";
  for (const std::string& name : commandNames())
    out += ".BR " + troff(pageName("linelet " + name)) + " (1)\n";
  return out;
}

std::string
completionOf(const CLI::App& app)
{
  const std::string key = keyOf(app);
  std::string options, values;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->nonpositional())
      continue;
    for (const std::string& name : option->get_lnames()) {
      options.append(options.empty() ? "--" : " --").append(name);
      if (const std::string words = choicesOf(*option); !words.empty())
        values += assignment("values", key + " --" + name, words);
    }
  }
  return assignment("options", key, options) + values;
}

std::string
completionOfTool()
{
  std::string names;
  for (const Command& command : commands())
    names += std::string(names.empty() ? "" : " ") + command.name;
  return "# bash completion of linelet, made by linelet itself\n"
         "declare -gA _linelet_options _linelet_values\n"
         "_linelet()\n{\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} key=${COMP_WORDS[1]}\n"
         "  local previous=${COMP_WORDS[COMP_CWORD-1]} words\n"
         "  COMPREPLY=()\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    COMPREPLY=($(compgen -W \"" +
         names +
         " --help --version\" -- \"$current\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"$key ${COMP_WORDS[2]}\" in\n"
         "    'generate corridor'|'generate scene') key+=\" ${COMP_WORDS[2]}\" ;;\n"
         "  esac\n"
         "  words=${_linelet_values[\"$key $previous\"]}\n"
         "  if [[ -n $words ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "  elif [[ $current == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"${_linelet_options[$key]}\" -- \"$current\"))\n"
         "  fi\n"
         "}\n"
         "complete -o default -F _linelet linelet\n";
}

} // namespace linelet::apps
