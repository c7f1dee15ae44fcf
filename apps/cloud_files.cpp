// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_files.h"

#include <linelet/io/output_check.h>

#include "options.h"

namespace linelet::apps {

void
warnOfDegrees(const io::Cloud& cloud, const std::string& path, Frame& frame)
{
  if (const std::string why = io::degreesIn(cloud); !why.empty())
    frame.warn(path + ": " + why +
               ", which are no lengths: distances, shapes and densities in its plan "
               "mean nothing; " +
               projection_help);
}

CloudInput::CloudInput(Frame& frame, Use use, const std::string& meaning)
    : frame_(frame), use_(use)
{
  frame.app.add_option("INPUT", path_, meaning)->required();
  frame.reads(path_);
  addOptions(frame.app, options_);
  if (use != Use::Copy)
    addOptions(frame.app, classes_);
}

io::Cloud
CloudInput::read()
{
  std::vector<std::string> warnings;
  io::Cloud cloud = io::readCloud(path_, options_, &warnings, &frame_.monitor);
  frame_.warn(warnings);
  if (use_ == Use::Analysis)
    warnOfDegrees(cloud, path_, frame_);
  else if (const std::string why = io::degreesIn(cloud);
           use_ == Use::Lengths && !why.empty())
    throw io::FileError(path_ + ": " + why + ", and it needs lengths; " +
                        projection_help);
  frame_.lap("read");
  return cloud;
}

io::UsablePoints
CloudInput::usable(const io::Cloud& cloud) const
{
  if (!classes_.kept.empty() && cloud.find("classification") == nullptr)
    throw io::FileError(path_ +
                        ": its points have no classes; leave out --keep-classes");
  std::vector<std::string> warnings;
  io::UsablePoints usable(cloud, &warnings, classes_);
  frame_.warn(warnings);
  if (usable.leftOut() == cloud.points.size() && usable.ignored() > 0)
    frame_.warn(path_ + ": no point is left; linelet info lists the classes it has");
  return usable;
}

CloudOutput::CloudOutput(Frame& frame) : frame_(frame)
{
  frame.app.add_option("OUTPUT", path_, "point file, in the format of its ending")
      ->required();
  frame.writes(path_);
  addOptions(frame.app, options_);
}

void
CloudOutput::check() const
{
  io::checkCloudOutput(path_);
}

void
CloudOutput::write(const io::Cloud& cloud)
{
  std::vector<std::string> warnings;
  io::writeCloud(path_, cloud, options_, &warnings, &frame_.monitor);
  frame_.warn(warnings);
  frame_.lap("write");
}

} // namespace linelet::apps
