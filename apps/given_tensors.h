// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/tensor/neighborhood_tensor.h>

namespace linelet::apps {

/** \brief The attributes that hold the tensors of points: xx, xy, xz, yy, yz, zz. */
const std::vector<std::string>&
tensorAttributes();

/** \brief The tensors in these attributes of a cloud.
 * \throws std::runtime_error if one of them is missing */
std::vector<SymmetricTensor>
givenTensors(const io::Cloud& cloud, const std::string& file);

} // namespace linelet::apps
