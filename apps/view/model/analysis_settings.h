// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/curves/reconstruct_curves.h>
#include <linelet/features/multi_scale_settings.h>
#include <linelet/features/tensor_settings.h>
#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>
#include <linelet/powerline/power_line_settings.h>
#include <linelet/support/names.h>

namespace linelet::view {

/** \brief The analyses of the viewer, each a command of the tool. */
enum class Analysis { Tensor, MultiScale, Curves, PowerLines };

/** \brief An option of an analysis, from its description. */
struct Parameter {
  enum class Kind { Flag, Count, Number, Numbers, Choice, Text };
  std::string name, heading, meaning;
  Kind kind = Kind::Text;
  std::string value, standard;      ///< as on the command line; standard: the default
  std::vector<std::string> choices; ///< of Kind::Choice; some allow others, too
  std::string range;                ///< as text
  std::string unit;                 ///< empty: none, or unknown
};

/** \brief All settings of the four analyses, with the names, meanings and checks of the
 * tool's own options. */
class AnalysisSettings {
public:
  io::ReadOptions read;
  io::ClassFilter classes;
  TensorSettings tensor;
  MultiScaleSettings scales;
  ReconstructionSettings curves;
  powerline::PowerLineSettings wires;

  std::vector<Parameter>
  parameters(Analysis analysis) const;

  /** \brief Sets an option from text, as the tool would.
   * \throws std::invalid_argument with the reason in one sentence; nothing is
   * changed */
  void
  set(Analysis analysis, const std::string& name, const std::string& text);

  /** \brief All options of \a analysis as an option file that its command reads. */
  std::string
  config(Analysis analysis) const;

  /** \brief Reads an option file of the tool, whole or in part.
   * \return names in it that have no meaning here (such as outputs)
   * \throws std::invalid_argument with the reason; nothing is changed */
  std::vector<std::string>
  loadConfig(Analysis analysis, const std::string& path);

  /** \brief The command line that computes the same without a window: settings that
   * differ from the defaults, \a inputs and \a output, quoted for a shell. */
  std::string
  commandLine(Analysis analysis,
              const std::vector<std::string>& inputs,
              const std::string& output) const;
};

/** \brief \a word quoted for a shell. */
std::string
shellQuoted(const std::string& word);

} // namespace linelet::view

namespace linelet {

template <>
struct Names<view::Analysis> {
  static constexpr std::string_view kind = "analysis";
  static constexpr std::array<std::pair<view::Analysis, std::string_view>, 4> table = {
      {{view::Analysis::Tensor, "tensor"},
       {view::Analysis::MultiScale, "multiscale"},
       {view::Analysis::Curves, "curves"},
       {view::Analysis::PowerLines, "powerlines"}}};
};

} // namespace linelet
