// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief A section of the page. */
struct Section {
  std::string id;    ///< its place in links; also page/ID.mustache, which draws it
  std::string title; ///< heading; may be empty
  nlohmann::ordered_json data; ///< for the template
};

/** \brief The most important figures: lines, lengths, how many wires are too low. */
Section
summarySection(const Content& content);

/** \brief The lines seen from above. */
Section
planSection(const Content& content);

/** \brief Cloud and lines in space, that can be rotated; a still picture without
 * WebGL 2. */
Section
spaceSection(const Content& content);

/** \brief Everything below the clearance limit, the closest first. */
Section
clearancesSection(const Content& content);

/** \brief What comes too close to the wires as they were scanned: stretches, trees that
 * could fall in, crossings, limits. Needs hazards. */
Section
hazardsSection(const Content& content);

/** \brief The same for every other state of the conductors, and how they got there. */
Section
statesSection(const Content& content);

/** \brief Table of all spans. */
Section
spansSection(const Content& content);

/** \brief Profile and wires of every span. */
Section
profilesSection(const Content& content, const ProgressMonitor* monitor);

/** \brief Inputs and settings of the run. */
Section
settingsSection(const Content& content);

/** \brief All sections of the page, in order. A new section takes a function here, a
 * template in page/ and a line in this function. */
std::vector<Section>
sectionsOf(const Content& content, const ProgressMonitor* monitor);

} // namespace linelet::powerline::report
