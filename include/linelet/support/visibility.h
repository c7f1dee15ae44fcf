// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/** \brief What a shared library of linelet shows: all else in it is hidden. */
#ifdef __GNUC__
#define LINELET_PUBLIC [[gnu::visibility("default")]]
#else
#define LINELET_PUBLIC
#endif
