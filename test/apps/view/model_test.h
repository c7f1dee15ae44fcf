// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include <linelet/io/point_file.h>

#include "model/model.h"

namespace linelet::test {

/** \brief A test with a model and its own folder. */
class ModelTest : public testing::Test {
protected:
  ModelTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("linelet_view_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder_);
  }
  ~ModelTest() override { std::filesystem::remove_all(folder_); }

  std::string
  path(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  std::string
  write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  /** \brief A noisy wire above noisy ground, far from the origin: 600 and 1400 points.
   */
  std::string
  writeWire() const
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 20);
    std::normal_distribution<double> noise(0, 0.02);
    io::Cloud cloud;
    cloud.shift = Point(500000, 5900000, 50);
    for (int i = 0; i < 600; ++i)
      cloud.points.emplace_back(i / 30.0, 10 + noise(random), 6 + noise(random));
    for (int i = 0; i < 1400; ++i)
      cloud.points.emplace_back(place(random), place(random), noise(random));
    io::writeCloud(path("wire.las"), cloud);
    return path("wire.las");
  }

  /** \brief Opens \a name; the test fails with the reason if it cannot. */
  void
  open(const std::string& name, const std::string& truth = {})
  {
    model.open({name}, truth);
    EXPECT_EQ(model.wait().error, "");
  }

  std::filesystem::path folder_;
  view::Model model;
};

} // namespace linelet::test
