// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_file.h"

#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace linelet::apps {

namespace {

Point
place(const nlohmann::ordered_json& json, const char* name)
{
  const auto& values = json.at(name);
  if (!values.is_array() || values.size() != 3)
    throw std::runtime_error(std::string("'") + name + "' is not [x, y, z]");
  return {values[0].get<double>(), values[1].get<double>(), values[2].get<double>()};
}

} // namespace

Camera
readCamera(const std::string& path, const Point& shift)
{
  std::ifstream file(path);
  if (!file)
    throw std::runtime_error(path + ": the camera cannot be read");
  Camera camera;
  try {
    const nlohmann::ordered_json json = nlohmann::ordered_json::parse(file);
    for (const auto& item : json.items()) {
      const std::string& key = item.key();
      if (key != "eye" && key != "target" && key != "up" && key != "field_of_view" &&
          key != "width" && key != "height" && key != "near" && key != "far")
        throw std::runtime_error("a camera has no '" + key + "'");
    }
    const Point eye = place(json, "eye"), target = place(json, "target");
    if (!((target - eye).norm() > 0))
      throw std::runtime_error("'eye' and 'target' are the same place");
    camera.lookAt(eye - shift,
                  target - shift,
                  json.contains("up") ? place(json, "up") : Point::UnitZ());
    camera.field_of_view = json.value("field_of_view", camera.field_of_view);
    camera.width = json.value("width", camera.width);
    camera.height = json.value("height", camera.height);
    camera.near = json.value("near", camera.near);
    camera.far = json.value("far", camera.far);
  }
  catch (const std::exception& error) {
    throw std::runtime_error(path + ": not a camera: " + error.what() +
                             "; it is JSON like {\"eye\": [0, 0, 10], \"target\": "
                             "[5, 5, 0], \"field_of_view\": 60}");
  }
  return camera;
}

} // namespace linelet::apps
