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

/** \brief A record of finished work, one small file per entry, replaced atomically: a
 * killed worker leaves a complete entry or none. Any number of workers may write;
 * workers that do the same work write the same entry, except for times. */
class Ledger {
public:
  /** \brief Kinds of work, which name the folders. */
  static constexpr const char* cut = "cut";       ///< an input into pieces
  static constexpr const char* task = "task";     ///< a fragment
  static constexpr const char* output = "output"; ///< an output written

  struct Entry {
    bool done = false;  ///< else it failed
    std::string reason; ///< why it failed, with the file's name
    double points = 0, seconds = 0, peak_bytes = 0;
    std::string device;                          ///< device that computed it, or empty
    std::map<std::size_t, std::uint64_t> pieces; ///< cut: points by fragment
    std::map<std::string, double> figures;       ///< totals that the command keeps
  };

  /** \param[in] fingerprint of the plan; entries with another one are ignored */
  Ledger(std::string folder, std::string fingerprint);

  /** \brief The entry of \a number; empty if there is no valid one. */
  std::optional<Entry>
  find(const char* kind, std::size_t number) const;

  bool
  done(const char* kind, std::size_t number) const;

  /** \throws io::FileError */
  void
  write(const char* kind, std::size_t number, const Entry& entry) const;

  /** \brief Removes failures, so that they are tried again. */
  void
  forgetFailures() const;

  /** \brief Removes the lock files once all is done. */
  void
  removeLocks() const;

  /** \brief The file of an entry, with its lock file beside it. */
  std::string
  path(const char* kind, std::size_t number) const;

private:
  std::string folder_, fingerprint_;
};

/** \brief Locks \a path against all workers that share the file system, if it supports
 * locks; released when the process ends. */
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
