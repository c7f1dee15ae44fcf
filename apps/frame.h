// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <linelet/support/progress_monitor.h>

namespace CLI {
class App;
}

namespace linelet::apps {

/** \brief Progress on stderr if that is a terminal: stage, bar and estimated time left,
 * shown once a stage takes longer than a second. Canceled by signals (see
 * signals.h). */
class ProgressBar : public ProgressMonitor {
public:
  ProgressBar();
  ~ProgressBar() override;
  void
  begin(std::string_view stage, std::size_t total) override;
  void
  advance(std::size_t steps) override;
  bool
  canceled() const override;

private:
  void
  erase();

  using Clock = std::chrono::steady_clock;
  bool terminal_;
  std::mutex mutex_;
  std::string stage_;
  std::size_t total_ = 0;
  std::atomic<std::size_t> done_{0};
  Clock::time_point begun_, shown_;
  bool visible_ = false;
};

/** \brief Thrown to leave a command early with an exit code (after --help, for
 * example). */
struct Exit {
  int code;
};

/** \brief What every command shares: option parsing, threads, JSON summary, progress.
 *
 * A command creates a frame, adds its options to \ref app, calls \ref parse, does its
 * work, fills \ref summary, and returns \ref finish. */
class Frame {
  std::unique_ptr<CLI::App> parser_;

public:
  Frame(const std::string& command, const std::string& summary);
  ~Frame();

  CLI::App& app;
  unsigned threads = 0; ///< 0: all
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();
  ProgressBar monitor;

  /** \brief Declares that \a path, empty if not given, names a file to read after \ref
   * parse; must outlive this. */
  void
  reads(const std::string& path);

  /** \brief The same for several. The last of them is the output of \ref addOutput, if
   * there is one. */
  void
  reads(std::vector<std::string>& paths);

  /** \brief "linelet COMMAND". */
  const std::string&
  name() const;

  /** \brief Adds the required argument \a name. */
  void
  addArgument(const char* name, std::string& value, const std::string& meaning);
  void
  addArgument(const char* name,
              std::vector<std::string>& values,
              const std::string& meaning);

  /** \brief Adds the required argument \a name after those to read; it names the output
   * \a path. */
  void
  addOutput(const char* name, std::string& path, const std::string& meaning);

  /** \brief The same for a file to write; \ref parse rejects it if it is also an input
   * or another output. */
  void
  writes(const std::string& path);

  /** \brief Parses the arguments after the command's name.
   * \throws Exit, io::FileError if --json cannot be written, or an output is an
   * input */
  void
  parse(const std::vector<std::string>& arguments);

  /** \brief Rejects \a outputs, known only after \ref parse, that are inputs or other
   * outputs.
   * \throws io::FileError */
  void
  checkOutputs(const std::vector<std::string>& outputs) const;

  /** \brief Name and value of every option of the command, given or not, in the order
   * of its help; known after \ref parse. */
  std::vector<std::pair<std::string, std::string>>
  settings() const;

  /** \brief The options under \a heading that are set to other values than their
   * defaults: an option file has all of them. */
  std::vector<std::string>
  changedOptions(const std::string& heading) const;

  /** \brief Reports a loss or an oddity in one sentence, on stderr and in the
   * summary. */
  void
  warn(const std::string& sentence);
  void
  warn(const std::vector<std::string>& sentences);

  /** \brief Records the time since the previous lap, or since construction, as that of
   * \a stage, for the summary. */
  void
  lap(const char* stage);

  /** \brief Writes --json: the summary, seconds by stage, warnings.
   * \return the exit code of success */
  int
  finish();

private:
  std::vector<std::string>
  inputs() const;

  std::vector<const std::string*> inputs_, outputs_;
  void
  takeOutput();

  std::vector<std::string>* names_ = nullptr; ///< files to read
  std::string* output_ = nullptr;             ///< what comes after them
  const char* output_name_ = nullptr;
  std::string json_file_;
  bool print_config_ = false;
  std::vector<std::string> warnings_;
  nlohmann::ordered_json seconds_;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

} // namespace linelet::apps
