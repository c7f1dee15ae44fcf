// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/** \brief Exported from shared libraries; everything else in them is hidden. */
#ifdef __GNUC__
#define LINELET_PUBLIC [[gnu::visibility("default")]]
#else
#define LINELET_PUBLIC
#endif
