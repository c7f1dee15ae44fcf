// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <linelet/io/usable_points.h>
#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline_output/output_files.h>

namespace linelet::powerline::report {

/** \brief \a value with \a decimals digits behind the point; a dash where it is not
 * known. */
std::string
number(double value, int decimals);

/** \brief \a text with what HTML reserves replaced. */
std::string
escaped(std::string_view text);

/** \brief HTML or SVG text that grows. Numbers come with one decimal, as pixels do. */
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

/** \brief \a data in base64. */
std::string
base64(const std::vector<std::uint8_t>& data);

/** \brief An 8-bit palette picture as PNG in base64, for a data address.
 * \param[in] pixels row by row from the top, places in \a palette */
std::string
pngBase64(std::size_t width,
          std::size_t height,
          const std::vector<std::uint8_t>& pixels,
          const std::vector<std::array<std::uint8_t, 3>>& palette);

/** \brief Everything the parts of the report draw from. */
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

  /** \brief \a meters with \a decimals, beside them feet where the file counts in feet:
   * "3.21 (10.5 ft)". */
  std::string
  length(double meters, int decimals) const;

  /** \brief "P3", or "edge" for an end without a support. */
  std::string
  supportName(int id) const;
};

/** \brief The lines seen from above, to scale, over a picture of the cloud. */
void
addPlan(Markup& page, const Content& content);

/** \brief Points of the cloud beside every span, a few thousand each at most. */
std::vector<Indices>
pointsOfSpans(const Content& content);

/** \brief The profile of a span: wires, points, terrain, attachments, clearances. */
void
addProfile(Markup& page,
           const Content& content,
           const Span& span,
           const Indices& points);

/** \brief Table of the wires of a span (see report_table.h). */
nlohmann::ordered_json
wireTable(const Content& content, const Span& span);

/** \brief Table of all spans. */
nlohmann::ordered_json
spanTable(const Content& content);

} // namespace linelet::powerline::report
