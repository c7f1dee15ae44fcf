// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "help.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <sstream>

#include <CLI/CLI.hpp>

namespace linelet::apps {

namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t text_column = 26; // where the meaning of an option begins

/** \brief Wraps \a text into lines that begin at \a column, where the cursor already
 * is. */
std::string
wrapped(const std::string& text, std::size_t column)
{
  std::string out;
  std::size_t at = column;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (at > column && at + 1 + word.size() > line_width) {
        out += '\n' + std::string(column, ' ');
        at = column;
      }
      if (at > column) {
        out += ' ';
        ++at;
      }
      out += word;
      at += word.size();
    }
    if (!lines.eof()) {
      out += '\n' + std::string(column, ' ');
      at = column;
    }
  }
  return out + '\n';
}

/** \brief "  --radius X=0    what it means", with the meaning on lines of its own if
 * the name is too long. */
std::string
entry(const std::string& name, const std::string& meaning)
{
  std::string out = "  " + name;
  if (out.size() + 2 > text_column)
    out += '\n' + std::string(text_column, ' ');
  else
    out.resize(text_column, ' ');
  return out + wrapped(meaning, text_column);
}

/** \brief "--radius X=0": name, kind of value and default. */
std::string
signature(const CLI::Option& option)
{
  std::string out = option.get_name(false, true);
  if (option.get_type_size() == 0) // a flag
    return out;
  out += ' ' + option.get_type_name();
  const std::string value = option.get_default_str();
  if (!value.empty() && value != "[]")
    out += '=' + value;
  return out;
}

std::string
optionsHelp(const CLI::App& app, const std::string& group)
{
  std::string out;
  for (const CLI::Option* option : app.get_options())
    if (option->nonpositional() && option->get_group() == group)
      out += entry(signature(*option), option->get_description());
  return out.empty() ? out : '\n' + group + ":\n" + out;
}

/** \brief Minimum number of insertions, deletions and replacements of letters that turn
 * \a a into \a b (Levenshtein 1966). */
std::size_t
editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

/** \brief The first option on the command line that \a app does not have; empty if
 * none. */
std::string
unknownOption(const CLI::App& app)
{
  for (const std::string& word : app.remaining())
    if (word.size() > 1 && word[0] == '-')
      return word.substr(0, word.find('='));
  return {};
}

} // namespace

std::string
helpOf(const CLI::App& app)
{
  std::string usage = "Usage: " + app.get_name() + " [OPTIONS]", arguments;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) {
      usage += ' ' + option->get_name(true);
      arguments += entry(option->get_name(true), option->get_description());
    }
  std::string out = usage + "\n\n" + wrapped(app.get_description(), 0);
  if (!arguments.empty())
    out += '\n' + arguments;
  for (const std::string& group : app.get_groups())
    if (group != common_options)
      out += optionsHelp(app, group);
  return out + optionsHelp(app, common_options);
}

std::string
didYouMean(const std::string& word, const std::vector<std::string>& known)
{
  std::size_t least = word.size() / 3 + 1; // more edits: a different word
  std::string best;
  for (const std::string& candidate : known)
    if (const std::size_t distance = editDistance(word, candidate); distance < least) {
      least = distance;
      best = candidate;
    }
  return best.empty() ? best : ", did you mean " + best + "?";
}

std::string
usageError(const CLI::App* app, const CLI::Error& error)
{
  std::string what = error.what();
  // The value of an unknown option looks like a surplus argument.
  if (const std::string unknown = unknownOption(*app); !unknown.empty()) {
    std::vector<std::string> known;
    for (const CLI::Option* option : app->get_options())
      if (option->nonpositional())
        known.push_back(option->get_name(false, false));
    what = "there is no option " + unknown + didYouMean(unknown, known);
  }
  else if (const std::string stiff = "Could not convert: "; what.rfind(stiff, 0) == 0)
    what = what.substr(stiff.size()) + " is not a valid number";
  else if (dynamic_cast<const CLI::ConfigError*>(&error) != nullptr)
    what = app->get_config_ptr()->as<std::string>() + ": " + what;
  const std::string& name = app->get_name();
  return name + ": " + what + "; " + name + " --help lists the options\n";
}

} // namespace linelet::apps
