// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <linelet/io/usable_points.h>
#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline_output/output_options.h>

namespace linelet::powerline::report {

/** \brief \a value with \a decimals digits after the point; a dash if it is unknown. */
std::string
number(double value, int decimals);

/** \brief \a text with HTML's reserved characters escaped. */
std::string
escaped(std::string_view text);

/** \brief Growing HTML or SVG text. Numbers get one decimal, enough for pixels. */
class Markup {
public:
  Markup&
  operator<<(std::string_view text)
  {
    text_ += text;
    return *this;
  }

  Markup&
  operator<<(double value)
  {
    text_ += number(value, 1);
    return *this;
  }

  Markup&
  operator<<(int value)
  {
    text_ += std::to_string(value);
    return *this;
  }

  Markup&
  operator<<(std::size_t value)
  {
    text_ += std::to_string(value);
    return *this;
  }

  const std::string&
  text() const
  {
    return text_;
  }

private:
  std::string text_;
};

/** \brief A round step that gives about \a count marks over \a range: 1, 2 or 5 times a
 * power of ten. */
double
roundStep(double range, int count);

/** \brief Color of the wire with that number. */
std::string_view
wireColor(int number);

/** \brief Input of all parts of the report. */
struct Content {
  const io::Cloud& cloud;
  const PowerLineNetwork& network;
  const OutputOptions& options;
  MetricFrame metric;
  io::UsablePoints usable;

  /** \brief A point of the cloud in meters, as the network has it; NaN if left out. */
  Point
  point(std::size_t i) const
  {
    return metric.meters(usable.points()[i]);
  }

  const Wire&
  wire(int id) const
  {
    return network.wires[static_cast<std::size_t>(id) - 1];
  }

  /** \brief \a meters with \a decimals, followed by feet if the file is in feet: "3.21
   * (10.5 ft)". */
  std::string
  length(double meters, int decimals) const;

  /** \brief "P3", or "edge" for an end without a support. */
  std::string
  supportName(int id) const;
};

} // namespace linelet::powerline::report
