// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <linelet/io/vector_file.h>

#include "complaints.h"

namespace linelet::io {

/** \brief Creates layers in a dataset of a GDAL driver, whose errors become
 * FileErrors. */
class LayerWriter {
public:
  /** \param[in] path for messages
   * \param[in] staged where the file is written */
  LayerWriter(const std::string& path,
              const std::string& staged,
              const char* driver_name);

  OGRLayer*
  makeLayer(const std::string& name,
            OGRwkbGeometryType type,
            OGRSpatialReference* system,
            const char* const* options = nullptr);

  /** \brief Adds the columns of \a content that do not exist yet. */
  void
  makeFields(OGRLayer& layer, const VectorLayer& content);

  void
  makeField(OGRLayer& layer, const std::string& name, OGRFieldType type);

  OGRFeatureUniquePtr
  makeFeature(OGRLayer& layer, VectorLayer::Kind kind, const Points& vertices);

  static void
  setAttributes(OGRFeature& out, const VectorFeature& feature);

  void
  add(OGRLayer& layer, OGRFeature& feature);

  /** \brief Flushes everything; disk errors appear here at the latest. */
  void
  close();

private:
  [[noreturn]] void
  fail() const;

  std::string path_;
  Complaints complaints_;
  std::unique_ptr<GDALDataset> dataset_;
};

} // namespace linelet::io
