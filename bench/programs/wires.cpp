// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Accuracy and speed of wire extraction on classified tiles (the classes are the truth
// and are hidden from the extraction):
//
//   benchmark_wires [--thin N [SEED]] TILE.las ...
//
// One line per tile: precision, recall and F1 of wire points, their F1 farther than 6 m
// (in plan) from pylon points, F1 of pylon points, vectors, supports, seconds, and
// number of false vectors: those with most points neither wire nor pylon. --thin keeps
// one point in N, drawn with SEED (1).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <boost/random/mersenne_twister.hpp>

#include <linelet/io/point_file.h>
#include <linelet/powerline/extract_power_lines.h>

namespace {

using linelet::Point;
using linelet::Points;

struct Score {
  double hit = 0, extra = 0, missed = 0;

  void
  add(bool is, bool found)
  {
    hit += is && found;
    extra += !is && found;
    missed += is && !found;
  }

  double
  f1() const
  {
    return 2 * hit / (2 * hit + extra + missed);
  }
};

/** Points of pylons in a raster of 6 m. */
class Pylons {
public:
  void
  add(const Point& p)
  {
    cells_[cell(p, 0, 0)].push_back(p);
  }

  bool
  near(const Point& p) const
  {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        if (const auto found = cells_.find(cell(p, dx, dy)); found != cells_.end())
          for (const Point& q : found->second)
            if ((p - q).head<2>().norm() <= reach)
              return true;
    return false;
  }

private:
  static constexpr double reach = 6;

  static std::pair<int, int>
  cell(const Point& p, int dx, int dy)
  {
    return {static_cast<int>(std::floor(p.x() / reach)) + dx,
            static_cast<int>(std::floor(p.y() / reach)) + dy};
  }

  std::map<std::pair<int, int>, Points> cells_;
};

struct Tile {
  Points points;
  std::vector<double> classes;
};

/** One point in \a thin on average, drawn with \a seed. */
Tile
read(const std::string& path, unsigned thin, unsigned seed)
{
  const linelet::io::Cloud cloud = linelet::io::readCloud(path);
  const linelet::io::Column* classes = cloud.find("classification");
  if (classes == nullptr)
    throw std::runtime_error(path + ": has no classes to compare with");
  Tile tile;
  boost::random::mt19937 random(seed);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (thin <= 1 || random() % thin == 0) {
      tile.points.push_back(cloud.points[i]);
      tile.classes.push_back(linelet::io::valueAt(*classes, i));
    }
  return tile;
}

std::size_t
countFalse(const Tile& tile, const linelet::powerline::PowerLineNetwork& network)
{
  std::vector<Score> wires(network.wires.size() + 1);
  for (std::size_t i = 0; i < tile.points.size(); ++i)
    if (const int id = network.wire_id[i]; id > 0)
      wires[static_cast<std::size_t>(id)].add(
          tile.classes[i] == linelet::powerline::wire_class ||
              tile.classes[i] == linelet::powerline::pylon_class,
          true);
  return static_cast<std::size_t>(
      std::count_if(wires.begin(), wires.end(), [](const Score& wire) {
        return wire.extra > wire.hit;
      }));
}

void
measure(const std::string& path, unsigned thin, unsigned seed)
{
  const Tile cloud = read(path, thin, seed);
  const auto network = linelet::powerline::extractPowerLines(cloud.points);
  Pylons pylons;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.classes[i] == linelet::powerline::pylon_class)
      pylons.add(cloud.points[i]);
  Score wire, away, pylon;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double truth = cloud.classes[i];
    const bool is = truth == linelet::powerline::wire_class;
    const bool found = network.classes[i] == linelet::powerline::wire_class;
    wire.add(is, found);
    if ((is || found) && !pylons.near(cloud.points[i]))
      away.add(is, found);
    pylon.add(truth == linelet::powerline::pylon_class,
              network.classes[i] == linelet::powerline::pylon_class);
  }
  double seconds = 0;
  for (const auto& stage : network.stages)
    seconds += stage.seconds;
  std::printf("%6.4f %6.4f %6.4f %6.4f %6.4f %6zu %6zu %7.3f %6zu  %s\n",
              wire.hit / (wire.hit + wire.extra),
              wire.hit / (wire.hit + wire.missed),
              wire.f1(),
              away.f1(),
              pylon.f1(),
              network.wires.size(),
              network.supports.size(),
              seconds,
              countFalse(cloud, network),
              path.c_str());
}

} // namespace

int
main(int count, char** arguments)
{
  std::printf("%6s %6s %6s %6s %6s %6s %6s %7s %6s\n",
              "P",
              "R",
              "F1",
              "away",
              "pylon",
              "wires",
              "supp.",
              "s",
              "false");
  try {
    std::vector<std::string> words(arguments + 1, arguments + count);
    unsigned thin = 1, seed = 1;
    const auto takeNumber = [&](std::size_t at, unsigned& number) {
      if (words.size() <= at ||
          words[at].find_first_not_of("0123456789") != std::string::npos)
        return false;
      number = static_cast<unsigned>(std::stoul(words[at]));
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
      return true;
    };
    if (!words.empty() && words[0] == "--thin") {
      if (!takeNumber(1, thin))
        throw std::invalid_argument("--thin needs a number");
      takeNumber(1, seed);
      words.erase(words.begin());
    }
    for (const std::string& path : words)
      measure(path, thin, seed);
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_wires: %s\n", error.what());
    return 1;
  }
  return 0;
}
