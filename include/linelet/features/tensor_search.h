// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/tensor_record.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The neighborhood tensors of \ref estimateTensors with neighbors from \a
 * search over \a surface; the engine of \a settings has no effect.
 * \throws std::invalid_argument see \ref validate
 * \throws Canceled */
std::vector<PointDistributionTensor>
estimateTensors(const NeighborSearch& search,
                const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes = {},
                ProgressMonitor* monitor = nullptr);

} // namespace linelet
