// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sweep.h"

#include <set>
#include <stdexcept>

#include <bench/runs/benchmark.h>

#include <CLI/CLI.hpp>

#include "options.h"

namespace linelet::apps {

namespace {

/** \brief Whether \a settings have an option \a name. */
template <class Settings>
bool
hasOption(const std::string& name)
{
  Settings settings;
  bool found = false;
  describe(settings, [&](const std::string& known, const auto&, const auto&) {
    found = found || known == name;
  });
  return found;
}

/** \brief Parses \a words, --NAME VALUE ..., into \a settings, like the command. */
template <class Settings>
void
read(const std::vector<std::string>& words, Settings& settings)
{
  CLI::App app;
  addOptions(app, settings);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  }
  catch (const CLI::ParseError& error) {
    throw std::runtime_error(std::string("--vary: ") + error.what());
  }
}

std::vector<std::string>
split(const std::string& text)
{
  const char gap = text.find('|') == std::string::npos ? ',' : '|';
  std::vector<std::string> values(1);
  for (const char c : text)
    if (c == gap)
      values.emplace_back();
    else
      values.back() += c;
  return values;
}

} // namespace

Sweep::Sweep(const std::vector<std::string>& texts)
{
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    if (sign == 0 || sign == std::string::npos || sign + 1 == text.size())
      throw std::runtime_error("--vary " + text +
                               ": write NAME=VALUE,... with the name of an option");
    Option option{text.substr(0, sign), split(text.substr(sign + 1)), false};
    option.of_samples = hasOption<bench::SamplingSettings>(option.name);
    if (!option.of_samples && !hasOption<ReconstructionSettings>(option.name))
      throw std::runtime_error(
          "--vary " + text + ": there is no option '" + option.name +
          "'; linelet benchmark --help lists those of the "
          "reconstruction, linelet generate --help those of samples");
    options_.push_back(std::move(option));
  }
}

std::size_t
Sweep::size() const
{
  std::size_t product = 1;
  for (const Option& option : options_)
    product *= option.values.size();
  return product;
}

std::vector<std::string>
Sweep::names() const
{
  std::vector<std::string> result;
  for (const Option& option : options_)
    result.push_back(option.name);
  return result;
}

std::vector<std::size_t>
Sweep::places(std::size_t index) const
{
  std::vector<std::size_t> result(options_.size());
  for (std::size_t k = options_.size(); k-- > 0;) {
    result[k] = index % options_[k].values.size();
    index /= options_[k].values.size();
  }
  return result;
}

std::string
Sweep::label(std::size_t index) const
{
  const std::vector<std::size_t> at = places(index);
  std::string text;
  for (std::size_t k = 0; k < options_.size(); ++k) {
    std::string value = options_[k].values[at[k]];
    for (char& c : value)
      c = c == ',' ? ';' : c; // fields of a result row end at commas
    text += (k > 0 ? " " : "") + options_[k].name + ' ' + value;
  }
  return text;
}

std::vector<bench::BenchmarkRun>
Sweep::apply(std::size_t index,
             ReconstructionSettings& settings,
             const std::vector<bench::BenchmarkRun>& runs) const
{
  const std::vector<std::size_t> at = places(index);
  std::vector<std::string> words, samples;
  for (std::size_t k = 0; k < options_.size(); ++k) {
    auto& some = options_[k].of_samples ? samples : words;
    some.push_back("--" + options_[k].name);
    some.push_back(options_[k].values[at[k]]);
  }
  read(words, settings);
  settings.threads = 1;
  std::vector<bench::BenchmarkRun> result;
  std::set<std::string> seen;
  for (bench::BenchmarkRun run : runs) {
    if (!samples.empty())
      read(samples, run.sampling);
    if (seen.insert(bench::keyOf("", run)).second)
      result.push_back(run);
  }
  return result;
}

} // namespace linelet::apps
