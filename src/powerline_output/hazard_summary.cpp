// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hazard_summary.h"

#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include <linelet/powerline_output/hazard_layers.h>

namespace linelet::powerline {

namespace {

using Json = nlohmann::ordered_json;

/** Rounded to a tenth of a millimeter; null: unknown, or no id. */
Json
json(const std::string& name, const io::Value& value)
{
  constexpr std::string_view suffix = "_id";
  const bool is_id =
      name.size() > suffix.size() &&
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
  if (const auto* number = std::get_if<std::int64_t>(&value))
    return is_id && *number == 0 ? Json(nullptr) : Json(*number);
  if (const auto* real = std::get_if<double>(&value))
    return std::isfinite(*real) ? Json(std::round(*real * 1e4) / 1e4) : Json(nullptr);
  return std::get<std::string>(value);
}

Json
limitsJson(const ClearanceLimits& limits)
{
  Json rows = Json::object();
  for (const auto& [kind, name] : Names<HazardKind>::table) {
    const ClearanceLimits::Row& row = limits.of(kind);
    rows[std::string(name)] = {
        {"high", row.high}, {"medium", row.medium}, {"low", row.low}};
  }
  return {{"name", limits.name}, {"meters", std::move(rows)}};
}

} // namespace

Json
hazardSummary(const io::Cloud& cloud, const std::vector<Hazards>& states)
{
  Json all = Json::array();
  for (const Hazards& at : states) {
    Json entry = {{"state", at.state}, {"limits", limitsJson(at.limits)}};
    Json counts = Json::object();
    for (const Encroachment& one : at.clearances) {
      Json& count =
          counts[std::string(nameOf(one.kind))][std::string(nameOf(one.severity))];
      count = count.is_null() ? 1 : count.get<int>() + 1;
    }
    entry["counts"] = std::move(counts);
    // The attributes of the layers, with the same names.
    for (const io::VectorLayer& layer : hazardLayers(cloud, {at})) {
      if (layer.kind == io::VectorLayer::Kind::Polygons)
        continue;
      Json list = Json::array();
      for (const io::VectorFeature& feature : layer.features) {
        Json one = Json::object();
        for (const auto& [name, value] : feature.attributes)
          if (name != "state")
            one[name] = json(name, value);
        list.push_back(std::move(one));
      }
      entry[layer.name] = std::move(list);
    }
    all.push_back(std::move(entry));
  }
  return all;
}

} // namespace linelet::powerline
