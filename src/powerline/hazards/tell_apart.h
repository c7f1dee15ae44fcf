// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/surroundings.h>

namespace linelet::powerline {

/** \brief Distinguishes buildings from vegetation among the points of \a all listed in
 * \a unknown, by the planarity of their surroundings over some meters and by the share
 * of single echoes, both averaged over the neighborhood.
 * \param[in] single whether each point is the only echo of its pulse
 * \return whether each point is part of something as thin as a wire */
std::vector<bool>
tellApart(Surroundings& all,
          const Indices& unknown,
          const std::vector<bool>& single,
          unsigned threads);

} // namespace linelet::powerline
