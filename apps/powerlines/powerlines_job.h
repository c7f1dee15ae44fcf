// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/powerline/hazards_at_states.h>
#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline/network_part.h>
#include <linelet/powerline/power_line_settings.h>
#include <linelet/powerline_output/output_files.h>

#include "cloud_files.h"
#include "fragments/fragment_job.h"
#include "frame.h"

namespace linelet::apps {

/** \brief The command powerlines, with its options read. */
class PowerlinesJob : public FragmentJob {
public:
  explicit PowerlinesJob(const std::vector<std::string>& arguments);

  const std::string&
  place() const override
  {
    return folder_;
  }
  void
  check() override;
  double
  ghost(const Figures& /*measures*/) override;
  Figures
  compute(const FragmentTask& task) override;
  Figures
  write(const OutputTask& task) override;
  void
  report(const Figures& figures) override;
  int
  runWhole() override;

private:
  void
  warnOfUnits(const std::string& wkt);
  void
  refuseOtherResults(const std::string& other) const;
  std::string
  reference();
  powerline::InputExtent
  extent();
  std::size_t
  wiresCutOff(const fragments::Plan& plan,
              const fragments::Fragment& fragment,
              const io::Cloud& cloud,
              const powerline::NetworkPart& part) const;
  /** Reads the input again and writes it with what was found.
   * \return points whose class is not confirmed, see powerline::classify */
  std::size_t
  copyInput(const powerline::PowerLineNetwork& network,
            const Point& shift,
            const std::string& wkt,
            std::vector<std::string>* warnings);
  /** The same with all attributes held in memory, for inputs that differ too much. */
  std::size_t
  writeInOnePiece(const powerline::PowerLineNetwork& network,
                  const Point& shift,
                  const std::string& wkt,
                  std::vector<std::string>* warnings);
  void
  tell(const powerline::PowerLineNetwork& network,
       double points,
       const std::vector<std::string>& files);

  std::string folder_;
  powerline::PowerLineSettings settings_;
  powerline::HazardSettings hazards_;
  powerline::OutputOptions output_;
  double buffer_ = 300;
  std::string reviewed_;
  bool overwrite_ = false;
};

} // namespace linelet::apps
