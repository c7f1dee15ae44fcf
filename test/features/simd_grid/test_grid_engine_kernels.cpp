// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <iostream>

#include <hwy/targets.h>

#include <linelet/tensor/eigen_analysis.h>

#include "features/simd_grid/kernels/sweep_kernels.h"
#include "features/simd_grid/kernels/weight_error.h"
#include "features/simd_grid/test_grid_engine.h"

using namespace linelet;
using namespace linelet::test;

namespace {

/** \brief Runs a check on every instruction set of this machine and build. */
template <class Check>
void
onEveryInstructionSet(const Check& check)
{
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    SCOPED_TRACE(grid::sweepKernels().target);
    check();
    hwy::SetSupportedTargetsForTest(0);
  }
}

std::vector<Weighting>
allWeightings()
{
  std::vector<Weighting> all;
  for (const auto& kernel : Names<Kernel>::table)
    if (kernel.first != Kernel::FermiDirac && kernel.first != Kernel::Step)
      all.emplace_back(kernel.first);
  all.push_back(Weighting::fermiDirac(0.5, 0.02));
  all.push_back(Weighting::fermiDirac(2, 5));
  all.push_back(Weighting::fermiDirac(0.5, 1e-6));
  return all;
}

} // namespace

TEST(GridKernels, RunOnMoreThanOneInstructionSet)
{
  std::cout << "best instruction set: " << gridInstructionSet() << "\n";
  EXPECT_FALSE(gridInstructionSet().empty());
  EXPECT_GE(hwy::SupportedAndGeneratedTargets().size(), 1u);
}

// If a SIMD weight exceeded its stated error bound, so would shape factors: tested on
// the functions themselves, and on tables where they are used.
TEST(GridKernels, WeightsAreWithinTheirBounds)
{
  constexpr std::size_t count = 16384;
  std::vector<float> squared(count), weight(count);
  onEveryInstructionSet([&] {
    for (const Weighting& w : allWeightings())
      for (const bool table : {false, true}) {
        const grid::WeightError bound = grid::weightError(w);
        for (std::size_t i = 0; i < count; ++i) {
          // Tables end at the largest distance of a neighbor.
          const double x = (table ? 0.9999 : 1.25) * static_cast<double>(i) / count;
          squared[i] = static_cast<float>(x * x);
        }
        grid::sweepKernels().weights(
            grid::SweepWeight(w), table, squared.data(), weight.data(), count);
        for (std::size_t i = 0; i < count; ++i) {
          const double u = squared[i];
          if (std::abs(u - 1) < 1e-6)
            continue; // a step of ease-exponential
          const double expected = w(std::sqrt(u));
          EXPECT_NEAR(
              weight[i], expected, bound.absolute + bound.relative * expected + 1e-37)
              << w.name() << " at " << std::sqrt(u) << (table ? " by table" : "");
        }
      }
  });
}

// The bound of every Fermi-Dirac weight in the specification, checked against its
// closed form: 1e-6 relative.
TEST(GridKernels, FermiDiracIsWithinAMillionth)
{
  constexpr std::size_t count = 16384;
  std::vector<float> squared(count), weight(count);
  for (std::size_t i = 0; i < count; ++i)
    squared[i] = static_cast<float>(i) / count;
  const std::vector<std::pair<Kernel, std::pair<double, double>>> kernels = {
      {Kernel::FermiDirac1, {0.6, 0.1}},
      {Kernel::FermiDirac2, {0.35, 0.05}},
      {Kernel::FermiDirac3, {0.3, 0.1}}};
  for (const auto& [kernel, parameters] : kernels) {
    const auto [m, t] = parameters;
    EXPECT_GE(grid::SweepWeight(kernel).table.degree, 3) << nameOf(kernel);
    onEveryInstructionSet([&, kernel = kernel, m = m, t = t] {
      for (const bool table : {false, true}) {
        grid::sweepKernels().weights(
            grid::SweepWeight(kernel), table, squared.data(), weight.data(), count);
        for (std::size_t i = 0; i < count; ++i) {
          const double x = std::sqrt(static_cast<double>(squared[i]));
          const double exact = 1 / (std::exp((x - m) / t) + 1);
          // Rounding of x matters in units of the temperature.
          const double argument = 0x1p-24 * x / t;
          const bool looked_up = table && grid::sweepKernels().lanes == 16;
          EXPECT_NEAR(
              weight[i], exact, (looked_up ? 1e-6 : 1e-6 + 2 * argument) * exact)
              << nameOf(kernel) << " at " << x << (table ? " by table" : "");
        }
      }
    });
  }
}

TEST(GridKernels, EveryInstructionSetAgrees)
{
  const Points points = uniformPoints(2500, {6, 6, 2}, 3);
  onEveryInstructionSet([&] {
    for (const char* weight : {"const", "fermi-dirac-1", "cs-rbf-2"})
      for (const Centroid centroid :
           {Centroid::QueryPoint, Centroid::Mean, Centroid::WeightedMean}) {
        TensorSettings settings;
        settings.radius = 0.9;
        settings.weighting = Weighting(weight);
        settings.centroid = centroid;
        EXPECT_TRUE(gridAgrees(points, settings, {}, 200));
      }
  });
}

// The higher moments of points determine their weighted moments around any query.
TEST(GridKernels, QuadraticMomentsHoldForEveryQuery)
{
  for (const std::size_t count : {1, 7, 16, 1500}) {
    const Points points = uniformPoints(count, {1.5, 1, 0.2}, 31);
    grid::PointList list;
    list.reserve(count + 3);
    for (const Point& p : points) {
      list.x[list.size + 3] = static_cast<float>(p.x());
      list.y[list.size + 3] = static_cast<float>(p.y());
      list.z[list.size + 3] = static_cast<float>(p.z());
      ++list.size;
    }
    list.size += 3;
    onEveryInstructionSet([&] {
      grid::QuadraticMoments sums;
      const Point center(0.25, -0.125, 0.5);
      grid::sweepKernels().quadraticMoments(list, 3, {0.25F, -0.125F, 0.5F}, sums);
      const grid::QuadraticMoments moved = sums.relativeTo(-center);
      for (const Point& q : uniformPoints(5, {2, 2, 2}, 32)) {
        grid::Moments expected;
        for (const Point& p : points)
          expected.add(0.75 - 0.6 * (p - q).squaredNorm(), p - q);
        const grid::Moments found = moved.weighted(0.75, -0.6, q).relativeTo(q);
        const double bound = 2e-6 * static_cast<double>(count);
        EXPECT_NEAR(found.count, expected.count, bound);
        EXPECT_LE((found.first - expected.first).norm(), bound);
        EXPECT_LE((found.matrix() - expected.matrix()).norm(), bound);
      }
    });
  }
}

TEST(GridKernels, EigenAnalysisKeepsSmallEigenvalues)
{
  constexpr std::size_t count = 1000;
  const Points axes = uniformPoints(3 * count, {1, 1, 1}, 9);
  std::array<std::vector<double>, 6> tensor;
  std::array<std::vector<double>, 9> out;
  for (auto& entries : tensor)
    entries.resize(count + grid::PointList::padding);
  for (auto& entries : out)
    entries.resize(count + grid::PointList::padding);
  std::vector<SymmetricTensor> tensors(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Wires, discs, balls and zero, with eigenvalues down to 1e-10 of the largest.
    const double thin = std::pow(10.0, -static_cast<double>(i % 11));
    const double flat = i % 3 == 0 ? 1 : std::pow(10.0, -static_cast<double>(i % 7));
    if (i % 101 != 0) {
      tensors[i].add(1, axes[3 * i]);
      tensors[i].add(flat, axes[3 * i + 1]);
      tensors[i].add(thin, axes[3 * i + 2]);
    }
    const SymmetricTensor& t = tensors[i];
    const std::array<double, 6> entries = {t.xx, t.xy, t.xz, t.yy, t.yz, t.zz};
    for (std::size_t entry = 0; entry < 6; ++entry)
      tensor[entry][i] = entries[entry];
  }
  grid::EigenBatch batch{};
  batch.count = count;
  for (std::size_t entry = 0; entry < 6; ++entry)
    batch.tensor[entry] = tensor[entry].data();
  for (std::size_t i = 0; i < 3; ++i) {
    batch.values[i] = out[i].data();
    batch.major[i] = out[3 + i].data();
    batch.normal[i] = out[6 + i].data();
  }
  onEveryInstructionSet([&] {
    grid::sweepKernels().eigen(batch);
    for (std::size_t i = 0; i < count; ++i) {
      const EigenSystem expected = eigenAnalysis(tensors[i]);
      const double scale = tensors[i].trace();
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(batch.values[k][i],
                    expected.values[static_cast<Eigen::Index>(k)],
                    1e-14 * scale);
      const Point major(batch.major[0][i], batch.major[1][i], batch.major[2][i]);
      const Point normal(batch.normal[0][i], batch.normal[1][i], batch.normal[2][i]);
      EXPECT_NEAR(major.norm(), 1, 1e-14);
      EXPECT_NEAR(normal.norm(), 1, 1e-14);
      EXPECT_NEAR(major.dot(normal), 0, 1e-14);
      // An eigenvector, by definition.
      const Eigen::Matrix3d m = tensors[i].matrix();
      EXPECT_LE((m * major - batch.values[2][i] * major).norm(), 1e-14 * scale);
      EXPECT_LE((m * normal - batch.values[0][i] * normal).norm(), 1e-14 * scale);
      Eigen::Index largest = 0;
      major.cwiseAbs().maxCoeff(&largest);
      EXPECT_GT(major[largest], 0);
    }
  });
}
