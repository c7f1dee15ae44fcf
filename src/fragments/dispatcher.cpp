// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/dispatcher.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace linelet::fragments {

std::optional<std::size_t>
simpleH(const Waiting& waiting, bool slow)
{
  if (waiting.empty())
    return {};
  return slow ? waiting.front() : waiting.back();
}

std::optional<std::size_t>
simpleHS(const Waiting& waiting,
         bool slow,
         const std::vector<double>& points,
         const TimePrediction& on_slow,
         const TimePrediction& on_fastest)
{
  const auto taken = simpleH(waiting, slow);
  if (!taken || !slow || !on_slow.known() || !on_fastest.known())
    return taken;
  double all = 0;
  for (const std::size_t fragment : waiting)
    all += on_fastest(points[fragment]);
  return on_slow(points[*taken]) < all ? taken : std::nullopt;
}

Dispatcher::Dispatcher(Heuristic heuristic,
                       std::vector<double> points,
                       std::size_t devices,
                       std::size_t slow)
    : dynamic_(true),
      predicts_(heuristic == Heuristic::SimpleHS),
      points_(std::move(points)),
      slow_(devices > 1 ? slow : none),
      waiting_(points_.size()),
      on_(devices)
{
  if (heuristic != Heuristic::SimpleH && heuristic != Heuristic::SimpleHS)
    throw std::invalid_argument("a static heuristic needs expected times");
  std::iota(waiting_.begin(), waiting_.end(), std::size_t{0});
  std::stable_sort(waiting_.begin(), waiting_.end(), [this](auto a, auto b) {
    return points_[a] < points_[b];
  });
}

Dispatcher::Dispatcher(const Schedule& schedule, std::size_t devices)
    : dynamic_(false), queues_(devices)
{
  for (const Assignment& assignment : schedule)
    queues_.at(assignment.device).push_back(assignment.fragment);
}

std::optional<std::size_t>
Dispatcher::next(std::size_t device)
{
  Waiting& queue = dynamic_ ? waiting_ : queues_.at(device);
  if (!dynamic_) {
    if (queue.empty())
      return {};
    const std::size_t fragment = queue.front();
    queue.pop_front();
    return fragment;
  }
  const bool slow = device == slow_;
  // The fastest is the one expected to take least time for what comes next.
  const TimePrediction* fastest = nullptr;
  for (std::size_t d = 0; d < on_.size() && !queue.empty(); ++d)
    if (d != slow_ && on_[d].known() &&
        (fastest == nullptr ||
         on_[d](points_[queue.back()]) < (*fastest)(points_[queue.back()])))
      fastest = &on_[d];
  const auto taken = predicts_ && slow && fastest != nullptr
                         ? simpleHS(queue, slow, points_, on_[device], *fastest)
                         : simpleH(queue, slow);
  if (!taken)
    return {};
  if (slow)
    queue.pop_front();
  else
    queue.pop_back();
  return taken;
}

void
Dispatcher::finished(std::size_t fragment, std::size_t device, double seconds)
{
  if (predicts_)
    on_.at(device).add(points_.at(fragment), seconds);
}

namespace {

std::size_t
slowest(const ExpectedTimes& times)
{
  std::vector<double> sums(times.devices(), 0.0);
  for (std::size_t f = 0; f < times.fragments(); ++f)
    for (std::size_t d = 0; d < times.devices(); ++d)
      sums[d] += times(f, d);
  const auto [low, high] = std::minmax_element(sums.begin(), sums.end());
  return sums.empty() || *low == *high ? Dispatcher::none
                                       : static_cast<std::size_t>(high - sums.begin());
}

} // namespace

Dispatcher
dispatcherFor(Heuristic heuristic,
              const ExpectedTimes& times,
              const std::vector<double>& points)
{
  switch (heuristic) {
  case Heuristic::MinMin:
    return {minMin(times), times.devices()};
  case Heuristic::MaxMin:
    return {maxMin(times), times.devices()};
  case Heuristic::Sufferage:
    return {sufferage(times), times.devices()};
  default:
    break;
  }
  if (points.size() != times.fragments())
    throw std::invalid_argument("there must be as many numbers of points as fragments");
  return {heuristic, points, times.devices(), slowest(times)};
}

Schedule
simulate(Heuristic heuristic,
         const ExpectedTimes& times,
         const std::vector<double>& points)
{
  Dispatcher dispatcher = dispatcherFor(heuristic, times, points);
  std::vector<Assignment> running(times.devices());
  std::vector<bool> asks(times.devices(), true), busy(times.devices(), false);
  Schedule schedule;
  for (;;) {
    std::size_t device = Dispatcher::none;
    for (std::size_t d = 0; d < times.devices(); ++d)
      if (asks[d] &&
          (device == Dispatcher::none || running[d].end < running[device].end))
        device = d;
    if (device == Dispatcher::none)
      return schedule;
    const double now = running[device].end;
    // All devices that are done by now report before any gets its next fragment.
    for (std::size_t d = 0; d < times.devices(); ++d)
      if (busy[d] && running[d].end <= now) {
        dispatcher.finished(running[d].fragment, d, running[d].end - running[d].begin);
        busy[d] = false;
      }
    const auto fragment = dispatcher.next(device);
    asks[device] = fragment.has_value();
    if (!fragment)
      continue;
    running[device] = {*fragment, device, now, now + times(*fragment, device)};
    busy[device] = true;
    schedule.push_back(running[device]);
  }
}

} // namespace linelet::fragments
