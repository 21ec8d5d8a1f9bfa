#pragma once
#include <fmt/format.h>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_tables.h>

namespace ringwatch {

// What the readers of several sections share.

Eigen::Vector3d vectorOf(const nlohmann::ordered_json& value);
/// The nodes of a table by its keys `where` and `set`, or of others that begin with a prefix. Throws InputError unless
/// one of the two is given.
NodeSelection selectionOf(const SceneTable& section, const std::string& prefix = "");
/// The table of time of a section that takes one, where it has one.
std::optional<TimeTable> tableOf(const SceneTable& section, Scene& scene);

}  // namespace ringwatch
