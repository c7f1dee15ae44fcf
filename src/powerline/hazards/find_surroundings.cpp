// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/find_surroundings.h>

#include <algorithm>
#include <cmath>

#include <linelet/powerline/clearance_limits.h>
#include <linelet/powerline/metric_frame.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/threads.h>

#include "powerline/hazards/tell_apart.h"
#include "powerline/hazards/wire_cells.h"

namespace linelet::powerline {

namespace {

constexpr double tallest = 60;       // meters, trees
constexpr double off_ground = 0.5;   // meters above the terrain
constexpr double company_radius = 1; // meters
constexpr std::size_t company = 3;   // neighbors, otherwise it is a bird or noise
// Half widths and lengths of what carries wires, meters: a lattice body, a pole, a
// crossarm, a string of insulators with its fittings.
constexpr double pylon_body = 3, pole_body = 1.5, arm = 1.5, hanging = 4.5,
                 fitting = 0.6;
constexpr double beside_support = 12; // meters, half of the longest crossarm

/** What a class says about its points. */
enum class Meaning : std::uint8_t { Unknown, Vegetation, Building, Support, Nothing };

Meaning
meaningOf(int given, std::uint8_t found, const SurroundingClasses& classes)
{
  if (found == pylon_class || found == connector_class)
    return Meaning::Support;
  if (found == wire_class)
    return Meaning::Nothing; // a jumper
  if (classes.vegetation.contains(given))
    return Meaning::Vegetation;
  if (classes.buildings.contains(given))
    return Meaning::Building;
  switch (given) {
  case 2:
  case 7:
  case 8:
  case 9:
  case 11:
  case 13:
  case 14:
  case 15:
  case 16:
  case 18:
    return Meaning::Nothing;
  default:
    return Meaning::Unknown;
  }
}

double
squaredToSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& end, const Point& p)
{
  const Eigen::Vector2d b = end - a, d = p.head<2>() - a;
  const double t = std::clamp(b.dot(d) / std::max(1e-9, b.squaredNorm()), 0.0, 1.0);
  return (d - t * b).squaredNorm();
}

/** Whether a point may be part of what carries \a wire: body and arm of its supports,
 * insulators, jumper loops. */
bool
mayCarry(const Wire& wire, const std::vector<Support>& supports, const Point& p)
{
  for (const bool front : {true, false}) {
    const int id = front ? wire.front_support : wire.back_support;
    if (id <= 0 || static_cast<std::size_t>(id) > supports.size())
      continue;
    const Support& support = supports[static_cast<std::size_t>(id) - 1];
    const Point& end = front ? wire.front : wire.back;
    const Eigen::Vector2d axis = support.base.head<2>();
    const double body = support.kind == Support::Kind::Pole ? pole_body : pylon_body;
    if ((p.head<2>() - axis).squaredNorm() < body * body)
      return true;
    if (p.z() > end.z() - hanging &&
        squaredToSegment(axis, end.head<2>(), p) < arm * arm)
      return true;
    const Point inward = (front ? wire.back - wire.front : wire.front - wire.back);
    const Eigen::Vector2d string =
        end.head<2>() + hanging * inward.head<2>().normalized();
    if (std::abs(p.z() - end.z()) < 2 * fitting &&
        squaredToSegment(end.head<2>(), string, p) < fitting * fitting)
      return true;
  }
  return false;
}

/** The support that a point of pylons belongs to; 0: none is near. */
int
supportAt(const std::vector<Support>& supports, const Point& p)
{
  int best = 0;
  double least = beside_support * beside_support;
  for (const Support& support : supports)
    if (const double d = (support.base - p).head<2>().squaredNorm(); d < least) {
      least = d;
      best = support.id;
    }
  return best;
}

/** Keeps the entries marked in \a keep in all lists. */
void
filter(Surroundings& all, const std::vector<bool>& keep)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) {
      all.points[kept] = all.points[i];
      all.kinds[kept] = all.kinds[i];
      all.support[kept++] = all.support[i];
    }
  all.points.resize(kept);
  all.kinds.resize(kept);
  all.support.resize(kept);
}

} // namespace

Surroundings
findSurroundings(const PowerLineNetwork& network,
                 const io::Cloud& cloud,
                 const io::UsablePoints& usable,
                 const ClearanceLimits& limits,
                 const SurroundingClasses& meant,
                 unsigned threads,
                 const ProgressMonitor* monitor)
{
  Surroundings found;
  if (network.wires.empty() || network.ground.heights.empty())
    return found;
  const MetricFrame frame(cloud);
  const io::Column* classes = cloud.find("classification");
  const io::Column* returns = cloud.find("number_of_returns");
  const double reach = limits.largest(), margin = limits.of(HazardKind::FallIn).low;
  const WireCells cells(network.wires, std::max(reach, tallest + margin));

  // What each point is; Nothing if it is too far from every wire to matter.
  const auto n = static_cast<std::ptrdiff_t>(cloud.points.size());
  std::vector<Meaning> meanings(cloud.points.size(), Meaning::Nothing);
#pragma omp parallel for schedule(dynamic, 4096) num_threads(threadCount(threads))
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Point p = frame.meters(usable.points()[i]);
    if (!p.allFinite() || network.wire_id[i] != 0)
      continue;
    const int given =
        classes != nullptr ? static_cast<int>(io::valueAt(*classes, i)) : 0;
    const Meaning meaning = meaningOf(given, network.classes[i], meant);
    const double height = p.z() - network.ground.heightAt(p.x(), p.y());
    if (meaning == Meaning::Nothing || !(height > off_ground))
      continue;
    const double far = std::max(reach, std::min(height, tallest) + margin);
    const auto& near = cells.near(p);
    // Classifiers often mistake insulators for vegetation.
    if ((meaning == Meaning::Unknown || meaning == Meaning::Vegetation) &&
        std::any_of(near.begin(), near.end(), [&](std::uint32_t w) {
          return mayCarry(network.wires[w], network.supports, p);
        }))
      continue;
    for (const std::uint32_t w : near)
      if (squaredToSegment(network.wires[w].front.head<2>(),
                           network.wires[w].back.head<2>(),
                           p) < far * far) {
        meanings[i] = meaning;
        break;
      }
  }
  throwIfCanceled(monitor);

  std::vector<Index> unknown; // indices in found
  std::vector<bool> single;
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    if (meanings[i] == Meaning::Nothing)
      continue;
    const Point p = frame.meters(usable.points()[i]);
    if (meanings[i] == Meaning::Unknown)
      unknown.push_back(static_cast<Index>(found.points.size()));
    single.push_back(returns == nullptr || io::valueAt(*returns, i) <= 1);
    found.points.push_back(p);
    found.kinds.push_back(meanings[i] == Meaning::Building  ? HazardKind::Building
                          : meanings[i] == Meaning::Support ? HazardKind::Support
                                                            : HazardKind::Vegetation);
    found.support.push_back(
        meanings[i] == Meaning::Support ? supportAt(network.supports, p) : 0);
  }
  const std::vector<bool> lines = tellApart(found, unknown, single, threads);
  throwIfCanceled(monitor);

  const UniformGrid grid(found.points, company_radius);
  std::vector<bool> keep(found.points.size());
  for (std::size_t i = 0; i < keep.size(); ++i)
    keep[i] = found.kinds[i] != HazardKind::Support || found.support[i] != 0;
  for (const Index i : unknown)
    keep[i] = !lines[i] && grid.countWithin(found.points[i], company_radius) > company;
  filter(found, keep);
  return found;
}

} // namespace linelet::powerline
