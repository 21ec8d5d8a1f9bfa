#include <ringwatch/app/scene/deck_writer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {

DeckWriter::DeckWriter(const std::filesystem::path& file, DeckUse use, detail::DeckDialect dialect)
    : file_(file), use_(use), text_(detail::readWholeFile(file)), lines_(file, text_, dialect) {}

void DeckWriter::refuse(std::size_t position, const std::string& what) {
  refused_.push_back(fmt::format("{}: {}", lines_.where(position), what));
}

void DeckWriter::throwRefused() const {
  if (refused_.empty()) return;
  std::string text = refused_.front();
  constexpr std::size_t shown = 8;
  if (refused_.size() > 1) text += fmt::format("; and {} more: ", refused_.size() - 1);
  for (std::size_t i = 1; i < std::min(refused_.size(), shown); ++i) text += (i == 1 ? "" : "; ") + refused_[i];
  if (refused_.size() > shown) text += "; …";
  throw InputError(text);
}

void DeckWriter::leaveOut(std::string_view keyword, std::size_t position) {
  left_ += fmt::format("{}*{} ({})", left_.empty() ? "" : ", ", keyword, placeOf(position));
}

std::string DeckWriter::placeOf(std::size_t position) const {
  const std::string where = lines_.where(position), own = file_.string() + ":";
  return where.starts_with(own) ? "line " + where.substr(own.size()) : where;
}

bool DeckWriter::follow(DeckRule rule, std::string_view keyword, std::string_view parameter, std::string_view why,
                        std::size_t position) {
  const auto told = [&] { return fmt::format("*{}{}{}: {}", keyword, parameter.empty() ? "" : ", ", parameter, why); };
  switch (rule) {
    case DeckRule::mesh:
    case DeckRule::taken:
      return true;
    case DeckRule::takenInRun:
      if (!forRun()) leaveOut(keyword, position);
      return true;
    case DeckRule::other:
      note(fmt::format("{}: {}", lines_.where(position), told()));
      return true;
    case DeckRule::harmless:
      if (!parameter.empty()) {
        if (forRun()) note(fmt::format("{}: {}", lines_.where(position), told()));
        return true;
      }
      [[fallthrough]];
    case DeckRule::output:
    case DeckRule::temperature:
    case DeckRule::expansion:
      leaveOut(keyword, position);
      return true;
    case DeckRule::procedure:
    case DeckRule::load:
      if (!forRun()) {
        if (parameter.empty()) leaveOut(keyword, position);
        return true;
      }
      [[fallthrough]];
    case DeckRule::refused:
      refuse(position, told());
      return false;
  }
  return false;
}

const Mesh& DeckWriter::mesh() {
  if (!mesh_) mesh_ = readMesh(file_);
  return *mesh_;
}

std::vector<std::int32_t> DeckWriter::nodesOf(const std::string& selection) {
  if (const auto set = mesh().nodeSets.find(selection); set != mesh().nodeSets.end()) return set->second;
  if (selection.starts_with('#')) {
    if (const auto node = numbers().node(std::stoll(selection.substr(1)))) return {*node};
  }
  return {};
}

NumberIndex& DeckWriter::numbers() {
  if (!numbers_) numbers_.emplace(mesh());
  return *numbers_;
}

const DeckFaces& DeckWriter::faces() {
  if (!faces_) faces_.emplace(mesh());
  return *faces_;
}

void DeckWriter::press(const std::vector<std::int32_t>& faces, double pressure, const std::string& amplitude,
                       std::size_t position) {
  const auto begin = [&] {
    pressures_.push_back({pressure, amplitude, position});
    pressed_.clear();
  };
  if (pressures_.empty() || pressures_.back().position != position || pressures_.back().value != pressure ||
      pressures_.back().amplitude != amplitude)
    begin();
  for (const std::int32_t one : faces) {
    if (!pressed_.insert(one).second) {  // pressures on a face add up
      begin();
      pressed_.insert(one);
    }
    pressures_.back().faces.push_back(one);
  }
}

void DeckWriter::addEntry(const std::string& section, const std::string& selection, const Json& rest,
                          std::size_t position) {
  Json& list = scene_.sections[section];
  if (list.is_null()) list = Json::array();
  const std::string key = rest.dump();
  Last& last = last_[section];
  // A node that comes again adds its value once more.
  if (selection.starts_with("#") && !list.empty() && last.key == key && last.nodes.insert(selection).second) {
    list.back()["set"] = list.back()["set"].get<std::string>() + "," + selection.substr(1);
    return;
  }
  last = {selection.starts_with("#") ? key : "", {selection}};
  scene_.origins[fmt::format("{}.{}", section, list.size())] = lines_.where(position);
  Json entry = Json::object();
  if (!selection.empty())
    entry["set"] = selection;
  else if (section != "contact" && section != "obstacle" && !rest.contains("rigid"))
    entry["where"] = "all";
  entry.update(rest);
  list.push_back(std::move(entry));
}

void DeckWriter::writeMaterialList(Json list, const std::vector<std::string>& origins) {
  if (list.size() == 1) {
    scene_.sections["material"] = list.front();
    scene_.origins["material"] = origins.front();
    return;
  }
  scene_.sections["material"] = std::move(list);
  for (std::size_t i = 0; i < origins.size(); ++i) scene_.origins[fmt::format("material.{}", i)] = origins[i];
}

void DeckWriter::writeBoundaries() {
  for (const DeckBoundary& held : boundaries_) {
    if (held.components.empty()) continue;  // a solid has no rotations
    if (held.value == 0 || !forRun()) {
      addEntry("fix", held.selection, {{"components", held.components}}, held.position);
      continue;
    }
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (const char c : held.components) value[c - 'x'] = held.value;
    const Table table = held.velocity ? tableOf(held.amplitude, held.position) : displacementTable(held);
    Json entry{{"components", held.components},
               {held.velocity ? "velocity" : "displacement", listOf(table.factor * value)}};
    entry.update(table.entries);
    addEntry("move", held.selection, entry, held.position);
  }
}

void DeckWriter::addContact(const Json& entry, const std::string& nodes, const std::string& faces, bool nodesHaveFaces,
                            std::size_t position) {
  if (!std::exchange(contactIsTold_, true))
    note(
        fmt::format("{}: contact is by penalty here, of a stiffness at the nodes that the step has room for; "
                    "contact.penalty sets it",
                    lines_.where(position)));
  const auto write = [&](const std::string& own, const std::string& other) {
    Json sides = entry;
    if (!other.empty()) sides["to_set"] = other;
    keepApart("contact");
    addEntry("contact", own, sides, position);
  };
  write(nodes, faces);
  if (nodesHaveFaces && nodes != faces) write(faces, nodes);
}

void DeckWriter::writeLoad(const DeckLoad& load) {
  const Table table = tableOf(load.amplitude, load.position);
  Json entry{{load.acceleration ? "acceleration" : "each", listOf(table.factor * load.value)}};
  entry.update(table.entries);
  addEntry("force", load.selection, entry, load.position);
}

void DeckWriter::addWaves(const Json& entry, std::vector<ElementRef> elements, const std::string& what,
                          std::size_t position) {
  const std::string model = entry["model"];
  const double density = entry["density"];
  Options parameters;
  for (const OptionInfo& parameter : lawNamed(model).parameters)
    if (const auto own = entry.find(std::string(parameter.name)); own != entry.end())
      parameters.set(own.key(), own->get<double>());
  try {
    waves_.push_back({std::move(elements), makeMaterial(model, parameters, density).waveSpeed(), density});
  } catch (const InputError& fault) {
    lines_.failAt(position, fmt::format("{}: {}", what, fault.what()));
  }
}

DeckWriter::Crossings DeckWriter::scaleMasses(double step, const std::set<ElementRef>* elements,
                                              std::string_view keyword, std::size_t position) {
  Crossings all;
  const auto quality = meshQuality(mesh());
  std::map<std::int32_t, double> added;  // by node
  for (const auto& [ofMaterial, speed, density] : waves_)
    for (const ElementRef element : ofMaterial) {
      const MeshBlock& block = mesh().blocks[element.block];
      const ElementQuality& own = quality[element.block][element.element];
      const double mass = density * std::abs(own.volume);
      all.mass += mass;
      ++all.count;
      const bool mayGet = step > 0 && (elements == nullptr || elements->contains(element));
      if (elementInfo(block.type).order > 1) {
        if (mayGet)
          lines_.failAt(position, fmt::format("*{}: the mass that it adds to elements of ten nodes is not known; take "
                                              "it out, or the elements",
                                              keyword));
        continue;
      }
      const double crossing = std::abs(own.minHeight) / speed;
      if (crossing < all.least) {
        all.least = crossing;
        all.controlling = block.id(static_cast<std::size_t>(element.element));
      }
      if (!mayGet || crossing >= step) continue;
      ++all.scaled;
      // As the mass of the element, so that its density is the one that its step needs.
      const double share = mass * (step * step / (crossing * crossing) - 1) / block.nodesPerElement();
      for (int a = 0; a < block.nodesPerElement(); ++a)
        added[block.element(static_cast<std::size_t>(element.element))[a]] += share;
    }
  std::map<double, std::vector<std::int64_t>> alike;
  for (const auto& [node, own] : added) {
    all.added += own;
    alike[own].push_back(mesh().nodeId(node));
  }
  for (const auto& [own, nodes] : alike) {
    keepApart("mass");
    addEntry("mass", fmt::format("#{}", fmt::join(nodes, ",")), {{"mass", own * static_cast<double>(nodes.size())}},
             position);
  }
  return all;
}

void DeckWriter::writePressures() {
  for (const Pressure& pressure : pressures_) {
    const Table table = tableOf(pressure.amplitude, pressure.position);
    Json entry{{"pressure", table.factor * pressure.value}};
    entry.update(table.entries);
    for (const std::string& nodes : faces().nodeSetsOf(pressure.faces)) {
      keepApart("pressure");  // sets of two entries stay apart
      addEntry("pressure", nodes, entry, pressure.position);
    }
  }
}

DeckScene DeckWriter::finished() {
  if (!left_.empty())
    note(fmt::format("{}: left out, they {}: {}", file_.string(),
                     forRun() ? "change no motion" : "do not matter to the step of the body at rest", left_));
  return std::move(scene_);
}

}  // namespace ringwatch
