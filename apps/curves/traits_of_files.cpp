// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "traits_of_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include <linelet/io/point_stream.h>

namespace linelet::apps {

namespace {

constexpr double most = 1e6, of_square = 1e4; // points

/** \brief Some of the squares of the plane. */
class RandomSquares {
public:
  explicit RandomSquares(CloudInput& input)
  {
    double points = 0, area = 0;
    for (const io::FileSummary& file : input.summaries()) {
      points += static_cast<double>(file.points);
      area += (file.high.x() - file.low.x()) * (file.high.y() - file.low.y());
    }
    side_ = std::sqrt(area * of_square / std::max(points, 1.0));
    every_ = side_ > 0 ? static_cast<std::uint64_t>(std::ceil(points / most)) : 1;
  }

  bool
  hold(const Point& p) const
  {
    if (every_ <= 1)
      return true;
    const auto number = [&](double x) {
      return static_cast<std::uint64_t>(
          static_cast<std::int64_t>(std::floor(x / side_)));
    };
    // Murmur3's finalizer.
    std::uint64_t hash = number(p.x()) * 0x9e3779b97f4a7c15U + number(p.y());
    hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdU;
    hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53U;
    return (hash ^ (hash >> 33)) % every_ == 0;
  }

private:
  double side_ = 0;
  std::uint64_t every_ = 1;
};

} // namespace

CloudTraits
traitsOfFiles(CloudInput& input, unsigned threads, ProgressMonitor* monitor)
{
  const RandomSquares squares(input);
  io::ReadOptions options = input.readOptions();
  options.shift = input.shift();
  Points some;
  double count = 0;
  Eigen::AlignedBox3d box;
  for (const std::string& file : input.files()) {
    io::PointStream stream(file, options, 400000, nullptr, monitor);
    io::Cloud cloud;
    while (stream.next(cloud)) {
      throwIfCanceled(monitor);
      const io::UsablePoints usable(cloud, nullptr, input.classes());
      for (const Point& p : usable.points())
        if (p.allFinite()) {
          ++count;
          box.extend(p);
          if (squares.hold(p + cloud.shift))
            some.push_back(p);
        }
    }
  }
  CloudTraits traits = cloudTraits(some, threads);
  traits.points = std::max(traits.points, count);
  traits.extent = box.isEmpty() ? 0 : box.diagonal().norm();
  return traits;
}

} // namespace linelet::apps
