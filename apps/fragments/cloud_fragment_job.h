// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fragment_job.h"
#include "fragment_parts.h"

namespace linelet::apps {

/** \brief A command that writes one cloud per input cloud. */
class CloudFragmentJob : public FragmentJob {
public:
  const std::string&
  place() const override
  {
    return output_.path();
  }
  std::vector<std::size_t>
  needs(const fragments::Plan& plan, std::size_t number) override
  {
    return fragmentsOfInput(plan, number);
  }

protected:
  CloudFragmentJob(const std::string& command,
                   const std::string& summary,
                   const BytesPerPoint& bytes_per_point)
      : FragmentJob(command, summary, bytes_per_point)
  {
  }

  CloudOutput output_{frame_};
};

} // namespace linelet::apps
