// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <memory>

#include "models.h"

namespace linelet::laz {

/** \brief \a Count models, created on first use, since most are never used. */
template <unsigned Count, unsigned Symbols>
class ModelBank {
public:
  SymbolModel<Symbols>&
  operator[](unsigned i)
  {
    if (models_[i] == nullptr)
      models_[i] = std::make_unique<SymbolModel<Symbols>>();
    return *models_[i];
  }

private:
  std::array<std::unique_ptr<SymbolModel<Symbols>>, Count> models_;
};

} // namespace linelet::laz
