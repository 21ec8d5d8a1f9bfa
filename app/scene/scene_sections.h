#pragma once
#include <fmt/format.h>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_tables.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {

// The declarations of sections, each once; scene_keys.cpp lists them.
SceneSection unitsSection();
SceneSection meshSection();
SceneSection materialSection();
SceneSection integratorSection();
SceneSection dampingSection();
SceneSection monitorSection();
SceneSection handlerSection();
SceneSection fixSection();
SceneSection initialSection();
SceneSection moveSection();
SceneSection forceSection();
SceneSection pressureSection();
SceneSection massSection();
SceneSection massDampingSection();
SceneSection rigidSection();
SceneSection springSection();
SceneSection obstacleSection();
SceneSection contactSection();
SceneSection cutSection();
SceneSection erosionSection();
SceneSection probeSection();
SceneSection outputSection();

// What their checks share.

Eigen::Vector3d vectorOf(const nlohmann::ordered_json& value);
/// The nodes of a table by its keys `where` or `set`, or by others that begin with a prefix, one of which is given.
NodeSelection selectionOf(const SceneTable& section, const std::string& prefix = "");
/// The keys of a table of time. what: that it scales.
std::vector<SceneKey> timeTableKeys(std::string_view what);
/// The table of time of a section that takes one, where it has one.
std::optional<TimeTable> tableOf(const SceneTable& section, const Scene& scene);

/// Refuses the name of an earlier entry of a list.
template <class Item>
void requireOwnName(const SceneTable& table, const std::vector<Item>& all, const Item& item) {
  for (const Item* other = all.data(); other != &item; ++other)
    if (other->name == item.name)
      fail(table.given("name") ? table.at("name").origin : table.origin, table.name + ".name",
           fmt::format("{} is the name of {} already; give another", inQuotes(item.name), other->origin));
}
/// The position of the entry of a list that a key names: [[kind]].
template <class Item>
std::size_t positionOf(const SceneTable& table, const std::string& kind, const std::vector<Item>& all) {
  const auto name = table.get<std::string>(kind);
  std::vector<std::string> known;
  for (const Item& item : all) known.push_back(item.name);
  const auto found = std::ranges::find(known, name);
  if (found == known.end())
    fail(table.at(kind).origin, table.name + "." + kind,
         known.empty() ? fmt::format("{} names a [[{}]]; there is none", inQuotes(name), kind)
                       : fmt::format("no [[{}]] is named {}; {}the scene has {}", kind, inQuotes(name),
                                     didYouMean(name, known), shortList(known)));
  return static_cast<std::size_t>(found - known.begin());
}

}  // namespace ringwatch
