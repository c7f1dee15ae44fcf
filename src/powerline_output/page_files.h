// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace linelet::powerline::report {

/** \brief A file of the folder page/, embedded at build time. */
struct EmbeddedText {
  const char* name; ///< null: end of the table
  const char* text;
};

extern const EmbeddedText page_files[];

} // namespace linelet::powerline::report
