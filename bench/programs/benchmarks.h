// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace linelet::benchmarking {

/** \brief Registers the benchmarks of the tensor engine. Counters: us_per_point (CPU
 * time), x_pcl (how many times as fast as pcl::NormalEstimationOMP with the same
 * threads in the same run, building of the search structures included), Gpairs/s,
 * of_peak (share of the inner loop's speed on data in the cache). */
void
addTensorBenchmarks();

/** \brief Registers the benchmarks of the OpenCL engine: CPU time of the whole process,
 * wall time of every stage, x_tree and x_pcl (times as fast as the kd-tree engine and
 * as PCL's normals). Only where linelet was built with OpenCL. */
void
addOpenClBenchmarks();

/** \brief Registers the benchmarks of what the scales of the multi-scale feature cost.
 * Counters: x_one_pass (the default sequence of radii up to 60 D, D measured, in passes
 * of estimateTensorsOnGrid at its largest radius), x_one_pass_D_given, x_one_scale (in
 * sequences of the largest radius alone), x_sweep (how many times as fast
 * ScaleEngine::Grid is as ScaleEngine::Sweep), neighbors at the largest radius. CPU
 * time, the best of three. */
void
addMultiScaleBenchmarks();

/** \brief Registers the benchmarks of neighbor search: building, radius search, k
 * nearest, as ratios to FLANN and nanoflann. */
void
addSearchBenchmarks();

} // namespace linelet::benchmarking
