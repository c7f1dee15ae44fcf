// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <linelet/features/point_types.h>
#include <linelet/io/cloud.h>

namespace linelet::apps {

/** \brief Attributes that `tensor` writes, as text: "linearity,verticality". "shape"
 * stands for the whole record, "all" adds the features of eigenvalues. */
class FeatureList {
public:
  /** \throws std::invalid_argument that lists the names */
  explicit FeatureList(std::string_view text);

  const std::string&
  name() const
  {
    return text_;
  }

  /** \brief In the order of the list. */
  const std::vector<std::string>&
  names() const
  {
    return names_;
  }

private:
  std::string text_;
  std::vector<std::string> names_;
};

/** \brief Adds the attributes of \a features to the points of \a cloud. */
void
addFeatures(io::Cloud& cloud,
            const std::vector<PointDistributionTensor>& records,
            const FeatureList& features);

} // namespace linelet::apps
