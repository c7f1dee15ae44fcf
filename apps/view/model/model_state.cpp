// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model.h"

#include <cmath>

namespace linelet::view {

namespace {

using Json = nlohmann::ordered_json;

Json
number(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json
place(const Point& p)
{
  return Json::array({number(p.x()), number(p.y()), number(p.z())});
}

Json
graphsJson(const PointGraphs& graphs)
{
  Json rows = Json::array();
  for (std::size_t k = 0; k < graphs.graph.size(); ++k) {
    const ScaleShape& s = graphs.graph[k];
    rows.push_back({{"radius", graphs.radii[k]},
                    {"neighbors", s.neighbors},
                    {"linearity", number(static_cast<double>(s.linearity))},
                    {"planarity", number(static_cast<double>(s.planarity))},
                    {"sphericity", number(static_cast<double>(s.sphericity))}});
  }
  Json maxima = Json::array();
  for (const GraphMaximum& maximum : graphs.reading.maxima)
    maxima.push_back(
        {{"radius", graphs.radii[maximum.scale]}, {"score", maximum.score}});
  return {{"own_radius", graphs.ownRadius()},
          {"rows", std::move(rows)},
          {"maxima", std::move(maxima)}};
}

} // namespace

Json
Model::state() const
{
  Json state = {{"inputs", scene_->inputs},
                {"points", scene_->cloud.points.size()},
                {"scale_unit", number(scene_->scale_unit)},
                {"fields", fields()},
                {"curves", curves().curves.size()},
                {"warnings", scene_->warnings}};
  Json computed = Json::array(), outdated = Json::array();
  for (const auto& [analysis, name] : Names<Analysis>::table) {
    if (!computed_with_[static_cast<std::size_t>(analysis)].empty())
      computed.push_back(std::string(name));
    if (stale(analysis))
      outdated.push_back(std::string(name));
  }
  state["computed"] = std::move(computed);
  state["stale"] = std::move(outdated);
  state["selection"] = nullptr;
  if (selected_) {
    Json selection = {
        {"point", *selected_},
        {"at", place(scene_->cloud.points[*selected_] + scene_->cloud.shift)}};
    if (graphs_ != nullptr)
      selection["graphs"] = graphsJson(*graphs_);
    if (const auto tensor = tensorAtSelection())
      selection["tensor"] = {
          {"radius", tensorRadius()},
          {"neighbors", tensor->neighbors},
          {"linearity", number(static_cast<double>(tensor->linearity))},
          {"planarity", number(static_cast<double>(tensor->planarity))},
          {"sphericity", number(static_cast<double>(tensor->sphericity))}};
    state["selection"] = std::move(selection);
  }
  state["image"] = image_ == nullptr ? Json(nullptr)
                                     : Json{{"columns", image_->columns.size()},
                                            {"radii", image_->radii.size()}};
  Json wires = Json::array();
  if (lines() != nullptr)
    for (const powerline::Wire& wire : lines()->wires) {
      const powerline::Review& said = review(wire.id);
      wires.push_back({{"wire_id", wire.id},
                       {"confidence", number(wire.confidence)},
                       {"reason", wire.reason},
                       {"review", std::string(nameOf(said.verdict))},
                       {"review_class", said.point_class},
                       {"review_note", said.note}});
    }
  state["wires"] = std::move(wires);
  state["wire"] = wire_;
  return state;
}

} // namespace linelet::view
