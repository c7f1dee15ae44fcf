// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "traits_of_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include <linelet/curves/refined_reconstruction.h>
#include <linelet/io/cloud_sink.h>
#include <linelet/io/point_stream.h>

namespace linelet::apps {

namespace {

constexpr double most = 1e6, of_square = 1e4; // points

/** \brief Some of the squares of the plane. */
class RandomSquares {
public:
  /** \brief All of them. */
  RandomSquares() = default;

  explicit RandomSquares(const std::vector<io::FileSummary>& files)
  {
    double points = 0, area = 0;
    for (const io::FileSummary& file : files) {
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

/** \brief The sample of points that the traits are estimated from. */
class Sample {
public:
  explicit Sample(const RandomSquares& squares) : squares_(squares) {}

  /** \param[in] p relative to \a shift */
  void
  add(const Point& p, const Point& shift)
  {
    if (!p.allFinite())
      return;
    ++count_;
    box_.extend(p);
    if (squares_.hold(p + shift))
      some_.push_back(p);
  }

  CloudTraits
  traits(unsigned threads) const
  {
    CloudTraits traits = cloudTraits(some_, threads);
    traits.points = count_;
    if (!box_.isEmpty()) {
      traits.low = box_.min();
      traits.high = box_.max();
    }
    return traits;
  }

private:
  RandomSquares squares_;
  Points some_;
  double count_ = 0;
  Eigen::AlignedBox3d box_;
};

} // namespace

CloudTraits
traitsOfFiles(CloudInput& input, unsigned threads, ProgressMonitor* monitor)
{
  Sample sample{RandomSquares(input.summaries())};
  io::ReadOptions options = input.readOptions();
  options.shift = input.shift();
  for (const std::string& file : input.files()) {
    io::PointStream stream(file, options, 400000, nullptr, monitor);
    io::Cloud cloud;
    while (stream.next(cloud)) {
      throwIfCanceled(monitor);
      const io::UsablePoints usable(cloud, nullptr, input.classes());
      for (const Point& p : usable.points())
        sample.add(p, cloud.shift);
    }
  }
  return sample.traits(threads);
}

CloudTraits
traitsOfCloud(CloudInput& input,
              const Points& points,
              const Point& shift,
              unsigned threads)
{
  // Chooses as fragments would, for files with fast headers.
  const bool choose =
      static_cast<double>(points.size()) > most &&
      std::all_of(input.files().begin(), input.files().end(), io::CloudSink::takes);
  Sample sample(choose ? RandomSquares(input.summaries()) : RandomSquares());
  for (const Point& p : points)
    sample.add(p, shift);
  return sample.traits(threads);
}

} // namespace linelet::apps
