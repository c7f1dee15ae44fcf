// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/io/vector_file.h>
#include <linelet/powerline/metric_frame.h>
#include <linelet/support/points.h>

namespace linelet::powerline {

/** \brief An integer as an attribute. */
io::Value
whole(std::size_t value);
io::Value
whole(int value);

/** \brief The name of an enumerator as an attribute. */
template <class E>
io::Value
named(E value)
{
  return std::string(nameOf(value));
}

/** \brief Two decimals for a label, "-" for NaN. */
std::string
decimals(double value);

Points
worldPoints(const Points& points, const MetricFrame& frame);

/** \brief Sets the height of labels in drawings. */
void
setTextHeight(std::vector<io::VectorLayer>& layers, const MetricFrame& frame);

} // namespace linelet::powerline
