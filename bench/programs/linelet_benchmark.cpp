// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// linelet-benchmark --benchmark_filter=tensor prints the tables of doc/benchmarks.md.

#include <string>

#include <benchmark/benchmark.h>

#include <linelet/features/grid_tensor_engine.h>

#include "benchmarks.h"

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::AddCustomContext("instruction set",
                              std::string(linelet::gridInstructionSet()));
  linelet::benchmarking::addTensorBenchmarks();
  linelet::benchmarking::addMultiScaleBenchmarks();
  linelet::benchmarking::addSearchBenchmarks();
#ifdef LINELET_HAS_OPENCL
  linelet::benchmarking::addOpenClBenchmarks();
#endif
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
