// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <linelet/io/usable_points.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>

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
 *       visit("max-radius", s.max_radius, "largest radius, meters; 0: 60 D");
 *     }
 *
 * which is the only place that says its options' names and meaning; the defaults are
 * those of the struct. Enumerations are spoken of by their Names, a type with a
 * constructor from std::string_view and a name() by that name. A meaning that begins
 * with one word and a colon puts the option under that heading of the help. */
class OptionAdder {
public:
  explicit OptionAdder(CLI::App& app) : app_(app) {}

  template <class T>
  void
  operator()(const char* name, T& value, const char* help) const
  {
    const std::string option = std::string("--") + name;
    if constexpr (std::is_same_v<T, bool>)
      add(app_.add_flag(value ? option + ",!--no-" + name : option, value), "", help);
    else if constexpr (std::is_enum_v<T>) {
      std::string choices;
      for (const auto& entry : Names<T>::table)
        choices += (choices.empty() ? "" : ", ") + std::string(entry.second);
      addNamed(option, byName(value), std::string(help) + " (" + choices + ")")
          ->default_str(std::string(nameOf(value)));
    }
    else if constexpr (std::is_unsigned_v<T>)
      add(app_.add_option(option, value)->check(notNegative), "N", help);
    else if constexpr (std::is_floating_point_v<T>)
      add(app_.add_option(option, value), "X", help);
    else if constexpr (std::is_same_v<T, std::string>)
      add(app_.add_option(option, value), "TEXT", help);
    else if constexpr (std::is_same_v<T, std::vector<double>>)
      add(app_.add_option(option, value)->delimiter(',')->allow_extra_args(false),
          "X,...",
          help);
    else if constexpr (std::is_same_v<T, std::vector<std::string>>)
      add(app_.add_option(option, value)->allow_extra_args(false), "TEXT", help);
    else if constexpr (std::is_same_v<T, Indices>)
      add(app_.add_option(option, value)
              ->delimiter(',')
              ->allow_extra_args(false)
              ->check(notNegative),
          "N,...",
          help);
    else if constexpr (std::is_same_v<T, io::ClassList>) {
      const auto set = [&value](const std::string& text) { value = T(text); };
      addNamed(option, set, help)->default_str(value.name())->type_name("N,...");
    }
    else {
      const auto set = [&value](const std::string& text) { value = T(text); };
      addNamed(option, set, help)->default_str(value.name());
    }
  }

  /** \brief Adds an argument \a name, which must be given, for an enumeration. */
  template <class E>
  void
  argument(const char* name, E& value, const std::string& help) const
  {
    addNamed(name, byName(value), help)->required();
  }

private:
  template <class E>
  static auto
  byName(E& value)
  {
    return [&value](const std::string& text) { value = fromName<E>(text); };
  }

  static CLI::Option*
  add(CLI::Option* option, const char* type, const std::string& help)
  {
    const std::size_t word = help.find_first_of(": ");
    const bool headed = word != std::string::npos && help[word] == ':';
    option->group(headed ? help.substr(0, word) : "Options");
    option->description(headed ? help.substr(help.find_first_not_of(": ", word))
                               : help);
    return option->type_name(type)->capture_default_str();
  }

  /** \brief An option whose text \a set understands or refuses. */
  template <class Set>
  CLI::Option*
  addNamed(const std::string& option, Set set, const std::string& help) const
  {
    const auto reader = [set](const std::string& text) {
      try {
        set(text);
      }
      catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(error.what());
      }
    };
    return add(app_.add_option_function<std::string>(option, reader), "NAME", help);
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
