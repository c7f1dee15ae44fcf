// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "growth.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <linelet/support/threads.h>

#include "adaptive_dop853.h"
#include "meeting.h"
#include "support/parallel_failure.h"

namespace linelet {

namespace {

// In h. Noise makes the field rough, where small steps would gain nothing; a step must
// not outrun the points that gave its direction.
constexpr double least_adaptive_step = 1. / 16, most_adaptive_step = 5;

struct GrowingEnd {
  Index line = 0;
  LineLetSide side = back_side;
  LocalScale scale; // last known
  std::optional<AdaptiveDop853>
      adaptive; // its own streamline, where steps are not constant

  // The step it is about to take.
  Point position = Point::Zero();
  bool near_points = false;
};

void
stop(LineLetEnd& end, EndKind kind)
{
  end.growing = false;
  end.kind = kind;
}

/** \brief Computes the step of \a end. */
void
propose(GrowingEnd& growing,
        const LineLets& lets,
        const DirectionField& field,
        const CloudNeighbors& neighbors,
        const GrowthLimits& limits,
        const ButcherTable& table)
{
  const LineLetEnd& end = lets.lines[growing.line].ends[growing.side];
  const Point from = lets.vertices[end.vertex].position;
  const auto direction = [&](const Point& x) {
    growing.scale = field.scaleAt(x, growing.scale);
    return field.at(x, end.direction, growing.scale);
  };
  growing.position = growing.adaptive
                         ? growing.adaptive->advance(limits.step, direction)
                         : from + integrationStep(table, from, limits.step, direction);
  growing.near_points = neighbors.nearest(growing.position, limits.distance_cutoff) !=
                        CloudNeighbors::none;
}

/** \brief Takes the step of \a growing. \return whether the end keeps growing */
bool
advance(const GrowingEnd& growing, LineLets& lets, GrowthLimits& limits)
{
  LineLetEnd& end = lets.lines[growing.line].ends[growing.side];
  if (!end.growing) // another end met it in this round
    return false;
  const Point step = growing.position - lets.vertices[end.vertex].position;
  const double step_length = step.norm();
  if (limits.total_steps == 0 || end.steps == limits.max_iterations ||
      !(step_length > 0)) {
    stop(end, EndKind::Iterations);
    return false;
  }
  --limits.total_steps;
  const Point direction = step / step_length;
  if (direction.dot(end.direction) < limits.branch_cosine && end.steps > 0) {
    end.growing = false;
    end.closed = true;
    lets.branch(end.vertex, direction); // `end` may be gone
    return false;
  }
  if ((growing.position.array() < limits.low.array()).any() ||
      (growing.position.array() > limits.high.array()).any()) {
    stop(end, EndKind::Bounds);
    return false;
  }
  if (!growing.near_points) {
    stop(end, EndKind::Cutoff);
    return false;
  }
  end.direction = direction;
  ++end.steps;
  lets.append(growing.line, growing.side, growing.position);
  return !meet(lets, growing.line, growing.side, limits.merge_distance);
}

} // namespace

void
grow(LineLets& lets,
     const DirectionField& field,
     const CloudNeighbors& neighbors,
     GrowthLimits& limits,
     const StreamlineSettings& settings,
     ProgressMonitor* monitor)
{
  const ButcherTable& table = butcherTable(settings.scheme);
  LocalScale unknown;
  unknown.radius = (settings.interpolation_radius > 0 ? settings.interpolation_radius
                                                      : 2 * settings.search_radius) *
                   field.scaleUnit();
  unknown.blend = 0.5;

  const StepControl control = {settings.tolerance * field.scaleUnit(),
                               limits.step,
                               limits.step * least_adaptive_step,
                               limits.step * most_adaptive_step};
  std::vector<GrowingEnd> ends;
  std::size_t seen = 0; // line-lets whose ends were collected
  const auto collect = [&] {
    for (; seen < lets.lines.size(); ++seen)
      for (const LineLetSide side : {back_side, front_side})
        if (lets.lines[seen].ends[side].growing) {
          GrowingEnd end;
          end.line = static_cast<Index>(seen);
          end.side = side;
          end.scale = unknown;
          if (settings.scheme == IntegrationScheme::Dop853Adaptive)
            end.adaptive.emplace(
                lets.vertices[lets.lines[seen].ends[side].vertex].position, control);
          ends.push_back(end);
        }
  };
  for (collect(); !ends.empty(); collect()) {
    if (monitor != nullptr && monitor->canceled())
      throw Canceled();
    const auto count = static_cast<std::ptrdiff_t>(ends.size());
    ParallelFailure failure;
#pragma omp parallel for schedule(dynamic, 8)                                          \
    num_threads(threadCount(settings.threads)) if (count > 32)
    for (std::ptrdiff_t i = 0; i < count; ++i)
      failure.guard([&] {
        propose(
            ends[static_cast<std::size_t>(i)], lets, field, neighbors, limits, table);
      });
    failure.rethrow();
    std::vector<GrowingEnd> still;
    for (const GrowingEnd& end : ends)
      if (advance(end, lets, limits))
        still.push_back(end);
    ends = std::move(still);
  }
}

} // namespace linelet
