// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ridge_trace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <linelet/tensor/shape_factors.h>

#include "major_direction.h"

namespace linelet {

namespace {

// All in bandwidths.
constexpr double step_length = 0.4;
constexpr double look_ahead = 3;
constexpr double attach_distance = 0.8;
constexpr double loop_length = 5;
constexpr double explained_distance = 2;
constexpr double least_length = 3;

// A trace that turns back within 3b follows the noise around the end of its curve.
constexpr std::size_t turn_steps = 8;
constexpr double least_cosine = -0.64;

constexpr double least_relative_support = 0.45;
constexpr double support_memory = 0.85; // of the running mean, per step
constexpr int correctors = 3;
constexpr std::size_t least_new_points = 5;

/** \brief Nodes of the traces so far, in a chained hash of cells for proximity
 * queries. */
class NodeMap {
public:
  NodeMap(double cell, std::size_t expected) : cell_(cell)
  {
    std::size_t buckets = 64;
    while (buckets < 2 * expected)
      buckets *= 2;
    heads_.assign(buckets, none);
  }

  struct Node {
    Point at;
    std::size_t trace; // which attempt set it
    double arc;        // along that trace in bandwidths, 0 at its seed
    std::size_t next;
  };

  void
  add(const Point& at, std::size_t trace, double arc)
  {
    const std::size_t bucket = bucketOf(cellOf(at));
    nodes_.push_back({at, trace, arc, heads_[bucket]});
    heads_[bucket] = nodes_.size() - 1;
  }

  /** \brief The nearest node within \a distance (at most a cell) that \a accept
   * accepts, or null. */
  template <class Accept>
  const Node*
  nearest(const Point& x, double distance, Accept&& accept) const
  {
    const Eigen::Matrix<std::int64_t, 3, 1> middle = cellOf(x);
    const Node* best = nullptr;
    double best_squared = distance * distance;
    Eigen::Matrix<std::int64_t, 3, 1> c;
    for (c.x() = middle.x() - 1; c.x() <= middle.x() + 1; ++c.x())
      for (c.y() = middle.y() - 1; c.y() <= middle.y() + 1; ++c.y())
        for (c.z() = middle.z() - 1; c.z() <= middle.z() + 1; ++c.z())
          for (std::size_t k = heads_[bucketOf(c)]; k != none; k = nodes_[k].next) {
            const double squared = (nodes_[k].at - x).squaredNorm();
            if (squared <= best_squared && accept(nodes_[k])) {
              best_squared = squared;
              best = &nodes_[k];
            }
          }
    return best;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Eigen::Matrix<std::int64_t, 3, 1>
  cellOf(const Point& x) const
  {
    return (x / cell_).array().floor().cast<std::int64_t>();
  }
  std::size_t
  bucketOf(const Eigen::Matrix<std::int64_t, 3, 1>& c) const
  {
    const auto h = static_cast<std::uint64_t>(c.x()) * 0x9E3779B97F4A7C15u ^
                   static_cast<std::uint64_t>(c.y()) * 0xC2B2AE3D27D4EB4Fu ^
                   static_cast<std::uint64_t>(c.z()) * 0x165667B19E3779F9u;
    return static_cast<std::size_t>(h ^ (h >> 29)) & (heads_.size() - 1);
  }

  double cell_;
  std::vector<std::size_t> heads_;
  std::vector<Node> nodes_;
};

class Tracer {
public:
  Tracer(const RidgeField& field, const TraceLimits& limits)
      : field_(field),
        map_(attach_distance * field.widestBandwidth(), field.kept().size()),
        explained_(field.kept().size(), 0)
  {
    // No trace needs more steps than its points can support.
    most_steps_ = limits.steps > 0 ? limits.steps : 4 * field.kept().size() + 100;
    most_seeds_ = limits.seeds > 0 ? limits.seeds : field.kept().size();
  }

  Traces
  run()
  {
    std::vector<Index> kept_index(field_.supports().size(), UniformGrid::none);
    for (std::size_t k = 0; k < field_.keptIndices().size(); ++k)
      kept_index[field_.keptIndices()[k]] = static_cast<Index>(k);
    std::size_t seeds = 0;
    for (const Index i : field_.seeds()) {
      if (explained_[kept_index[i]])
        continue;
      if (seeds++ >= most_seeds_)
        break;
      explained_[kept_index[i]] = 1;
      traceFrom(field_.kept()[kept_index[i]]);
    }
    return std::move(traces_);
  }

private:
  enum class Stop { Support, Meeting, Loop, Steps };

  void
  traceFrom(Point x)
  {
    RidgeField::Sample here = field_.sample(x);
    Point d = majorDirection(here.covariance, Point::UnitX());
    for (int k = 0; k < 5; ++k) { // onto the ridge
      const Point off = here.mean - x;
      x += off - d.dot(off) * d;
      here = field_.sample(x);
      d = majorDirection(here.covariance, d);
    }
    const std::size_t attempt = discarded_.size();
    const double b = field_.bandwidthAt(x);
    if (map_.nearest(x, attach_distance * b, [&](const NodeMap::Node& node) {
          return !discarded_[node.trace];
        }))
      return;

    discarded_.push_back(0);
    ModelCurve trace;
    Stop stops[2] = {Stop::Support, Stop::Support};
    Point met[2];
    Points forward{x}, backward{x};
    map_.add(x, attempt, 0);
    stops[1] = walk(forward, d, 1, 0, attempt, met[1]);
    if (stops[1] == Stop::Loop) {
      trace.nodes = std::move(forward);
      trace.closed = true;
    }
    else {
      const double far_end = step_length * static_cast<double>(forward.size() - 1);
      stops[0] = walk(backward, -d, -1, far_end, attempt, met[0]);
      trace.nodes.assign(backward.rbegin(), backward.rend());
      trace.nodes.insert(trace.nodes.end(), forward.begin() + 1, forward.end());
      trace.closed = stops[0] == Stop::Loop;
    }
    const std::size_t gained = explain(trace);
    const bool bridge = stops[0] == Stop::Meeting && stops[1] == Stop::Meeting;
    if (trace.nodes.size() < 2 || gained < least_new_points ||
        (length(trace) < least_length * b && !bridge && !trace.closed)) {
      discarded_[attempt] = 1;
      return;
    }
    if (!trace.closed)
      for (int end = 0; end < 2; ++end)
        if (stops[end] == Stop::Meeting)
          traces_.meetings.push_back(met[end]);
    traces_.curves.push_back(std::move(trace));
  }

  /** \brief Walks from the only node of \a path toward \a d; \a sign is that of the arc
   * length on this side, \a far_end the arc length of the trace's other end. */
  Stop
  walk(Points& path,
       Point d,
       double sign,
       double far_end,
       std::size_t attempt,
       Point& met)
  {
    RidgeField::Sample here = field_.sample(path.back());
    double running = std::min(here.support, 1.5 * field_.medianSupport());
    Points tentative; // past the last well supported node
    Points directions;
    for (std::size_t steps = 0; steps < most_steps_; ++steps) {
      const Point last = tentative.empty() ? path.back() : tentative.back();
      const double b = field_.bandwidthAt(last), h = step_length * b;
      const double v = std::clamp((linearityOf(here.covariance) - 0.1) / 0.3, 0.0, 1.0);
      const Point blended = v * majorDirection(here.covariance, d) + (1 - v) * d;
      const double norm = blended.norm();
      if (norm > 0)
        d = blended / norm;
      Point x = last + h * d;
      for (int k = 0; k < correctors; ++k) {
        const RidgeField::Sample at = field_.sample(x);
        if (!(at.support > 0))
          break;
        const Point off = at.mean - x;
        x += off - d.dot(off) * d;
      }
      const Point moved = x - last;
      if (moved.squaredNorm() > 0.01 * h * h)
        d = (d + moved.normalized()).normalized();
      here = field_.sample(x);
      directions.push_back(d);
      if (directions.size() > turn_steps &&
          d.dot(directions[directions.size() - 1 - turn_steps]) < least_cosine) {
        path.resize(path.size() - std::min(turn_steps / 2, path.size() - 1));
        return Stop::Support;
      }

      const double threshold =
          least_relative_support * std::min(running, 1.5 * field_.medianSupport());
      tentative.push_back(x);
      const double arc =
          sign * step_length * static_cast<double>(path.size() + tentative.size() - 1);
      if (const NodeMap::Node* near =
              map_.nearest(x, attach_distance * b, [&](const NodeMap::Node& other) {
                return !discarded_[other.trace] &&
                       (other.trace != attempt ||
                        std::abs(arc - other.arc) > loop_length);
              })) {
        const NodeMap::Node node = *near; // the map moves when it grows
        append(path, tentative, sign, attempt);
        if (node.trace == attempt && std::abs(node.arc - far_end) <= attach_distance)
          return Stop::Loop;
        met = node.at;
        path.push_back(met);
        return Stop::Meeting;
      }
      if (here.support >= threshold) {
        append(path, tentative, sign, attempt);
        running = support_memory * running + (1 - support_memory) * here.support;
      }
      else if (static_cast<double>(tentative.size()) * step_length > look_ahead)
        return Stop::Support;
    }
    return Stop::Steps;
  }

  void
  append(Points& path, Points& tentative, double sign, std::size_t attempt)
  {
    for (const Point& x : tentative) {
      map_.add(x, attempt, sign * step_length * static_cast<double>(path.size()));
      path.push_back(x);
    }
    tentative.clear();
  }

  /** \brief Marks the points near \a trace. \return how many are new */
  std::size_t
  explain(const ModelCurve& trace)
  {
    std::size_t gained = 0;
    for (std::size_t k = 0; k < trace.nodes.size(); k += 2)
      field_.grid().forEachWithin(trace.nodes[k],
                                  explained_distance *
                                      field_.bandwidthAt(trace.nodes[k]),
                                  [&](Index i, double) {
                                    gained += explained_[i] ? 0 : 1;
                                    explained_[i] = 1;
                                  });
    return gained;
  }

  const RidgeField& field_;
  NodeMap map_;
  std::vector<char> explained_;
  std::vector<char> discarded_; // by attempt
  std::size_t most_steps_ = 0;
  std::size_t most_seeds_ = 0;
  Traces traces_;
};

} // namespace

Traces
traceRidges(const RidgeField& field, const TraceLimits& limits)
{
  if (field.kept().empty())
    return {};
  return Tracer(field, limits).run();
}

} // namespace linelet
