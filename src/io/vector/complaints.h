// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <cpl_error.h>

namespace linelet::io {

/** \brief Collects GDAL's error messages for use in ours. */
class Complaints {
public:
  Complaints() { CPLPushErrorHandlerEx(hear, this); }
  ~Complaints() { CPLPopErrorHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints&
  operator=(const Complaints&) = delete;

  /** \brief The first failure; empty if there was none. */
  const std::string&
  first() const
  {
    return first_;
  }

private:
  static void CPL_STDCALL
  hear(CPLErr level, CPLErrorNum, const char* message)
  {
    auto& self = *static_cast<Complaints*>(CPLGetErrorHandlerUserData());
    if (level >= CE_Failure && self.first_.empty())
      self.first_ = message;
  }

  std::string first_;
};

} // namespace linelet::io
