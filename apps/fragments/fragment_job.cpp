// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fragment_job.h"

#include <numeric>
#include <stdexcept>

namespace linelet::apps {

std::vector<std::size_t>
FragmentJob::needs(const fragments::Plan& plan, std::size_t number)
{
  std::vector<std::size_t> all(number == 0 ? plan.tiling.boxes() : 0);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::unique_ptr<FragmentJob>
makeFragmentJob(const std::string& name, const std::vector<std::string>& arguments)
{
  if (name == "tensor")
    return makeTensorJob(arguments);
  if (name == "multiscale")
    return makeMultiscaleJob(arguments);
  if (name == "powerlines")
    return makePowerlinesJob(arguments);
  if (name == "curves")
    return makeCurvesJob(arguments);
  throw std::runtime_error("'" + name +
                           "' cannot run in fragments; use tensor, "
                           "multiscale, curves or powerlines");
}

} // namespace linelet::apps
