#include <ringwatch/app/integrator_catalog.h>
#include <ringwatch/app/scene.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <ringwatch/app/scene_keys.h>
#include <ringwatch/app/scene_mesh.h>
#include <ringwatch/app/toml_text.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/node_order.h>
#include <ringwatch/monitor/metrics.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

/// A checked value and where it came from: "scene.toml:12", "--set integrator.step=1" or "default".
struct Entry {
  Json value;
  std::string origin;
  bool given = false;
};
/// One table of the scene: [name], or one of several [[name]].
struct Section {
  std::string name, origin;
  std::map<std::string, Entry> entries;

  bool given(const std::string& key) const { return entries.count(key) != 0 && entries.at(key).given; }
  const Entry& at(const std::string& key) const { return entries.at(key); }
  template <class T>
  T get(const std::string& key) const {
    return entries.at(key).value.get<T>();
  }
  std::string where(const std::string& key) const {
    return fmt::format("{}: {}.{}", entries.at(key).origin, name, key);
  }
  /// The value that a text names.
  template <class Table>
  auto named(const std::string& key, const Table& table) const {
    return table.valueOf(where(key), get<std::string>(key));
  }
};

[[noreturn]] void fail(const std::string& origin, const std::string& key, const std::string& what) {
  throw InputError(fmt::format("{}: {}: {}", origin, shortened(key), what));
}

std::string withArticle(std::string_view type) {
  if (type.substr(0, 4) == "true") return std::string(type);
  return fmt::format("{} {}", type.front() == 'i' ? "an" : "a", type);
}

/// What is said of a key that must be given.
std::string missingText(SceneType type, std::string_view unit, const SceneRange& range) {
  return fmt::format("missing; give {}{}{}{}{}", withArticle(sceneTypeName(type)), unit.empty() ? "" : " in ", unit,
                     range.text().empty() ? "" : ", ", range.text());
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

class Reader {
 public:
  Reader(std::filesystem::path file, const std::vector<std::string>& overrides) : file_(std::move(file)) {
    parseFile();
    for (const std::string& text : overrides) applyOverride(text);
  }
  /// Of the echo of a scene, in which all defaults are filled in; file: for messages.
  Reader(std::filesystem::path file, toml::table echo)
      : file_(std::move(file)), root_(std::move(echo)), isEcho_(true) {}

  /// All sections with their values checked and defaults filled in; lists in the order of the file.
  std::vector<Section> sections() {
    checkSectionNames();
    std::vector<Section> result;
    for (const SceneSection& section : sceneSections()) {
      const toml::node* node = root_.get(section.name);
      const std::string name(section.name);
      if (section.list) {
        if (!node) continue;
        const toml::array* list = node->as_array();
        if (!list || !std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_table(); }))
          fail(originOf(name, *node), name,
               fmt::format("{} where tables are needed; write [[{}]] above each", kindOf(*node), name));
        std::size_t i = 0;
        for (const toml::node& table : *list)
          result.push_back(readSection(name, fmt::format("{}.{}", name, i++), *table.as_table()));
      } else if (!node) {
        if (section.required)
          throw InputError(
              fmt::format("{}: [{}]: the section is missing; it holds {}", file_.string(), name, requiredKeys(name)));
        result.push_back(readSection(name, name, toml::table{}));
      } else {
        if (!node->is_table())
          fail(originOf(name, *node), name,
               fmt::format("{} where a section is needed; write [{}]", kindOf(*node), name));
        result.push_back(readSection(name, name, *node->as_table()));
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
    errno = 0;
    std::ifstream stream(file_, std::ios::binary);
    std::string content(mostBytes + 1, '\0');
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    content.resize(static_cast<std::size_t>(stream.gcount()));
    if (!stream.is_open() || stream.bad())
      throw InputError(fmt::format("{}: cannot read: {}; a scene file (TOML) is needed", file_.string(),
                                   errno != 0 ? std::strerror(errno) : "input error"));
    if (content.size() > mostBytes)
      throw InputError(fmt::format(
          "{}: is larger than 16 MiB; a scene file (TOML) is needed, meshes are files of their own", file_.string()));
    if (const auto fault = tomlTextFault(content))
      throw InputError(fmt::format("{}:{}: not TOML: {}", file_.string(), fault->line, fault->what));
    try {
      root_ = toml::parse(content, file_.string());
    } catch (const toml::parse_error& fault) {
      std::string what(fault.description());
      std::replace(what.begin(), what.end(), '\n', ' ');
      throw InputError(fmt::format("{}:{}: not TOML: {}", file_.string(), fault.source().begin.line, what));
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
    if (equals == std::string::npos || parts.size() < 2 || parts.size() > 3)
      throw InputError(
          fmt::format("{}: not an assignment; write section.key=value, e.g. integrator.step=1e-3", origin));

    const toml::table assignment = parseValue(text.substr(equals + 1), origin);
    toml::table* target = nullptr;
    if (parts.size() == 2) {
      if (findSection(parts[0]) && findSection(parts[0])->list)
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
      const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_-./:", c) != nullptr;
      };
      if (!text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) &&
          std::all_of(text.begin(), text.end(), plain))
        return toml::table{{"value", text}};
    }
    throw InputError(
        fmt::format("{}: the value is not TOML; write a number, a \"text\", true, false or [a, list]", origin));
  }

  static const SceneSection* findSection(std::string_view name) {
    for (const SceneSection& section : sceneSections())
      if (section.name == name) return &section;
    return nullptr;
  }

  void checkSectionNames() const {
    for (const auto& [key, node] : root_) {
      const std::string name(key.str());
      if (findSection(name)) continue;
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
    if (isEcho_ || node.source().begin.line == 0) return file_.string();
    return fmt::format("{}:{}", file_.string(), node.source().begin.line);
  }

  static std::string requiredKeys(const std::string& section) {
    std::string text;
    for (const SceneKey& key : sceneKeys())
      if (key.section == section && key.required) text += (text.empty() ? "" : ", ") + key.key;
    return text.empty() ? "either file or generate" : text;
  }

  Section readSection(const std::string& name, const std::string& path, const toml::table& table) const {
    Section section{name, originOf(path, table), {}};
    for (const auto& [tomlKey, node] : table) {
      const std::string key(tomlKey.str());
      const std::string origin = originOf(path + "." + key, node);
      const SceneKey* found = nullptr;
      std::vector<std::string> known;
      for (const SceneKey& candidate : sceneKeys()) {
        if (candidate.section != name) continue;
        known.push_back(candidate.key);
        if (candidate.key == key) found = &candidate;
      }
      if (!found)
        fail(origin, name + "." + key,
             fmt::format("unknown key {} in [{}]; {}known are {}", inQuotes(key), name, didYouMean(key, known),
                         fmt::join(known, ", ")));
      Entry& entry = section.entries[key] = {check(*found, node, origin), origin, true};
      if (isEcho_ && !found->fallback.empty()) entry.given = entry.value != defaultOf(*found);
    }
    for (const SceneKey& key : sceneKeys()) {
      if (key.section != name || section.entries.count(key.key) != 0) continue;
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
  std::map<std::string, std::string> overrides_;  // "section.key" -> origin
};

Eigen::Vector3d vectorOf(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

std::array<bool, 3> componentsOf(const Section& section) {
  const auto text = section.get<std::string>("components");
  const auto components = parseComponents(text);
  if (!components)
    fail(section.at("components").origin, section.name + ".components",
         inQuotes(text) + " names no components; must be some of x, y, z, each once");
  return *components;
}

NodeSelection selectionOf(const Section& section) {
  if (section.given("where") == section.given("set"))
    fail(section.given("set") ? section.at("set").origin : section.origin, section.name + ".where",
         section.given("set") ? "both where and set are given; give one of them"
                              : "missing; give a condition, e.g. where = \"x < 1e-6\", or set = \"NAME\"");
  if (section.given("set")) return {std::nullopt, section.get<std::string>("set"), section.where("set")};
  return NodeSelection::parse(section.get<std::string>("where"), section.where("where"));
}

/// [mesh]: a file, or a generator with parameters that it takes.
void readMeshSection(const Section& section, Scene& scene) {
  if (section.given("file") == section.given("generate"))
    fail(section.given("file") ? section.at("file").origin : section.origin, "mesh.file",
         section.given("file") ? "both file and generate are given; give one of them"
                               : "missing; give file or generate");
  if (section.given("file")) {
    const std::filesystem::path path = section.get<std::string>("file");
    scene.meshFile = path.is_absolute() ? path : scene.file.parent_path() / path;
    scene.meshOrigin = section.where("file");
  } else {
    scene.generator = section.get<std::string>("generate");
    scene.meshOrigin = section.where("generate");
    scene.generatorArguments = Json::object();
  }
  for (const auto& [key, entry] : section.entries) {
    if (key == "file" || key == "generate") continue;
    if (scene.generator.empty())
      fail(entry.origin, "mesh." + key, "is a parameter of generators; a mesh file takes none");
    const std::string fault = generatorFault(scene.generator, key, entry.value);
    if (!fault.empty()) fail(entry.origin, "mesh." + key, fault);
    scene.generatorArguments[key] = entry.value;
  }
  if (scene.generator.empty()) return;
  const Json defaults = generatorDefaults(scene.generator);
  for (const auto& [key, value] : defaults.items())
    if (!scene.generatorArguments.contains(key)) scene.generatorArguments[key] = value;
  scene.echo["mesh"].update(scene.generatorArguments);
}

/// The keys of [material] that the law declares.
void readLawParameters(const LawInfo& law, const Section& material, Scene& scene) {
  for (const LawInfo& other : allLaws())
    for (const OptionInfo& option : other.parameters) {
      const std::string key(option.name);
      if (material.given(key) && !findOption(law.parameters, key)) {
        std::vector<std::string_view> known;
        for (const OptionInfo& own : law.parameters) known.push_back(own.name);
        fail(material.at(key).origin, "material." + key,
             fmt::format("is no parameter of the law \"{}\"; it takes {}", law.name, fmt::join(known, ", ")));
      }
    }
  for (const OptionInfo& option : law.parameters) {
    const std::string key(option.name);
    if (!material.given(key)) {
      if (option.fallback.empty())
        fail(material.origin, "material." + key, missingText(SceneType::number, option.unit, option.range));
      continue;
    }
    scene.parameters.set(key, material.get<double>(key));
    if (const std::string fault = optionFault(law.parameters, scene.parameters, key); !fault.empty())
      fail(material.at(key).origin, "material." + key,
           fmt::format("{}; {}{}", material.at(key).value.dump(), fault,
                       option.unit.empty() ? "" : fmt::format(" {}", option.unit)));
  }
}

/// "verlet and symplectic-euler": the names of the entries that have a trait.
template <class Infos, class Trait>
std::string namesWhere(const Infos& infos, const Trait& trait) {
  std::vector<std::string_view> names;
  for (const auto& info : infos)
    if (trait(info)) names.push_back(info.name);
  return fmt::format("{}", fmt::join(names, " and "));
}

void readIntegratorSection(const Section& integrator, const Section& monitor, const Section& damping, Scene& scene) {
  scene.damping = {damping.get<double>("mass"), damping.get<double>("stiffness")};
  scene.method = integrator.get<std::string>("method");
  const Json& step = integrator.at("step").value;
  if (step.is_number()) scene.step = step.get<double>();
  scene.end = integrator.get<double>("end");
  scene.safety = integrator.get<double>("safety");

  scene.mode = monitor.named("mode", monitorModeNames);
  if (scene.mode == MonitorMode::metric && monitor.get<std::string>("metric") == "none")
    fail(monitor.at("mode").origin, "monitor.mode", "\"metric\" needs a metric; set monitor.metric");
  if (!monitor.get<bool>("bracket")) {
    if (scene.mode == MonitorMode::threshold)
      fail(monitor.at("bracket").origin, "monitor.bracket",
           "false leaves nothing to prove, but mode = \"threshold\" does; take one of them out");
    scene.mode = MonitorMode::metric;
  }
  scene.metric = monitor.get<std::string>("metric");
  if (scene.metric == "none") scene.metric.clear();
  scene.margin = monitor.get<double>("margin");
  scene.every = monitor.get<std::int64_t>("every");
  scene.energyTolerance = monitor.get<double>("energy_tolerance");
  scene.requireCertified = monitor.get<bool>("require_certified");
  scene.onViolation = monitor.named("on_violation", onViolationNames);

  if (scene.step && *scene.step > scene.end)
    fail(integrator.at("step").origin, "integrator.step",
         fmt::format("{} s is beyond the end; must be <= end = {} s", *scene.step, scene.end));
  if (scene.step)
    if (const std::string fault = tooManySteps(*scene.step, scene.end); !fault.empty())
      fail(integrator.at("step").origin, "integrator.step", fault);
  if (!scene.step && scene.mode != MonitorMode::bracket)
    fail(integrator.at("step").origin, "integrator.step",
         "\"auto\" follows the safe step; it needs monitor.bracket = true and monitor.mode = \"bracket\"");
  if (scene.onViolation == OnViolation::reduceStep && !scene.monitored())
    fail(monitor.at("on_violation").origin, "monitor.on_violation",
         "\"reduce-step\" needs monitor.bracket = true or a monitor.metric");
  if (scene.monitored() && !(integratorCatalog().find(scene.method)->imaginaryLimit > 0))
    fail(integrator.at("method").origin, "integrator.method",
         fmt::format("\"{}\" is unstable at every step without damping, so there is no critical step to monitor; "
                     "choose another, "
                     "or set monitor.bracket = false and monitor.metric = \"none\"",
                     scene.method));
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  if (std::isinf(info.imaginaryLimit) || info.partitioned) {
    // No step is too large for it, or its stiff part is whatever the step asks for: there is nothing to watch but
    // energies and the state itself.
    if (!scene.step)
      fail(integrator.at("step").origin, "integrator.step",
           fmt::format("\"auto\" follows the critical step, and \"{}\" {}; give a number", scene.method,
                       info.partitioned ? "chooses its stiff elements by the step" : "is stable at every step"));
    scene.mode = MonitorMode::metric;
    scene.metric.clear();
  }
  if (scene.requireCertified && !scene.proves())
    fail(monitor.at("require_certified").origin, "monitor.require_certified",
         "true needs a proof: monitor.mode = \"bracket\" or \"threshold\", and an integrator with a critical step");
  if (scene.proves() && scene.damping.any() && !info.highestModeBinds)
    fail(integrator.at("method").origin, "integrator.method",
         fmt::format(
             "\"{}\": with [damping] the bracket is proven for {} only; choose one of them, or set monitor.bracket "
             "= false, with a monitor.metric for an estimate",
             scene.method,
             namesWhere(integratorInfos(), [](const IntegratorInfo& one) { return one.highestModeBinds; })));
}

/// The keys of [handler] that the handler declares.
void readHandlerOptions(const HandlerInfo& info, const Section& handler, Scene& scene) {
  if (!info.takes(scene.handlerOptions.selection)) {
    std::vector<std::string> names;
    for (const Selection one : info.selections) names.push_back(fmt::format("\"{}\"", selectionNames.nameOf(one)));
    fail(handler.at("selection").origin, "handler.selection",
         fmt::format("\"{}\" does not go with {}; must be {}", selectionNames.nameOf(scene.handlerOptions.selection),
                     info.name, fmt::join(names, " or ")));
  }
  Options& own = scene.handlerOptions.own;
  for (const auto& [key, entry] : handler.entries) {
    if (!entry.given || isKeyOfEveryHandler(key)) continue;
    if (!findOption(info.options, key)) {
      std::vector<std::string_view> owners;
      for (const HandlerEntry& other : allHandlers())
        if (findOption(other.info->options, key)) owners.push_back(other.info->name);
      fail(entry.origin, "handler." + key,
           fmt::format("is a key of {}; \"{}\" does not take it", fmt::join(owners, ", "), info.name));
    }
    own.set(key, entry.value.is_string() ? OptionValue(entry.value.get<std::string>())
                                         : OptionValue(entry.value.get<double>()));
  }
  for (const auto& [key, value] : own)
    if (const std::string fault = optionFault(info.options, own, key); !fault.empty())
      fail(handler.at(key).origin, "handler." + key,
           fmt::format("{} {}, with the handler \"{}\"", handler.at(key).value.dump(), fault, info.name));
  const Options all = completed(info.name, info.options, own);
  scene.reduceOnFailure = findOption(info.options, "on_failure") && all.text("on_failure") == "reduce-step";
}

void readHandlerSection(const Section& handler, const Section& integrator, const Section& monitor,
                        const Section& damping, Scene& scene) {
  scene.handler = handler.get<std::string>("method");
  if (scene.handler == "none") scene.handler.clear();
  scene.handlerOptions.selection = handler.named("selection", selectionNames);
  scene.handlerOptions.margin = handler.get<double>("margin");

  if (scene.handler.empty()) {
    for (const auto& [key, entry] : handler.entries)
      if (entry.given && key != "method")
        fail(entry.origin, "handler." + key, "there is no handler; set handler.method");
    if (scene.onViolation == OnViolation::handle)
      fail(monitor.at("on_violation").origin, "monitor.on_violation", "\"handle\" needs a handler; set handler.method");
    return;
  }
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  if (!takesHandler(info))
    fail(integrator.at("method").origin, "integrator.method",
         fmt::format("\"{}\": handlers work on {}; choose one of them", scene.method,
                     namesWhere(integratorInfos(), takesHandler)));
  if (!scene.step)
    fail(integrator.at("step").origin, "integrator.step",
         "\"auto\" follows the safe step, which a handler is there to exceed; give a number");
  readHandlerOptions(*findHandler(scene.handler), handler, scene);
  if (scene.onViolation == OnViolation::reduceStep)
    fail(monitor.at("on_violation").origin, "monitor.on_violation",
         "\"reduce-step\" works against the handler; set it to \"handle\", \"warn\" or \"stop\"");
  if (scene.onViolation == OnViolation::handle && !scene.proves())
    fail(monitor.at("on_violation").origin, "monitor.on_violation",
         "\"handle\" follows the proven bracket; it needs monitor.mode = \"bracket\" or \"threshold\"");
  if (scene.damping.any())
    fail(damping.origin, "[damping]", "handlers do not work with damping; remove it or set handler.method = \"none\"");
}

void readDevice(const Section& integrator, Scene& scene) {
  scene.device = integrator.named("device", runDeviceNames);
  if (scene.device == RunDevice::cpu) return;
  scene.deviceOrigin = integrator.at("device").origin + ": integrator.device";
  const HandlerInfo* info = findHandler(scene.handler);
  const bool onGpu = integratorCatalog().find(scene.method)->runsOnGpu && !scene.damping.any() &&
                     (scene.handler.empty() || info->forGpu != nullptr);
  if (!onGpu) {
    std::vector<HandlerInfo> handlers;
    for (const HandlerEntry& entry : allHandlers()) handlers.push_back(*entry.info);
    scene.noDevice = fmt::format("a GPU runs {} without [damping], and of the handlers {} alone",
                                 namesWhere(integratorInfos(), [](const IntegratorInfo& one) { return one.runsOnGpu; }),
                                 namesWhere(handlers, [](const HandlerInfo& one) { return one.forGpu != nullptr; }));
  } else if (info) {
    scene.noDevice = info->forGpu(scene.handlerOptions.own);
  }
  if (scene.noDevice.empty()) return;
  if (scene.device == RunDevice::cuda)
    fail(integrator.at("device").origin, "integrator.device", scene.noDevice + "; change that, or set it to \"cpu\"");
}

void readLoadSection(const Section& section, Scene& scene) {
  NodeSelection nodes = selectionOf(section);
  if (section.name == "fix") {
    scene.fixes.push_back({std::move(nodes), componentsOf(section)});
  } else if (section.name == "move") {
    scene.moves.push_back({std::move(nodes), componentsOf(section), vectorOf(section.at("velocity").value)});
  } else {
    if (section.given("acceleration") == section.given("force"))
      fail(section.given("force") ? section.at("force").origin : section.origin, "force.acceleration",
           section.given("force") ? "both acceleration and force are given; give one of them"
                                  : "missing; give acceleration (m/s2) or force (N)");
    Scene::Force force{std::move(nodes), std::nullopt, std::nullopt};
    if (section.given("force"))
      force.total = vectorOf(section.at("force").value);
    else
      force.acceleration = vectorOf(section.at("acceleration").value);
    scene.forces.push_back(std::move(force));
  }
}

void readCutSection(const Section& section, Scene& scene) {
  for (const auto& [one, other] : {std::pair{"point", "normal"}, std::pair{"line", "sweep"}})
    if (section.given(one) != section.given(other))
      fail(section.origin, std::string("cut.") + (section.given(one) ? other : one),
           fmt::format("missing; it goes with {}", section.given(one) ? one : other));
  if (section.given("point") == section.given("line"))
    fail(section.origin, "[[cut]]",
         section.given("line") ? "both a plane and a line are given; give one of them"
                               : "missing; give point and normal, or line and sweep");
  const std::string origin = section.origin + ": [[cut]]";
  const auto time = section.get<double>("time");
  if (!(time < scene.end))
    fail(section.at("time").origin, "cut.time",
         fmt::format("{} s is not before the end; must be < end = {} s", time, scene.end));
  try {
    CutSurface surface = [&] {
      if (section.given("point"))
        return CutSurface::plane(vectorOf(section.at("point").value), vectorOf(section.at("normal").value));
      std::vector<Eigen::Vector3d> line;
      for (const Json& point : section.at("line").value) line.push_back(vectorOf(point));
      return CutSurface::swept(std::move(line), vectorOf(section.at("sweep").value));
    }();
    scene.cuts.push_back({std::move(surface), time, section.get<double>("snap"),
                          section.named("positions", cutPositionsNames) == CutPositions::reference,
                          section.get<bool>("critical_step"), origin});
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", origin, fault.what()));
  }
}

/// What the [[fix]] and [[move]] of a scene prescribe at each component of each node. Two that ask for different
/// velocities at one of them are refused.
class PrescribedMotions {
 public:
  explicit PrescribedMotions(std::int32_t nodes) : by_(3 * static_cast<std::size_t>(nodes), -1) {}

  void add(const std::string& origin, const std::vector<std::int32_t>& nodes, const std::array<bool, 3>& components,
           const Eigen::Vector3d& velocity) {
    const auto own = static_cast<std::int32_t>(all_.size());
    all_.push_back({origin, velocity});
    std::map<std::int32_t, std::pair<std::size_t, int>> conflicts;  // of an earlier one: shared nodes, first component
    for (const std::int32_t node : nodes) {
      std::int32_t counted = -1;
      for (int c = 0; c < 3; ++c) {
        if (!components[c]) continue;
        std::int32_t& by = by_[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(c)];
        if (by < 0) {
          by = own;
        } else if (all_[by].velocity[c] != velocity[c] && by != counted) {
          conflicts.try_emplace(by, 0, c).first->second.first += 1;
          counted = by;
        }
      }
    }
    if (conflicts.empty()) return;
    const auto& [other, shared] = *conflicts.begin();
    const auto& [count, c] = shared;
    throw InputError(fmt::format(
        "{}: it prescribes another velocity than {} at {} node{} of both ({} and {} m/s along {}); change "
        "a condition or "
        "components so that no node has two",
        origin, all_[other].origin, count, count == 1 ? "" : "s", velocity[c], all_[other].velocity[c], "xyz"[c]));
  }

 private:
  struct Motion {
    std::string origin;
    Eigen::Vector3d velocity;  // m/s
  };
  std::vector<Motion> all_;
  std::vector<std::int32_t> by_;  // [node][component]: which of all_; -1: none
};

Json echoOf(const std::vector<Section>& sections) {
  Json echo = Json::object();
  for (const Section& section : sections) {
    Json values = Json::object();
    for (const SceneKey& key : sceneKeys())  // the table's order
      if (key.section == section.name && section.entries.count(key.key) != 0)
        values[key.key] = section.at(key.key).value;
    if (section.name == "fix" || section.name == "move" || section.name == "force" || section.name == "cut")
      echo[section.name].push_back(std::move(values));
    else
      echo[section.name] = std::move(values);
  }
  return echo;
}

}  // namespace

NodeSelection NodeSelection::parse(const std::string& text, const std::string& origin) {
  if (text.rfind("set:", 0) == 0) return {std::nullopt, text.substr(4), origin};
  try {
    return {WhereExpression(text), {}, origin};
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}: {}", origin, inQuotes(text), fault.what()));
  }
}

std::vector<std::int32_t> NodeSelection::nodesOf(const Mesh& mesh) const {
  if (!where) {
    const auto found = mesh.nodeSets.find(set);
    if (found != mesh.nodeSets.end() && !found->second.empty()) return found->second;
    std::vector<std::string> known;
    for (const auto& entry : mesh.nodeSets) known.push_back(entry.first);
    if (found != mesh.nodeSets.end())
      throw InputError(fmt::format("{}: the node set {} is empty", origin, inQuotes(set)));
    throw InputError(known.empty()
                         ? fmt::format("{}: unknown node set {}; the mesh has no named sets", origin, inQuotes(set))
                         : fmt::format("{}: unknown node set {}; {}the mesh has {}", origin, inQuotes(set),
                                       didYouMean(set, known), shortList(known)));
  }
  std::vector<std::int32_t> nodes;
  try {
    for (Eigen::Index i = 0; i < mesh.X.cols(); ++i)
      if (where->holdsAt(mesh.X.col(i))) nodes.push_back(static_cast<std::int32_t>(i));
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", origin, fault.what()));
  }
  if (nodes.empty()) {
    const Eigen::Vector3d low = mesh.X.rowwise().minCoeff(), high = mesh.X.rowwise().maxCoeff();
    throw InputError(fmt::format("{}: {} selects no node; the mesh lies in {} <= x <= {}, {} <= y <= {}, {} <= z <= {}",
                                 origin, inQuotes(where->text()), low[0], high[0], low[1], high[1], low[2], high[2]));
  }
  return nodes;
}

std::string tooManySteps(double h, double end) {
  const double steps = end / h;
  if (steps <= mostSteps) return {};
  return fmt::format("{} s makes {:.3g} steps to the end at {} s; at most {} are possible", h, steps, end, mostSteps);
}

namespace {
Scene makeScene(const std::filesystem::path& file, const std::vector<Section>& sections) {
  Scene scene;
  scene.file = file;
  scene.echo = echoOf(sections);
  const auto section = [&](std::string_view name) -> const Section& {
    return *std::find_if(sections.begin(), sections.end(), [&](const Section& s) { return s.name == name; });
  };
  readMeshSection(section("mesh"), scene);

  const Section& material = section("material");
  scene.model = material.get<std::string>("model");
  readLawParameters(lawNamed(scene.model), material, scene);
  scene.density = material.get<double>("density");
  scene.lumping = material.named("lumping", lumpingNames);
  if (material.given("rules"))
    scene.rules = parseRules(material.get<std::vector<std::string>>("rules"), material.where("rules"));

  readIntegratorSection(section("integrator"), section("monitor"), section("damping"), scene);
  readHandlerSection(section("handler"), section("integrator"), section("monitor"), section("damping"), scene);
  readDevice(section("integrator"), scene);
  for (const Section& s : sections)
    if (s.name == "fix" || s.name == "move" || s.name == "force") readLoadSection(s, scene);

  for (const Section& s : sections)
    if (s.name == "cut") readCutSection(s, scene);
  std::stable_sort(scene.cuts.begin(), scene.cuts.end(),
                   [](const Scene::Cut& a, const Scene::Cut& b) { return a.time < b.time; });
  if (!scene.cuts.empty() && scene.device == RunDevice::cuda)
    throw InputError(fmt::format("{}: \"cuda\": a GPU runs no cuts; set it to \"cpu\"", scene.deviceOrigin));
  if (!scene.cuts.empty() && scene.device == RunDevice::automatic) scene.noDevice = "a GPU runs no cuts";

  const Section& output = section("output");
  if (output.given("every")) {
    scene.frameInterval = output.get<double>("every");
    const double frames = scene.end / *scene.frameInterval;
    if (!(frames <= mostSteps))
      fail(output.at("every").origin, "output.every",
           fmt::format("{} s makes {:.3g} frames to the end at {} s; at most {} are possible", *scene.frameInterval,
                       frames, scene.end, mostSteps));
  }
  scene.fields = output.get<std::vector<std::string>>("fields");
  scene.historyEvery = output.get<std::int64_t>("history_every");
  scene.energy = output.get<bool>("energy");
  scene.picture = output.get<bool>("picture");
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  for (const std::string& field : scene.fields)
    if ((std::isinf(info.imaginaryLimit) || info.partitioned) && (field == "critical_step" || findMetric(field)))
      fail(output.at("fields").origin, "output.fields",
           fmt::format("\"{}\": \"{}\" {} and has no critical step", field, scene.method,
                       info.partitioned ? "chooses its stiff elements by the step" : "is stable at every step"));
  if (scene.metric.empty() && std::find(scene.fields.begin(), scene.fields.end(), "metric") != scene.fields.end())
    fail(output.at("fields").origin, "output.fields", "\"metric\" needs a metric; set monitor.metric");
  return scene;
}
}  // namespace

Scene readScene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return makeScene(file, Reader(file, overrides).sections());
}

Scene sceneOfRun(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "summary.json";
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(fmt::format("{}: cannot read; it is there when a run has ended in this folder", file.string()));
  const Json summary = Json::parse(stream, nullptr, false);
  const auto echo = summary.is_object() ? summary.find("scene") : summary.end();
  if (!summary.is_object() || echo == summary.end() || !echo->is_object())
    throw InputError(fmt::format("{}: not the summary of a run; it has no \"scene\"", file.string()));
  // JSON's texts, numbers and lists are TOML's.
  std::string text;
  const auto add = [&](const std::string& head, const Json& section) {
    text += head + "\n";
    for (const auto& [key, value] : section.items())
      if (!value.is_null()) text += fmt::format("{} = {}\n", key, value.dump());
  };
  for (const auto& [name, section] : echo->items()) {
    if (!section.is_array()) {
      add(fmt::format("[{}]", name), section);
    } else {
      for (const Json& entry : section) add(fmt::format("[[{}]]", name), entry);
    }
  }
  try {
    return makeScene(file, Reader(file, toml::parse(text)).sections());
  } catch (const toml::parse_error& fault) {
    throw InputError(fmt::format("{}: its \"scene\" cannot be read: {}", file.string(), fault.description()));
  }
}

std::optional<std::array<bool, 3>> parseComponents(std::string_view text) {
  std::array<bool, 3> result{};
  for (char c : text) {
    if (c < 'x' || c > 'z' || result[c - 'x']) return std::nullopt;
    result[c - 'x'] = true;
  }
  if (text.empty()) return std::nullopt;
  return result;
}

Scene::Fix parseFix(const std::string& text, const std::string& origin) {
  const std::size_t begin = text.rfind("set:", 0) == 0 ? 4 : 0, colon = text.rfind(':');
  if (colon == std::string::npos || colon < begin) return {NodeSelection::parse(text, origin), {true, true, true}};
  const std::string components = text.substr(colon + 1);
  const auto held = parseComponents(components);
  if (!held)
    throw InputError(fmt::format("{}: {}: {} names no components; must be some of x, y, z, each once", origin,
                                 inQuotes(text), inQuotes(components)));
  return {NodeSelection::parse(text.substr(0, colon), origin), *held};
}

std::map<std::string, std::string> parseRules(const std::vector<std::string>& texts, const std::string& origin) {
  std::map<std::string, std::string> rules;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const ElementInfo* element = nullptr;
    std::vector<std::string> elements;
    for (const ElementInfo& info : allElements()) {
      elements.emplace_back(info.name);
      if (info.name == name) element = &info;
    }
    if (equals == std::string::npos || !element)
      throw InputError(fmt::format("{}: {} must be ELEMENT=RULE; elements are {}", origin, inQuotes(text),
                                   fmt::join(elements, ", ")));
    const std::string rule = text.substr(equals + 1);
    if (!findRule(*element, rule) || rule.empty()) {
      std::vector<std::string> known;
      for (const QuadratureRule& r : element->rules) known.emplace_back(r.name);
      throw InputError(fmt::format("{}: unknown rule {} for {}; did you mean \"{}\"? known are {}", origin,
                                   inQuotes(rule), name, nearestName(rule, known), fmt::join(known, ", ")));
    }
    rules[name] = rule;
  }
  return rules;
}

int threadsThatPay(int requested, const Mesh& mesh) {
  constexpr std::size_t elementsPerThread = 4000;
  if (requested > 0) return requested;
  return std::min(threadCount(0),
                  static_cast<int>(std::min<std::size_t>(1 + mesh.elementCount() / elementsPerThread, 1 << 20)));
}

Mesh sceneMesh(const Scene& scene, std::vector<std::string>& notes) {
  if (scene.generator.empty()) {
    try {
      Mesh mesh = loadMesh(scene.meshFile, &notes);
      renumberNodes(mesh);  // a mesher's order may cost a fifth of every step
      return mesh;
    } catch (const InputError& fault) {
      throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));
    }
  }
  try {
    return generateMesh(scene.generator, generatorArguments(scene.generatorArguments));
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));
  }
}

Body sceneBody(const Scene& scene, Mesh mesh, int threads) {
  BodyOptions options;
  options.lumping = scene.lumping;
  options.rules = scene.rules;
  options.threads = threadsThatPay(threads, mesh);
  std::optional<Body> body;
  try {
    body.emplace(std::move(mesh), makeMaterial(scene.model, scene.parameters, scene.density), options);
  } catch (const NumericalError& fault) {
    throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));  // the mesh is what the user can mend
  }
  PrescribedMotions prescribed(body->nodeCount());
  for (const Scene::Fix& fix : scene.fixes) {
    const std::vector<std::int32_t> nodes = fix.nodes.nodesOf(body->mesh());
    prescribed.add(fix.nodes.origin, nodes, fix.components, Eigen::Vector3d::Zero());
    for (std::int32_t node : nodes)
      for (int c = 0; c < 3; ++c)
        if (fix.components[c]) body->constraints().fix(node, c);
  }
  for (const Scene::Move& move : scene.moves) {
    const std::vector<std::int32_t> nodes = move.nodes.nodesOf(body->mesh());
    prescribed.add(move.nodes.origin, nodes, move.components, move.velocity);
    for (std::int32_t node : nodes)
      for (int c = 0; c < 3; ++c)
        if (move.components[c]) body->constraints().move(node, c, move.velocity[c]);
  }
  for (const Scene::Force& force : scene.forces) {
    const std::vector<std::int32_t> nodes = force.nodes.nodesOf(body->mesh());
    double mass = 0;
    for (std::int32_t node : nodes) mass += body->lumpedMass()[node];
    const Eigen::Vector3d acceleration =
        force.acceleration ? *force.acceleration : Eigen::Vector3d(*force.total / mass);
    for (std::int32_t node : nodes) body->externalForce().col(node) += body->lumpedMass()[node] * acceleration;
  }
  return std::move(*body);
}

}  // namespace ringwatch
