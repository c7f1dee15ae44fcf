// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/schedule.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace linelet::fragments {

namespace {

/** The best device of a fragment, the time at which it would be done there, and by how
 * much the second best is later. */
struct Choice {
  std::size_t device = 0;
  double completion = std::numeric_limits<double>::infinity();
  double sufferage = 0;
};

Choice
choose(const ExpectedTimes& times,
       std::size_t fragment,
       const std::vector<double>& load)
{
  Choice best;
  double second = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < load.size(); ++d) {
    const double completion = load[d] + times(fragment, d);
    if (completion < best.completion) {
      second = best.completion;
      best.device = d;
      best.completion = completion;
    }
    else
      second = std::min(second, completion);
  }
  best.sufferage = std::isfinite(second) ? second - best.completion : 0;
  return best;
}

void
check(const ExpectedTimes& times)
{
  for (std::size_t f = 0; f < times.fragments(); ++f)
    for (std::size_t d = 0; d < times.devices(); ++d)
      if (!(times(f, d) >= 0) || !std::isfinite(times(f, d)))
        throw std::invalid_argument("expected times must be finite and not negative");
}

/** Assigns one fragment after the other: the one that comes \a before all others. */
template <class Before>
Schedule
assign(const ExpectedTimes& times, Before before)
{
  check(times);
  std::vector<double> load(times.devices(), 0.0);
  std::vector<std::size_t> left(times.fragments());
  std::iota(left.begin(), left.end(), std::size_t{0});
  Schedule schedule;
  while (!left.empty()) {
    std::size_t taken = 0;
    Choice choice = choose(times, left[0], load);
    for (std::size_t i = 1; i < left.size(); ++i) {
      const Choice other = choose(times, left[i], load);
      if (before(other, choice)) {
        taken = i;
        choice = other;
      }
    }
    schedule.push_back(
        {left[taken], choice.device, load[choice.device], choice.completion});
    load[choice.device] = choice.completion;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(taken));
  }
  return schedule;
}

bool
endsLater(const Choice& a, const Choice& b)
{
  return a.completion > b.completion;
}

/** With two equal devices all fragments suffer alike, except for rounding: the longest
 * one then goes first. */
bool
suffersMore(const Choice& a, const Choice& b)
{
  const double tie = 1e-9 * (a.completion + b.completion);
  if (std::abs(a.sufferage - b.sufferage) > tie)
    return a.sufferage > b.sufferage;
  return endsLater(a, b);
}

} // namespace

double
makespan(const Schedule& schedule)
{
  double last = 0;
  for (const Assignment& assignment : schedule)
    last = std::max(last, assignment.end);
  return last;
}

Schedule
minMin(const ExpectedTimes& times)
{
  return assign(times,
                [](const Choice& a, const Choice& b) { return endsLater(b, a); });
}

Schedule
maxMin(const ExpectedTimes& times)
{
  return assign(times, endsLater);
}

Schedule
sufferage(const ExpectedTimes& times)
{
  return assign(times, suffersMore);
}

} // namespace linelet::fragments
