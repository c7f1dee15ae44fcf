// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <linelet/support/names.h>

namespace linelet::apps {

/** \brief What is wrong with a count \a text; CLI11 takes -1 for the largest number. */
inline std::string
notNegative(const std::string& text)
{
  return text.find('-') == std::string::npos ? "" : "must not be negative";
}

/** \brief Turns the description of a settings struct into command line options.
 *
 * Every settings struct S of the library comes with
 *
 *     template <class Visit> void describe(S& s, Visit&& visit)
 *     {
 *       visit("max-radius", s.max_radius, "largest radius, metres; 0: 60 D");
 *     }
 *
 * which is the only place that says its options' names and meaning; the defaults are
 * those of the struct. Enumerations are spoken of by their Names, a type with a
 * constructor from std::string_view and a name() by that name. */
class OptionAdder {
public:
  explicit OptionAdder(CLI::App& app) : app_(app) {}

  template <class T>
  void
  operator()(const char* name, T& value, const char* help) const
  {
    const std::string option = std::string("--") + name;
    if constexpr (std::is_same_v<T, bool>)
      app_.add_flag(value ? option + ",!--no-" + name : option, value, help);
    else if constexpr (std::is_enum_v<T>) {
      std::string choices = std::string(help) + ":";
      for (const auto& entry : Names<T>::table)
        choices += " " + std::string(entry.second);
      addNamed(
          option,
          [&value](const std::string& text) { value = fromName<T>(text); },
          choices,
          std::string(nameOf(value)));
    }
    else if constexpr (std::is_unsigned_v<T>)
      app_.add_option(option, value, help)->capture_default_str()->check(notNegative);
    else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>)
      app_.add_option(option, value, help)->capture_default_str();
    else if constexpr (std::is_same_v<T, std::vector<double>>)
      app_.add_option(option, value, help)->delimiter(',')->capture_default_str();
    else
      addNamed(
          option,
          [&value](const std::string& text) { value = T(text); },
          help,
          value.name());
  }

private:
  template <class Set>
  void
  addNamed(const std::string& option,
           Set set,
           const std::string& help,
           const std::string& shown) const
  {
    app_.add_option_function<std::string>(
            option,
            [set](const std::string& text) {
              try {
                set(text);
              }
              catch (const std::invalid_argument& error) {
                throw CLI::ValidationError(error.what());
              }
            },
            help)
        ->default_str(shown);
  }

  CLI::App& app_;
};

/** \brief Adds an option for every parameter of \a settings to \a app. */
template <class Settings>
void
addOptions(CLI::App& app, Settings& settings)
{
  describe(settings, OptionAdder(app));
}

} // namespace linelet::apps
