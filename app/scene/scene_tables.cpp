#include <ringwatch/app/scene/scene_tables.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include <toml++/toml.h>

#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/app/scene/toml_text.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/mesh_io.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

std::string withArticle(std::string_view type) {
  if (type.substr(0, 4) == "true") return std::string(type);
  return fmt::format("{} {}", type.front() == 'i' ? "an" : "a", type);
}

std::string kindOf(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "the text " + inQuotes(**node.as_string());
    case toml::node_type::integer:
      return fmt::format("the number {}", **node.as_integer());
    case toml::node_type::floating_point:
      return fmt::format("the number {}", **node.as_floating_point());
    case toml::node_type::boolean:
      return **node.as_boolean() ? "true" : "false";
    case toml::node_type::array:
      return fmt::format("a list of {}", node.as_array()->size());
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// A word that stands for itself where quotes are forgotten or eaten by a shell.
bool isBareWord(std::string_view text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
         std::ranges::all_of(text, [](unsigned char c) {
           return std::isalnum(c) != 0 || std::strchr("_-./:", static_cast<char>(c)) != nullptr;
         });
}

/// What is meant by a line of a scene that is no TOML: quotes that are missing, or a fraction. "" for another one.
std::string whatIsMeant(std::string_view content, std::size_t line) {
  for (std::size_t i = 1; i < line; ++i) content.remove_prefix(std::min(content.find('\n'), content.size() - 1) + 1);
  const std::string_view whole = content.substr(0, content.find('\n')), text = whole.substr(0, whole.find('#'));
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return {};
  const std::string_view key = trimmed(text.substr(0, equals)), value = trimmed(text.substr(equals + 1));
  if (const std::optional<double> number = numberOrFraction(value)) return fmt::format("; write {} = {}", key, *number);
  return isBareWord(value) ? fmt::format("; a text stands in quotes, {} = \"{}\"", key, value) : "";
}

bool isMeshFile(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return !extension.empty() && std::ranges::any_of(allMeshFormats(), [&](const MeshFormatInfo& format) {
    return (std::string(format.extensions) + "/").find(extension + "/") != std::string::npos;
  });
}

class Reader {
 public:
  Reader(std::filesystem::path file, const std::vector<std::string>& overrides) : file_(std::move(file)) {
    parseFile();
    for (const std::string& text : overrides) applyOverride(text);
  }
  /// Of the echo of a scene, in which all defaults are filled in; file: for messages.
  Reader(std::filesystem::path file, toml::table echo)
      : file_(std::move(file)), root_(std::move(echo)), isEcho_(true) {}

  /// Of a deck. origins: of its sections.
  Reader(std::filesystem::path file, toml::table sections, std::map<std::string, std::string> origins,
         const std::vector<std::string>& overrides)
      : file_(std::move(file)), root_(std::move(sections)), origins_(std::move(origins)) {
    for (const std::string& text : overrides) applyOverride(text);
  }

  /// All sections with their values checked and defaults filled in; lists in the order of the file.
  std::vector<SceneTable> sections() {
    checkSectionNames();
    std::vector<SceneTable> result;
    for (const SceneSection& section : sceneSections()) {
      const toml::node* node = root_.get(section.name);
      const std::string name(section.name);
      if (section.list || (section.alsoList && node && node->is_array())) {
        if (!node) continue;
        const toml::array* list = node->as_array();
        if (!list || (section.required && list->empty()) ||
            !std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_table(); }))
          fail(originOf(name, *node), name,
               fmt::format("{} where tables are needed; write [[{}]] above each", kindOf(*node), name));
        std::size_t i = 0;
        for (const toml::node& table : *list)
          result.push_back(readSection(section, fmt::format("{}.{}", name, i++), *table.as_table()));
      } else if (!node) {
        if (section.required)
          throw InputError(fmt::format("{}: [{}]: the section is missing; it holds {}", file_.string(), name,
                                       requiredKeys(section)));
        result.push_back(readSection(section, name, toml::table{}));
      } else {
        if (!node->is_table())
          fail(originOf(name, *node), name,
               fmt::format("{} where a section is needed; write [{}]", kindOf(*node), name));
        result.push_back(readSection(section, name, *node->as_table()));
      }
    }
    return result;
  }

 private:
  void parseFile() {
    std::error_code error;
    if (std::filesystem::is_directory(file_, error))
      throw InputError(fmt::format("{}: is a folder; a scene file (TOML) is needed", file_.string()));
    const std::filesystem::file_status status = std::filesystem::status(file_, error);
    if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
      throw InputError(fmt::format("{}: is a device; a scene file (TOML) is needed", file_.string()));
    constexpr std::size_t mostBytes = std::size_t{16} << 20;
    const std::string content = readBytes(file_, "; a scene file (TOML) is needed", mostBytes + 1);
    detail::requireContent(file_, content);
    if (isMeshFile(file_))
      throw InputError(
          fmt::format("{}: is a mesh; give a scene (TOML) with [mesh] file = {}, or call ringwatch inspect "
                      "{}, which needs none",
                      file_.string(), inQuotes(file_.filename().string()), file_.string()));
    if (content.size() > mostBytes)
      throw InputError(fmt::format(
          "{}: is larger than 16 MiB; a scene file (TOML) is needed, meshes are files of their own", file_.string()));
    if (const auto fault = tomlTextFault(content))
      throw InputError(fmt::format("{}:{}: not TOML: {}", file_.string(), fault->line, fault->what));
    try {
      root_ = toml::parse(content, file_.string());
    } catch (const toml::parse_error& fault) {
      detail::refuseForeign(file_, content);
      std::string what(fault.description());
      std::replace(what.begin(), what.end(), '\n', ' ');
      const std::size_t line = fault.source().begin.line;
      throw InputError(fmt::format("{}:{}: not TOML: {}{}", file_.string(), line, what, whatIsMeant(content, line)));
    }
  }

  /// `section.key=value`, or `section.N.key=value` for the N-th of a list, counted from 0.
  void applyOverride(const std::string& text) {
    std::string origin = "--set " + text.substr(0, 200);
    std::replace_if(
        origin.begin(), origin.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    const std::size_t equals = text.find('=');
    std::string path = text.substr(0, equals);
    path.erase(path.find_last_not_of(" \t") + 1);
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= path.size();) {
      const std::size_t end = std::min(path.find('.', begin), path.size());
      parts.push_back(path.substr(begin, end - begin));
      begin = end + 1;
    }
    if (equals == std::string::npos || parts.size() < 2 || parts.size() > 3) {
      std::vector<std::string> meant;  // keys of that name
      for (const SceneKey& key : sceneKeys())
        if (equals != std::string::npos && key.key == path)
          meant.push_back(fmt::format("{}{}.{}={}", key.section, findSceneSection(key.section)->list ? ".0" : "",
                                      key.key, text.substr(equals + 1)));
      throw InputError(
          meant.empty()
              ? fmt::format("{}: not an assignment; write section.key=value, e.g. integrator.step=1e-3", origin)
              : fmt::format("{}: the section is missing; write {}", origin, fmt::join(meant, " or ")));
    }

    const toml::table assignment = parseValue(text.substr(equals + 1), origin);
    toml::table* target = nullptr;
    if (parts.size() == 2) {
      const SceneSection* section = findSceneSection(parts[0]);
      if (section && (section->list || (section->alsoList && root_.contains(parts[0]) && root_[parts[0]].is_array())))
        throw InputError(fmt::format("{}: [[{}]] is a list; write {}.0.{}=… for its first entry", origin, parts[0],
                                     parts[0], parts[1]));
      if (!root_.contains(parts[0])) root_.insert(parts[0], toml::table{});
      target = root_.get_as<toml::table>(parts[0]);
    } else {
      toml::array* list = root_.get_as<toml::array>(parts[0]);
      const std::size_t count = list ? list->size() : 0;
      std::size_t index = count;
      if (!parts[1].empty() && parts[1].size() < 7 && parts[1].find_first_not_of("0123456789") == std::string::npos)
        index = std::stoul(parts[1]);
      if (index >= count)
        throw InputError(fmt::format("{}: there is no [[{}]] number {}; the scene has {}, counted from 0", origin,
                                     parts[0], parts[1], count));
      target = list->get_as<toml::table>(index);
    }
    if (!target) throw InputError(fmt::format("{}: {} is not a section of the scene", origin, parts[0]));
    target->insert_or_assign(parts.back(), *assignment.get("value"));
    overrides_[path] = origin;
  }

  /// A TOML value, or a bare word as a text, since shells eat quotes.
  static toml::table parseValue(const std::string& text, const std::string& origin) {
    if (const auto fault = tomlTextFault(text))
      throw InputError(fmt::format("{}: the value is not TOML: {}", origin, fault->what));
    try {
      if (text.find('\n') == std::string::npos) {
        toml::table parsed = toml::parse("value = " + text);
        if (parsed.size() == 1 && parsed.contains("value")) return parsed;
      }
    } catch (const toml::parse_error&) {
      if (const std::optional<double> fraction = numberOrFraction(text)) return toml::table{{"value", *fraction}};
      if (isBareWord(text)) return toml::table{{"value", text}};
    }
    throw InputError(
        fmt::format("{}: the value is not TOML; write a number, a \"text\", true, false or [a, list]", origin));
  }

  void checkSectionNames() const {
    for (const auto& [key, node] : root_) {
      const std::string name(key.str());
      if (findSceneSection(name)) continue;
      std::vector<std::string> known;
      for (const SceneSection& section : sceneSections()) known.emplace_back(section.name);
      // Text before any [section] is most likely a key that lost its section.
      if (!node.is_table() && !node.is_array_of_tables())
        fail(originOf(name, node), name,
             fmt::format("a key outside of a section; sections are {}", fmt::join(known, ", ")));
      fail(originOf(name, node), fmt::format("[{}]", shortened(name)),
           fmt::format("unknown section {}; {}known are {}", inQuotes(name), didYouMean(name, known),
                       fmt::join(known, ", ")));
    }
  }

  std::string originOf(const std::string& path, const toml::node& node) const {
    // An override of a key inside also stands for a section that only overrides made.
    for (const auto& [key, origin] : overrides_)
      if (key == path || (key.size() > path.size() && key.compare(0, path.size() + 1, path + ".") == 0 &&
                          node.source().begin.line == 0))
        return origin;
    if (!origins_.empty()) {
      for (std::string part = path;; part.erase(part.rfind('.'))) {
        if (const auto known = origins_.find(part); known != origins_.end()) return known->second;
        if (part.find('.') == std::string::npos) return file_.string();
      }
    }
    if (isEcho_ || node.source().begin.line == 0) return file_.string();
    return fmt::format("{}:{}", file_.string(), node.source().begin.line);
  }

  static std::string requiredKeys(const SceneSection& section) {
    std::string text;
    for (const SceneKey& key : section.keys)
      if (key.required) text += (text.empty() ? "" : ", ") + key.key;
    return text.empty() ? "either file or generate" : text;
  }

  SceneTable readSection(const SceneSection& declared, const std::string& path, const toml::table& table) const {
    const std::string name(declared.name);
    SceneTable section{name, originOf(path, table), {}};
    for (const auto& [tomlKey, node] : table) {
      const std::string key(tomlKey.str());
      const std::string origin = originOf(path + "." + key, node);
      const SceneKey* found = nullptr;
      std::vector<std::string> known;
      for (const SceneKey& candidate : declared.keys) {
        known.push_back(candidate.key);
        if (candidate.key == key) found = &candidate;
      }
      if (!found)
        fail(origin, name + "." + key,
             fmt::format("unknown key {} in [{}]; {}known are {}", inQuotes(key), name, didYouMean(key, known),
                         fmt::join(known, ", ")));
      SceneEntry& entry = section.entries[key] = {check(*found, node, origin), origin, true};
      if (isEcho_ && !found->fallback.empty()) entry.given = entry.value != defaultOf(*found);
    }
    for (const SceneKey& key : declared.keys) {
      if (section.entries.count(key.key) != 0) continue;
      if (key.required) fail(section.origin, name + "." + key.key, missingText(key.type, key.unit, key.range));
      if (key.fallback.empty()) continue;
      section.entries[key.key] = {defaultOf(key), "default", false};
    }
    return section;
  }

  static Json defaultOf(const SceneKey& key) {
    const toml::table parsed = toml::parse("value = " + key.fallback);
    return check(key, *parsed.get("value"), "default");
  }

  /// The value as JSON, after checks of type, range and choices.
  static Json check(const SceneKey& key, const toml::node& node, const std::string& origin) {
    const std::string name = key.section + "." + key.key;
    const auto wrongType = [&](const std::string& found) {
      fail(origin, name,
           fmt::format("{} where {} is needed{}", found, withArticle(sceneTypeName(key.type)), hint(key)));
    };
    const auto number = [&](const toml::node& n) {
      if (!n.is_number()) wrongType(kindOf(n));
      const double value = *n.value<double>();
      if (!std::isfinite(value)) fail(origin, name, fmt::format("{} is not a finite number{}", value, hint(key)));
      if (!key.range.holds(value)) fail(origin, name, fmt::format("{} is out of range{}", value, hint(key)));
      return value;
    };
    const auto integer = [&](const toml::node& n) {
      if (!n.is_integer()) wrongType(kindOf(n));
      number(n);
      return *n.value<std::int64_t>();
    };
    const auto text = [&](const toml::node& n) {
      if (!n.is_string()) wrongType(kindOf(n));
      std::string value = **n.as_string();
      for (const auto& [alias, meant] : key.aliases)
        if (value == alias) value = meant;
      if (!key.choices.empty() && std::find(key.choices.begin(), key.choices.end(), value) == key.choices.end())
        fail(origin, name,
             fmt::format("unknown {}; {}must be {}{}", inQuotes(value), didYouMean(value, key.choices),
                         key.choices.size() > 1 ? "one of " : "", fmt::join(key.choices, ", ")));
      return value;
    };
    const auto list = [&](const auto& element) {
      if (!node.is_array()) wrongType(kindOf(node));
      Json values = Json::array();
      for (const toml::node& n : *node.as_array()) values.push_back(element(n));
      return values;
    };
    switch (key.type) {
      case SceneType::number:
        return number(node);
      case SceneType::integer:
        return integer(node);
      case SceneType::boolean:
        if (!node.is_boolean()) wrongType(kindOf(node));
        return **node.as_boolean();
      case SceneType::text:
        return text(node);
      case SceneType::texts:
        return list(text);
      case SceneType::numbers:
        return list(number);
      case SceneType::vector: {
        Json values = list(number);
        if (values.size() != 3) wrongType(kindOf(node));
        return values;
      }
      case SceneType::vectors:
        return list([&](const toml::node& point) {
          if (!point.is_array() || point.as_array()->size() != 3) wrongType("a list with " + kindOf(point));
          Json values = Json::array();
          for (const toml::node& n : *point.as_array()) values.push_back(number(n));
          return values;
        });
      case SceneType::numberOrAuto:
        if (node.is_string() && **node.as_string() == "auto") return "auto";
        return number(node);
      case SceneType::parameter: {
        // Integers stay integers, so that messages and the echo show them as they were written.
        const auto exact = [&](const toml::node& n) { return n.is_integer() ? Json(integer(n)) : Json(number(n)); };
        if (node.is_array()) return list(exact);
        if (node.is_string()) return text(node);
        return exact(node);
      }
    }
    return {};
  }

  static std::string hint(const SceneKey& key) {
    const std::string range = key.range.text();
    std::string text;
    if (!range.empty()) text += "; must be " + range + (key.unit.empty() ? "" : " " + key.unit);
    if (!key.choices.empty()) text += fmt::format("; must be one of {}", fmt::join(key.choices, ", "));
    return text;
  }

  std::filesystem::path file_;
  toml::table root_;
  bool isEcho_ = false;
  std::map<std::string, std::string> origins_;    // of a deck's sections
  std::map<std::string, std::string> overrides_;  // "section.key" -> origin
};

}  // namespace

void fail(const std::string& origin, const std::string& key, const std::string& what) {
  throw InputError(fmt::format("{}: {}: {}", origin, shortened(key), what));
}

std::string missingText(SceneType type, std::string_view unit, const SceneRange& range) {
  return fmt::format("missing; give {}{}{}{}{}", withArticle(sceneTypeName(type)), unit.empty() ? "" : " in ", unit,
                     range.text().empty() ? "" : ", ", range.text());
}

std::vector<SceneTable> readSceneTables(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return Reader(file, overrides).sections();
}

std::vector<SceneTable> sceneTablesOfDeck(const std::filesystem::path& file, const DeckScene& deck,
                                          const std::vector<std::string>& overrides) {
  return Reader(file, toml::parse(tomlOfSections(deck.sections)), deck.origins, overrides).sections();
}

std::string tomlOfSections(const Json& sections) {
  std::string text;
  const auto add = [&](const std::string& head, const Json& section) {
    text += head + "\n";
    for (const auto& [key, value] : section.items())
      if (!value.is_null()) text += fmt::format("{} = {}\n", key, value.dump());
  };
  for (const auto& [name, section] : sections.items()) {
    if (!section.is_array()) {
      add(fmt::format("[{}]", name), section);
    } else {
      for (const Json& entry : section) add(fmt::format("[[{}]]", name), entry);
    }
  }
  return text;
}

std::vector<SceneTable> sceneTablesOfEcho(const std::filesystem::path& file, const std::string& toml) {
  try {
    return Reader(file, toml::parse(toml)).sections();
  } catch (const toml::parse_error& fault) {
    throw InputError(fmt::format("{}: its \"scene\" cannot be read: {}", file.string(), fault.description()));
  }
}

}  // namespace ringwatch
