// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Converts between a cloud, which may be in feet, and the network of its lines,
 * which is in meters, with the same axes and origin (io::Cloud::shift). */
class MetricFrame {
public:
  /** \brief The frame of \a cloud, by the units of its reference system.
   * \throws std::invalid_argument if these are not lengths but degrees */
  explicit MetricFrame(const io::Cloud& cloud);

  /** \brief A point of the cloud (without its shift) in meters. */
  Point
  meters(const Point& of_cloud) const
  {
    return of_cloud.cwiseProduct(unit_);
  }

  /** \brief World coordinates, in the units of the file, of a point of the network. */
  Point
  world(const Point& of_network) const
  {
    return of_network.cwiseQuotient(unit_) + shift_;
  }

  /** \brief Height in meters above the file's zero for a height in the network. */
  double
  metersAbove(double z) const
  {
    return z + shift_.z() * unit_.z();
  }

  const io::Units&
  units() const
  {
    return units_;
  }

private:
  io::Units units_;
  Point shift_, unit_; // unit_: meters per unit of each axis
};

} // namespace powerline
} // namespace linelet
