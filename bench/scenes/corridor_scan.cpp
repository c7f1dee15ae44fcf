// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_scan.h"

#include <algorithm>
#include <cmath>

#include "corridor_rays.h"

namespace linelet::bench::corridor {

namespace {

constexpr double gain = 22; ///< signal over the detection threshold at reflectivity 1
constexpr double dead_zone = 0.5; ///< minimum distance of returns of a pulse, meters
constexpr int most_returns = 5;

/** One strip: where the aircraft is and how it sways. */
struct Flight {
  std::uint16_t number;
  double y, tilt, roll_phase, start_time;
  Point error; ///< residual offset of the strip adjustment
};

class Scanner {
public:
  Scanner(const Scene& scene, const CorridorSettings& settings, Random& random)
      : settings_(settings),
        random_(random),
        scene_(scene),
        beam_(0.0005 * settings.divergence * settings.altitude),
        caster_(scene, beam_)
  {
    out_.beam_radius = beam_;
  }

  void
  fly(const Flight& flight, ProgressMonitor* monitor)
  {
    const double spacing = std::sqrt(settings_.strips / settings_.density);
    const double half = 0.5 * settings_.width, reach = half + 5;
    // Tall objects at the ends are hit by rays whose ground point lies outside.
    const double margin = 5 + caster_.top() * std::abs(std::tan(flight.tilt));
    const auto lines =
        static_cast<std::size_t>((settings_.length + 2 * margin) / spacing);
    const auto pulses = static_cast<std::size_t>(2 * reach / spacing);
    if (monitor != nullptr)
      monitor->begin("scan strip " + std::to_string(flight.number), lines);
    for (std::size_t line = 0; line < lines; ++line) {
      if (monitor != nullptr) {
        if (monitor->canceled())
          throw Canceled();
        monitor->advance(1);
      }
      const double x = -margin + spacing * static_cast<double>(line);
      const double sway = 0.4 * std::sin(x / 37 + flight.roll_phase);
      for (std::size_t i = 0; i < pulses; ++i) {
        const double y = -reach + spacing * (static_cast<double>(i) + 0.5) + sway;
        const double jitter = 0.1 * spacing;
        Point target(x, y, 0);
        target.x() += random_.normal(jitter);
        target.y() += random_.normal(jitter);
        Ray ray;
        ray.origin = Point(x - settings_.altitude * std::tan(flight.tilt),
                           flight.y,
                           settings_.altitude);
        ray.direction = (target - ray.origin).normalized();
        const double time =
            flight.start_time + 0.01 * static_cast<double>(line) +
            0.006 * static_cast<double>(i) / static_cast<double>(pulses);
        pulse(flight, ray, time);
      }
    }
  }

  CorridorScan
  finish()
  {
    return std::move(out_);
  }

private:
  void
  pulse(const Flight& flight, const Ray& ray, double time)
  {
    returns_.clear();
    const std::vector<Hit>& hits = caster_.cast(ray, random_);
    if (random_.uniform(0, 1) < settings_.outliers) {
      const double low = hits.back().t - caster_.top() - 40;
      Hit hit{random_.uniform(low, hits.back().t + 3), NoiseClass, 0.1F, 0.2, -1};
      returns_.push_back({hit, 0.1});
    }
    else
      collect(hits);
    for (std::size_t i = 0; i < returns_.size(); ++i)
      record(flight, ray, time, i);
  }

  /** The receiver: every hit takes its share of the beam's energy. */
  void
  collect(const std::vector<Hit>& hits)
  {
    double energy = 1, last = -1e9;
    for (const Hit& hit : hits) {
      const double share = energy * hit.fraction;
      const double signal = share * hit.reflectivity;
      energy -= share;
      if (random_.uniform(0, 1) < gain * signal && hit.t - last > dead_zone) {
        returns_.push_back({hit, signal});
        last = hit.t;
      }
      if (energy < 0.02 || returns_.size() == most_returns)
        return;
    }
  }

  void
  record(const Flight& flight, const Ray& ray, double time, std::size_t number)
  {
    const Hit& hit = returns_[number].hit;
    Point p = ray.at(hit.t + random_.normal(settings_.range_noise)) + flight.error;
    if (p.x() < 0 || p.x() > settings_.length ||
        std::abs(p.y()) > 0.5 * settings_.width)
      return;
    std::uint8_t classification = hit.classification;
    if (classification == GroundClass) {
      if (random_.uniform(0, settings_.thin_ground) >= 1)
        return;
      p.z() += std::abs(random_.normal(0.02)); // grass
    }
    if (classification == VegetationClass) {
      const double above = p.z() - scene_.terrain.height(p.x(), p.y());
      classification = above < 1 ? 3 : (above < 3 ? 4 : 5);
    }
    const double noise = 1 + random_.normal(0.08);
    out_.points.push_back(p);
    out_.classification.push_back(classification);
    out_.intensity.push_back(static_cast<std::uint16_t>(
        std::clamp(60000 * returns_[number].signal * noise, 1.0, 65535.0)));
    out_.return_number.push_back(static_cast<std::uint8_t>(number + 1));
    out_.number_of_returns.push_back(static_cast<std::uint8_t>(returns_.size()));
    out_.scan_angle.push_back(static_cast<float>(
        -std::atan2(ray.direction.y(), -ray.direction.z()) * 180 / pi));
    out_.strip.push_back(flight.number);
    out_.gps_time.push_back(time);
    out_.wire.push_back(hit.wire);
  }

  struct Return {
    Hit hit;
    double signal;
  };

  const CorridorSettings& settings_;
  Random& random_;
  const Scene& scene_;
  double beam_;
  RayCaster caster_;
  std::vector<Return> returns_;
  CorridorScan out_;
};

} // namespace

CorridorScan
scan(const Scene& scene,
     const CorridorSettings& settings,
     Random& random,
     ProgressMonitor* monitor)
{
  Scanner scanner(scene, settings, random);
  for (unsigned k = 0; k < settings.strips; ++k) {
    Flight flight;
    flight.number = static_cast<std::uint16_t>(k + 1);
    flight.y = settings.width * ((k + 0.5) / settings.strips - 0.5) * 0.6;
    flight.tilt = random.uniform(-6, 6) * pi / 180;
    flight.roll_phase = random.uniform(0, 2 * pi);
    flight.start_time = 300000000.0 + 240.0 * k + 0.001 * random.integer(0, 100000);
    for (int axis = 0; axis < 3; ++axis)
      flight.error[axis] = random.normal(settings.strip_error);
    scanner.fly(flight, monitor);
  }
  return scanner.finish();
}

} // namespace linelet::bench::corridor
