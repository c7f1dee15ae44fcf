// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The memory of a run in fragments depends on --memory, not on the size of the cloud.

#include <sys/resource.h>

#include <linelet/io/point_file.h>

#include "tiles_test.h"

namespace linelet::test {

class FragmentsMemoryTest : public TilesTest {
protected:
  void
  SetUp() override
  {
  }

  /** The bundled corridor \a count times in a row. \return the folder */
  std::string
  corridors(int count) const
  {
    std::string folder = path("of_" + std::to_string(count));
    fs::create_directories(folder);
    io::Cloud cloud =
        io::readCloud(std::string(LINELET_SOURCE_DIR) + "/data/corridor.las");
    double low = 1e30, high = -1e30;
    for (const Point& p : cloud.points) {
      low = std::min(low, p.x());
      high = std::max(high, p.x());
    }
    for (int k = 0; k < count; ++k) {
      io::writeCloud(folder + "/t" + std::to_string(k) + ".laz", cloud);
      cloud.shift.x() += std::ceil(high - low);
    }
    return folder;
  }

  /** Peak memory of a run of the tool, in megabytes. */
  static double
  peakOf(const std::vector<std::string>& arguments)
  {
    const pid_t child = start(arguments);
    int status = 0;
    struct rusage usage {};
    EXPECT_EQ(::wait4(child, &status, 0, &usage), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    return static_cast<double>(usage.ru_maxrss) / 1024;
  }

  /** Peak memory for power lines in \a count corridors. */
  double
  peakOfPowerLines(int count) const
  {
    const std::string result = path("result_" + std::to_string(count));
    return peakOf({"powerlines",
                   "--threads",
                   "1",
                   "--memory",
                   "64M",
                   "--buffer",
                   "60",
                   corridors(count),
                   result});
  }
};

TEST_F(FragmentsMemoryTest, PowerLinesTakeNoMoreForMoreTiles)
{
  const double few = peakOfPowerLines(6), many = peakOfPowerLines(12);
  // Measured: 156 MB, and 135 to 138 depending on where the boxes lie. It grew by 27 MB
  // for every six tiles when each fragment kept all points that the report might draw.
  EXPECT_LT(many, few + 5) << few << " MB for 6 tiles, " << many << " for 12";
}

} // namespace linelet::test
