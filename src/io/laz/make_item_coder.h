// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>

#include "decoder.h"
#include "encoder.h"
#include "item_coder.h"
#include "layout.h"

namespace linelet::laz {

/** \brief A decoder of \a item, initialized with its bytes in the \a first point. */
std::unique_ptr<ItemCoder<Decoder>>
makeItemDecoder(const Item& item, const std::uint8_t* first);

/** \brief The same for the version that is written. */
std::unique_ptr<ItemCoder<Encoder>>
makeItemEncoder(const Item& item, const std::uint8_t* first);

} // namespace linelet::laz
