// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/point_file.h>

namespace linelet::io {

/** \brief A point file to write, and whom to tell about losses. */
struct Target {
  std::string path;
  std::vector<std::string>* warnings = nullptr;
  Monitor* monitor = nullptr;

  void
  warn(const std::string& what) const
  {
    if (warnings != nullptr)
      warnings->push_back(path + ": " + what);
  }

  /** \brief Tells the monitor of \a steps more points. \throws Cancelled */
  void
  advance(std::size_t steps) const
  {
    if (monitor == nullptr)
      return;
    monitor->advance(steps);
    if (monitor->cancelled())
      throw Cancelled();
  }
};

void
writeLas(const Target& target, const Cloud& cloud);

void
writePcd(const Target& target, const Cloud& cloud);

void
writePly(const Target& target, const Cloud& cloud);

void
writeText(const Target& target, const Cloud& cloud);

void
writeObjVertices(const Target& target, const Cloud& cloud);

} // namespace linelet::io
