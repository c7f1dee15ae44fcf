// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/usable_points.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <stdexcept>

#include "io/text_scan.h"

namespace linelet::io {

namespace {

/** Values of \a column from \a first on. */
void
copyValues(const Column& column, std::size_t first, std::size_t count, double* out)
{
  std::visit(
      [&](const auto& values) {
        for (std::size_t k = 0; k < count; ++k)
          out[k] = static_cast<double>(values[first + k]);
      },
      column.values);
}

std::string
listOf(const std::set<int>& numbers)
{
  std::string list;
  for (const int number : numbers)
    list += (list.empty() ? "" : ", ") + std::to_string(number);
  return list;
}

} // namespace

ClassList::ClassList(std::string_view text) : text_(text)
{
  if (text == "none" || text == "all")
    return;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view word = rest.substr(0, rest.find(','));
    int number = 0;
    if (!parseNumber(word, number) || number < 0 || number > 255)
      throw std::invalid_argument(
          "'" + std::string(text) +
          "' is not a list of classes, such as 7,18 (0 to 255)");
    numbers_.push_back(number);
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
  }
}

bool
ClassList::contains(int number) const
{
  return std::find(numbers_.begin(), numbers_.end(), number) != numbers_.end();
}

bool
ClassFilter::passes(int number) const
{
  return kept.empty() ? !ignored.contains(number) : kept.contains(number);
}

UsablePoints::UsablePoints(const Cloud& cloud,
                           std::vector<std::string>* warnings,
                           const ClassFilter& classes)
    : cloud_(cloud)
{
  const Column* flags = cloud.find("withheld");
  const Column* labels = cloud.find("classification");
  std::set<int> numbers;        // of the points left out
  std::array<bool, 257> passes; // by number; the last one: not a class
  for (int number = -1; number < 256; ++number)
    passes[static_cast<std::size_t>(number < 0 ? 256 : number)] =
        classes.passes(number);
  constexpr std::size_t block = 4096;
  std::array<double, block> flag{}, label{};
  for (std::size_t first = 0; first < cloud.points.size(); first += block) {
    const std::size_t count = std::min(block, cloud.points.size() - first);
    if (flags != nullptr)
      copyValues(*flags, first, count, flag.data());
    if (labels != nullptr)
      copyValues(*labels, first, count, label.data());
    for (std::size_t k = 0; k < count; ++k) {
      if (flag[k] != 0) {
        leaveOut(first + k);
        ++withheld_;
        continue;
      }
      if (labels == nullptr)
        continue;
      const int number =
          label[k] >= 0 && label[k] < 256 ? static_cast<int>(label[k]) : -1;
      if (passes[static_cast<std::size_t>(number < 0 ? 256 : number)])
        continue;
      leaveOut(first + k);
      ++ignored_;
      numbers.insert(number);
    }
  }
  if (warnings == nullptr)
    return;
  const std::string of = " of " + std::to_string(cloud.points.size()) + " points ";
  if (withheld_ > 0)
    warnings->push_back(std::to_string(withheld_) + of +
                        "are flagged as withheld and were ignored");
  if (ignored_ > 0)
    warnings->push_back(std::to_string(ignored_) + of + "are of class " +
                        listOf(numbers) + " and were ignored" +
                        (classes.kept.empty()
                             ? "; --ignore-classes chooses the classes to ignore"
                             : ""));
}

void
UsablePoints::leaveOut(std::size_t i)
{
  if (usable_.empty())
    usable_ = cloud_.points;
  usable_[i].setConstant(std::numeric_limits<double>::quiet_NaN());
}

} // namespace linelet::io
