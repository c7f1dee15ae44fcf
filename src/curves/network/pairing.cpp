// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pairing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/search/uniform_grid.h>

#include "line_meeting.h"
#include "support/groups.h"

namespace linelet {

namespace {

struct Center {
  Point at = Point::Zero();
  double radius = 0;
  std::size_t meetings = 0;
};

/** \brief One end of a piece: piece * 2 + end. */
using End = std::size_t;
constexpr End no_end = static_cast<End>(-1);

/** \brief How an end continues: through \a via to the end \a other (or nowhere). */
struct Link {
  End other = no_end;
  Points via; // from this end outwards
  int junction = -1;
};

std::vector<Center>
clusterMeetings(const Points& meetings, double distance, double cut)
{
  Groups groups(meetings.size());
  const UniformGrid grid(meetings, distance);
  for (std::size_t i = 0; i < meetings.size(); ++i)
    grid.forEachWithin(
        meetings[i], distance, [&](Index j, double) { groups.unite(i, j); });
  std::vector<std::size_t> number(meetings.size());
  std::vector<Center> centers;
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    if (groups.root(i) == i) {
      number[i] = centers.size();
      centers.emplace_back();
    }
    Center& center = centers[number[groups.root(i)]];
    center.at += meetings[i];
    ++center.meetings;
  }
  for (Center& center : centers)
    center.at /= static_cast<double>(center.meetings);
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    Center& center = centers[number[groups.root(i)]];
    center.radius = std::max(center.radius, (meetings[i] - center.at).norm());
  }
  for (Center& center : centers)
    center.radius += cut;
  return centers;
}

class Joiner {
public:
  Joiner(const std::vector<Center>& centers, const PairingSettings& settings)
      : centers_(centers),
        settings_(settings),
        center_grid_(positions(centers), settings.cluster),
        arms_(centers.size())
  {
    for (const Center& center : centers)
      widest_ = std::max(widest_, center.radius);
  }

  void
  cut(const ModelCurve& curve);
  void
  pairAll();
  ModelCurves
  chains() const;

private:
  static Points
  positions(const std::vector<Center>& centers)
  {
    Points result;
    for (const Center& center : centers)
      result.push_back(center.at);
    return result;
  }
  Point
  tip(End end) const
  {
    const ModelCurve& piece = pieces_[end / 2];
    return end % 2 == 0 ? piece.nodes.front() : piece.nodes.back();
  }
  Point
  direction(End end) const
  {
    return outwardDirection(
        pieces_[end / 2], static_cast<int>(end % 2), settings_.reach);
  }
  void
  addPiece(ModelCurve piece, int front, int back);
  void
  pairAt(std::size_t center);
  void
  connect(End a, End b, const Points& via);

  const std::vector<Center>& centers_;
  PairingSettings settings_;
  UniformGrid center_grid_;
  double widest_ = 0;
  ModelCurves pieces_;
  std::vector<Link> links_;
  std::vector<std::vector<End>> arms_; // by center
};

void
Joiner::addPiece(ModelCurve piece, int front, int back)
{
  const std::size_t p = pieces_.size();
  const int at[2] = {front, back};
  for (std::size_t end = 0; end < 2; ++end) {
    links_.emplace_back();
    links_.back().junction = at[end];
    if (at[end] >= 0)
      arms_[static_cast<std::size_t>(at[end])].push_back(2 * p + end);
  }
  pieces_.push_back(std::move(piece));
}

void
Joiner::cut(const ModelCurve& curve)
{
  const std::size_t n = curve.nodes.size();
  std::vector<int> inside(n, -1);
  bool any = false;
  for (std::size_t i = 0; i < n; ++i)
    center_grid_.forEachWithin(curve.nodes[i], widest_, [&](Index c, double squared) {
      const double radius = centers_[c].radius;
      if (squared < radius * radius &&
          (inside[i] < 0 || static_cast<int>(c) < inside[i])) {
        inside[i] = static_cast<int>(c);
        any = true;
      }
    });
  if (!any) {
    addPiece(curve, -1, -1);
    return;
  }
  // A closed curve starts inside a junction, so that no piece wraps around.
  std::size_t start = 0;
  if (curve.closed)
    while (inside[start] < 0)
      ++start;
  ModelCurve piece;
  int entered = -1;
  const std::size_t steps = n + (curve.closed ? 1 : 0);
  for (std::size_t k = 0; k < steps; ++k) {
    const std::size_t i = (start + k) % n;
    if (inside[i] < 0) {
      piece.nodes.push_back(curve.nodes[i]);
      continue;
    }
    if (piece.nodes.size() > 1)
      addPiece(piece, entered, inside[i]);
    piece.nodes.clear();
    entered = inside[i];
  }
  if (piece.nodes.size() > 1)
    addPiece(piece, entered, -1);
}

void
Joiner::connect(End a, End b, const Points& via)
{
  links_[a].other = b;
  links_[a].via = via;
  links_[b].other = a;
  links_[b].via.assign(via.rbegin(), via.rend());
}

void
Joiner::pairAt(std::size_t c)
{
  std::vector<End>& arms = arms_[c];
  struct Pair {
    double turn;
    End a, b;
  };
  std::vector<Point> directions;
  directions.reserve(arms.size());
  for (const End arm : arms)
    directions.push_back(direction(arm));
  const double far = 2 * centers_[c].radius;
  if (arms.size() == 2) {
    Points via;
    if (const auto at =
            meetingAhead(tip(arms[0]), directions[0], tip(arms[1]), directions[1], far))
      via.push_back(*at);
    connect(arms[0], arms[1], via);
    return;
  }
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < arms.size(); ++i)
    for (std::size_t j = i + 1; j < arms.size(); ++j) {
      const double turn =
          std::acos(std::clamp(-directions[i].dot(directions[j]), -1.0, 1.0));
      if (turn < settings_.max_turn * M_PI / 180)
        pairs.push_back({turn, arms[i], arms[j]});
    }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
    return p.turn != q.turn ? p.turn < q.turn : (p.a != q.a ? p.a < q.a : p.b < q.b);
  });
  Points middles;
  for (const Pair& pair : pairs)
    if (links_[pair.a].other == no_end && links_[pair.b].other == no_end) {
      connect(pair.a, pair.b, {});
      middles.push_back(0.5 * (tip(pair.a) + tip(pair.b)));
    }
  for (const End arm : arms) {
    if (links_[arm].other != no_end)
      continue;
    Point target = centers_[c].at;
    double best = std::numeric_limits<double>::infinity();
    for (const Point& middle : middles)
      if ((middle - tip(arm)).squaredNorm() < best) {
        best = (middle - tip(arm)).squaredNorm();
        target = middle;
      }
    links_[arm].via = {target};
  }
}

void
Joiner::pairAll()
{
  for (std::size_t c = 0; c < centers_.size(); ++c)
    pairAt(c);
}

ModelCurves
Joiner::chains() const
{
  ModelCurves result;
  std::vector<char> used(pieces_.size(), 0);
  // Chains with a loose end first; what remains are rings.
  for (int rings = 0; rings < 2; ++rings)
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      for (std::size_t first = 0; first < 2; ++first) {
        const End begin = 2 * p + first;
        if (used[p] || (rings == 0 && links_[begin].other != no_end))
          continue;
        ModelCurve chain;
        if (pieces_[p].closed) {
          chain = pieces_[p];
          used[p] = 1;
          result.push_back(std::move(chain));
          continue;
        }
        const bool open = links_[begin].other == no_end;
        if (open && !links_[begin].via.empty()) {
          chain.nodes.push_back(links_[begin].via.back());
          chain.junction[0] = links_[begin].junction;
        }
        End at = begin;
        while (true) {
          const Points& nodes = pieces_[at / 2].nodes;
          used[at / 2] = 1;
          if (at % 2 == 0)
            chain.nodes.insert(chain.nodes.end(), nodes.begin(), nodes.end());
          else
            chain.nodes.insert(chain.nodes.end(), nodes.rbegin(), nodes.rend());
          const Link& out = links_[at ^ 1];
          chain.nodes.insert(chain.nodes.end(), out.via.begin(), out.via.end());
          if (out.other == no_end) {
            chain.junction[1] = out.via.empty() ? -1 : out.junction;
            break;
          }
          if (used[out.other / 2]) {
            chain.closed = true;
            break;
          }
          at = out.other;
        }
        result.push_back(std::move(chain));
      }
  return result;
}

} // namespace

ModelCurves
pairArms(const ModelCurves& curves,
         const Points& meetings,
         const PairingSettings& settings)
{
  if (meetings.empty())
    return curves;
  const std::vector<Center> centers =
      clusterMeetings(meetings, settings.cluster, settings.cut);
  Joiner joiner(centers, settings);
  for (const ModelCurve& curve : curves)
    joiner.cut(curve);
  joiner.pairAll();
  return joiner.chains();
}

} // namespace linelet
