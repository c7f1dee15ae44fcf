// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <linelet/io/usable_points.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>

namespace CLI {
class App;
}

namespace linelet::apps {

/** \brief What is wrong with \a text as a count; CLI11 reads -1 as the largest
 * number. */
std::string
notNegative(const std::string& text);

/** \brief Turns the description of a settings struct into command line options.
 *
 * Every settings struct S of the library comes with
 *
 *     template <class Visit> void describe(S& s, Visit&& visit)
 *     {
 *       visit("max-radius", s.max_radius, "largest radius, meters; 0: 60 D");
 *     }
 *
 * which is the only place that states the names and meanings of its options; the
 * defaults are those of the struct. Enumerations are written by their Names; so is a
 * type with a constructor from std::string_view and a name(). A meaning that begins
 * with one word and a colon puts the option under that heading of the help.
 *
 * CLI11 is included only by the sources that call it: its header takes 3 s to compile.
 */
class OptionAdder {
public:
  explicit OptionAdder(CLI::App& app) : app_(app) {}

  void
  operator()(const char* name, bool& value, const char* help) const;
  void
  operator()(const char* name, unsigned& value, const char* help) const;
  void
  operator()(const char* name, std::size_t& value, const char* help) const;
  void
  operator()(const char* name, double& value, const char* help) const;
  void
  operator()(const char* name, std::string& value, const char* help) const;
  void
  operator()(const char* name, std::vector<double>& value, const char* help) const;
  void
  operator()(const char* name, std::vector<std::string>& value, const char* help) const;
  void
  operator()(const char* name, Indices& value, const char* help) const;
  void
  operator()(const char* name, io::ClassList& value, const char* help) const;

  template <class T>
  void
  operator()(const char* name, T& value, const char* help) const
  {
    if constexpr (std::is_enum_v<T>) {
      std::string choices;
      for (const auto& entry : Names<T>::table)
        choices += (choices.empty() ? "" : ", ") + std::string(entry.second);
      named(name,
            byName(value),
            std::string(nameOf(value)),
            std::string(help) + " (" + choices + ")");
    }
    else
      named(
          name,
          [&value](const std::string& text) { value = T(text); },
          value.name(),
          help);
  }

  /** \brief Adds a required argument \a name for an enumeration. */
  template <class E>
  void
  argument(const char* name, E& value, const std::string& help) const
  {
    namedArgument(name, byName(value), help);
  }

  /** \brief Takes the text of an option. \throws std::invalid_argument */
  using Set = std::function<void(const std::string&)>;

private:
  template <class E>
  static Set
  byName(E& value)
  {
    return [&value](const std::string& text) { value = fromName<E>(text); };
  }

  void
  named(const char* name,
        const Set& set,
        const std::string& value,
        const std::string& help) const;
  void
  namedArgument(const char* name, const Set& set, const std::string& help) const;

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
