// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "options.h"

#include <stdexcept>

#include <CLI/CLI.hpp>

namespace linelet::apps {

namespace {

CLI::Option*
described(CLI::Option* option, const char* type, const std::string& help)
{
  const std::size_t word = help.find_first_of(": ");
  const bool headed = word != std::string::npos && help[word] == ':';
  option->group(headed ? help.substr(0, word) : "Options");
  option->description(headed ? help.substr(help.find_first_not_of(": ", word)) : help);
  return option->type_name(type)->capture_default_str();
}

/** \brief An option whose text \a set parses or rejects. */
CLI::Option*
addNamed(CLI::App& app,
         const std::string& option,
         const OptionAdder::Set& set,
         const std::string& help)
{
  const auto reader = [set](const std::string& text) {
    try {
      set(text);
    }
    catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(error.what());
    }
  };
  return described(app.add_option_function<std::string>(option, reader), "NAME", help);
}

std::string
dashed(const char* name)
{
  return std::string("--") + name;
}

} // namespace

std::string
notNegative(const std::string& text)
{
  return text.find('-') == std::string::npos ? "" : "must not be negative";
}

void
OptionAdder::operator()(const char* name, bool& value, const char* help) const
{
  const std::string option = dashed(name);
  described(app_.add_flag(value ? option + ",!--no-" + name : option, value), "", help);
}

void
OptionAdder::operator()(const char* name, unsigned& value, const char* help) const
{
  described(app_.add_option(dashed(name), value)->check(notNegative), "N", help);
}

void
OptionAdder::operator()(const char* name, std::size_t& value, const char* help) const
{
  described(app_.add_option(dashed(name), value)->check(notNegative), "N", help);
}

void
OptionAdder::operator()(const char* name, double& value, const char* help) const
{
  described(app_.add_option(dashed(name), value), "X", help);
}

void
OptionAdder::operator()(const char* name, std::string& value, const char* help) const
{
  described(app_.add_option(dashed(name), value), "TEXT", help);
}

void
OptionAdder::operator()(const char* name,
                        std::vector<double>& value,
                        const char* help) const
{
  described(
      app_.add_option(dashed(name), value)->delimiter(',')->allow_extra_args(false),
      "X,...",
      help);
}

void
OptionAdder::operator()(const char* name,
                        std::vector<std::string>& value,
                        const char* help) const
{
  described(
      app_.add_option(dashed(name), value)->allow_extra_args(false), "TEXT", help);
}

void
OptionAdder::operator()(const char* name, Indices& value, const char* help) const
{
  described(app_.add_option(dashed(name), value)
                ->delimiter(',')
                ->allow_extra_args(false)
                ->check(notNegative),
            "N,...",
            help);
}

void
OptionAdder::operator()(const char* name, io::ClassList& value, const char* help) const
{
  const auto set = [&value](const std::string& text) { value = io::ClassList(text); };
  addNamed(app_, dashed(name), set, help)
      ->default_str(value.name())
      ->type_name("N,...");
}

void
OptionAdder::named(const char* name,
                   const Set& set,
                   const std::string& value,
                   const std::string& help) const
{
  addNamed(app_, dashed(name), set, help)->default_str(value);
}

void
OptionAdder::namedArgument(const char* name,
                           const Set& set,
                           const std::string& help) const
{
  addNamed(app_, name, set, help)->required();
}

} // namespace linelet::apps
