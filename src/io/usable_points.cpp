// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/usable_points.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "io/text/text_scan.h"

namespace linelet::io {

namespace {

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
      throw std::invalid_argument("'" + std::string(text) +
                                  "' is no list of classes, such as 7,18 (0 to 255)");
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
  std::set<int> numbers; // of the points that are left out for them
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (flags != nullptr && valueAt(*flags, i) != 0) {
      leaveOut(i);
      ++withheld_;
      continue;
    }
    if (labels == nullptr)
      continue;
    const double label = valueAt(*labels, i);
    const int number = label >= 0 && label < 256 ? static_cast<int>(label) : -1;
    if (classes.passes(number))
      continue;
    leaveOut(i);
    ++ignored_;
    numbers.insert(number);
  }
  if (warnings == nullptr)
    return;
  const std::string of = " of " + std::to_string(cloud.points.size()) + " points ";
  if (withheld_ > 0)
    warnings->push_back(std::to_string(withheld_) + of +
                        "are flagged as withheld and take no part");
  if (ignored_ > 0)
    warnings->push_back(
        std::to_string(ignored_) + of + "are of class " + listOf(numbers) +
        " and take no part" +
        (classes.kept.empty() ? "; --ignore-classes chooses which do not" : ""));
}

void
UsablePoints::leaveOut(std::size_t i)
{
  if (usable_.empty())
    usable_ = cloud_.points;
  usable_[i].setConstant(std::numeric_limits<double>::quiet_NaN());
}

} // namespace linelet::io
