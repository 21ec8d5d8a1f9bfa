#pragma once
#include <algorithm>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/app/scene/scene_tables.h>
#include <ringwatch/base/infinity.h>

namespace ringwatch {

/// The ranges of most keys.
struct KeyRange {
  static constexpr SceneRange positive{0, infinity, false, true}, notNegative{0, infinity, true, true},
      atLeastOne{1, infinity, true, true};
  static constexpr SceneRange share{0, 1, true, false};   // 0 <= s < 1
  static constexpr SceneRange factor{0, 1, false, true};  // 0 < s <= 1
};

// How a key of a scene is declared and bound to its member, in one place:
//   key("end", &Scene::end, "time at which the run ends", {.unit = "s", .required = true, .range = positive})
// Its type and default are those of the member.

/// A key of a section whose tables are read into an Item. store: puts its value there; empty where the section's check
/// takes it.
template <class Item>
struct BoundKey {
  SceneKey key;
  std::function<void(const SceneTable& table, Item& item)> store = {};
};
template <class Item>
using BoundKeys = std::vector<BoundKey<Item>>;

/// A member of an Item, or a member of one.
template <class Item, class Value>
using Access = std::function<Value&(Item&)>;
template <class Item, class Part, class Value>
Access<Item, Value> at(Part Item::*part, Value Part::*member) {
  return [part, member](Item& item) -> Value& { return item.*part.*member; };
}

namespace detail {

template <class Value>
inline constexpr bool isOptional = false;
template <class Value>
inline constexpr bool isOptional<std::optional<Value>> = true;

template <class Value>
constexpr SceneType sceneTypeOf() {
  if constexpr (isOptional<Value>)
    return sceneTypeOf<typename Value::value_type>();
  else if constexpr (std::same_as<Value, bool>)
    return SceneType::boolean;
  else if constexpr (std::integral<Value>)
    return SceneType::integer;
  else if constexpr (std::floating_point<Value>)
    return SceneType::number;
  else if constexpr (std::same_as<Value, std::string>)
    return SceneType::text;
  else if constexpr (std::same_as<Value, std::vector<std::string>>)
    return SceneType::texts;
  else if constexpr (std::same_as<Value, Eigen::Vector3d>)
    return SceneType::vector;
  else
    return SceneType::numbers;
}

/// Takes a value of a scene; "auto" leaves an optional number empty.
template <class Value>
void assign(const nlohmann::ordered_json& json, Value& value) {
  if constexpr (isOptional<Value>) {
    value.reset();
    if (json != "auto") assign(json, value.emplace());
  } else if constexpr (std::same_as<Value, Eigen::Vector3d>) {
    value = vectorOf(json);
  } else {
    value = json.get<Value>();
  }
}

/// A default as TOML; "" for what is empty.
template <class Value>
std::string tomlOf(const Value& value) {
  if constexpr (isOptional<Value>) {
    return {};
  } else if constexpr (std::same_as<Value, Eigen::Vector3d>) {
    return tomlOf(std::vector<double>(value.begin(), value.end()));
  } else if constexpr (requires(Value list) { list.push_back(list.front()); } && !std::same_as<Value, std::string>) {
    std::vector<std::string> items;
    for (const auto& item : value) items.push_back(tomlOf(item));
    return fmt::format("[{}]", fmt::join(items, ", "));
  } else {
    if constexpr (std::same_as<Value, std::string>)
      if (value.empty()) return {};
    return nlohmann::ordered_json(value).dump();
  }
}

}  // namespace detail

/// Declares a key that is stored in a member. rest: what its type and its default do not say.
template <class Item, class Value>
BoundKey<Item> key(const std::string& name, Access<Item, Value> member, std::string help, SceneKey rest = {}) {
  rest.key = name;
  rest.type = detail::sceneTypeOf<Value>();
  rest.help = std::move(help);
  if (Item usual{}; rest.fallback.empty() && !rest.required) rest.fallback = detail::tomlOf(member(usual));
  return {std::move(rest),
          [name, member](const SceneTable& table, Item& item) { detail::assign(table.at(name).value, member(item)); }};
}
template <class Item, class Value>
BoundKey<Item> key(std::string name, Value Item::*member, std::string help, SceneKey rest = {}) {
  return key(std::move(name), Access<Item, Value>(member), std::move(help), std::move(rest));
}
/// Declares a key that takes a number, or "auto", which leaves its member empty.
template <class Item>
BoundKey<Item> numberOrAuto(std::string name, std::optional<double> Item::*member, std::string help,
                            SceneKey rest = {}) {
  if (!rest.required) rest.fallback = "\"auto\"";
  BoundKey<Item> bound = key(std::move(name), member, std::move(help), std::move(rest));
  bound.key.type = SceneType::numberOrAuto;
  return bound;
}
/// Declares a key whose member stays as it is where it is not given.
template <class Item>
BoundKey<Item> withoutDefault(BoundKey<Item> bound) {
  bound.key.fallback.clear();
  return bound;
}

/// Other names of the entries of a table.
template <class Table>
std::vector<std::pair<std::string, std::string>> aliasesOf(const Table& table) {
  std::vector<std::pair<std::string, std::string>> aliases;
  for (const auto& entry : table)
    if (!entry.alias.empty()) aliases.emplace_back(entry.alias, entry.name);
  return aliases;
}
template <class Table>
std::vector<std::string> namesOf(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

/// Declares a key that names a value of an enumeration, whose help ends with what the names mean.
template <class Item, class Enum, class Table>
BoundKey<Item> choice(std::string name, Access<Item, Enum> member, const Table& names, const std::string& help,
                      SceneKey rest = {}) {
  Item usual{};
  rest.key = name;
  rest.type = SceneType::text;
  rest.fallback = fmt::format("\"{}\"", names.nameOf(member(usual)));
  rest.choices = names.names();
  rest.aliases = aliasesOf(names);
  const bool explained = std::ranges::any_of(names, [](const auto& known) { return !known.help.empty(); });
  rest.help = fmt::format("{}{}{}", help, help.empty() || !explained ? "" : "; ", explained ? names.listing() : "");
  return {std::move(rest),
          [name, member, &names](const SceneTable& table, Item& item) { member(item) = table.named(name, names); }};
}
template <class Item, class Enum, class Table>
BoundKey<Item> choice(std::string name, Enum Item::*member, const Table& names, const std::string& help,
                      SceneKey rest = {}) {
  return choice(std::move(name), Access<Item, Enum>(member), names, help, std::move(rest));
}

/// The keys `where` and `set` of nodes, or others that begin with a prefix.
template <class Item, class Nodes>
BoundKeys<Item> nodeKeys(Nodes Item::*nodes, const std::string& prefix = "",
                         const std::string& help =
                             "condition on the reference position, e.g. \"x < 1e-6 and y > 0.01\", "
                             "\"all\", or \"set:NAME\"") {
  const std::string where = prefix + "where", set = prefix + "set";
  const auto store = [nodes, prefix](const SceneTable& table, Item& item) {
    if (table.given(prefix + "where") || table.given(prefix + "set")) item.*nodes = selectionOf(table, prefix);
  };
  return {{{.key = where, .type = SceneType::text, .help = help}, store},
          {{.key = set,
            .type = SceneType::text,
            .help = prefix.empty() ? "named node set of the mesh, instead of where; \"#3,7\" are the nodes with these "
                                     "numbers in the mesh file"
                                   : fmt::format("named node set of the mesh, instead of {}", where)},
           store}};
}

/// Keys that the section's check takes.
template <class Item>
BoundKeys<Item> unbound(std::vector<SceneKey> keys) {
  BoundKeys<Item> bound;
  for (SceneKey& key : keys) bound.push_back({std::move(key)});
  return bound;
}

namespace detail {

/// The keys of all parts, which the section has from now on.
template <class Item>
BoundKeys<Item> declare(SceneSection& section, std::initializer_list<BoundKeys<Item>> parts) {
  BoundKeys<Item> all;
  for (const BoundKeys<Item>& part : parts) all.insert(all.end(), part.begin(), part.end());
  for (BoundKey<Item>& bound : all) {
    bound.key.section = section.name;
    section.keys.push_back(bound.key);
  }
  return all;
}

template <class Item>
void store(const BoundKeys<Item>& keys, const SceneTable& table, Item& item) {
  for (const BoundKey<Item>& bound : keys)
    if (bound.store && table.entries.contains(bound.key.key)) bound.store(table, item);
}

}  // namespace detail

/// Declares [name], whose values are members of the scene.
inline SceneSection plainSection(SceneSection section, std::initializer_list<BoundKeys<Scene>> parts,
                                 const std::function<void(const SceneTable&, Scene&)>& check = {}) {
  section.read = [keys = detail::declare(section, parts)](const SceneTable& table, Scene& scene) {
    detail::store(keys, table, scene);
  };
  if (check)
    section.check = [check](std::span<const SceneTable> tables, Scene& scene) { check(tables.front(), scene); };
  return section;
}

/// Declares [name] that a scene has where one of its keys is given.
template <class Item>
SceneSection optionalSection(SceneSection section, std::optional<Item> Scene::*member,
                             std::initializer_list<BoundKeys<Item>> parts,
                             const std::type_identity_t<std::function<void(const SceneTable&, Scene&, Item&)>>& check) {
  section.read = [member, keys = detail::declare(section, parts)](const SceneTable& table, Scene& scene) {
    if (std::ranges::any_of(table.entries, [](const auto& entry) { return entry.second.given; }))
      detail::store(keys, table, *(scene.*member = Item{}));
  };
  section.check = [member, check](std::span<const SceneTable> tables, Scene& scene) {
    if (scene.*member) check(tables.front(), scene, *(scene.*member));
  };
  return section;
}

/// Declares [[name]], or with alsoList [name] too, each of which is an entry of a list of the scene. check: of each;
/// together: of all.
template <class Item>
SceneSection listSection(SceneSection section, std::vector<Item> Scene::*list,
                         std::initializer_list<BoundKeys<Item>> parts,
                         const std::type_identity_t<std::function<void(const SceneTable&, Scene&, Item&)>>& check = {},
                         const std::function<void(std::span<const SceneTable>, Scene&)>& together = {}) {
  section.list = !section.alsoList;
  section.read = [list, keys = detail::declare(section, parts)](const SceneTable& table, Scene& scene) {
    Item& item = (scene.*list).emplace_back();
    if constexpr (requires { item.origin; }) item.origin = fmt::format("{}: [[{}]]", table.origin, table.name);
    detail::store(keys, table, item);
    if constexpr (requires { item.name; })
      if (!table.given("name")) item.name = fmt::format("{} {}", table.name, (scene.*list).size() - 1);
  };
  section.check = [list, check, together](std::span<const SceneTable> tables, Scene& scene) {
    for (std::size_t i = 0; check && i < tables.size(); ++i) check(tables[i], scene, (scene.*list)[i]);
    if (together) together(tables, scene);
  };
  return section;
}

}  // namespace ringwatch
