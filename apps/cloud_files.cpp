// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_files.h"

#include <linelet/io/output_check.h>

#include "options.h"

namespace linelet::apps {

CloudInput::CloudInput(Frame& frame, const std::string& meaning) : frame_(frame)
{
  frame.app.add_option("INPUT", path_, meaning)->required();
  addOptions(frame.app, options_);
}

io::Cloud
CloudInput::read()
{
  std::vector<std::string> warnings;
  io::Cloud cloud = io::readCloud(path_, options_, &warnings, &frame_.monitor);
  frame_.warn(warnings);
  frame_.lap("read");
  return cloud;
}

io::UsablePoints
usablePoints(const io::Cloud& cloud, Frame& frame)
{
  std::vector<std::string> warnings;
  io::UsablePoints usable(cloud, &warnings);
  frame.warn(warnings);
  return usable;
}

CloudOutput::CloudOutput(Frame& frame) : frame_(frame)
{
  frame.app.add_option("OUTPUT", path_, "point file, in the format of its ending")
      ->required();
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
