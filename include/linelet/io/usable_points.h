// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief The points of a cloud that an analysis may use.
 *
 * A point flagged as withheld counts as deleted (so the LAS specification: not to be
 * included in processing). It stays in the cloud, so that a file written again has it
 * bit for bit; here it has no coordinates, which every analysis passes over. Overlap,
 * synthetic and key points are points like others. */
class UsablePoints {
public:
  /** \brief Those of \a cloud, which must outlive this.
   * \param[out] warnings one sentence where any point is left out */
  explicit UsablePoints(const Cloud& cloud,
                        std::vector<std::string>* warnings = nullptr);

  /** \brief As many as the cloud has, in its order; NaN where withheld. */
  const Points&
  points() const
  {
    return withheld_ == 0 ? cloud_.points : usable_;
  }

  std::size_t
  withheld() const
  {
    return withheld_;
  }

private:
  const Cloud& cloud_;
  Points usable_; // empty where nothing is withheld
  std::size_t withheld_ = 0;
};

} // namespace io
} // namespace linelet
