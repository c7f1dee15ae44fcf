// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <string>

#include "caster.h"
#include "scanner.h"

namespace linelet::bench::scenes {

namespace {

constexpr double dead_zone = 0.5; ///< minimum distance of returns of a pulse, meters
constexpr std::size_t most_returns = 5;
constexpr double outliers = 1e-5; ///< share of pulses that return from empty air

/** One strip: the aircraft's position and the residual offset of the strip
 * adjustment. */
struct Flight {
  std::uint16_t number = 1;
  double across = 0; ///< of the aircraft, in the frame of the flight
  double tilt = 0;   ///< forward, radians
  Point offset = Point::Zero();
};

class Scanner {
public:
  Scanner(const World& world, const ScanPlan& plan, Random& random, SceneScan& out)
      : world_(world),
        plan_(plan),
        random_(random),
        out_(out),
        caster_(world, static_cast<std::uint32_t>(random.integer(0, 1 << 30))),
        along_(std::cos(plan.heading), std::sin(plan.heading), 0),
        across_(-along_.y(), along_.x(), 0),
        middle_(world.relief.at(0.5 * world.length, 0))
  {
    // Lines are farther apart than the pulses of a line, or closer together.
    aspect_ = std::exp(random.uniform(-0.7, 1.4));
    zigzag_ = random.integer(0, 1) == 0;
  }

  void
  fly(const Flight& flight, ProgressMonitor* monitor)
  {
    const double spacing = std::sqrt(plan_.strips / plan_.density);
    const double line_step = spacing * std::sqrt(aspect_);
    const double pulse_step = spacing / std::sqrt(aspect_);
    // Solves reach = half the extent + the margin there.
    const double reach = (0.5 * std::hypot(world_.length, world_.width) +
                          std::abs(flight.across) + marginAt(flight, flight.across)) *
                         (1 + tallest() / plan_.altitude);
    const auto lines = static_cast<std::size_t>(2 * reach / line_step);
    if (monitor != nullptr)
      monitor->begin("scan strip " + std::to_string(flight.number), lines);
    for (std::size_t line = 0; line < lines; ++line) {
      if (monitor != nullptr) {
        if (monitor->canceled())
          throw Canceled();
        monitor->advance(1);
      }
      const double u = -reach + line_step * static_cast<double>(line);
      const double phase = random_.uniform(0, pulse_step);
      for (double v = -reach + phase; v < reach; v += pulse_step) {
        // An oscillating mirror scans lines that lean alternately.
        const double lean =
            zigzag_ ? (line % 2 == 0 ? 0.5 : -0.5) * line_step * v / reach : 0;
        const double aside = random_.normal(0.1 * pulse_step);
        shoot(flight, u + lean + random_.normal(0.1 * line_step), v + aside);
      }
    }
  }

private:
  /** Height of the tallest object above the ground in the middle, in meters. */
  double
  tallest() const
  {
    return std::max(0.0, caster_.top() - middle_.z());
  }

  /** Tall objects are hit by pulses whose ground point lies outside the extent: the
   * distance outside for pulses aimed at \a v. */
  double
  marginAt(const Flight& flight, double v) const
  {
    const double slope = std::hypot((v - flight.across) / (plan_.altitude + tallest()),
                                    std::tan(flight.tilt));
    return tallest() * slope + 3;
  }

  void
  shoot(const Flight& flight, double u, double v)
  {
    const Point plan = middle_ + u * along_ + v * across_;
    const double margin = marginAt(flight, v);
    if (plan.x() < -margin || plan.x() > world_.length + margin ||
        std::abs(plan.y()) > 0.5 * world_.width + margin)
      return;
    const Point target = world_.relief.at(plan.x(), plan.y());
    Pulse pulse;
    pulse.origin = middle_ + (u - plan_.altitude * std::tan(flight.tilt)) * along_ +
                   flight.across * across_;
    pulse.origin.z() = std::max(middle_.z(), caster_.top()) + plan_.altitude;
    pulse.direction = target - pulse.origin;
    pulse.ground = pulse.direction.norm();
    pulse.direction /= pulse.ground;

    returns_.clear();
    if (random_.uniform(0, 1) < outliers) {
      const double t = pulse.ground - random_.uniform(-3, 60);
      returns_.push_back({t, pulse.at(t), 1, NoiseClass, -1});
    }
    else
      listen(pulse, target);
    for (std::size_t i = 0; i < returns_.size(); ++i)
      record(flight, i);
  }

  /** The receiver: every hit takes its share of the pulse's energy. */
  void
  listen(const Pulse& pulse, const Point& target)
  {
    double energy = 1, last = -1e9;
    const auto hear = [&](const Hit& hit) {
      const double signal = energy * hit.cover;
      energy -= signal;
      if (signal > random_.uniform(0.03, 0.15) && hit.t - last > dead_zone) {
        returns_.push_back(hit);
        last = hit.t;
      }
    };
    for (const Hit& hit : caster_.cast(pulse, random_)) {
      hear(hit);
      if (energy < 0.05 || returns_.size() == most_returns)
        return;
    }
    if (!world_.relief.water(target.x(), target.y()))
      hear({pulse.ground, target, 1, GroundClass, -1});
  }

  void
  record(const Flight& flight, std::size_t number)
  {
    const Hit& hit = returns_[number];
    Point p = hit.place + flight.offset;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] += random_.normal(plan_.noise);
    if (hit.classification == GroundClass)
      p.z() += std::abs(random_.normal(0.02)); // grass
    if (p.x() < 0 || p.x() > world_.length || std::abs(p.y()) > 0.5 * world_.width)
      return;
    out_.points.push_back(p);
    out_.classification.push_back(hit.classification);
    out_.return_number.push_back(static_cast<std::uint8_t>(number + 1));
    out_.number_of_returns.push_back(static_cast<std::uint8_t>(returns_.size()));
    out_.strip.push_back(flight.number);
    out_.wire.push_back(hit.wire);
  }

  const World& world_;
  const ScanPlan& plan_;
  Random& random_;
  SceneScan& out_;
  Caster caster_;
  Point along_, across_, middle_;
  double aspect_ = 1;
  bool zigzag_ = false;
  std::vector<Hit> returns_;
};

} // namespace

void
scan(const World& world,
     const ScanPlan& plan,
     Random& random,
     SceneScan& out,
     ProgressMonitor* monitor)
{
  Scanner scanner(world, plan, random, out);
  std::vector<Flight> flights(plan.strips);
  Point shared = Point::Zero();
  for (unsigned k = 0; k < plan.strips; ++k) {
    Flight& flight = flights[k];
    flight.number = static_cast<std::uint16_t>(k + 1);
    flight.across = world.width * ((k + 0.5) / plan.strips - 0.5) * 1.2 +
                    random.uniform(-0.1, 0.1) * plan.altitude;
    flight.tilt = random.uniform(-6, 6) * pi / 180;
    for (int axis = 0; axis < 3; ++axis)
      flight.offset[axis] = random.normal(plan.misfit);
    shared += flight.offset / plan.strips;
  }
  for (Flight& flight : flights) {
    flight.offset -= shared; // an offset shared by all strips is not visible
    scanner.fly(flight, monitor);
  }
}

} // namespace linelet::bench::scenes
