// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>

#include "las_front.h"

namespace linelet::io {

/** \brief Makes the records of all points of a cloud in several threads, and passes
 * them on in order.
 * \param[in] count number of points of the cloud of \a front
 * \param[in] put called from one thread at a time, while others make the next
 * records */
void
forEachRecords(const LasFront& front,
               std::size_t count,
               const FileWork& target,
               const std::function<void(const std::string& records)>& put);

} // namespace linelet::io
