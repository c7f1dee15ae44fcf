// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace linelet::benchmarking {

/** \brief Registers the benchmarks of the tensor engine. Counters: us_per_point (CPU
 * time), x_pcl (speedup over pcl::NormalEstimationOMP with as many threads in the same
 * run, including the construction of search structures), Gpairs/s, of_peak (share of
 * the inner loop's speed on data in the cache). */
void
addTensorBenchmarks();

/** \brief Registers the benchmarks of the OpenCL engine: CPU time of the whole process,
 * wall time of every stage, x_tree and x_pcl (speedup over the kd-tree engine and over
 * PCL's normals). Only if linelet was built with OpenCL. */
void
addOpenClBenchmarks();

/** \brief Registers the benchmarks of the cost of multi-scale features. Counters:
 * x_one_pass (the default sequence of radii up to 60 D, D measured, in passes of
 * estimateTensorsOnGrid at its largest radius), x_one_pass_D_given, x_one_scale (in
 * sequences of the largest radius alone), x_sweep (speedup of ScaleEngine::Grid over
 * ScaleEngine::Sweep), neighbors at the largest radius. CPU time, best of three. */
void
addMultiScaleBenchmarks();

/** \brief Registers the benchmarks of neighbor search: construction, radius search and
 * k nearest, relative to FLANN and nanoflann. */
void
addSearchBenchmarks();

} // namespace linelet::benchmarking
