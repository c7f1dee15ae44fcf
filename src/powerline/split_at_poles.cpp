// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "powerline/groups.h"
#include "powerline/joints.h"
#include "powerline/profile.h"

namespace linelet::powerline {

namespace {

constexpr double highest_pole = 16; // metres of a wire above ground
constexpr double curtain = 1.25;    // metres beside the wire
constexpr double patch = 2;         // metres, of the curtain looked at at once
constexpr double level = 0.5;       // metres above and below, of what is level with it
constexpr double pole_radius = 0.4; // metres
constexpr double clear_from = 0.9, clear_to = 2.0; // metres around it, along the wire
constexpr double filled = 0.7; // of the metres from candidates to wire
constexpr double contrast = 4; // points of the pole per points around
constexpr double alone_from = 0.6, alone_to = 3.0; // metres, empty around a pole ...
constexpr double filled_alone = 0.4;               // ... that may fill so little
constexpr double least_piece = 6;                  // metres, a shorter rest is cut off
constexpr double thin_part = 0.3;     // of the points a metre of the whole, a part has
constexpr std::size_t crowded = 3000; // points below, too many for a pole in the open

constexpr double same_line = 3;         // metres between wires that share their poles
constexpr double side_by_side = 0.6;    // of the shorter one
constexpr double around_wire = 0.35;    // metres, of the points that may be its own
constexpr double profile_step = 0.25;   // metres between the places tried
constexpr double independent = 2;       // points a metre that tell something new
constexpr double least_residual = 0.02; // metres, finer differences are noise
constexpr double least_kink = 0.008;    // change of slope, mean of the wires
constexpr double telling = 8;           // evidence of a kink ...
constexpr double enough = 25;           // evidence for a pole
constexpr double least_rest = 2;        // metres on both sides of a kink
// Log-likelihood ratios of pole to none: six of ten metres of a pole show points, and
// three of a hundred elsewhere.
constexpr double hit_metre = 3.0, missed_metre = -0.9;

struct Below {
  double s, t, drop; // along, across, below the wire
  double depth;      // of the lowest candidate that there can be
};

// The free candidates in the curtain below a wire.
std::vector<Below>
curtainOf(const SpanModel& m, const Growth& growth, double height)
{
  std::vector<Below> points;
  const Candidates& candidates = growth.candidates();
  for (double s = m.begin; s < m.end; s += patch)
    for (double drop = -level; drop < height; drop += patch) {
      const Point centre = m.at(s + patch / 2) - (drop + patch / 2) * Point::UnitZ();
      candidates.grid.forEachWithin(
          centre, std::hypot(patch, curtain), [&](Index i, double) {
            const Point& p = candidates.points[i];
            const double at = m.along(p);
            if (growth.owner(i) != Growth::nobody || at < s || at >= s + patch)
              return;
            const Eigen::Vector2d r = m.residual(p, at);
            const double below = SpanModel::value(m.z, at) - p.z();
            if (std::abs(r[0]) <= curtain && below >= drop && below < drop + patch)
              points.push_back({at,
                                r[0],
                                below,
                                below + static_cast<double>(candidates.height[i]) -
                                    candidates.least_height});
          });
    }
  return points;
}

// Where a pole stands below a wire, with nothing much beside it.
std::vector<double>
findPoles(const std::vector<Below>& points)
{
  std::vector<double> found;
  if (points.size() > crowded)
    return found;
  struct Pole {
    double s, inside;
  };
  std::vector<Pole> poles;
  for (const Below& centre : points) {
    const int slices = static_cast<int>(std::floor(centre.depth - 0.3));
    if (slices < 2)
      continue;
    std::set<int> hit;
    double inside = 0, around = 0;
    bool alone = true;
    for (const Below& p : points) {
      if (p.drop < 0.3 || p.drop > centre.depth)
        continue;
      const double away = std::abs(p.s - centre.s);
      if (std::hypot(p.s - centre.s, p.t - centre.t) <= pole_radius) {
        ++inside;
        hit.insert(static_cast<int>(p.drop - 0.3));
      }
      else if (away >= clear_from && away <= clear_to)
        ++around;
      alone = alone && (away < alone_from || away > alone_to);
    }
    const double least = alone ? filled_alone : filled;
    if (static_cast<double>(hit.size()) >= least * slices && *hit.begin() <= 1 &&
        inside >= (alone ? 3 : 4) && inside >= contrast * around)
      poles.push_back({centre.s, inside});
  }
  std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) {
    return a.inside != b.inside ? a.inside > b.inside : a.s < b.s;
  });
  for (const Pole& pole : poles)
    if (std::none_of(found.begin(), found.end(), [&](double s) {
          return std::abs(s - pole.s) < least_piece;
        }))
      found.push_back(pole.s);
  std::sort(found.begin(), found.end());
  return found;
}

double
heightOf(const Hanging& wire, const Candidates& candidates)
{
  const Indices& members = wire.strand.piece.members;
  double height = 0;
  for (const Index i : members)
    height += static_cast<double>(candidates.height[i]);
  return height / static_cast<double>(members.size());
}

// Low wires that run side by side: their poles carry all of them.
std::vector<std::vector<std::size_t>>
gatherLines(const std::vector<Hanging>& wires, const Candidates& candidates)
{
  std::vector<char> low(wires.size());
  for (std::size_t w = 0; w < wires.size(); ++w)
    low[w] = heightOf(wires[w], candidates) < highest_pole;
  Groups groups(wires.size());
  uniteNeighbours(groups, wires, same_line, [&](const Hanging& a, const Hanging& b) {
    const auto place = [&](const Hanging& wire) {
      return static_cast<std::size_t>(&wire - wires.data());
    };
    if (low[place(a)] == 0 || low[place(b)] == 0)
      return false;
    const Parallel parallel = compare(a.model(), b.model());
    return parallel.distance <= same_line &&
           parallel.overlap >=
               side_by_side * std::min(a.model().length(), b.model().length());
  });
  std::map<std::size_t, std::vector<std::size_t>> lines;
  for (std::size_t w = 0; w < wires.size(); ++w)
    if (low[w] != 0)
      lines[groups.root(w)].push_back(w);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [root, line] : lines)
    result.push_back(std::move(line));
  return result;
}

/** A free point near a wire: its place along the line and its metre below the wire, 0
 * for what is level with it, as a crossarm is. */
struct Slice {
  double s;
  int metre;
};

/** A wire of a line as seen along the line. */
struct Seen {
  Profile profile; ///< heights over the wire's own model
  double begin, end;
  std::vector<Slice> curtain; ///< free points around and below, by place
};

/** Where poles stand along a line. */
class PolesOfLine {
public:
  PolesOfLine(const std::vector<const Hanging*>& wires, const Growth& growth)
      : axis_((*std::max_element(wires.begin(),
                                 wires.end(),
                                 [](const Hanging* a, const Hanging* b) {
                                   return a->model().length() < b->model().length();
                                 }))
                  ->model())
  {
    for (const Hanging* wire : wires)
      add(*wire, growth);
    search(axis_.begin, axis_.end);
    std::sort(found_.begin(), found_.end());
  }

  /** Places of the poles along \a model, ascending. */
  std::vector<double>
  along(const SpanModel& model) const
  {
    std::vector<double> places;
    for (const double s : found_)
      if (const double at = model.along(axis_.at(s));
          at > model.begin && at < model.end)
        places.push_back(at);
    std::sort(places.begin(), places.end());
    return places;
  }

private:
  void
  add(const Hanging& wire, const Growth& growth)
  {
    const Piece& piece = wire.strand.piece;
    const SpanModel& m = piece.model;
    const Points& points = growth.candidates().points;
    Indices own = piece.members;
    for (double s = m.begin; s < m.end; s += bin_length)
      growth.look(m, s, std::min(s + bin_length, m.end), around_wire, &own);
    std::vector<std::pair<double, double>> samples;
    double begin = std::numeric_limits<double>::infinity(), end = -begin;
    for (const Index i : own) {
      const double s = axis_.along(points[i]);
      samples.emplace_back(s,
                           points[i].z() - SpanModel::value(m.z, m.along(points[i])));
      begin = std::min(begin, s);
      end = std::max(end, s);
    }
    const std::vector<Below> curtain =
        curtainOf(m, growth, heightOf(wire, growth.candidates()) + patch);
    std::vector<Slice> slices;
    for (const Below& p : curtain)
      slices.push_back(
          {axis_.along(m.at(p.s)), static_cast<int>(std::floor(p.drop + level))});
    std::sort(slices.begin(), slices.end(), [](const Slice& a, const Slice& b) {
      return a.s < b.s;
    });
    wires_.push_back({Profile(std::move(samples)), begin, end, std::move(slices)});
    for (const double s : findPoles(curtain))
      columns_.push_back(axis_.along(m.at(s)));
  }

  /** The part of a wire that is searched, as one span. */
  struct Stretch {
    const Profile& profile;
    double from, to;
    double count;   ///< of its points
    double squares; ///< of their deviations from one parabola
  };

  std::vector<Stretch>
  stretches(double low, double high) const
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
  // unless it points downwards.
  static double
  kinkAt(double s, const std::vector<Stretch>& wires)
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
    return jumps <= -least_kink * count ? evidence : 0;
  }

  // Log-likelihood that a pole stands at \a s, by the metres below a wire that have
  // points there and none before and behind; 0 where it does not reach up to the wire.
  double
  poleAt(double s) const
  {
    double best = 0;
    for (const Seen& wire : wires_) {
      std::set<int> inside, around;
      const auto from =
          std::lower_bound(wire.curtain.begin(),
                           wire.curtain.end(),
                           s - clear_to,
                           [](const Slice& slice, double at) { return slice.s < at; });
      for (auto slice = from; slice != wire.curtain.end() && slice->s <= s + clear_to;
           ++slice) {
        const double away = std::abs(slice->s - s);
        if (away <= pole_radius)
          inside.insert(slice->metre);
        else if (away >= clear_from)
          around.insert(slice->metre);
      }
      if (inside.count(0) + inside.count(1) == 0)
        continue;
      double evidence = 0;
      for (int metre = 0; metre <= *inside.rbegin(); ++metre)
        if (around.count(metre) == 0)
          evidence += inside.count(metre) > 0 ? hit_metre : missed_metre;
      best = std::max(best, evidence);
    }
    return best;
  }

  // Adds the best place between \a low and \a high if it is good enough, then looks on
  // both its sides. What a wire has beyond a kink near its end only spoils the search.
  void
  search(double low, double high)
  {
    const std::vector<Stretch> wires = stretches(low, high);
    double best = 0, place = 0;
    bool column = false;
    for (double s = low + least_rest; s < high - least_rest; s += profile_step) {
      const double kink = kinkAt(s, wires);
      if (const double evidence = kink + poleAt(s);
          kink >= telling && evidence >= enough && evidence > best) {
        best = evidence;
        place = s;
      }
    }
    for (const double s : columns_)
      if (const double evidence = kinkAt(s, wires) + poleAt(s);
          s > low + least_rest && s < high - least_rest && evidence > best) {
        best = evidence;
        place = s;
        column = true;
      }
    if (best == 0)
      return;
    if (column || (place >= low + least_piece && place <= high - least_piece))
      found_.push_back(place);
    search(low, place);
    search(place, high);
  }

  SpanModel axis_;
  std::vector<Seen> wires_;
  std::vector<double> columns_; ///< that stand below a wire
  std::vector<double> found_;
};

double
density(const Piece& piece)
{
  return static_cast<double>(piece.members.size()) / piece.model.length();
}

// What hangs between two poles of a wire that was taken for one: fitted anew, as far
// from what it was fitted to before as a wire over a pole is. Empty if nothing does.
Piece
partOf(const Piece& whole, double low, double high, const Growth& growth)
{
  Piece part;
  part.thickness = whole.thickness;
  SpanModel& m = part.model;
  m = whole.model;
  m.begin = low;
  m.end = high;
  m = m.reframed();
  const double begin = m.begin, end = m.end;
  if (!growth.collect(part, std::max(around_wire, whole.thickness)) ||
      !growth.collect(part, std::max(m.tolerance, whole.thickness)) ||
      density(part) < thin_part * density(whole))
    part.members.clear();
  m.begin = begin; // up to the poles, also where these hide it
  m.end = end;
  return part;
}

} // namespace

void
splitAtPoles(std::vector<Hanging>& wires, Growth& growth)
{
  const Candidates& candidates = growth.candidates();
  std::vector<std::vector<double>> poles(wires.size());
  for (const std::vector<std::size_t>& line : gatherLines(wires, candidates)) {
    std::vector<const Hanging*> members;
    for (const std::size_t w : line)
      members.push_back(&wires[w]);
    const PolesOfLine found(members, growth);
    for (const std::size_t w : line)
      poles[w] = found.along(wires[w].model());
  }
  std::vector<Hanging> result;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    Hanging& wire = wires[w];
    Piece& piece = wire.strand.piece;
    if (poles[w].empty()) {
      result.push_back(std::move(wire));
      continue;
    }
    growth.claim(piece, Growth::nobody);
    for (std::size_t k = 0; k <= poles[w].size(); ++k) {
      const double low = k == 0 ? piece.model.begin : poles[w][k - 1];
      const double high = k == poles[w].size() ? piece.model.end : poles[w][k];
      if (high - low < least_piece)
        continue;
      Hanging part;
      part.strand.piece = partOf(piece, low, high, growth);
      if (part.strand.piece.members.empty())
        continue;
      growth.claim(part.strand.piece, 0);
      result.push_back(std::move(part));
    }
    if (!result.empty())
      for (Piece& companion : wire.strand.companions)
        result.back().strand.companions.push_back(std::move(companion));
  }
  wires = std::move(result);
}

} // namespace linelet::powerline
