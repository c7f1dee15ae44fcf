// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Names of an enumeration on the command line and in files.
 *
 * Specialize with `static constexpr std::string_view kind` (a word for messages) and
 * `static constexpr std::array<std::pair<E, std::string_view>, N> table`. */
template <class E>
struct Names;

/** \brief The name of \a value; "?" for a value that its table lacks. */
template <class E>
constexpr std::string_view
nameOf(E value)
{
  for (const auto& entry : Names<E>::table)
    if (entry.first == value)
      return entry.second;
  return "?";
}

/** \brief The value called \a name.
 * \throws std::invalid_argument naming the choices when there is none. */
template <class E>
E
fromName(std::string_view name)
{
  for (const auto& entry : Names<E>::table)
    if (entry.second == name)
      return entry.first;
  std::string message = "unknown " + std::string(Names<E>::kind) + " '" +
                        std::string(name) + "', use one of";
  for (const auto& entry : Names<E>::table)
    message += " " + std::string(entry.second);
  throw std::invalid_argument(message);
}

} // namespace linelet
