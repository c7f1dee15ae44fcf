// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/line_poles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "powerline/pieces/growth.h"
#include "powerline/pieces/profile.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/vertical_slice.h"

namespace linelet::powerline {

namespace {

constexpr double least_mean_kink = 0.008; // change of slope, mean of the wires
constexpr double telling = 8;             // evidence of a kink ...
constexpr double enough_evidence = 25;    // evidence for a pole
constexpr double least_rest = 2;          // meters on both sides of a kink
// Log-likelihood ratios of pole to no pole: six in ten meters of a pole show points,
// and three in a hundred elsewhere.
constexpr double hit_meter = 3.0, missed_meter = -0.9;

} // namespace

/** The part of a wire that is searched, as one span. */
struct LinePoles::Stretch {
  const Profile& profile;
  double from, to;
  double count;   ///< of its points
  double squares; ///< of their deviations from one parabola
};

LinePoles::LinePoles(const std::vector<const Piece*>& wires, const Growth& growth)
    : axis_((*std::max_element(wires.begin(),
                               wires.end(),
                               [](const Piece* a, const Piece* b) {
                                 return a->model.length() < b->model.length();
                               }))
                ->model)
{
  for (const Piece* wire : wires)
    add(*wire, growth);
  search(axis_.begin, axis_.end);
  std::sort(found_.begin(), found_.end());
}

std::vector<double>
LinePoles::along(const SpanModel& model) const
{
  std::vector<double> places;
  for (const double s : found_)
    if (const double at = model.along(axis_.at(s)); at > model.begin && at < model.end)
      places.push_back(at);
  std::sort(places.begin(), places.end());
  return places;
}

void
LinePoles::add(const Piece& wire, const Growth& growth)
{
  const SpanModel& m = wire.model;
  const Points& points = growth.candidates().points;
  Indices own = wire.members;
  for (double s = m.begin; s < m.end; s += bin_length)
    growth.look(m, s, std::min(s + bin_length, m.end), around_wire, &own);
  std::vector<std::pair<double, double>> samples;
  double begin = std::numeric_limits<double>::infinity(), end = -begin;
  for (const Index i : own) {
    const double s = axis_.along(points[i]);
    samples.emplace_back(s, points[i].z() - m.height(m.along(points[i])));
    begin = std::min(begin, s);
    end = std::max(end, s);
  }
  const std::vector<Below> vertical_slice = verticalSliceOf(wire, growth);
  std::vector<Slice> slices;
  for (const Below& p : vertical_slice)
    slices.push_back(
        {axis_.along(m.at(p.s)), static_cast<int>(std::floor(p.drop + level))});
  std::sort(slices.begin(), slices.end(), [](const Slice& a, const Slice& b) {
    return a.s < b.s;
  });
  wires_.push_back({Profile(std::move(samples)), begin, end, std::move(slices)});
  for (const double s : findColumns(vertical_slice))
    columns_.push_back(axis_.along(m.at(s)));
}

std::vector<LinePoles::Stretch>
LinePoles::stretches(double low, double high) const
{
  std::vector<Stretch> result;
  for (const Seen& wire : wires_) {
    const double from = std::max(low, wire.begin), to = std::min(high, wire.end);
    if (to - from > 2 * least_rest)
      result.push_back({wire.profile,
                        from,
                        to,
                        wire.profile.count(from, to),
                        wire.profile.squaresOfOne(from, to)});
  }
  return result;
}

// Log-likelihood that all of \a wires have a kink at \a s over that they have none; 0
// unless it points downward.
double
LinePoles::kinkAt(double s, const std::vector<Stretch>& wires)
{
  double evidence = 0, jumps = 0, count = 0;
  for (const Stretch& wire : wires) {
    if (s < wire.from + least_rest || s > wire.to - least_rest)
      continue;
    const Hinge hinge = wire.profile.hingeAt(s, wire.from, wire.to);
    const double floor = wire.count * least_residual * least_residual;
    evidence += std::min(wire.count, independent * (wire.to - wire.from)) / 2 *
                std::log((wire.squares + floor) / (hinge.squares + floor));
    jumps += hinge.jump;
    count += 1;
  }
  return jumps <= -least_mean_kink * count ? evidence : 0;
}

// Log-likelihood that a pole stands at \a s, by the meters below a wire that have
// points there and none before and behind; 0 where it does not reach up to the wire.
double
LinePoles::poleAt(double s) const
{
  double best = 0;
  for (const Seen& wire : wires_) {
    std::set<int> inside, around;
    const auto from =
        std::lower_bound(wire.vertical_slice.begin(),
                         wire.vertical_slice.end(),
                         s - clear_to,
                         [](const Slice& slice, double at) { return slice.s < at; });
    for (auto slice = from;
         slice != wire.vertical_slice.end() && slice->s <= s + clear_to;
         ++slice) {
      const double away = std::abs(slice->s - s);
      if (away <= pole_radius)
        inside.insert(slice->meter);
      else if (away >= clear_from)
        around.insert(slice->meter);
    }
    if (inside.count(0) + inside.count(1) == 0)
      continue;
    double evidence = 0;
    for (int meter = 0; meter <= *inside.rbegin(); ++meter)
      if (around.count(meter) == 0)
        evidence += inside.count(meter) > 0 ? hit_meter : missed_meter;
    best = std::max(best, evidence);
  }
  return best;
}

// Adds the best place between \a low and \a high if it is good enough, then searches
// both sides of it. Parts of a wire beyond a kink near its end only spoil the search.
void
LinePoles::search(double low, double high)
{
  const std::vector<Stretch> wires = stretches(low, high);
  double best = 0, place = 0;
  for (double s = low + least_rest; s < high - least_rest; s += profile_step) {
    const double kink = kinkAt(s, wires);
    if (const double evidence = kink + poleAt(s);
        kink >= telling && evidence >= enough_evidence && evidence > best) {
      best = evidence;
      place = s;
    }
  }
  for (const double s : columns_)
    if (const double evidence = kinkAt(s, wires) + poleAt(s);
        s > low + least_rest && s < high - least_rest && evidence > best) {
      best = evidence;
      place = s;
    }
  if (best == 0)
    return;
  found_.push_back(place);
  search(low, place);
  search(place, high);
}

} // namespace linelet::powerline
