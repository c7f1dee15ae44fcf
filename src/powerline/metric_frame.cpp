// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/metric_frame.h>

#include <cmath>
#include <stdexcept>

namespace linelet::powerline {

MetricFrame::MetricFrame(const io::Cloud& cloud)
    : units_(io::unitsOf(cloud.wkt)),
      shift_(cloud.shift),
      unit_(units_.plan, units_.plan, units_.height)
{
  if (std::isnan(units_.plan))
    throw std::invalid_argument("its reference system " + io::referenceName(cloud.wkt) +
                                " has the unit " + units_.plan_name +
                                ", but power lines need a unit of length");
}

} // namespace linelet::powerline
