// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_features.h"

#include <cstdint>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <linelet/tensor/eigen_features.h>

namespace linelet::apps {

namespace {

using Record = PointDistributionTensor;

EigenFeatures
featuresOf(const Record& r)
{
  return eigenFeatures({r.lambda1, r.lambda2, r.lambda3},
                       {r.normal_x, r.normal_y, r.normal_z});
}

struct Feature {
  const char* name;
  const char* description;
  float (*value)(const Record&); ///< null: the number of neighbors
  bool of_record;                ///< a field of PointDistributionTensor
};

#define LINELET_FIELD(name, description)                                               \
  {                                                                                    \
#name, description, [](const Record& r) { return r.name; }, true                   \
  }
#define LINELET_FEATURE(name, description)                                             \
  {                                                                                    \
#name, description,                                                                \
        [](const Record& r) { return static_cast<float>(featuresOf(r).name); }, false  \
  }

const Feature all_features[] = {
    LINELET_FIELD(xx, "neighborhood tensor"),
    LINELET_FIELD(xy, "neighborhood tensor"),
    LINELET_FIELD(xz, "neighborhood tensor"),
    LINELET_FIELD(yy, "neighborhood tensor"),
    LINELET_FIELD(yz, "neighborhood tensor"),
    LINELET_FIELD(zz, "neighborhood tensor"),
    LINELET_FIELD(lambda1, "smallest eigenvalue"),
    LINELET_FIELD(lambda2, "middle eigenvalue"),
    LINELET_FIELD(lambda3, "largest eigenvalue"),
    LINELET_FIELD(major_x, "along the largest extent"),
    LINELET_FIELD(major_y, "along the largest extent"),
    LINELET_FIELD(major_z, "along the largest extent"),
    LINELET_FIELD(normal_x, "along the smallest extent"),
    LINELET_FIELD(normal_y, "along the smallest extent"),
    LINELET_FIELD(normal_z, "along the smallest extent"),
    LINELET_FIELD(linearity, "shape factor CL, 0 to 1"),
    LINELET_FIELD(planarity, "shape factor CP, 0 to 1"),
    LINELET_FIELD(sphericity, "shape factor CS, 0 to 1"),
    {"neighbors", "points in the neighborhood", nullptr, true},
    LINELET_FEATURE(verticality, "1 - |normal z|"),
    LINELET_FEATURE(omnivariance, "cbrt(l1 l2 l3) / sum"),
    LINELET_FEATURE(eigenentropy, "of eigenvalues / sum"),
    LINELET_FEATURE(surface_variation, "l1 / sum"),
};

#undef LINELET_FIELD
#undef LINELET_FEATURE

const Feature*
find(const std::string& name)
{
  for (const Feature& feature : all_features)
    if (name == feature.name)
      return &feature;
  return nullptr;
}

} // namespace

FeatureList::FeatureList(std::string_view text) : text_(text)
{
  std::istringstream words(text_);
  for (std::string word; std::getline(words, word, ',');) {
    if (word == "shape" || word == "all") {
      for (const Feature& feature : all_features)
        if (word == "all" || feature.of_record)
          names_.emplace_back(feature.name);
      continue;
    }
    if (find(word) == nullptr) {
      std::string known = "shape, all";
      for (const Feature& feature : all_features)
        known.append(", ").append(feature.name);
      throw std::invalid_argument("there is no feature '" + word + "'; there are " +
                                  known);
    }
    names_.push_back(word);
  }
  if (names_.empty())
    throw std::invalid_argument("no feature is named; name some, or shape or all");
}

void
addFeatures(io::Cloud& cloud,
            const std::vector<Record>& records,
            const FeatureList& features)
{
  for (const std::string& name : features.names()) {
    const Feature& feature = *find(name);
    if (feature.value == nullptr) {
      std::vector<std::uint32_t> values(records.size());
      for (std::size_t i = 0; i < records.size(); ++i)
        values[i] = records[i].neighbors;
      cloud.set({name, std::move(values), feature.description});
      continue;
    }
    std::vector<float> values(records.size());
    for (std::size_t i = 0; i < records.size(); ++i)
      values[i] = feature.value(records[i]);
    cloud.set({name, std::move(values), feature.description});
  }
}

} // namespace linelet::apps
