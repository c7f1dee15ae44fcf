// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>

#include "frame.h"

namespace linelet::apps {

/** \brief What to do about coordinates that are degrees. */
constexpr const char* projection_help =
    "project it first, for example with pdal translate IN OUT.las reprojection "
    "--filters.reprojection.out_srs=EPSG:25832 (the code of your zone)";

/** \brief A warning where \a cloud, of the file \a path, is in degrees. */
void
warnOfDegrees(const io::Cloud& cloud, const std::string& path, Frame& frame);

/** \brief The point file that a command reads: its argument INPUT and its options. */
class CloudInput {
public:
  /** \brief What the points are read for. */
  enum class Use {
    Copy,     ///< nothing is made of them
    Analysis, ///< they are chosen by class, and degrees are warned of
    Lengths   ///< the same, but degrees are refused
  };

  /** \param[in] frame gets argument and options; must outlive this */
  explicit CloudInput(Frame& frame,
                      Use use = Use::Analysis,
                      const std::string& meaning = "point file");

  const std::string&
  path() const
  {
    return path_;
  }

  /** \brief Which points take part. */
  const io::ClassFilter&
  classes() const
  {
    return classes_;
  }

  /** \brief Reads the file; what is lost is told as a warning, as are degrees that an
   * analysis would take for lengths. \throws io::FileError */
  io::Cloud
  read();

  /** \brief The points of \a cloud, as read, that take part; a warning where some do
   * not. \throws io::FileError where classes are asked for that it does not have */
  io::UsablePoints
  usable(const io::Cloud& cloud) const;

private:
  Frame& frame_;
  Use use_;
  std::string path_;
  io::ReadOptions options_;
  io::ClassFilter classes_;
};

/** \brief The point file that a command writes: its argument OUTPUT and its options. */
class CloudOutput {
public:
  /** \param[in] frame gets argument and options; must outlive this */
  explicit CloudOutput(Frame& frame);

  const std::string&
  path() const
  {
    return path_;
  }

  /** \brief Fails at once where \ref write would fail after long work.
   * \throws io::FileError */
  void
  check() const;

  /** \brief Writes \a cloud; what the format cannot hold is told as a warning.
   * \throws io::FileError */
  void
  write(const io::Cloud& cloud);

private:
  Frame& frame_;
  std::string path_;
  io::WriteOptions options_;
};

/** \brief Makes \a member of \a records, one a point, an attribute of \a cloud. */
template <class Record, class T>
void
addColumn(io::Cloud& cloud,
          const std::vector<Record>& records,
          const char* name,
          T Record::*member,
          const char* description)
{
  std::vector<T> values;
  values.reserve(records.size());
  for (const Record& record : records)
    values.push_back(record.*member);
  cloud.set({name, std::move(values), description});
}

} // namespace linelet::apps
