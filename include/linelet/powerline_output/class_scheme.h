// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include <linelet/io/cloud.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/support/names.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief What to do with points that had the class of a wire or tower but belong to
 * nothing that was found. */
enum class ExistingClasses {
  Keep, ///< they keep their class
  Reset ///< they become unclassified (1)
};

/** \brief The classes to assign to a cloud. */
struct ClassScheme {
  unsigned wire = wire_class, tower = pylon_class; ///< 0 to 255
  ExistingClasses existing = ExistingClasses::Keep;
};

template <class Visit>
void
describe(ClassScheme& s, Visit&& visit)
{
  visit("wire-class", s.wire, "class of wires in classified.las (ASPRS: 14)");
  visit("tower-class", s.tower, "class of pylons and poles there (ASPRS: 15)");
  visit("existing-classes",
        s.existing,
        "what to do with points that had one of these classes but belong to no wire or "
        "support found: keep the class, or reset it to unclassified (1)");
}

/** \brief Checks the classes. \throws std::invalid_argument if one is above 255 or both
 * are the same */
void
check(const ClassScheme& scheme);

/** \brief Adds to \a cloud what was found: the classes of \a scheme in
 * `classification`, and the columns `wire_id` and `span_id` (0: none), `wire_distance`
 * (meters, NaN: none) and `unexplained` (1: part of PowerLineNetwork::unexplained).
 * Every other class and attribute stays as it is.
 * \return how many points had one of these classes but belong to nothing that was found
 * \throws std::invalid_argument unless the network belongs to the cloud; see also \ref
 * check */
std::size_t
classify(io::Cloud& cloud,
         const PowerLineNetwork& network,
         const ClassScheme& scheme = {});

} // namespace powerline

template <>
struct Names<powerline::ExistingClasses> {
  static constexpr std::string_view kind = "treatment of existing classes";
  static constexpr std::array<std::pair<powerline::ExistingClasses, std::string_view>,
                              2>
      table = {{{powerline::ExistingClasses::Keep, "keep"},
                {powerline::ExistingClasses::Reset, "reset"}}};
};

} // namespace linelet
