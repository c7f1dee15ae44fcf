// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include <unistd.h>

#include <CLI/CLI.hpp>

#include <linelet/io/input_list.h>
#include <linelet/io/output_check.h>
#include <linelet/io/output_file.h>
#include <linelet/io/point_file.h>

#include "help.h"
#include "manual.h"
#include "option_file.h"
#include "options.h"
#include "signals.h"

namespace linelet::apps {

namespace {

double
seconds(std::chrono::steady_clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

io::FileError
inputAsOutput(const std::string& path, const std::string& input)
{
  return io::FileError(path + ": is the input " +
                       (path == input ? "" : input + " by another name ") +
                       "and would be overwritten; name another output");
}

} // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar()
{
  erase();
}

void
ProgressBar::begin(std::string_view stage, std::size_t total)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  erase();
  stage_ = stage;
  total_ = total;
  done_ = 0;
  begun_ = shown_ = Clock::now();
}

void
ProgressBar::advance(std::size_t steps)
{
  done_ += steps;
  if (!terminal_ || !mutex_.try_lock())
    return;
  const std::lock_guard<std::mutex> lock(mutex_, std::adopt_lock);
  const auto now = Clock::now();
  if (seconds(now - begun_) < 1 || seconds(now - shown_) < 0.1)
    return;
  shown_ = now;
  visible_ = true;
  if (total_ == 0) {
    std::fprintf(stderr, "\r%-16s %zu\x1b[K", stage_.c_str(), done_.load());
    return;
  }
  const double part =
      std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_));
  const int filled = static_cast<int>(part * 30);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(30 - filled), '.');
  std::fprintf(stderr,
               "\r%-16s [%s] %3.0f%%  %.0f s left\x1b[K",
               stage_.c_str(),
               bar.c_str(),
               100 * part,
               part > 0 ? seconds(now - begun_) * (1 - part) / part : 0.0);
}

bool
ProgressBar::canceled() const
{
  return stopRequested();
}

void
ProgressBar::erase()
{
  if (visible_)
    std::fprintf(stderr, "\r\x1b[K");
  visible_ = false;
}

Frame::Frame(const std::string& command, const std::string& description)
    : parser_(std::make_unique<CLI::App>(description, "linelet " + command)),
      app(*parser_)
{
  app.option_defaults()->always_capture_default();
  app.formatter_fn([](const CLI::App* of, const std::string&, CLI::AppFormatMode) {
    return helpOf(*of);
  });
  app.failure_message(usageError);
  app.set_help_flag("-h,--help", "this text")->group(common_options);
  app.add_option("--threads", threads, "threads; 0: all")
      ->type_name("N")
      ->check(notNegative)
      ->group(common_options);
  app.add_option("--json", json_file_, "write a machine-readable summary to this file")
      ->type_name("FILE")
      ->configurable(false)
      ->group(common_options);
  app.set_config("--config", "", "read options from this file")
      ->type_name("FILE")
      ->group(common_options);
  app.config_formatter(std::make_shared<OptionFile>());
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.add_flag("--print-config", print_config_, "print all options with their values")
      ->configurable(false)
      ->group(common_options);
}

Frame::~Frame() = default;

const std::string&
Frame::name() const
{
  return app.get_name();
}

void
Frame::addArgument(const char* name, std::string& value, const std::string& meaning)
{
  app.add_option(name, value, meaning)->required();
}

void
Frame::addArgument(const char* name,
                   std::vector<std::string>& values,
                   const std::string& meaning)
{
  app.add_option(name, values, meaning)->required();
}

void
Frame::parse(const std::vector<std::string>& arguments)
{
  if (arguments.size() == 1 &&
      (arguments[0] == "--help-manual" || arguments[0] == "--help-completion")) {
    std::cout << (arguments[0] == "--help-manual" ? manualOf(app) : completionOf(app));
    throw Exit{0};
  }
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    if (!print_config_)
      takeOutput();
  }
  catch (const CLI::ParseError& error) {
    // Options can be printed without an input file.
    const bool asked_early =
        print_config_ && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    // A request for help exits with 0, everything else is a usage error.
    if (!asked_early)
      throw Exit{app.exit(error) == 0 ? 0 : 2};
  }
  if (print_config_) {
    std::cout << app.config_to_str(true, true);
    throw Exit{0};
  }
  std::vector<std::string> outputs;
  for (const std::string* path : outputs_)
    if (!path->empty())
      outputs.push_back(*path);
  checkOutputs(outputs);
  if (!json_file_.empty())
    io::checkWritable(json_file_);
}

void
Frame::reads(const std::string& path)
{
  inputs_.push_back(&path);
}

void
Frame::reads(std::vector<std::string>& paths)
{
  names_ = &paths;
}

void
Frame::addOutput(const char* name, std::string& path, const std::string& meaning)
{
  app.add_option(name, path, meaning);
  output_ = &path;
  output_name_ = name;
  writes(path);
}

void
Frame::takeOutput()
{
  if (output_ == nullptr || !output_->empty())
    return;
  if (names_ == nullptr || names_->size() < 2)
    throw CLI::RequiredError(output_name_);
  *output_ = std::move(names_->back());
  names_->pop_back();
}

void
Frame::writes(const std::string& path)
{
  outputs_.push_back(&path);
}

std::vector<std::string>
Frame::inputs() const
{
  std::vector<std::string> paths;
  for (const std::string* path : inputs_)
    if (!path->empty()) {
      paths.push_back(*path);
      paths.push_back(*path + ".shift"); // of a point file
    }
  if (names_ != nullptr) {
    paths.insert(paths.end(), names_->begin(), names_->end());
    for (const std::string& file : io::findInputs(*names_).files) {
      paths.push_back(file);
      paths.push_back(file + ".shift");
    }
  }
  if (const auto config = app.get_config_ptr()->as<std::string>(); !config.empty())
    paths.push_back(config);
  return paths;
}

void
Frame::checkOutputs(const std::vector<std::string>& outputs) const
{
  std::map<std::string, std::string> read; // by identity
  for (const std::string& input : inputs())
    read.emplace(io::identityOf(input), input);
  std::set<std::string> written;
  const auto check = [&](const std::string& path) {
    const std::string identity = io::identityOf(path);
    if (identity.empty())
      return;
    if (const auto input = read.find(identity); input != read.end())
      throw inputAsOutput(path, input->second);
    if (!written.insert(identity).second)
      throw io::FileError(path + ": is named for two outputs; name another file "
                                 "for one of them");
  };
  for (const std::string& path : outputs)
    check(path);
  if (!json_file_.empty())
    check(json_file_);
}

std::vector<std::pair<std::string, std::string>>
Frame::settings() const
{
  std::vector<std::pair<std::string, std::string>> all;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->nonpositional() || option->get_group() == common_options)
      continue;
    std::string value;
    for (const std::string& part : option->results())
      value += (value.empty() ? "" : ",") + part;
    if (option->count() == 0)
      value = option->get_type_size() == 0 && option->get_default_str().empty()
                  ? "false"
                  : option->get_default_str();
    all.emplace_back(option->get_name(false, false), value);
  }
  return all;
}

std::vector<std::string>
Frame::changedOptions(const std::string& heading) const
{
  std::vector<std::string> changed;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() == heading && option->count() > 0 &&
        option->results() != std::vector<std::string>{option->get_default_str()} &&
        !(option->get_expected_max() == 0 && option->as<std::string>() == "false"))
      changed.push_back(option->get_name());
  return changed;
}

void
Frame::warn(const std::string& sentence)
{
  if (std::find(warnings_.begin(), warnings_.end(), sentence) != warnings_.end())
    return; // when a file is checked twice
  std::cerr << app.get_name() << ": warning: " << sentence << '\n';
  warnings_.push_back(sentence);
}

void
Frame::warn(const std::vector<std::string>& sentences)
{
  for (const std::string& sentence : sentences)
    warn(sentence);
}

void
Frame::lap(const char* stage)
{
  const auto now = std::chrono::steady_clock::now();
  seconds_[stage] = seconds(now - since_);
  since_ = now;
}

int
Frame::finish()
{
  if (json_file_.empty())
    return 0;
  if (!seconds_.empty())
    summary["seconds"] = seconds_;
  summary["warnings"] = warnings_;
  io::OutputFile file(json_file_);
  // A path may not be UTF-8, as JSON must be.
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  file.write(summary.dump(2, ' ', false, replace) + '\n');
  file.commit();
  return 0;
}

} // namespace linelet::apps
