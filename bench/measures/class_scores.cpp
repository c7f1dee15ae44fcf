// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include <bench/measures/wire_scores.h>

namespace linelet::bench {

namespace {

double
ratio(std::size_t part, std::size_t whole)
{
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

double
ClassScores::precision() const
{
  return ratio(right, right + false_alarms);
}

double
ClassScores::recall() const
{
  return ratio(right, right + missed);
}

double
ClassScores::f1() const
{
  return ratio(2 * right, 2 * right + false_alarms + missed);
}

ClassScores&
ClassScores::operator+=(const ClassScores& other)
{
  right += other.right;
  false_alarms += other.false_alarms;
  missed += other.missed;
  return *this;
}

ClassScores
scoreClass(const std::vector<std::uint8_t>& found,
           const std::vector<std::uint8_t>& truth,
           std::uint8_t classification,
           const std::vector<std::uint8_t>& ignored)
{
  if (found.size() != truth.size() ||
      (!ignored.empty() && ignored.size() != found.size()))
    throw std::invalid_argument(
        "classes to compare need the same points: " + std::to_string(found.size()) +
        " and " + std::to_string(truth.size()));
  ClassScores scores;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!ignored.empty() && ignored[i] != 0)
      continue;
    const bool is = truth[i] == classification, said = found[i] == classification;
    scores.right += is && said ? 1 : 0;
    scores.false_alarms += said && !is ? 1 : 0;
    scores.missed += is && !said ? 1 : 0;
  }
  return scores;
}

std::vector<std::uint8_t>
nearClass(const Points& points,
          const std::vector<std::uint8_t>& classes,
          std::uint8_t classification,
          double distance)
{
  // Cells as wide as the distance: whatever is near lies in the nine around a point.
  const auto cellOf = [&](const Point& p) {
    return std::pair<long, long>(std::lround(std::floor(p.x() / distance)),
                                 std::lround(std::floor(p.y() / distance)));
  };
  std::map<std::pair<long, long>, Indices> cells;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (classes[i] == classification)
      cells[cellOf(points[i])].push_back(static_cast<Index>(i));
  std::vector<std::uint8_t> near(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = cellOf(points[i]);
    for (long dx = -1; dx <= 1 && near[i] == 0; ++dx)
      for (long dy = -1; dy <= 1 && near[i] == 0; ++dy) {
        const auto cell = cells.find({x + dx, y + dy});
        if (cell == cells.end())
          continue;
        for (const Index k : cell->second)
          if ((points[k] - points[i]).head<2>().squaredNorm() <= distance * distance) {
            near[i] = 1;
            break;
          }
      }
  }
  return near;
}

} // namespace linelet::bench
