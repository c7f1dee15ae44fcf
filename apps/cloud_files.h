// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/io/cloud.h>
#include <linelet/io/file_summary.h>
#include <linelet/io/input_list.h>
#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>

#include "frame.h"

namespace linelet::apps {

/** \brief What to do about coordinates in degrees. */
constexpr const char* projection_help =
    "project it first, for example with pdal translate IN OUT.las reprojection "
    "--filters.reprojection.out_srs=EPSG:25832 (the code of your zone)";

/** \brief Warns if \a cloud, read from \a path, is in degrees. */
void
warnOfDegrees(const io::Cloud& cloud, const std::string& path, Frame& frame);

/** \brief The values of the attribute \a name of \a cloud, read from \a file.
 * \throws io::FileError if there is no such attribute */
std::vector<double>
valuesOf(const io::Cloud& cloud, const std::string& name, const std::string& file);

/** \brief The point files that a command reads: its argument INPUT (files, folders,
 * virtual point clouds, lists) and its options. All share one reference system. */
class CloudInput {
public:
  /** \brief What the points are used for. */
  enum class Use {
    Copy,     ///< nothing is computed from them
    Analysis, ///< filtered by class, with a warning about degrees
    Lengths   ///< the same, but degrees are rejected
  };

  /** \param[in] frame gets argument and options; must outlive this */
  explicit CloudInput(Frame& frame,
                      Use use = Use::Analysis,
                      const std::string& meaning =
                          "point files, folders of them, .vpc, "
                          "or .txt lists of paths");

  /** \brief The files; known once the frame has parsed. */
  const std::vector<std::string>&
  files();

  /** \brief Whether each file gets its own output, in a folder. */
  bool
  several();

  /** \brief Reads only the attributes \a names, and those that select the points of an
   * analysis: for commands that do not copy attributes. */
  void
  readOnly(std::vector<std::string> names);

  /** \brief The first input named, for messages. */
  const std::string&
  path() const
  {
    return names_.front();
  }

  /** \brief Which points are used. */
  const io::ClassFilter&
  classes() const
  {
    return classes_;
  }

  /** \brief The headers of the files.
   * \throws io::FileError if they differ in reference system */
  const std::vector<io::FileSummary>&
  summaries();

  /** \brief The same for commands that read no points: warns if a selection of points
   * was requested. */
  const std::vector<io::FileSummary>&
  headers();

  /** \brief How the files are read. */
  io::ReadOptions
  readOptions() const;

  /** \brief The shift that \ref read applies to all files, and its warnings, from the
   * first points of the first file. */
  Point
  shift();

  /** \brief Reads all files as one cloud; losses are reported as warnings, as are
   * degrees that an analysis would take for lengths.
   * \throws io::FileError */
  io::Cloud
  read();

  /** \brief Reads one of the files. */
  io::Cloud
  read(std::size_t number);

  /** \brief The points of one file among those of the others, in the order of the
   * files. */
  struct Surroundings {
    Points points;
    CloudPiece piece;           ///< which of them belong to the file
    std::vector<double> values; ///< of the requested field, one per point
  };

  /** \brief The usable points of file \a number, and those of the other files that are
   * nearer than \a distance to their box, relative to its shift.
   * \param[in] cloud the file as read, \a usable its usable points
   * \param[in] field attribute whose values are also needed, or empty
   * \throws io::FileError */
  Surroundings
  surroundings(std::size_t number,
               const io::Cloud& cloud,
               const io::UsablePoints& usable,
               double distance,
               const std::string& field = {});

  /** \brief The usable points of \a cloud, with a warning if some are not.
   * \throws io::FileError if classes are requested that it does not have */
  io::UsablePoints
  usable(const io::Cloud& cloud) const;

private:
  io::Cloud
  readFile(const std::string& path);
  void
  checkReference(const std::string& path, const std::string& wkt);
  void
  chooseShift();
  void
  checkUnits(const io::Cloud& cloud, const std::string& path);

  Frame& frame_;
  Use use_;
  std::vector<std::string> names_;
  io::InputList list_;
  std::vector<io::FileSummary> summaries_; ///< of the files, once needed
  std::string reference_, reference_file_; ///< of the first file that has one
  // The box of all files, with the summaries.
  Point low_ = Point::Constant(std::numeric_limits<double>::infinity()), high_ = -low_;
  io::ReadOptions options_;
  io::ClassFilter classes_;
};

/** \brief The point file that a command writes: its argument OUTPUT and its options. */
class CloudOutput {
public:
  enum class Inputs { None, Some };

  /** \param[in] frame gets argument and options; must outlive this
   * \param[in] inputs if the command reads several files, the output is a folder */
  explicit CloudOutput(Frame& frame, Inputs inputs = Inputs::Some);

  const std::string&
  path() const
  {
    return path_;
  }

  /** \brief Fails before long work if \ref write would fail after it; creates the
   * folder for several outputs.
   * \throws io::FileError */
  void
  check(CloudInput& input);
  void
  check() const;

  /** \brief The output path for file \a number of \a input. */
  std::string
  pathFor(CloudInput& input, std::size_t number) const;

  /** \brief Writes \a cloud to \a path, one of \ref pathFor, with a warning about what
   * the format cannot hold.
   * \throws io::FileError */
  void
  write(const io::Cloud& cloud, const std::string& path);
  void
  write(const io::Cloud& cloud)
  {
    write(cloud, path_);
  }

private:
  Frame& frame_;
  std::string path_;
  io::WriteOptions options_;
};

/** \brief Makes \a member of \a records, one per point, an attribute of \a cloud. */
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
