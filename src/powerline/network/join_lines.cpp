// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/join_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr double together = 0.05; // meters between ends that are one
constexpr int halvings = 30;      // of an edge, to find where it crosses a border

double
lengthOf(const Points& course)
{
  double sum = 0;
  for (std::size_t v = 1; v < course.size(); ++v)
    sum += (course[v] - course[v - 1]).norm();
  return sum;
}

/** Open ends of lines, by position. */
class Ends {
public:
  void
  add(std::size_t line, const Points& course)
  {
    cells_[cellOf(course.front(), 0, 0)].push_back({line, false, course.front()});
    cells_[cellOf(course.back(), 0, 0)].push_back({line, true, course.back()});
  }

  void
  remove(std::size_t line, const Points& course)
  {
    for (const Point& at : {course.front(), course.back()}) {
      std::vector<End>& there = cells_[cellOf(at, 0, 0)];
      there.erase(std::remove_if(there.begin(),
                                 there.end(),
                                 [&](const End& end) { return end.line == line; }),
                  there.end());
    }
  }

  /** The line that has an end at \a at, and whether that is its back. */
  std::optional<std::pair<std::size_t, bool>>
  find(const Point& at) const
  {
    for (const int i : {0, -1, 1})
      for (const int j : {0, -1, 1}) {
        const auto cell = cells_.find(cellOf(at, i, j));
        if (cell == cells_.end())
          continue;
        for (const auto& [line, back, place] : cell->second)
          if ((place - at).norm() < together)
            return std::pair(line, back);
      }
    return {};
  }

private:
  struct End {
    std::size_t line;
    bool back;
    Point at;
  };
  using Cell = std::pair<std::int64_t, std::int64_t>;

  static Cell
  cellOf(const Point& p, int i, int j)
  {
    return {std::llround(p.x()) + i, std::llround(p.y()) + j};
  }

  std::map<Cell, std::vector<End>> cells_;
};

} // namespace

std::vector<UnexplainedLine>
clipLine(const UnexplainedLine& line,
         const std::function<bool(double x, double y)>& owns)
{
  std::vector<UnexplainedLine> parts;
  const auto inside = [&](const Point& p) { return owns(p.x(), p.y()); };
  const auto border = [&](Point in, Point out) {
    for (int k = 0; k < halvings; ++k) {
      const Point middle = (in + out) / 2;
      (inside(middle) ? in : out) = middle;
    }
    return in;
  };
  bool open = false;
  for (std::size_t v = 0; v < line.course.size(); ++v) {
    const Point& p = line.course[v];
    const bool is_in = inside(p);
    if (is_in && !open) {
      parts.push_back(line);
      parts.back().course.clear();
      if (v > 0)
        parts.back().course.push_back(border(p, line.course[v - 1]));
    }
    if (is_in)
      parts.back().course.push_back(p);
    else if (open)
      parts.back().course.push_back(border(line.course[v - 1], p));
    open = is_in;
  }
  if (parts.size() == 1 && parts.front().course.size() == line.course.size())
    return {line};
  for (UnexplainedLine& part : parts) {
    part.length = lengthOf(part.course);
    part.points = static_cast<std::size_t>(std::llround(
        static_cast<double>(line.points) * part.length / std::max(line.length, 1e-9)));
  }
  return parts;
}

void
joinLines(std::vector<UnexplainedLine>& lines)
{
  Ends ends;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].course.size() > 1)
      ends.add(k, lines[k].course);
  std::vector<bool> gone(lines.size(), false);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (gone[k] || lines[k].course.size() < 2)
      continue;
    ends.remove(k, lines[k].course);
    for (const bool back : {true, false})
      while (const auto next =
                 ends.find(back ? lines[k].course.back() : lines[k].course.front())) {
        UnexplainedLine& other = lines[next->first];
        ends.remove(next->first, other.course);
        gone[next->first] = true;
        if (next->second == back)
          std::reverse(other.course.begin(), other.course.end());
        Points& course = lines[k].course;
        if (back)
          course.insert(course.end(), other.course.begin() + 1, other.course.end());
        else
          course.insert(course.begin(), other.course.begin(), other.course.end() - 1);
        lines[k].length += other.length;
        lines[k].points += other.points;
        lines[k].width = std::max(lines[k].width, other.width);
      }
  }
  std::vector<UnexplainedLine> joined;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (!gone[k])
      joined.push_back(std::move(lines[k]));
  const auto key = [](const UnexplainedLine& line) {
    const Point& p = line.course.front();
    return std::tuple(-line.length, p.x(), p.y(), p.z());
  };
  std::sort(joined.begin(), joined.end(), [&](const auto& a, const auto& b) {
    return key(a) < key(b);
  });
  for (std::size_t k = 0; k < joined.size(); ++k)
    joined[k].id = static_cast<int>(k) + 1;
  lines = std::move(joined);
}

} // namespace linelet::powerline
