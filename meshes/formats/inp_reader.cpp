#include <algorithm>
#include <cctype>
#include <charconv>
#include <compare>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/formats/deck_lines.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

/// Nodes of a deck's element, and the number of its VTK cell.
struct DeckShape {
  int nodes, vtk;
};
constexpr DeckShape solidShapes[] = {{4, 10},  {5, 14},  {6, 13},  {8, 12}, {10, 24},
                                     {13, 27}, {15, 26}, {20, 25}, {27, 29}},
                    flatShapes[] = {{3, 5}, {4, 9}, {6, 22}, {8, 23}}, lineShapes[] = {{2, 3}, {3, 21}};
struct DeckFamily {
  std::string_view prefix;  // letters behind the number of nodes keep them (R reduced, H hybrid, M modified, …)
  std::span<const DeckShape> shapes;
};
/// The order of their nodes is VTK's for all of these.
constexpr DeckFamily deckFamilies[] = {
    {"C3D", solidShapes}, {"F3D", solidShapes}, {"DC3D", solidShapes}, {"CPS", flatShapes}, {"CPE", flatShapes},
    {"CAX", flatShapes},  {"M3D", flatShapes},  {"SFM3D", flatShapes}, {"S", flatShapes},   {"T3D", lineShapes}};

/// nullptr for types without a mesh cell (springs, masses, …).
const FileElement* elementOfDeck(std::string_view type) {
  if (type == "B31" || type == "B31R" || type == "B21") return findVtkElement(3);
  if (type == "B32" || type == "B32R") return findVtkElement(21);
  for (const auto& [prefix, shapes] : deckFamilies) {
    int nodes = 0;
    if (!type.starts_with(prefix) ||
        std::from_chars(type.data() + prefix.size(), type.data() + type.size(), nodes).ec != std::errc())
      continue;
    const auto found = std::ranges::find(shapes, nodes, &DeckShape::nodes);
    return found == shapes.end() ? nullptr : findVtkElement(found->vtk);
  }
  return nullptr;
}

class Deck {
 public:
  Deck(const std::filesystem::path& path, const std::string& text)
      : lines_(path, text),
        source_(path.string()),
        builder_(
            source_, [this](std::size_t p) { return lines_.where(p); },
            [this](std::size_t p) { return lines_.where(p); }) {}

  Mesh read(Notes* notes, Problems* problems) {
    while (const std::optional<DeckLine> line = lines_.next()) {
      if (line->isKeyword())
        begin(*line);
      else
        data(*line);
    }
    finishData();
    requireEnd();
    if (instances_.empty() && !parts_.empty() && model_.nodes.empty())
      lines_.failAt(parts_.begin()->second.position,
                    "the deck has parts, but no *INSTANCE of one, so that there is no mesh");
    requireNodes(model_);
    if (instances_.size() == 1) dropPrefix();
    for (const Node& node : model_.nodes) builder_.addNode(node.id, node.X[0], node.X[1], node.X[2], node.position);
    buildElements();
    addNodeSets();
    Mesh mesh = builder_.finish(notes, problems);
    if (notes != nullptr) addNotes(*notes);
    return mesh;
  }
  /// What is added to the numbers of each instance, by its name in upper case.
  std::map<std::string, std::int64_t> offsets() const {
    std::map<std::string, std::int64_t> all;
    for (const auto& [name, instance] : instances_) all[name] = instance.offset;
    return all;
  }

 private:
  struct Node {
    std::int64_t id;
    Eigen::Vector3d X;
    std::size_t position;
  };
  struct Element {
    const FileElement* type;
    const std::string* formulation;  // TYPE=, in upper case
    std::int64_t id;
    std::vector<std::int64_t> nodes;
    std::vector<std::uint32_t> sets;  // numbers of the element sets, in the order of their map
    std::size_t position;
  };
  /// first, first + step, … up to last.
  struct Range {
    std::int64_t first, last, step;
    auto operator<=>(const Range&) const = default;
    bool has(std::int64_t id) const { return first <= id && id <= last && (id - first) % step == 0; }
  };
  struct Set {
    std::string name;  // as first written
    std::vector<Range> ranges;
    std::size_t position;
    std::size_t distinct = 0;  // ranges that were left when repeated ones were last removed
    bool unsorted = false;

    /// A number that follows the one before goes into its range.
    void add(std::int64_t id) {
      if (!ranges.empty() && ranges.back().step == 1 && ranges.back().last == id - 1)
        ranges.back().last = id;
      else
        ranges.push_back({id, id, 1});
    }
    void removeRepeated() {
      sortUnique(ranges);
      distinct = ranges.size();
    }
  };
  using Sets = std::map<std::string, Set>;  // by the name in upper case
  /// A node of a set that stands above all *NODE with its number.
  struct Awaited {
    std::int64_t id;
    std::string set;
    std::size_t position;
  };
  /// A part, an instance of one, or the model: nodes and elements with numbers and sets of their own.
  struct Part {
    std::vector<Node> nodes;
    std::vector<Element> elements;
    std::unordered_map<std::int64_t, std::size_t> elementOfId, nodeOfId;
    std::vector<std::int64_t> shapeless;  // numbers of elements that the mesh does not have
    Sets nodeSets, elementSets;
    std::vector<Awaited> awaited;
    std::size_t position = 0;
  };
  struct Instance {
    std::string name;
    std::int64_t offset = 0;                     // of its numbers in the model
    std::vector<std::vector<double>> placement;  // translation; two points on an axis and an angle in degrees
  };
  /// Numbers of nodes or elements that the assembly has beside those of its instances.
  struct Own {
    std::map<std::int64_t, bool> inMesh;  // false where an instance has the number, and for what has no shape
    std::vector<Range> ofInstance;        // of sets of the assembly that name those of its only instance
  };
  enum class Reading {
    nothing,
    noData,  // a line of data is refused
    nodes,
    elements,
    shapeless,
    nodeSet,
    elementSet,
    placement,
    system,
    nodeLine,
    nodeFill,
    elementRows
  };

  void begin(const DeckLine& first) {
    finishData();
    keyword_ = lines_.keyword(first);
    std::string name = keyword_.name;
    std::erase(name, ' ');  // *ENDSTEP is *END STEP
    const auto refuse = [&](const std::string& why) { lines_.failAt(first.position, "*" + name + " " + why); };
    requireKnownParameters(name);
    reading_ = Reading::nothing;
    hasData_ = false;
    keepOpen(name);
    if (name == "NODE") {
      if (keyword_.has("SYSTEM") && inUpperCase(keyword_.value("SYSTEM")) != "R")
        refuse("with SYSTEM= other than R is not supported; write Cartesian coordinates");
      reading_ = Reading::nodes;
    } else if (name == "ELEMENT") {
      if (keyword_.value("TYPE").empty()) refuse("needs TYPE=, for instance TYPE=C3D8");
      const std::string type = inUpperCase(keyword_.value("TYPE"));
      type_ = elementOfDeck(type);
      formulation_ = &*formulations_.insert(type).first;
      if (type_ == nullptr) ++skipped_["*ELEMENT, TYPE=" + type];
      reading_ = type_ == nullptr ? Reading::shapeless : Reading::elements;
      continued_ = false;
      skipFormulation(type);
    } else if (name == "NSET" || name == "ELSET") {
      if (!keyword_.has(name)) refuse("needs the name of the set, " + name + "=");
      reading_ = name == "NSET" ? Reading::nodeSet : Reading::elementSet;
      Set& set = setOf(name == "NSET" ? part().nodeSets : part().elementSets, keyword_.value(name));
      set.unsorted = set.unsorted || keyword_.has("UNSORTED");
      if (name == "NSET" && keyword_.has("ELSET")) nodesOfElements();
    } else if (name == "PART") {
      const std::string part = inUpperCase(keyword_.value("NAME"));
      if (part.empty()) refuse("needs a name, NAME=");
      const auto [made, isNew] = parts_.try_emplace(part);
      if (!isNew) refuse("has the name of a part above, " + detail::quoted(keyword_.value("NAME")));
      made->second.position = first.position;
      current_ = &made->second;
      axes_ = Eigen::Affine3d::Identity();
      reading_ = Reading::noData;
    } else if (name == "INSTANCE") {
      beginInstance();
    } else if (name == "SYSTEM") {
      axes_ = Eigen::Affine3d::Identity();
      systemNumbers_.clear();
      reading_ = Reading::system;
    } else if (name == "NGEN" || name == "NFILL" || name == "ELGEN") {
      reading_ = name == "NGEN" ? Reading::nodeLine : name == "NFILL" ? Reading::nodeFill : Reading::elementRows;
    } else if (name == "NCOPY" || name == "ELCOPY" || name == "NMAP") {
      refuse("makes or moves nodes or elements and is not supported; write them out with *NODE and *ELEMENT");
    } else if (name.starts_with("END") || name == "ASSEMBLY") {
      reading_ = Reading::noData;
    } else if (name != "HEADING") {
      ++skipped_["*" + keyword_.name];
    }
    if (reading_ == Reading::nothing || reading_ == Reading::noData) return;
    keyword_.name = name;
    if (keyword_.has("INPUT")) lines_.include(keyword_);
  }

  /// A parameter of the mesh that is not followed would change it in silence.
  void requireKnownParameters(const std::string& keyword) const {
    static const std::map<std::string_view, std::vector<std::string_view>> known = {
        {"NODE", {"NSET", "SYSTEM", "INPUT"}},
        {"ELEMENT", {"TYPE", "ELSET", "INPUT"}},
        {"NSET", {"NSET", "ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED", "INPUT"}},
        {"ELSET", {"ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED", "INPUT"}},
        {"PART", {"NAME"}},
        {"ASSEMBLY", {"NAME"}},
        {"INSTANCE", {"NAME", "PART"}},
        {"SYSTEM", {"INPUT"}},
        {"NGEN", {"NSET"}},
        {"NFILL", {"NSET"}},
        {"ELGEN", {"ELSET"}}};
    const auto own = known.find(keyword);
    if (own == known.end()) return;
    for (const char* const name : {"NSET", "ELSET", "INSTANCE", "INPUT"})
      if (keyword_.has(name) && keyword_.value(name).empty())
        lines_.failAt(keyword_.position, joinText("*", keyword, ", ", name, ": needs a name, ", name, "="));
    for (const auto& entry : keyword_.parameters)
      if (std::find(own->second.begin(), own->second.end(), entry.first) == own->second.end()) {
        std::string list;
        for (const std::string_view name : own->second) list += joinText(list.empty() ? "" : ", ", name);
        lines_.failAt(keyword_.position, joinText("*", keyword, ", ", entry.first, " is not supported; ", list,
                                                  own->second.size() == 1 ? " is" : " are"));
      }
  }

  /// Solids with letters behind their number are of another quadrature or formulation than the plain ones.
  void skipFormulation(const std::string& type) {
    if (type_ == nullptr || type_->dimension < 3 || std::isdigit(static_cast<unsigned char>(type.back()))) return;
    const bool uniform = type.starts_with("C3D8R");
    ++skipped_[joinText("the formulation of ", type, uniform ? ", which rules = [\"hex8=uniform-strain\"] has" : "")];
  }

  /// Blocks that a line of their own ends.
  void keepOpen(const std::string& name) {
    for (const std::string_view block : {"PART", "ASSEMBLY", "INSTANCE", "STEP"}) {
      if (name == block) {
        open_.push_back({name, keyword_.position});
      } else if (name == joinText("END", block)) {
        if (block == "INSTANCE" && !open_.empty() && open_.back().name == block) place();
        while (!open_.empty() && open_.back().name != block) open_.pop_back();
        if (!open_.empty()) open_.pop_back();
        current_ = nullptr;
        axes_ = Eigen::Affine3d::Identity();
      }
    }
  }

  Part& part() { return current_ != nullptr ? *current_ : model_; }

  void beginInstance() {
    const auto refuse = [&](const std::string& why) { lines_.failAt(keyword_.position, "*INSTANCE " + why); };
    const std::string name = keyword_.value("NAME");
    if (name.empty()) refuse("needs a name, NAME=");
    if (instances_.count(inUpperCase(name)) != 0) refuse("has the name of an instance above, " + detail::quoted(name));
    if (order_.empty() && !model_.nodes.empty())
      refuse("stands below a *NODE of the model, whose numbers it may have too; write that *NODE below the instances");
    placed_ = {};
    if (const std::string part = keyword_.value("PART"); !part.empty()) {
      const auto found = parts_.find(inUpperCase(part));
      if (found == parts_.end())
        refuse(joinText("is of the part ", detail::quoted(part), ", which is not defined above"));
      placed_ = found->second;
    }
    instances_[inUpperCase(name)].name = name;
    order_.push_back(inUpperCase(name));
    current_ = &placed_;
    reading_ = Reading::placement;
  }

  void placementLine(const DeckLine& line) {
    Instance& instance = instances_[order_.back()];
    const std::size_t wanted = instance.placement.empty() ? 3 : 7;
    const auto words = DeckLines::fields(line.text);
    if (words.size() != wanted || instance.placement.size() > 1)
      lines_.failAt(line.position, joinText("the place of the instance has ", words.size(), " numbers in line ",
                                            instance.placement.size() + 1,
                                            "; it must have 3, its translation, and 7 in the next, two points of an "
                                            "axis and an angle in degrees"));
    auto& numbers = instance.placement.emplace_back();
    for (const std::string_view word : words)
      numbers.push_back(word.empty() ? 0 : lines_.real(word, "a number of the instance's place", line.position));
  }

  /// Puts the instance that ends into the model: moved, with numbers that are free, its sets as INSTANCE.SET.
  void place() {
    Instance& instance = instances_[order_.back()];
    Eigen::Affine3d moved = Eigen::Affine3d::Identity();
    if (!instance.placement.empty()) {
      const auto& t = instance.placement[0];
      moved.pretranslate(Eigen::Vector3d(t[0], t[1], t[2]));
    }
    if (instance.placement.size() > 1) {
      const auto& r = instance.placement[1];
      const Eigen::Vector3d a(r[0], r[1], r[2]), axis = Eigen::Vector3d(r[3], r[4], r[5]) - a;
      if (!(axis.norm() > 0)) lines_.failAt(keyword_.position, "the axis of the instance's rotation has no direction");
      constexpr double degree = 3.141592653589793 / 180;
      const Eigen::Affine3d turned =
          Eigen::Translation3d(a) * Eigen::AngleAxisd(degree * r[6], axis.normalized()) * Eigen::Translation3d(-a);
      moved = turned * moved;
    }
    requireNodes(placed_);
    std::int64_t largest = 0;
    for (const auto& entry : model_.nodeOfId) largest = std::max(largest, entry.first);
    for (const auto& entry : model_.elementOfId) largest = std::max(largest, entry.first);
    if (largest > 0) {
      constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max() / 20;
      if (largest > most) lines_.failAt(keyword_.position, joinText("no numbers above ", largest, " are left"));
      for (instance.offset = 10; instance.offset <= largest;) instance.offset *= 10;
    }
    const std::int64_t offset = instance.offset;
    spend(placed_.nodes.size() + placed_.elements.size(), "instance " + instance.name, keyword_.position);
    const bool still = instance.placement.empty();
    for (const Node& node : placed_.nodes) {
      model_.nodeOfId.emplace(shifted(node.id, offset), model_.nodes.size());
      model_.nodes.push_back(
          {shifted(node.id, offset), still ? node.X : Eigen::Vector3d(moved * node.X), node.position});
    }
    for (Element& element : placed_.elements) {
      element.id = shifted(element.id, offset);
      for (std::int64_t& node : element.nodes) node = shifted(node, offset);
      if (!model_.elementOfId.emplace(element.id, model_.elements.size()).second)
        lines_.failAt(element.position, joinText("element ", element.id, " is defined a second time"));
      model_.elements.push_back(std::move(element));
    }
    for (const std::int64_t id : placed_.shapeless) model_.shapeless.push_back(shifted(id, offset));
    for (const auto& [from, to] :
         {std::pair{&placed_.nodeSets, &model_.nodeSets}, {&placed_.elementSets, &model_.elementSets}})
      for (const auto& [key, set] : *from) {
        spend(set.ranges.size(), "set " + set.name, set.position);
        Set& own = to->try_emplace(order_.back() + "." + key, Set{instance.name + "." + set.name, {}, set.position})
                       .first->second;
        for (Range range : set.ranges) {
          range.first = shifted(range.first, offset);
          range.last = shifted(range.last, offset);
          own.ranges.push_back(range);
        }
      }
    placed_ = {};
  }
  static std::int64_t shifted(std::int64_t id, std::int64_t offset) {
    return id > std::numeric_limits<std::int64_t>::max() - offset ? std::numeric_limits<std::int64_t>::max()
                                                                  : id + offset;
  }

  /// The sets of the only instance have the names of its part, but where the assembly has a set of that name.
  void dropPrefix() {
    const std::string prefix = order_.front() + ".";
    for (Sets* sets : {&model_.nodeSets, &model_.elementSets}) {
      Sets renamed;
      for (auto& [key, set] : *sets) {
        const std::string plain = key.starts_with(prefix) ? key.substr(prefix.size()) : key;
        if (plain != key && sets->count(plain) == 0) {
          set.name = set.name.substr(prefix.size());
          renamed.emplace(plain, std::move(set));
        } else {
          renamed.emplace(key, std::move(set));
        }
      }
      *sets = std::move(renamed);
    }
  }

  Set& setOf(Sets& sets, const std::string& name) {
    return sets.try_emplace(inUpperCase(name), Set{name, {}, keyword_.position}).first->second;
  }

  void data(const DeckLine& line) {
    hasData_ = true;
    switch (reading_) {
      case Reading::nothing:
        if (keyword_.name.empty())
          lines_.failAt(line.position,
                        "a line of data before the first keyword; an .inp deck begins with *HEADING or *NODE");
        return;
      case Reading::noData:
        lines_.failAt(line.position, joinText("a line of data below *", keyword_.name, ", which has none"));
      case Reading::shapeless:
        if (!continued_) {
          part().shapeless.push_back(
              lines_.number(DeckLines::fields(line.text)[0], "the number of an element", line.position));
          if (inAssembly()) addOwn(part().shapeless.back(), false, "element", line.position);
        }
        continued_ = line.text.back() == ',';
        break;
      case Reading::placement:
        placementLine(line);
        break;
      case Reading::system:
        systemLine(line);
        break;
      case Reading::nodeLine:
        nodeLine(line);
        break;
      case Reading::nodeFill:
        nodeFill(line);
        break;
      case Reading::elementRows:
        elementRows(line);
        break;
      case Reading::nodes:
        node(line);
        break;
      case Reading::elements:
        element(line);
        break;
      case Reading::nodeSet:
        members(line, part().nodeSets, "node");
        break;
      case Reading::elementSet:
        members(line, part().elementSets, "element");
        break;
    }
    if (!line.ended)
      endless_.push_back(joinText(lines_.where(line.position), ": the last line, of *", keyword_.name,
                                  ", has no line end; it is taken as whole"));
  }

  void node(const DeckLine& line) {
    const auto words = DeckLines::fields(line.text);
    if (words.size() < 2 || words.size() > 7)
      lines_.failAt(line.position,
                    joinText("a node has ", words.size(), " entries; it must have a number and x, y, z"));
    const std::int64_t id = lines_.number(words[0], "the number of a node", line.position);
    Eigen::Vector3d X = Eigen::Vector3d::Zero();  // coordinates left out are zero
    for (std::size_t k = 0; k < 3 && k + 1 < words.size(); ++k)
      if (!words[k + 1].empty())
        X[k] = lines_.real(words[k + 1], joinText("coordinate ", "xyz"[k], " of node ", id), line.position);
    addNode(id, axes_ * X, line.position);
  }
  void addNode(std::int64_t id, const Eigen::Vector3d& X, std::size_t position) {
    const auto [known, isNew] = part().nodeOfId.try_emplace(id, part().nodes.size());
    if (isNew) part().nodes.push_back({id, X, position});
    if (inAssembly() && !addOwn(id, isNew, "node", position)) {
      if (keyword_.name != "NODE")
        lines_.failAt(position, joinText("*", keyword_.name, " makes node ", id,
                                         " of the assembly, a number that an instance has; take free numbers"));
      if (keyword_.has("NSET")) setOf(part().nodeSets, keyword_.value("NSET"));
      return;
    }
    if (part().nodes[known->second].X != X)
      lines_.failAt(position, joinText("node ", id, " is defined a second time, at another place"));
    if (keyword_.has("NSET")) setOf(part().nodeSets, keyword_.value("NSET")).add(id);
  }
  /// By value: new nodes move the others.
  Eigen::Vector3d placeOf(std::int64_t id, std::size_t position) {
    const auto known = part().nodeOfId.find(id);
    if (known == part().nodeOfId.end())
      lines_.failAt(position, joinText("*", keyword_.name, ": node ", id, " is not defined above"));
    return part().nodes[known->second].X;
  }
  /// The numbers of a line from entry `first` on; those that it does not have, or leaves empty, are 1, but for the
  /// `needed` first ones, which it must have.
  std::vector<std::int64_t> wholeNumbers(const DeckLine& line, std::size_t first, std::size_t count,
                                         std::size_t needed) {
    const auto words = DeckLines::fields(line.text);
    std::vector<std::int64_t> numbers(count, 1);
    for (std::size_t i = first; i < first + needed; ++i)
      if (i >= words.size() || words[i].empty())
        lines_.failAt(line.position, joinText("*", keyword_.name, " has no entry ", i + 1, "; it must be there"));
    if (words.size() > first + count)
      lines_.failAt(line.position, joinText("*", keyword_.name, " has ", words.size(),
                                            " entries; it must have at most ", first + count));
    constexpr std::int64_t most = 100'000'000'000;  // times as many as are made it is far from the largest number
    for (std::size_t i = first; i < words.size(); ++i) {
      if (words[i].empty()) continue;
      const std::string what = joinText("entry ", i + 1, " of *", keyword_.name);
      const std::int64_t number = lines_.number(words[i], what, line.position);
      if (number > most) lines_.failAt(line.position, joinText(what, " is ", number, "; it must be at most ", most));
      numbers[i - first] = number;
    }
    return numbers;
  }
  /// Nodes from one to another in a straight line, both ends included.
  void nodesBetween(std::int64_t first, std::int64_t last, std::int64_t step, std::int64_t intervals,
                    std::size_t position) {
    const Eigen::Vector3d a = placeOf(first, position), b = placeOf(last, position);
    spend(static_cast<std::uint64_t>(intervals), "*" + keyword_.name, position);
    for (std::int64_t i = 0; i <= intervals; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(intervals);
      const bool isEnd = i == 0 || i == intervals;
      addNode(i == intervals ? last : shifted(first, i * step),
              isEnd ? (i == 0 ? a : b) : Eigen::Vector3d((1 - share) * a + share * b), position);
    }
  }
  void nodeLine(const DeckLine& line) {
    const auto n = wholeNumbers(line, 0, 3, 2);
    if (n[1] <= n[0] || (n[1] - n[0]) % n[2] != 0)
      lines_.failAt(line.position, joinText("*NGEN goes from ", n[0], " to ", n[1], " by ", n[2],
                                            "; the last number must be above the first by a multiple of that"));
    nodesBetween(n[0], n[1], n[2], (n[1] - n[0]) / n[2], line.position);
  }
  /// Lines of nodes between those of two sets, of which equally many come in the order of their numbers.
  void nodeFill(const DeckLine& line) {
    const auto words = DeckLines::fields(line.text);
    std::vector<std::int64_t> known, ends[2];
    for (const auto& entry : part().nodeOfId) known.push_back(entry.first);
    std::sort(known.begin(), known.end());
    for (std::size_t side = 0; side < 2; ++side) {
      const auto set = side < words.size() ? part().nodeSets.find(inUpperCase(words[side])) : part().nodeSets.end();
      if (set == part().nodeSets.end())
        lines_.failAt(line.position, "*NFILL needs two node sets that are defined above");
      if (set->second.unsorted)
        lines_.failAt(line.position, joinText("*NFILL: ", set->second.name,
                                              " is UNSORTED, and its nodes would be taken "
                                              "in the order of their numbers; write the nodes out"));
      forEachMember(set->second, known, [&](std::int64_t id) { ends[side].push_back(id); });
      sortUnique(ends[side]);
    }
    if (ends[0].size() != ends[1].size())
      lines_.failAt(line.position, joinText("*NFILL is between sets of ", ends[0].size(), " and ", ends[1].size(),
                                            " nodes; they must be equally many"));
    const auto n = wholeNumbers(line, 2, 2, 1);
    for (std::size_t i = 0; i < ends[0].size(); ++i) nodesBetween(ends[0][i], ends[1][i], n[1], n[0], line.position);
  }
  /// Rows and layers of elements like one above: how many of each, and what is added to the numbers of nodes and
  /// elements.
  void elementRows(const DeckLine& line) {
    const auto n = wholeNumbers(line, 0, 10, 1);
    const auto master = part().elementOfId.find(n[0]);
    if (master == part().elementOfId.end())
      lines_.failAt(line.position, joinText("*ELGEN: element ", n[0], " is not defined above"));
    const Element first = part().elements[master->second];
    constexpr std::int64_t most = 1'000'000'000;
    if (n[1] > most / n[4] || n[1] * n[4] > most / n[7])
      lines_.failAt(line.position, joinText("*ELGEN makes more than ", most, " elements"));
    spend(static_cast<std::uint64_t>(n[1] * n[4] * n[7]), "*" + keyword_.name, line.position);
    for (std::int64_t layer = 0; layer < n[7]; ++layer)
      for (std::int64_t row = 0; row < n[4]; ++row)
        for (std::int64_t i = 0; i < n[1]; ++i) {
          Element made = first;
          made.id = shifted(made.id, i * n[3] + row * n[6] + layer * n[9]);
          for (std::int64_t& node : made.nodes) node = shifted(node, i * n[2] + row * n[5] + layer * n[8]);
          made.position = line.position;
          const std::int64_t id = made.id;
          if (i + row + layer > 0) {
            if (!part().elementOfId.emplace(id, part().elements.size()).second)
              lines_.failAt(line.position, joinText("element ", id, " is defined a second time"));
            part().elements.push_back(std::move(made));
          }
          if (keyword_.has("ELSET")) setOf(part().elementSets, keyword_.value("ELSET")).add(id);
        }
  }

  void element(const DeckLine& line) {
    std::vector<Element>& elements = part().elements;
    const auto words = DeckLines::fields(line.text);
    std::size_t next = 0;
    if (!unfinished_) {
      unfinished_ = true;
      elements.push_back({type_,
                          formulation_,
                          lines_.number(words[0], "the number of an element", line.position),
                          {},
                          {},
                          line.position});
      next = 1;
    }
    Element& element = elements.back();
    for (; next < words.size(); ++next)
      element.nodes.push_back(lines_.number(words[next], joinText("a node of element ", element.id), line.position));
    const std::size_t wanted = type_->nodes;
    if (element.nodes.size() > wanted)
      lines_.failAt(line.position, joinText("element ", element.id, " (", type_->name(), ") has ", element.nodes.size(),
                                            " nodes; it must have ", wanted));
    if (element.nodes.size() < wanted) return;  // goes on in the next line
    unfinished_ = false;
    if (inAssembly())
      for (const std::int64_t node : element.nodes)
        if (const auto own = ownNodes_.inMesh.find(node);
            own == ownNodes_.inMesh.end() ? order_.size() > 1 : !own->second)
          lines_.failAt(element.position, joinText("element ", element.id, " of the assembly has node ", node,
                                                   ", a number that an instance has; give the nodes of the assembly "
                                                   "numbers that are free"));
    if (!part().elementOfId.emplace(element.id, elements.size() - 1).second)
      lines_.failAt(element.position, joinText("element ", element.id, " is defined a second time"));
    if (inAssembly()) addOwn(element.id, true, "element", element.position);
    if (keyword_.has("ELSET")) setOf(part().elementSets, keyword_.value("ELSET")).add(element.id);
  }
  void finishData() {
    if (unfinished_) {
      const Element& element = part().elements.back();
      lines_.failAt(element.position, joinText("element ", element.id, " (", element.type->name(), ") has ",
                                               element.nodes.size(), " nodes; it must have ", element.type->nodes));
    }
    if (reading_ == Reading::system && !systemNumbers_.empty() && systemNumbers_.size() != ofOrigin &&
        systemNumbers_.size() != ofAxes)
      lines_.failAt(keyword_.position, joinText("*SYSTEM has ", systemNumbers_.size(),
                                                " numbers; it must have 9, those of 3 points, or 3 of the origin"));
  }

  /// What only a deck that was cut short can end with. A cut at a line end between two elements of a flat deck leaves
  /// no trace: the file says nowhere how many there are.
  void requireEnd() const {
    if (!open_.empty())
      lines_.failAt(open_.back().position, joinText("*", open_.back().name, " is never ended by *END ",
                                                    open_.back().name, "; is the file cut short?"));
    const std::string& name = keyword_.name;
    static const std::set<std::string_view> withLines{"NODE", "ELEMENT", "NSET", "ELSET", "NGEN", "NFILL", "ELGEN"};
    if (!withLines.contains(name)) return;
    const bool fromElements = name == "NSET" && keyword_.has("ELSET");  // has no lines of its own
    if (!hasData_ && !fromElements)
      lines_.failAt(keyword_.position, joinText("the file ends after the line of *", name, "; is it cut short?"));
  }

  bool inAssembly() const { return current_ == nullptr && !order_.empty(); }
  Own& ownOf(std::string_view what) { return what == "node" ? ownNodes_ : ownElements_; }
  /// Whether the node or element of the assembly is the one of the mesh that has its number. isFree: no other has it.
  bool addOwn(std::int64_t id, bool isFree, std::string_view what, std::size_t position) {
    Own& own = ownOf(what);
    const auto [known, isNew] = own.inMesh.try_emplace(id, isFree);
    if (isNew && std::ranges::any_of(own.ofInstance, [&](const Range& range) { return range.has(id); }))
      lines_.failAt(position,
                    joinText(what, " ", id, " of the assembly stands below a set that names it; write it above"));
    return known->second;
  }
  /// Numbers in a set of the assembly are those of its own nodes and elements or, where it has none of them, those of
  /// its only instance.
  void addMembers(Set& set, const Range& range, std::string_view what, std::size_t position) {
    if (inAssembly() && keyword_.value("INSTANCE").empty()) {
      Own& own = ownOf(what);
      bool any = false;
      for (auto one = own.inMesh.lower_bound(range.first); one != own.inMesh.end() && one->first <= range.last; ++one) {
        any = any || range.has(one->first);
        if (range.has(one->first) && one->second) set.add(one->first);
      }
      if (any) return;
      if (order_.size() > 1)
        lines_.failAt(position, joinText("set ", set.name, " holds ", what, " ", range.first,
                                         ", which is none of the assembly; INSTANCE= says whose it is"));
      own.ofInstance.push_back(range);
    }
    if (range.first == range.last)
      set.add(range.first);
    else
      set.ranges.push_back(range);
  }

  /// What is added to the numbers and put before the names in a set that INSTANCE= gives to one.
  std::pair<std::int64_t, std::string> instanceOf(const Set& set) const {
    const std::string name = keyword_.value("INSTANCE");
    if (name.empty()) return {0, ""};
    const auto instance = instances_.find(inUpperCase(name));
    if (instance == instances_.end())
      lines_.failAt(keyword_.position, joinText("set ", set.name, " is of the instance ", detail::quoted(name),
                                                ", which is not defined above"));
    return {instance->second.offset, instance->first + "."};
  }

  /// *NSET, ELSET=: the nodes of the elements of a set.
  void nodesOfElements() {
    Set& set = setOf(part().nodeSets, keyword_.value("NSET"));
    const std::string name = keyword_.value("ELSET");
    const auto from = part().elementSets.find(instanceOf(set).second + inUpperCase(name));
    if (from == part().elementSets.end())
      lines_.failAt(keyword_.position, joinText("set ", set.name, " is of the nodes of the element set ",
                                                detail::quoted(name), ", which is not defined above"));
    for (const Range& range : from->second.ranges)
      for (std::int64_t i = 0; i <= (range.last - range.first) / range.step; ++i) {
        const std::int64_t id = range.first + i * range.step;
        const auto element = part().elementOfId.find(id);
        if (element == part().elementOfId.end())
          lines_.failAt(keyword_.position, joinText("set ", set.name, " is of the nodes of element ", id, " of ", name,
                                                    ", which is not defined above, or has no shape"));
        const std::vector<std::int64_t>& nodes = part().elements[element->second].nodes;
        spend(nodes.size(), "set " + set.name, keyword_.position);
        for (const std::int64_t node : nodes) set.add(node);
      }
    set.removeRepeated();
  }

  void members(const DeckLine& line, Sets& sets, std::string_view what) {
    Set& set = setOf(sets, keyword_.value(keyword_.name));
    if (keyword_.name == "NSET" && keyword_.has("ELSET"))
      lines_.failAt(line.position, joinText("set ", set.name, " is of the nodes of ", keyword_.value("ELSET"),
                                            ", and has no lines of its own"));
    const auto [offset, prefix] = instanceOf(set);
    const auto words = DeckLines::fields(line.text);
    if (keyword_.has("GENERATE")) {
      if (words.size() < 2 || words.size() > 3)
        lines_.failAt(line.position,
                      joinText("GENERATE has ", words.size(), " entries; it must have first, last and step"));
      const std::int64_t first = lines_.number(words[0], "the first number", line.position),
                         last = lines_.number(words[1], "the last number", line.position);
      const std::int64_t step = words.size() == 3 ? lines_.number(words[2], "the step", line.position) : 1;
      if (last < first)
        lines_.failAt(line.position, joinText("GENERATE goes from ", first, " to ", last,
                                              "; the last number must not be below the first"));
      return addMembers(set, {shifted(first, offset), shifted(last, offset), step}, what, line.position);
    }
    for (const std::string_view word : words) {
      if (word.empty()) continue;
      if (std::isdigit(static_cast<unsigned char>(word.front()))) {
        const std::int64_t id = shifted(lines_.number(word, joinText("the number of a ", what), line.position), offset);
        if (what == "node" && part().nodeOfId.count(id) == 0) part().awaited.push_back({id, set.name, line.position});
        addMembers(set, {id, id, 1}, what, line.position);
      } else if (const auto id = numberInInstance(word, what, line.position)) {
        set.add(*id);
      } else {
        const auto other = sets.find(prefix + inUpperCase(word));
        if (other == sets.end() || &other->second == &set)
          lines_.failAt(line.position, joinText("set ", set.name, " refers to the set ", detail::quoted(word),
                                                ", which is not defined above"));
        // A set that comes a second time adds nothing.
        const std::vector<Range>& ranges = other->second.ranges;
        spend(ranges.size(), "set " + set.name, set.position);
        set.ranges.insert(set.ranges.end(), ranges.begin(), ranges.end());
        if (set.ranges.size() > 2 * set.distinct + 1000) set.removeRepeated();
      }
    }
  }

  /// The number in the model of "INSTANCE.12"; empty for another word.
  std::optional<std::int64_t> numberInInstance(std::string_view word, std::string_view what, std::size_t position) {
    const std::size_t dot = word.rfind('.');
    if (!inAssembly() || dot == std::string_view::npos || dot + 1 == word.size() ||
        !std::ranges::all_of(word.substr(dot + 1), [](unsigned char c) { return std::isdigit(c) != 0; }))
      return std::nullopt;
    const auto instance = instances_.find(inUpperCase(word.substr(0, dot)));
    if (instance == instances_.end()) return std::nullopt;
    const std::int64_t id = shifted(lines_.number(word.substr(dot + 1), what, position), instance->second.offset);
    if (what == "node" ? !model_.nodeOfId.contains(id) : !model_.elementOfId.contains(id))
      lines_.failAt(position, joinText("the instance has no ", what, " ", detail::quoted(std::string(word))));
    return id;
  }

  void requireNodes(const Part& part) const {
    for (const Awaited& node : part.awaited)
      if (part.nodeOfId.count(node.id) == 0)
        lines_.failAt(node.position, joinText("set ", node.set, " holds node ", node.id, ", which no *NODE defines"));
  }
  /// Axes for the nodes that follow: of their origin, or also of a point on the first one and one in the plane of the
  /// first two.
  static constexpr std::size_t ofOrigin = 3, ofAxes = 9;  // numbers
  void systemLine(const DeckLine& line) {
    for (const std::string_view word : DeckLines::fields(line.text))
      systemNumbers_.push_back(word.empty() ? 0 : lines_.real(word, "a number of *SYSTEM", line.position));
    if (systemNumbers_.size() > ofAxes)
      lines_.failAt(line.position, "*SYSTEM has more than 9 numbers; it must have those of 3 points, or of the origin");
    const auto point = [&](Eigen::Index i) { return Eigen::Map<const Eigen::Vector3d>(&systemNumbers_[3 * i]); };
    axes_ = Eigen::Affine3d::Identity();
    axes_.translation() = point(0);
    if (systemNumbers_.size() < ofAxes) return;
    const Eigen::Vector3d x = point(1) - point(0), z = x.cross(point(2) - point(0));
    if (!(z.norm() > 0)) lines_.failAt(line.position, "*SYSTEM: the three points lie on a line");
    axes_.linear() << x.normalized(), z.cross(x).normalized(), z.normalized();
  }

  /// Counts entries that the file does not spell out one by one, so that a few lines cannot fill the memory.
  void spend(std::uint64_t entries, const std::string& what, std::size_t position) {
    const std::uint64_t most = 10'000'000 + 4 * static_cast<std::uint64_t>(lines_.bytes());
    if (entries > most - spent_)
      lines_.failAt(position,
                    joinText(what, " makes ", entries, " entries, with which this file holds more than ", most,
                             " that it does not spell out, 10 million and 4 for each byte; does a set hold "
                             "others again and again?"));
    spent_ += entries;
  }
  /// Notes the first number of a set that the deck does not have. known: all numbers that exist, sorted.
  void noteAbsent(const Set& set, const std::vector<std::int64_t>& known, std::string_view what) {
    for (const Range& range : set.ranges) {
      auto at = std::ranges::lower_bound(known, range.first);
      for (std::int64_t id = range.first;; id += range.step) {
        at = std::find_if(at, known.end(), [&](std::int64_t one) { return one >= id; });
        if (at == known.end() || *at != id) {
          absent_ += joinText(absent_.empty() ? "" : ", ", set.name, " (", what, " ", id, ")");
          return;
        }
        if (id > range.last - range.step) break;
      }
    }
  }
  /// Calls found(id) for the members of a set that exist. known: all numbers that exist, sorted.
  template <class Found>
  void forEachMember(Set& set, const std::vector<std::int64_t>& known, const Found& found) {
    set.removeRepeated();
    for (const Range& range : set.ranges) {
      const auto begin = std::lower_bound(known.begin(), known.end(), range.first),
                 end = std::upper_bound(begin, known.end(), range.last);
      const auto inside = static_cast<std::uint64_t>(end - begin);
      const std::uint64_t count = static_cast<std::uint64_t>((range.last - range.first) / range.step) + 1;
      spend(std::min(inside, count), "set " + set.name, set.position);
      if (inside <= count) {
        for (auto id = begin; id != end; ++id)
          if ((*id - range.first) % range.step == 0) found(*id);
      } else {
        for (std::uint64_t i = 0; i < count; ++i) {
          const std::int64_t id = range.first + static_cast<std::int64_t>(i) * range.step;
          if (std::binary_search(begin, end, id)) found(id);
        }
      }
    }
  }

  void buildElements() {
    std::vector<Element>& elements = model_.elements;
    std::vector<std::int64_t> known;
    known.reserve(elements.size());
    for (const Element& element : elements) known.push_back(element.id);
    std::sort(known.begin(), known.end());
    std::vector<std::int64_t> all = known;
    all.insert(all.end(), model_.shapeless.begin(), model_.shapeless.end());
    sortUnique(all);
    std::vector<const std::string*> names;
    for (auto& [key, set] : model_.elementSets) {
      noteAbsent(set, all, "element");
      const auto number = static_cast<std::uint32_t>(names.size());
      names.push_back(&set.name);
      forEachMember(set, known, [&](std::int64_t id) {
        auto& own = elements[model_.elementOfId.at(id)].sets;
        if (own.empty() || own.back() != number) own.push_back(number);
      });
    }
    // Where solids of one shape are of several types, each set is also had by them.
    std::map<const FileElement*, const std::string*> firstType;
    const bool byType = std::ranges::any_of(elements, [&](const Element& element) {
      return element.type->dimension == 3 &&
             firstType.try_emplace(element.type, element.formulation).first->second != element.formulation;
    });
    std::map<std::pair<std::vector<std::uint32_t>, const std::string*>, int> groups;
    for (const Element& element : elements) {
      int group = -1;
      if (!element.sets.empty()) {
        const auto [entry, isNew] = groups.try_emplace({element.sets, byType ? element.formulation : nullptr}, 0);
        if (isNew) {
          std::vector<std::string> own;
          for (const std::uint32_t number : element.sets) {
            own.push_back(*names[number]);
            if (byType) own.push_back(joinText(*names[number], setOfType, *element.formulation));
          }
          entry->second = builder_.addGroup(std::move(own));
        }
        group = entry->second;
      }
      builder_.addElement(*element.type, element.id, element.nodes.data(), group, element.position);
    }
  }
  void addNodeSets() {
    std::vector<std::int64_t> known;
    known.reserve(model_.nodes.size());
    for (const Node& node : model_.nodes) known.push_back(node.id);
    std::sort(known.begin(), known.end());
    for (auto& entry : model_.nodeSets) {
      auto& set = entry.second;
      noteAbsent(set, known, "node");
      forEachMember(set, known, [&](std::int64_t id) { builder_.addToNodeSet(set.name, id); });
    }
  }

  void addNotes(Notes& notes) const {
    notes.insert(notes.end(), endless_.begin(), endless_.end());
    if (!absent_.empty())
      notes.push_back(
          joinText(source_, ": sets that name what the deck does not have, each with the first: ", absent_));
    std::string list;
    for (const auto& [name, count] : skipped_)
      list += (list.empty() ? "" : ", ") + name + (count > 1 ? joinText(" (", count, ")") : "");
    if (!list.empty()) notes.push_back(joinText(source_, deckSkippedNote, list));
    if (order_.size() < 2) return;
    list.clear();
    for (const std::string& key : order_) {
      const Instance& instance = instances_.at(key);
      list += joinText(list.empty() ? "" : ", ", instance.name, instance.offset == 0 ? "" : " + ",
                       instance.offset == 0 ? "" : std::to_string(instance.offset));
    }
    notes.push_back(
        joinText(source_, ": ", order_.size(),
                 " instances, their sets are INSTANCE.SET and their numbers those of the file plus: ", list));
  }

  DeckLines lines_;
  std::string source_;
  MeshBuilder builder_;
  DeckKeyword keyword_{};
  Reading reading_ = Reading::nothing;
  const FileElement* type_ = nullptr;
  std::set<std::string> formulations_;
  const std::string* formulation_ = nullptr;     // of type_, in that set
  bool unfinished_ = false, continued_ = false;  // an element goes on in the next line
  bool hasData_ = false;                         // lines of data since the last keyword
  struct Open {
    std::string name;
    std::size_t position;
  };
  std::vector<Open> open_;  // the innermost last
  Own ownNodes_, ownElements_;
  Part model_, placed_;  // placed_: of the instance that is being read
  std::map<std::string, Part> parts_;
  Part* current_ = nullptr;  // what is read now belongs to it; nullptr: to the model
  std::map<std::string, Instance> instances_;
  std::vector<std::string> order_;                      // of the instances
  Eigen::Affine3d axes_ = Eigen::Affine3d::Identity();  // of *SYSTEM
  std::vector<double> systemNumbers_;
  std::vector<std::string> endless_;  // notes
  std::string absent_;                // sets with a number that is not there
  std::uint64_t spent_ = 0;
  std::map<std::string, int> skipped_;
};

}  // namespace

// Abaqus Analysis User's Guide, "Elements: overview"; CalculiX CrunchiX user's manual, "Element types".
Mesh readInp(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  return Deck(path, text).read(notes, problems);
}

std::map<std::string, std::int64_t> instanceOffsets(const std::filesystem::path& path, const std::string& text) {
  Deck deck(path, text);
  (void)deck.read(nullptr, nullptr);
  return deck.offsets();
}

}  // namespace ringwatch::detail
