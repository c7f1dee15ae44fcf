// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <stdexcept>

#include "commands.h"

namespace linelet::apps {

namespace {

[[noreturn]] void
refuse()
{
  throw std::runtime_error("this linelet was built without its test geometries and "
                           "pictures; configure it with -DLINELET_BUILD_BENCH=ON");
}

} // namespace

int
runGenerate(const std::vector<std::string>&)
{
  refuse();
}

int
runEvaluate(const std::vector<std::string>&)
{
  refuse();
}

int
runBenchmark(const std::vector<std::string>&)
{
  refuse();
}

int
runImage(const std::vector<std::string>&)
{
  refuse();
}

} // namespace linelet::apps
