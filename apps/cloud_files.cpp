// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <linelet/io/merge.h>
#include <linelet/io/output_check.h>
#include <linelet/io/point_stream.h>
#include <linelet/io/whole_shift.h>

#include "options.h"

namespace linelet::apps {

void
warnOfDegrees(const io::Cloud& cloud, const std::string& path, Frame& frame)
{
  if (const std::string why = io::degreesIn(cloud); !why.empty())
    frame.warn(path + ": " + why +
               ", so that distances, shapes and densities in plan are "
               "meaningless; " +
               projection_help);
}

namespace {

/** The attributes that io::UsablePoints needs. */
const std::vector<std::string> choosing = {"classification", "withheld"};

} // namespace

std::vector<double>
valuesOf(const io::Cloud& cloud, const std::string& name, const std::string& file)
{
  std::vector<double> values;
  if (const io::Column* column = cloud.find(name)) {
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      values.push_back(io::valueAt(*column, i));
    return values;
  }
  std::string names;
  for (const io::Column& column : cloud.columns)
    names += " " + column.name;
  throw io::FileError(file + ": there is no field '" + name + "'; it has" +
                      (names.empty() ? " none" : names));
}

CloudInput::CloudInput(Frame& frame, Use use, const std::string& meaning)
    : frame_(frame), use_(use)
{
  frame.addArgument("INPUT", names_, meaning);
  frame.reads(names_);
  addOptions(frame.app, options_);
  if (use != Use::Copy)
    addOptions(frame.app, classes_);
}

const std::vector<std::string>&
CloudInput::files()
{
  if (list_.files.empty())
    list_ = io::findInputs(names_);
  return list_.files;
}

bool
CloudInput::several()
{
  files();
  return list_.several;
}

void
CloudInput::readOnly(std::vector<std::string> names)
{
  if (use_ != Use::Copy)
    names.insert(names.end(), choosing.begin(), choosing.end());
  options_.attributes = std::move(names);
}

void
CloudInput::checkReference(const std::string& path, const std::string& wkt)
{
  const std::string name = io::referenceName(wkt);
  if (name.empty())
    return;
  if (reference_.empty()) {
    reference_ = name;
    reference_file_ = path;
  }
  if (name != reference_)
    throw io::FileError(
        path + ": its reference system is " + name + ", that of " + reference_file_ +
        " is " + reference_ +
        "; process them one by one, or reproject them to one system first");
}

const std::vector<io::FileSummary>&
CloudInput::summaries()
{
  if (!summaries_.empty())
    return summaries_;
  std::vector<std::string> warnings;
  for (const std::string& file : files()) {
    summaries_.push_back(io::summaryOf(file, options_, &warnings));
    const io::FileSummary& summary = summaries_.back();
    checkReference(file, summary.wkt);
    if (summary.points == 0)
      continue;
    low_ = low_.cwiseMin(summary.low);
    high_ = high_.cwiseMax(summary.high);
  }
  frame_.warn(warnings);
  return summaries_;
}

const std::vector<io::FileSummary>&
CloudInput::headers()
{
  if (!options_.bounds.empty() || !options_.bounds_3d.empty() ||
      options_.resolution > 0)
    frame_.warn("--bounds, --bounds-3d and --resolution have no effect on figures from "
                "headers");
  return summaries();
}

/** One shift for all files, that of a file with all their points. */
void
CloudInput::chooseShift()
{
  if (use_ == Use::Copy || files().size() < 2 || options_.shift)
    return;
  summaries();
  options_.shift = Point::Zero();
  for (int axis = 0; axis < 3; ++axis)
    (*options_.shift)[axis] = io::wholeShift(low_[axis], high_[axis]);
}

io::Cloud
CloudInput::readFile(const std::string& path)
{
  std::vector<std::string> warnings;
  options_.threads = frame_.threads;
  chooseShift();
  io::Cloud cloud = io::readCloud(path, options_, &warnings, &frame_.monitor);
  frame_.warn(warnings);
  checkReference(path, cloud.wkt);
  return cloud;
}

void
CloudInput::checkUnits(const io::Cloud& cloud, const std::string& path)
{
  if (use_ == Use::Analysis)
    warnOfDegrees(cloud, path, frame_);
  else if (const std::string why = io::degreesIn(cloud);
           use_ == Use::Lengths && !why.empty())
    throw io::FileError(path + ": " + why + ", but lengths are needed; " +
                        projection_help);
}

io::Cloud
CloudInput::read(std::size_t number)
{
  const std::string& path = files().at(number);
  io::Cloud cloud = readFile(path);
  checkUnits(cloud, path);
  frame_.lap("read");
  return cloud;
}

io::ReadOptions
CloudInput::readOptions() const
{
  io::ReadOptions options = options_;
  options.threads = frame_.threads;
  return options;
}

Point
CloudInput::shift()
{
  chooseShift();
  const std::string& path = files().front();
  io::ReadOptions options = readOptions();
  options.attributes.emplace(); // none
  io::Cloud cloud;
  io::PointStream(path, options, 1, nullptr, &frame_.monitor).next(cloud);
  checkUnits(cloud, path);
  return cloud.shift;
}

io::Cloud
CloudInput::read()
{
  io::Cloud cloud = read(0);
  std::vector<std::string> warnings;
  for (std::size_t i = 1; i < files().size(); ++i) {
    const io::Cloud more = read(i);
    io::append(cloud, more, &warnings);
    if (cloud.wkt.empty())
      cloud.wkt = more.wkt;
  }
  std::sort(warnings.begin(), warnings.end());
  warnings.erase(std::unique(warnings.begin(), warnings.end()), warnings.end());
  frame_.warn(warnings);
  return cloud;
}

namespace {

/** \brief Appends the points of \a all that are used. */
void
add(const io::Cloud& cloud,
    const io::UsablePoints& usable,
    const std::string& field,
    const std::string& file,
    const Point& shift,
    CloudInput::Surroundings& all)
{
  std::vector<double> values;
  if (!field.empty())
    values = valuesOf(cloud, field, file);
  const Point step = cloud.shift - shift;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    all.points.push_back(usable.points()[i] + step);
    if (!field.empty())
      all.values.push_back(values[i]);
  }
}

} // namespace

CloudInput::Surroundings
CloudInput::surroundings(std::size_t number,
                         const io::Cloud& cloud,
                         const io::UsablePoints& usable,
                         double distance,
                         const std::string& field)
{
  Surroundings all;
  if (files().size() > 1)
    summaries();
  all.piece.low = low_ - cloud.shift;
  all.piece.high = high_ - cloud.shift;

  if (!std::isfinite(distance))
    distance = (high_ - low_).norm() + 1;
  constexpr double none = std::numeric_limits<double>::infinity();
  Point low = Point::Constant(none), high = -low;
  for (const Point& point : usable.points())
    if (point.allFinite()) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  low += cloud.shift - Point::Constant(distance);
  high += cloud.shift + Point::Constant(distance);
  io::ReadOptions around = options_;
  if (around.bounds_3d.size() == 6)
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      low[axis] = std::max(low[axis], around.bounds_3d[a]);
      high[axis] = std::min(high[axis], around.bounds_3d[a + 3]);
    }
  around.bounds_3d = {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  around.shift = cloud.shift;
  if (field.empty())
    around.attributes = choosing;
  const bool any = (low.array() <= high.array()).all();
  for (std::size_t i = 0; i < files().size(); ++i) {
    if (i == number) {
      all.piece.begin = all.points.size();
      add(cloud, usable, field, files()[i], cloud.shift, all);
      all.piece.end = all.points.size();
      continue;
    }
    const io::FileSummary& other = summaries()[i];
    if (!any || (other.high.array() < low.array()).any() ||
        (other.low.array() > high.array()).any())
      continue;
    const io::Cloud near = io::readCloud(other.path, around, nullptr, &frame_.monitor);
    add(near,
        io::UsablePoints(near, nullptr, classes_),
        field,
        other.path,
        cloud.shift,
        all);
  }
  return all;
}

io::UsablePoints
CloudInput::usable(const io::Cloud& cloud) const
{
  if (!classes_.kept.empty() && cloud.find("classification") == nullptr)
    throw io::FileError(path() + ": its points have no classes; omit --keep-classes");
  std::vector<std::string> warnings;
  io::UsablePoints usable(cloud, &warnings, classes_);
  frame_.warn(warnings);
  if (usable.leftOut() == cloud.points.size() && usable.ignored() > 0)
    frame_.warn(path() + ": no points are left; linelet info lists the classes it has");
  return usable;
}

CloudOutput::CloudOutput(Frame& frame, Inputs inputs) : frame_(frame)
{
  std::string meaning = "point file, in the format of its ending";
  if (inputs == Inputs::Some)
    meaning += "; for several inputs, a folder for files of the same names";
  frame.addOutput("OUTPUT", path_, meaning);
  addOptions(frame.app, options_);
}

std::string
CloudOutput::pathFor(CloudInput& input, std::size_t number) const
{
  if (!input.several())
    return path_;
  // Outputs have no octree, so .copc is dropped from the name.
  std::string name =
      std::filesystem::path(input.files().at(number)).filename().string();
  if (const std::size_t at = name.rfind(".copc.laz"); at != std::string::npos)
    name.replace(at, std::string::npos, ".laz");
  return (std::filesystem::path(path_) / name).string();
}

void
CloudOutput::check() const
{
  io::checkCloudOutput(path_);
}

void
CloudOutput::check(CloudInput& input)
{
  if (!input.several())
    return check();
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (!std::filesystem::is_directory(path_))
    throw io::FileError(path_ +
                        ": is not a folder, which the outputs of several inputs "
                        "need; name a folder");
  std::vector<std::string> outputs;
  for (std::size_t i = 0; i < input.files().size(); ++i)
    outputs.push_back(pathFor(input, i));
  frame_.checkOutputs(outputs);
  for (const std::string& output : outputs)
    io::checkCloudOutput(output);
}

void
CloudOutput::write(const io::Cloud& cloud, const std::string& path)
{
  std::vector<std::string> warnings;
  io::writeCloud(path, cloud, options_, &warnings, &frame_.monitor);
  frame_.warn(warnings);
  frame_.lap("write");
}

} // namespace linelet::apps
