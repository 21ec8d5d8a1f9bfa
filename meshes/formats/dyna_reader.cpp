#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_set>
#include <vector>

#include <ringwatch/meshes/formats/dyna_cards.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

constexpr int vtkTetrahedron = 10, vtkHexahedron = 12, vtkQuadraticTetrahedron = 24;

/// Keywords that would change nodes or elements and are not followed.
constexpr std::string_view changesMesh[] = {"INCLUDE_", "NODE_", "ELEMENT_SOLID_", "ELEMENT_GENERATE", "PARAMETER"};

/// What the numbers of a set are of.
enum class Of { nodes, parts, solids };
struct SetKeyword {
  std::string_view name;
  Of of;
  bool ranges;  // its numbers are first ones and last ones
};
constexpr SetKeyword setKeywords[] = {{"SET_NODE", Of::nodes, false},
                                      {"SET_NODE_LIST", Of::nodes, false},
                                      {"SET_NODE_LIST_GENERATE", Of::nodes, true},
                                      {"SET_PART", Of::parts, false},
                                      {"SET_PART_LIST", Of::parts, false},
                                      {"SET_PART_LIST_GENERATE", Of::parts, true},
                                      {"SET_SOLID", Of::solids, false},
                                      {"SET_SOLID_GENERATE", Of::solids, true}};

class DynaMesh {
 public:
  DynaMesh(const std::filesystem::path& path, const std::string& text)
      : lines_(path, text, DeckDialect::dyna),
        keywords_(lines_),
        source_(path.string()),
        builder_(
            source_, [this](std::size_t p) { return lines_.where(p); },
            [this](std::size_t p) { return lines_.where(p); }) {
    builder_.noVolumeHint = "; this is an LS-DYNA deck, in which *ELEMENT_SOLID has them";
  }

  Mesh read(Notes* notes, Problems* problems) {
    while (const std::optional<DeckLine> line = lines_.next()) {
      if (line->isKeyword())
        begin(*line);
      else
        data(*line);
    }
    finish();
    addElements();
    addNodeSets();
    Mesh mesh = builder_.finish(notes, problems);
    if (notes != nullptr) addNotes(*notes);
    return mesh;
  }

 private:
  enum class Reading { nothing, nodes, solids, structure, set, ranges };
  struct Solid {
    const FileElement* type;
    std::int64_t id, part;
    std::array<std::int64_t, 10> nodes;
    std::size_t position;
  };
  struct Set {
    Of of;
    std::vector<std::pair<std::int64_t, std::int64_t>> ranges;  // first, last
    std::size_t position;
  };
  void begin(const DeckLine& line) {
    finish();
    keyword_ = keywords_.read(line);
    const std::string& name = keyword_.name;
    reading_ = Reading::nothing;
    titles_ = keyword_.titled ? 1 : 0;
    set_ = nullptr;
    if (name == "NODE") {
      reading_ = Reading::nodes;
    } else if (name == "ELEMENT_SOLID") {
      reading_ = Reading::solids;
    } else if (name.starts_with("ELEMENT_SHELL") || name.starts_with("ELEMENT_BEAM")) {
      reading_ = Reading::structure;
      ++skipped_["*" + name];
    } else if (const auto* own = std::ranges::find(setKeywords, name, &SetKeyword::name);
               own != std::end(setKeywords)) {
      reading_ = own->ranges ? Reading::ranges : Reading::set;
      of_ = own->of;
    } else {
      for (const std::string_view prefix : changesMesh)
        if (name.starts_with(prefix) && name != "PARAMETER_DUPLICATION")
          lines_.failAt(line.position, joinText("*", name, " is not read; ringwatch help decks lists what is"));
      if (name != "KEYWORD" && name != "TITLE") ++skipped_["*" + name];
    }
  }

  void data(const DeckLine& line) {
    if (reading_ == Reading::nothing) return;
    if (titles_ > 0) {
      --titles_;
      return;
    }
    if (reading_ == Reading::structure) {
      ++builder_.leftOut;
      return;
    }
    if (reading_ == Reading::nodes) return node(line);
    if (reading_ == Reading::solids) return solid(line);
    member(line);
  }

  void node(const DeckLine& line) {
    if (line.text.empty()) return;
    const DynaCard card(lines_, keyword_, line, DynaLayout::node);
    builder_.addNode(card.id(0, "NID"), card.real(1, "X"), card.real(2, "Y"), card.real(3, "Z"), line.position);
    nodes_.push_back(card.id(0, "NID"));
  }

  /// A line of its own for the numbers of the element and its part, or one with the nodes as well.
  void solid(const DeckLine& line) {
    if (line.text.empty() && !unfinished_) return;
    const DynaCard card(lines_, keyword_, line, DynaLayout::elements);
    std::size_t first = 0;
    if (!unfinished_) {
      solids_.push_back({nullptr, card.id(0, "EID"), card.id(1, "PID"), {}, line.position});
      unfinished_ = card.size() <= 2;
      if (unfinished_) return;
      first = 2;
    }
    unfinished_ = false;
    Solid& solid = solids_.back();
    static constexpr std::string_view names[] = {"N1", "N2", "N3", "N4", "N5", "N6", "N7", "N8", "N9", "N10"};
    for (std::size_t i = 0; i < solid.nodes.size(); ++i) {
      const std::int64_t number = card.whole(first + i, names[i]);
      if (number < 0 || (number == 0 && i < 4)) card.fail(first + i, names[i], "the number of a node");
      solid.nodes[i] = number;
    }
    auto& n = solid.nodes;
    const auto isEmpty = [&](std::size_t begin) {
      return std::all_of(n.begin() + static_cast<std::ptrdiff_t>(begin), n.end(), [](auto one) { return one == 0; });
    };
    // A tetrahedron repeats its last node, or leaves the others out.
    const bool tetrahedron = isEmpty(4) || (isEmpty(8) && std::all_of(n.begin() + 4, n.begin() + 8,
                                                                      [&](std::int64_t one) { return one == n[3]; }));
    solid.type = findVtkElement(tetrahedron ? vtkTetrahedron : isEmpty(8) ? vtkHexahedron : vtkQuadraticTetrahedron);
    for (std::size_t i = 0; i < static_cast<std::size_t>(solid.type->nodes); ++i)
      if (n[i] == 0) card.fail(first + i, names[i], "the number of a node");
    if (!numbers_.insert(solid.id).second)
      lines_.failAt(solid.position, joinText("element ", solid.id, " is defined a second time"));
  }

  void member(const DeckLine& line) {
    const DynaCard card(lines_, keyword_, line);
    if (set_ == nullptr) {
      const auto [made, isNew] = sets_.try_emplace({of_, card.id(0, "SID")}, Set{of_, {}, line.position});
      if (!isNew)
        lines_.failAt(line.position,
                      joinText("*", keyword_.name, ": set ", card.id(0, "SID"), " is defined a second time"));
      set_ = &made->second;
      return;
    }
    const std::size_t step = reading_ == Reading::ranges ? 2 : 1;
    for (std::size_t i = 0; i < card.size(); i += step) {
      if (card.whole(i, "ID") == 0) continue;
      const std::int64_t from = card.id(i, "ID"), to = step == 1 ? from : card.id(i + 1, "the last ID");
      if (to < from) card.fail(i + 1, "the last ID", "no less than the first");
      set_->ranges.emplace_back(from, to);
    }
  }
  void finish() {
    if (unfinished_)
      lines_.failAt(solids_.back().position, joinText("element ", solids_.back().id, " has no line of nodes"));
  }

  /// Calls found(number) for the numbers of a set among those that there are, sorted.
  template <class Found>
  static void forEachMember(const Set& set, const std::vector<std::int64_t>& known, const Found& found) {
    for (const auto& [first, last] : set.ranges)
      for (auto at = std::lower_bound(known.begin(), known.end(), first); at != known.end() && *at <= last; ++at)
        found(*at);
  }

  void addElements() {
    std::vector<std::int64_t> solids, parts;
    for (const Solid& solid : solids_) {
      solids.push_back(solid.id);
      parts.push_back(solid.part);
    }
    sortUnique(solids);
    sortUnique(parts);
    std::map<std::int64_t, std::vector<std::string>> ofPart, ofSolid;
    for (const std::int64_t part : parts) ofPart[part] = {dynaPart(part)};
    for (const auto& entry : sets_) {
      const Set& set = entry.second;
      const std::int64_t id = entry.first.second;
      if (set.of == Of::parts)
        forEachMember(set, parts, [&](std::int64_t part) { ofPart[part].push_back(dynaPartSet(id)); });
      if (set.of == Of::solids)
        forEachMember(set, solids, [&](std::int64_t solid) { ofSolid[solid].push_back(dynaSolidSet(id)); });
    }
    std::map<std::vector<std::string>, int> groups;
    for (const Solid& solid : solids_) {
      std::vector<std::string> names = ofPart.at(solid.part);
      for (std::size_t i = 0; i < static_cast<std::size_t>(solid.type->nodes); ++i)
        for (const std::string& name : names) inPart_[name].push_back(solid.nodes[i]);
      if (const auto own = ofSolid.find(solid.id); own != ofSolid.end())
        names.insert(names.end(), own->second.begin(), own->second.end());
      const auto [group, isNew] = groups.try_emplace(names, 0);
      if (isNew) group->second = builder_.addGroup(names);
      builder_.addElement(*solid.type, solid.id, solid.nodes.data(), group->second, solid.position);
    }
  }
  void addNodeSets() {
    sortUnique(nodes_);
    for (auto& [name, nodes] : inPart_) {
      sortUnique(nodes);
      // What an element refers to in vain the builder tells.
      for (const std::int64_t node : nodes)
        if (std::binary_search(nodes_.begin(), nodes_.end(), node)) builder_.addToNodeSet(name, node);
    }
    for (const auto& entry : sets_) {
      const Set& set = entry.second;
      const std::int64_t id = entry.first.second;
      if (set.of != Of::nodes) continue;
      for (const auto& [first, last] : set.ranges)
        if (first == last && !std::binary_search(nodes_.begin(), nodes_.end(), first))
          lines_.failAt(set.position, joinText("set ", id, " holds node ", first, ", which no *NODE defines"));
      forEachMember(set, nodes_, [&](std::int64_t node) { builder_.addToNodeSet(dynaNodeSet(id), node); });
    }
  }

  void addNotes(Notes& notes) const {
    std::string list;
    for (const auto& [name, count] : skipped_)
      list += (list.empty() ? "" : ", ") + name + (count > 1 ? joinText(" (", count, ")") : "");
    if (!list.empty()) notes.push_back(joinText(source_, deckSkippedNote, list));
  }

  DeckLines lines_;
  DynaKeywords keywords_;
  std::string source_;
  MeshBuilder builder_;
  DynaKeyword keyword_;
  Reading reading_ = Reading::nothing;
  Of of_ = Of::nodes;
  int titles_ = 0;
  bool unfinished_ = false;  // an element whose nodes stand in the next line
  std::vector<Solid> solids_;
  std::unordered_set<std::int64_t> numbers_;  // of elements
  std::vector<std::int64_t> nodes_;           // numbers
  std::map<std::pair<Of, std::int64_t>, Set> sets_;
  Set* set_ = nullptr;
  std::map<std::string, std::vector<std::int64_t>> inPart_;  // nodes of parts and of sets of parts
  std::map<std::string, int> skipped_;
};

}  // namespace

// LS-DYNA Keyword User's Manual, Volume I, "*NODE", "*ELEMENT_SOLID", "*SET".
Mesh readDyna(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  return DynaMesh(path, text).read(notes, problems);
}

}  // namespace ringwatch::detail
