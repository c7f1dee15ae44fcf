// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "analysis_settings.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include <CLI/CLI.hpp>

#include "option_file.h"
#include "options.h"

namespace linelet::view {

namespace {

/** \brief Calls visit for every option of \a analysis in \a settings. */
template <class Settings, class Visit>
void
describeAll(Settings& settings, Analysis analysis, Visit&& visit)
{
  switch (analysis) {
  case Analysis::Tensor:
    describe(settings.tensor, visit);
    break;
  case Analysis::MultiScale:
    describe(settings.scales, visit);
    break;
  case Analysis::Curves:
    describe(settings.curves, visit);
    break;
  case Analysis::PowerLines:
    describe(settings.wires, visit);
    break;
  }
  const auto of_input = [&](const char* name, auto& value, const char* help) {
    visit(name, value, (std::string("input: ") + help).c_str());
  };
  describe(settings.read, of_input);
  describe(settings.classes, of_input);
}

/** \brief The shortest text that reads back as \a value. */
std::string
exact(double value)
{
  char text[32];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::stod(text) == value)
      break;
  }
  return text;
}

template <class T>
constexpr bool is_list = false;
template <class T>
constexpr bool is_list<std::vector<T>> = true;

template <class T>
std::string
textOf(const T& value)
{
  if constexpr (std::is_same_v<T, bool>)
    return value ? "true" : "false";
  else if constexpr (std::is_enum_v<T>)
    return std::string(nameOf(value));
  else if constexpr (std::is_unsigned_v<T>)
    return std::to_string(value);
  else if constexpr (std::is_floating_point_v<T>)
    return exact(value);
  else if constexpr (std::is_same_v<T, std::string>)
    return value;
  else if constexpr (is_list<T>) {
    std::string text;
    for (const auto& one : value)
      text += (text.empty() ? "" : ",") + textOf(one);
    return text;
  }
  else
    return std::string(value.name());
}

template <class E>
std::vector<std::string>
namesOf()
{
  std::vector<std::string> names;
  names.reserve(Names<E>::table.size());
  for (const auto& entry : Names<E>::table)
    names.emplace_back(entry.second);
  return names;
}

/** \brief The unit that the help text of an option names. */
std::string
unitIn(const std::string& meaning)
{
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> units =
      {{{"meters", "m"},
        {"degrees", "°"},
        {"in D", "D"},
        {"in h", "h"},
        {"unit of the file", "unit of the file"},
        {"unit of the cloud", "unit of the file"},
        {"unit of the points", "unit of the file"},
        {"X0,Y0", "unit of the file"}}};
  for (const auto& [words, unit] : units)
    if (meaning.find(words) != std::string::npos)
      return std::string(unit);
  return {};
}

/** \brief Collects what it visits. */
class Lister {
public:
  explicit Lister(std::vector<Parameter>& list) : list_(list) {}

  template <class T>
  void
  operator()(const char* name, const T& value, const char* help) const
  {
    Parameter p;
    p.name = name;
    const std::string text = help;
    const std::size_t word = text.find_first_of(": ");
    if (word != std::string::npos && text[word] == ':') {
      p.heading = text.substr(0, word);
      p.meaning = text.substr(text.find_first_not_of(": ", word));
    }
    else
      p.meaning = text;
    p.value = textOf(value);
    p.unit = unitIn(p.meaning);
    if constexpr (std::is_same_v<T, bool>) {
      p.kind = Parameter::Kind::Flag;
      p.range = "on or off";
    }
    else if constexpr (std::is_enum_v<T>) {
      p.kind = Parameter::Kind::Choice;
      p.choices = namesOf<T>();
      p.range = "one of " + std::to_string(p.choices.size());
    }
    else if constexpr (std::is_same_v<T, Weighting>) {
      p.kind = Parameter::Kind::Choice;
      p.choices = namesOf<Kernel>();
      p.range = "a kernel, fermi-dirac:M,T or step:S";
    }
    else if constexpr (std::is_unsigned_v<T>) {
      p.kind = Parameter::Kind::Count;
      p.range = "0 to 4294967295";
    }
    else if constexpr (std::is_floating_point_v<T>) {
      p.kind = Parameter::Kind::Number;
      p.range = "0 or more";
    }
    else if constexpr (is_list<T>) {
      p.kind = Parameter::Kind::Numbers;
      p.range = "numbers with commas, or none";
    }
    list_.push_back(std::move(p));
  }

private:
  std::vector<Parameter>& list_;
};

/** \brief Empties the list of numbers called \a name. */
struct Emptier {
  const std::string& name;
  bool& done;

  template <class T>
  void
  operator()(const char* visited, T& value, const char*) const
  {
    if constexpr (is_list<T> || std::is_same_v<T, std::string>)
      if (name == visited) {
        value = T();
        done = true;
      }
  }
};

std::unique_ptr<CLI::App>
appFor(AnalysisSettings& settings, Analysis analysis)
{
  auto app = std::make_unique<CLI::App>("", "linelet " + std::string(nameOf(analysis)));
  app->option_defaults()->always_capture_default();
  app->config_formatter(std::make_shared<apps::OptionFile>());
  describeAll(settings, analysis, apps::OptionAdder(*app));
  return app;
}

/** \brief Parses with the app of a copy of \a settings, which then replaces them. */
template <class Parse>
void
parseInto(AnalysisSettings& settings, Analysis analysis, const Parse& parse)
{
  AnalysisSettings copy = settings;
  const auto app = appFor(copy, analysis);
  try {
    parse(*app);
  }
  catch (const CLI::Error& error) {
    throw std::invalid_argument(error.what());
  }
  settings = std::move(copy);
}

/** \brief The options that differ from their defaults, as on a command line. */
std::vector<std::string>
differences(const AnalysisSettings& settings, Analysis analysis)
{
  std::vector<std::string> arguments;
  for (const Parameter& p : settings.parameters(analysis))
    if (p.value != p.standard)
      arguments.push_back(p.kind != Parameter::Kind::Flag
                              ? "--" + p.name + "=" + p.value
                          : p.value == "true" ? "--" + p.name
                                              : "--no-" + p.name);
  return arguments;
}

} // namespace

std::vector<Parameter>
AnalysisSettings::parameters(Analysis analysis) const
{
  std::vector<Parameter> list, standard;
  AnalysisSettings copy = *this, defaults;
  describeAll(copy, analysis, Lister(list));
  describeAll(defaults, analysis, Lister(standard));
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].standard = standard[i].value;
  return list;
}

void
AnalysisSettings::set(Analysis analysis,
                      const std::string& name,
                      const std::string& text)
{
  if (text.empty()) {
    bool done = false;
    describeAll(*this, analysis, Emptier{name, done});
    if (done)
      return;
  }
  const auto list = parameters(analysis);
  const auto found = std::find_if(
      list.begin(), list.end(), [&](const Parameter& p) { return p.name == name; });
  if (found == list.end())
    throw std::invalid_argument("linelet " + std::string(nameOf(analysis)) +
                                " has no option --" + name);
  if (found->kind == Parameter::Kind::Number && text.find('-') == 0)
    throw std::invalid_argument("--" + name + " is " + text + ", and must be " +
                                found->range);
  parseInto(
      *this, analysis, [&](CLI::App& app) { app.parse("--" + name + "=" + text); });
}

std::string
AnalysisSettings::config(Analysis analysis) const
{
  // Parsed once more, so that numbers are as exact as they were given.
  AnalysisSettings defaults;
  const auto app = appFor(defaults, analysis);
  std::vector<std::string> arguments = differences(*this, analysis);
  std::reverse(arguments.begin(), arguments.end());
  app->parse(std::move(arguments));
  return app->config_to_str(true, true);
}

std::vector<std::string>
AnalysisSettings::loadConfig(Analysis analysis, const std::string& path)
{
  std::ifstream in(path);
  if (!in)
    throw std::invalid_argument(path +
                                ": cannot be read; name a file that --print-config or "
                                "the viewer wrote");
  std::vector<std::string> unknown;
  parseInto(*this, analysis, [&](CLI::App& app) {
    std::vector<std::string> arguments;
    for (const CLI::ConfigItem& item : apps::OptionFile().from_config(in)) {
      const CLI::Option* option = app.get_option_no_throw("--" + item.name);
      std::string text;
      for (const std::string& one : item.inputs)
        text += (text.empty() ? "" : ",") + one;
      if (option == nullptr || !item.parents.empty())
        unknown.push_back(item.name);
      else if (!text.empty())
        arguments.push_back("--" + item.name + "=" + text);
    }
    std::reverse(arguments.begin(), arguments.end());
    app.parse(std::move(arguments));
  });
  return unknown;
}

std::string
AnalysisSettings::commandLine(Analysis analysis,
                              const std::vector<std::string>& inputs,
                              const std::string& output) const
{
  std::string line = "linelet " + std::string(nameOf(analysis));
  for (const std::string& argument : differences(*this, analysis))
    line += " " + shellQuoted(argument);
  for (const std::string& input : inputs)
    line += " " + shellQuoted(input);
  return line + " " + shellQuoted(output);
}

std::string
shellQuoted(const std::string& word)
{
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
  });
  if (plain)
    return word;
  std::string quoted = "'";
  for (const char c : word)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

} // namespace linelet::view
