// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief What is done, in one small file each, written beside and renamed: whoever is
 * killed leaves an entry or none. Any number of workers may write, and those that do
 * the same write the same but for times. */
class Ledger {
public:
  /** \brief Kinds of work; names of folders. */
  static constexpr const char* cut = "cut";       ///< an input into pieces
  static constexpr const char* task = "task";     ///< a fragment
  static constexpr const char* output = "output"; ///< an output written

  struct Entry {
    bool done = false;  ///< else it failed
    std::string reason; ///< why it failed, with the file's name
    double points = 0, seconds = 0, peak_bytes = 0;
    std::string device;                          ///< that computed it, or empty
    std::map<std::size_t, std::uint64_t> pieces; ///< cut: points by fragment
    std::map<std::string, double> figures;       ///< what a command has to add up
  };

  /** \param[in] fingerprint of the plan; entries with another one do not count */
  Ledger(std::string folder, std::string fingerprint);

  /** \brief The entry of \a number; nothing where there is none that counts. */
  std::optional<Entry>
  find(const char* kind, std::size_t number) const;

  bool
  done(const char* kind, std::size_t number) const;

  /** \throws io::FileError */
  void
  write(const char* kind, std::size_t number, const Entry& entry) const;

  /** \brief Forgets that something failed, so that it is tried again. */
  void
  forgetFailures() const;

  /** \brief Removes what workers waited for each other with, once all is done. */
  void
  removeLocks() const;

  /** \brief The file of an entry; beside it, workers wait for each other. */
  std::string
  path(const char* kind, std::size_t number) const;

private:
  std::string folder_, fingerprint_;
};

/** \brief Holds \a path locked among the processes of all workers that share the file
 * system, as far as that knows locks; a process that dies lets go. */
class WorkLock {
public:
  explicit WorkLock(const std::string& path);
  ~WorkLock();
  WorkLock(const WorkLock&) = delete;
  WorkLock&
  operator=(const WorkLock&) = delete;

private:
  int file_;
};

} // namespace fragments
} // namespace linelet
