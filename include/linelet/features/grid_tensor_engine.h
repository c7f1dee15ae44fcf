// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>
#include <vector>

#include <linelet/features/tensor_record.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Engine::Grid for radii: \ref estimateTensors at the speed of the machine.
 *
 * Points are sorted into blocks about as wide as the radius; the inner loops run over
 * vectors of candidates, on the best instruction set found at run time. Sums are in
 * float relative to the query's surroundings and in double beyond them; numbers of
 * neighbors are exactly those of the other engines, shape factors agree to 1e-4
 * (median and step: exactly). Memory beside input and output is 30 to 40 bytes per
 * point, and for every thread some 20 bytes per candidate: much only where a ball holds
 * a large part of the cloud.
 *
 * Settings and sizes are those of \ref estimateTensors with a radius, or one a query.
 * \throws std::invalid_argument, Canceled as there */
std::vector<PointDistributionTensor>
estimateTensorsOnGrid(const Points& surface,
                      const Points& queries,
                      const TensorSettings& settings,
                      const NeighborhoodSizes& sizes = {},
                      ProgressMonitor* monitor = nullptr);

/** \brief Name of the instruction set that the grid engine runs on here. */
std::string_view
gridInstructionSet();

} // namespace linelet
