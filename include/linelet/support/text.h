// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdio>
#include <string>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief \a value as messages show it, up to six digits: "-1", "0.25", "1e-09". */
inline std::string
textOf(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

} // namespace linelet
