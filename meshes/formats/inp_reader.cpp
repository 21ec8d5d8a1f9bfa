#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <compare>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The type of a deck's element by the number of its VTK cell; nullptr for types without a mesh cell (springs, masses,
/// …). Where the decks' node order is not VTK's it would be said here; for all of these the two agree.
const FileElement* elementOfDeck(const std::string& type) {
  const auto startsWith = [&](std::string_view prefix) { return type.rfind(prefix, 0) == 0; };
  std::size_t digits = type.size();
  const auto count = [&](std::size_t from) {
    digits = from;
    int n = 0;
    while (digits < type.size() && std::isdigit(static_cast<unsigned char>(type[digits])) && n < 1000)
      n = 10 * n + (type[digits++] - '0');
    return n;
  };
  if (startsWith("C3D") || startsWith("F3D") || startsWith("DC3D")) {
    // Letters after the number (R reduced, I incompatible modes, H hybrid, M modified, T thermal) keep the nodes.
    switch (count(type.find("3D") + 2)) {
      case 4:
        return findVtkElement(10);
      case 5:
        return findVtkElement(14);
      case 6:
        return findVtkElement(13);
      case 8:
        return findVtkElement(12);
      case 10:
        return findVtkElement(24);
      case 15:
        return findVtkElement(26);
      case 20:
        return findVtkElement(25);
      case 27:
        return findVtkElement(29);
      default:
        return nullptr;
    }
  }
  for (const std::string_view flat : {"CPS", "CPE", "CAX", "M3D", "SFM3D", "S"})
    if (startsWith(flat)) switch (count(flat.size())) {
        case 3:
          return findVtkElement(5);
        case 4:
          return findVtkElement(9);
        case 6:
          return findVtkElement(22);
        case 8:
          return findVtkElement(23);
        default:
          return nullptr;
      }
  if (type == "T3D2" || type == "B31" || type == "B31R" || type == "B21") return findVtkElement(3);
  if (type == "T3D3" || type == "B32" || type == "B32R") return findVtkElement(21);
  return nullptr;
}

/// A keyword line and its parameters.
struct Keyword {
  std::string name;  // upper case, without the star
  std::map<std::string, std::string> parameters;
  std::size_t position;
  bool has(const std::string& key) const { return parameters.count(key) != 0; }
  std::string value(const std::string& key) const {
    const auto found = parameters.find(key);
    return found == parameters.end() ? std::string() : found->second;
  }
};

class Deck {
 public:
  Deck(const std::filesystem::path& path, const std::string& text)
      : text_(text),
        cursor_(text, path.string()),
        source_(path.string()),
        builder_(
            source_, [this](std::size_t p) { return cursor_.where(p); },
            [this](std::size_t p) { return cursor_.where(p); }) {}

  Mesh read(Notes* notes, Problems* problems) {
    while (const std::optional<Line> line = nextLine()) {
      if (line->text.front() == '*')
        begin(*line);
      else
        data(*line);
    }
    finishData();
    requireEnd();
    buildElements();
    addNodeSets();
    Mesh mesh = builder_.finish(notes, problems);
    if (notes != nullptr && !skipped_.empty()) {
      std::string list;
      for (const auto& [name, count] : skipped_)
        list += (list.empty() ? "" : ", ") + name + (count > 1 ? joinText(" (", count, ")") : "");
      notes->push_back(source_ + ": skipped, only nodes, elements and their sets are read: " + list);
    }
    return mesh;
  }

 private:
  struct Line {
    std::string_view text;  // trimmed, not empty
    std::size_t position;
  };
  struct Element {
    const FileElement* type;
    std::int64_t id;
    std::vector<std::int64_t> nodes;
    std::vector<std::uint32_t> sets;  // numbers of the element sets, in the order of their map
    std::size_t position;
  };
  /// first, first + step, … up to last.
  struct Range {
    std::int64_t first, last, step;
    auto operator<=>(const Range&) const = default;
  };
  struct Set {
    std::string name;  // as first written
    std::vector<Range> ranges;
    std::size_t position;
    std::size_t distinct = 0;  // ranges that were left when repeated ones were last removed

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
  enum class Reading { nothing, nodes, elements, nodeSet, elementSet, mustBeEmpty };

  std::optional<Line> nextLine() {
    while (at_ < text_.size()) {
      const std::size_t begin = at_, end = std::min(text_.find('\n', begin), text_.size());
      at_ = end + 1;
      const std::string_view line = trimmed(std::string_view(text_).substr(begin, end - begin));
      if (line.empty() || line.rfind("**", 0) == 0) continue;
      return Line{line, begin};
    }
    return std::nullopt;
  }
  static std::vector<std::string_view> fields(std::string_view line) {
    std::vector<std::string_view> result;
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      result.push_back(trimmed(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    if (result.size() > 1 && result.back().empty()) result.pop_back();  // the line ends with a comma
    return result;
  }
  std::int64_t number(std::string_view word, std::string_view what, std::size_t position) const {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size() || value < 1)
      cursor_.failAt(position, joinText(what, " is ", quoted(word), "; it must be a whole number of 1 or more"));
    return value;
  }
  double real(std::string_view word, std::string_view what, std::size_t position) const {
    std::string copy(word);
    if (!copy.empty() && copy.front() == '+') copy.erase(0, 1);
    for (char& c : copy)
      if (c == 'd' || c == 'D') c = 'e';  // Fortran's double precision
    double value = 0;
    const auto [stop, error] = std::from_chars(copy.data(), copy.data() + copy.size(), value);
    if (error != std::errc() || stop != copy.data() + copy.size())
      cursor_.failAt(position, joinText(what, " is ", quoted(word), "; it must be a number"));
    return value;
  }

  void begin(const Line& first) {
    finishData();
    std::string whole(first.text);
    while (!whole.empty() && whole.back() == ',') {
      const std::optional<Line> more = nextLine();
      if (!more || more->text.front() == '*')
        cursor_.failAt(first.position, "the keyword line ends with a comma, but no line continues it");
      whole += std::string(more->text);
    }
    keyword_ = {};
    keyword_.position = first.position;
    bool isName = true;
    for (const std::string_view field : fields(whole)) {
      if (isName) {
        keyword_.name = inUpperCase(field.substr(1));
        keyword_.name = std::string(trimmed(keyword_.name));
      } else {
        const std::size_t equals = field.find('=');
        std::string_view value =
            equals == std::string_view::npos ? std::string_view() : trimmed(field.substr(equals + 1));
        if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
        keyword_.parameters[inUpperCase(trimmed(field.substr(0, equals)))] = std::string(value);
      }
      isName = false;
    }
    const std::string& name = keyword_.name;
    const auto refuse = [&](const std::string& why) { cursor_.failAt(first.position, "*" + name + " " + why); };
    reading_ = Reading::nothing;
    hasData_ = false;
    keepOpen();
    if (name == "NODE" || name == "ELEMENT" || name == "NSET" || name == "ELSET")
      if (keyword_.has("INPUT")) refuse("with INPUT= takes its lines from another file; put them into this one");
    if (name == "NODE") {
      if (keyword_.has("SYSTEM") && inUpperCase(keyword_.value("SYSTEM")) != "R")
        refuse("with SYSTEM= other than R is not supported; write Cartesian coordinates");
      reading_ = Reading::nodes;
    } else if (name == "ELEMENT") {
      if (keyword_.value("TYPE").empty()) refuse("needs TYPE=, for instance TYPE=C3D8");
      type_ = elementOfDeck(inUpperCase(keyword_.value("TYPE")));
      if (type_ == nullptr)
        ++skipped_["*ELEMENT, TYPE=" + inUpperCase(keyword_.value("TYPE"))];
      else
        reading_ = Reading::elements;
    } else if (name == "NSET" || name == "ELSET") {
      if (keyword_.value(name).empty()) refuse("needs the name of the set, " + name + "=");
      reading_ = name == "NSET" ? Reading::nodeSet : Reading::elementSet;
      setOf(name == "NSET" ? nodeSets_ : elementSets_, keyword_.value(name));
    } else if (name == "INCLUDE") {
      refuse("is not followed; put the lines of that file into this one");
    } else if (name == "SYSTEM" || name == "NGEN" || name == "NFILL" || name == "NCOPY" || name == "ELGEN" ||
               name == "ELCOPY" || name == "NMAP") {
      refuse("makes or moves nodes or elements and is not supported; write them out with *NODE and *ELEMENT");
    } else if (name == "INSTANCE") {
      if (++instances_ > 1) refuse("a second time: only decks with one instance are supported; write a flat deck");
      reading_ = Reading::mustBeEmpty;
    } else if (name != "HEADING") {
      ++skipped_["*" + name];
    }
  }

  /// Blocks that a line of their own ends.
  void keepOpen() {
    std::string name = keyword_.name;
    std::erase(name, ' ');  // *ENDSTEP is *END STEP
    for (const std::string_view block : {"PART", "ASSEMBLY", "INSTANCE", "STEP"}) {
      if (name == block) {
        open_.push_back({name, keyword_.position});
      } else if (name == joinText("END", block)) {
        while (!open_.empty() && open_.back().name != block) open_.pop_back();
        if (!open_.empty()) open_.pop_back();
      }
    }
  }

  Set& setOf(std::map<std::string, Set>& sets, const std::string& name) {
    return sets.try_emplace(inUpperCase(name), Set{name, {}, keyword_.position}).first->second;
  }

  void data(const Line& line) {
    hasData_ = true;
    switch (reading_) {
      case Reading::nothing:
        if (keyword_.name.empty())
          cursor_.failAt(line.position,
                         "a line of data before the first keyword; an .inp deck begins with *HEADING or *NODE");
        return;
      case Reading::mustBeEmpty:
        cursor_.failAt(line.position, "the instance is moved or turned, which is not supported; write a flat deck");
      case Reading::nodes:
        return node(line);
      case Reading::elements:
        return element(line);
      case Reading::nodeSet:
        return members(line, nodeSets_, "node");
      case Reading::elementSet:
        return members(line, elementSets_, "element");
    }
  }

  void node(const Line& line) {
    const auto words = fields(line.text);
    if (words.size() < 2 || words.size() > 7)
      cursor_.failAt(line.position,
                     joinText("a node has ", words.size(), " entries; it must have a number and x, y, z"));
    const std::int64_t id = number(words[0], "the number of a node", line.position);
    double X[3] = {0, 0, 0};  // coordinates left out are zero
    for (std::size_t k = 0; k < 3 && k + 1 < words.size(); ++k)
      if (!words[k + 1].empty())
        X[k] = real(words[k + 1], joinText("coordinate ", "xyz"[k], " of node ", id), line.position);
    builder_.addNode(id, X[0], X[1], X[2], line.position);
    nodeIds_.insert(id);
    if (keyword_.has("NSET")) setOf(nodeSets_, keyword_.value("NSET")).add(id);
  }

  void element(const Line& line) {
    const auto words = fields(line.text);
    std::size_t next = 0;
    if (!unfinished_) {
      unfinished_ = true;
      elements_.push_back({type_, number(words[0], "the number of an element", line.position), {}, {}, line.position});
      next = 1;
    }
    Element& element = elements_.back();
    for (; next < words.size(); ++next)
      element.nodes.push_back(number(words[next], joinText("a node of element ", element.id), line.position));
    const std::size_t wanted = type_->nodes;
    if (element.nodes.size() > wanted)
      cursor_.failAt(line.position, joinText("element ", element.id, " (", type_->name(), ") has ",
                                             element.nodes.size(), " nodes; it must have ", wanted));
    if (element.nodes.size() < wanted) return;  // goes on in the next line
    unfinished_ = false;
    if (!elementOfId_.emplace(element.id, elements_.size() - 1).second)
      cursor_.failAt(element.position, joinText("element ", element.id, " is defined a second time"));
    if (keyword_.has("ELSET")) setOf(elementSets_, keyword_.value("ELSET")).add(element.id);
  }
  void finishData() {
    if (unfinished_) {
      const Element& element = elements_.back();
      cursor_.failAt(element.position, joinText("element ", element.id, " (", element.type->name(), ") has ",
                                                element.nodes.size(), " nodes; it must have ", element.type->nodes));
    }
  }

  /// What only a deck that was cut short can end with. A cut at a line end between two elements of a flat deck leaves
  /// no trace: the file says nowhere how many there are.
  void requireEnd() const {
    if (!open_.empty())
      cursor_.failAt(open_.back().position, joinText("*", open_.back().name, " is never ended by *END ",
                                                     open_.back().name, "; is the file cut short?"));
    const std::string& name = keyword_.name;
    if (name != "NODE" && name != "ELEMENT" && name != "NSET" && name != "ELSET") return;
    const bool fromElements = name == "NSET" && keyword_.has("ELSET");  // has no lines of its own
    if (!hasData_ && !fromElements)
      cursor_.failAt(keyword_.position, joinText("the file ends after the line of *", name, "; is it cut short?"));
    if (text_.back() != '\n')
      cursor_.failAt(text_.size(), joinText("the last line, of *", name, ", has no line end; is the file cut short?"));
  }

  void members(const Line& line, std::map<std::string, Set>& sets, std::string_view what) {
    Set& set = setOf(sets, keyword_.value(keyword_.name));
    const auto words = fields(line.text);
    if (keyword_.has("GENERATE")) {
      if (words.size() < 2 || words.size() > 3)
        cursor_.failAt(line.position,
                       joinText("GENERATE has ", words.size(), " entries; it must have first, last and step"));
      const std::int64_t first = number(words[0], "the first number", line.position),
                         last = number(words[1], "the last number", line.position);
      const std::int64_t step = words.size() == 3 ? number(words[2], "the step", line.position) : 1;
      if (last < first)
        cursor_.failAt(line.position, joinText("GENERATE goes from ", first, " to ", last,
                                               "; the last number must not be below the first"));
      set.ranges.push_back({first, last, step});
      return;
    }
    for (const std::string_view word : words) {
      if (word.empty()) continue;
      if (std::isdigit(static_cast<unsigned char>(word.front()))) {
        const std::int64_t id = number(word, joinText("the number of a ", what), line.position);
        const bool known = what == "node" ? nodeIds_.count(id) != 0 : elementOfId_.count(id) != 0;
        if (!known && what == "node")
          cursor_.failAt(line.position,
                         joinText("set ", set.name, " holds node ", id, ", which no *NODE above defines"));
        set.add(id);
      } else {
        const auto other = sets.find(inUpperCase(word));
        if (other == sets.end() || &other->second == &set)
          cursor_.failAt(line.position, joinText("set ", set.name, " refers to the set ", quoted(word),
                                                 ", which is not defined above"));
        // A set that comes a second time adds nothing.
        const std::vector<Range>& ranges = other->second.ranges;
        spend(ranges.size(), set);
        set.ranges.insert(set.ranges.end(), ranges.begin(), ranges.end());
        if (set.ranges.size() > 2 * set.distinct + 1000) set.removeRepeated();
      }
    }
  }

  /// Counts entries of sets that the file does not spell out one by one, so that a few lines cannot fill the memory.
  void spend(std::uint64_t entries, const Set& set) {
    const std::uint64_t most = 10'000'000 + 4 * static_cast<std::uint64_t>(text_.size());
    if (entries > most - spent_)
      cursor_.failAt(set.position, joinText("set ", set.name, ": the sets of this file hold more than ", most,
                                            " members in all, 10 million and 4 for each byte of the file; does a set "
                                            "hold others again and again?"));
    spent_ += entries;
  }
  /// Calls found(id) for the members of a set that exist; numbers of skipped elements and gaps of GENERATE stand for
  /// nothing. known: all numbers that exist, sorted.
  template <class Found>
  void forEachMember(Set& set, const std::vector<std::int64_t>& known, const Found& found) {
    set.removeRepeated();
    for (const Range& range : set.ranges) {
      const auto begin = std::lower_bound(known.begin(), known.end(), range.first),
                 end = std::upper_bound(begin, known.end(), range.last);
      const auto inside = static_cast<std::uint64_t>(end - begin);
      const std::uint64_t count = static_cast<std::uint64_t>((range.last - range.first) / range.step) + 1;
      spend(std::min(inside, count), set);
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
    std::vector<std::int64_t> known;
    known.reserve(elements_.size());
    for (const Element& element : elements_) known.push_back(element.id);
    std::sort(known.begin(), known.end());
    std::vector<const std::string*> names;
    for (auto& [key, set] : elementSets_) {
      const auto number = static_cast<std::uint32_t>(names.size());
      names.push_back(&set.name);
      forEachMember(set, known, [&](std::int64_t id) {
        auto& own = elements_[elementOfId_.at(id)].sets;
        if (own.empty() || own.back() != number) own.push_back(number);
      });
    }
    std::map<std::vector<std::uint32_t>, int> groups;
    for (const Element& element : elements_) {
      int group = -1;
      if (!element.sets.empty()) {
        const auto [entry, isNew] = groups.try_emplace(element.sets, 0);
        if (isNew) {
          std::vector<std::string> own;
          for (const std::uint32_t number : element.sets) own.push_back(*names[number]);
          entry->second = builder_.addGroup(std::move(own));
        }
        group = entry->second;
      }
      builder_.addElement(*element.type, element.id, element.nodes.data(), group, element.position, false);
    }
  }
  void addNodeSets() {
    const std::vector<std::int64_t> known = [&] {
      std::vector<std::int64_t> ids(nodeIds_.begin(), nodeIds_.end());
      std::sort(ids.begin(), ids.end());
      return ids;
    }();
    for (auto& entry : nodeSets_) {
      auto& set = entry.second;
      forEachMember(set, known, [&](std::int64_t id) { builder_.addToNodeSet(set.name, id); });
    }
  }

  const std::string& text_;
  FileCursor cursor_;
  std::string source_;
  MeshBuilder builder_;
  std::size_t at_ = 0;
  Keyword keyword_{};
  Reading reading_ = Reading::nothing;
  const FileElement* type_ = nullptr;
  bool unfinished_ = false;
  int instances_ = 0;
  bool hasData_ = false;  // lines of data since the last keyword
  struct Open {
    std::string name;
    std::size_t position;
  };
  std::vector<Open> open_;  // the innermost last
  std::vector<Element> elements_;
  std::unordered_map<std::int64_t, std::size_t> elementOfId_;
  std::unordered_set<std::int64_t> nodeIds_;
  std::map<std::string, Set> nodeSets_, elementSets_;
  std::uint64_t spent_ = 0;
  std::map<std::string, int> skipped_;
};

}  // namespace

// Abaqus Analysis User's Guide, "Elements: overview"; CalculiX CrunchiX user's manual, "Element types".
Mesh readInp(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  return Deck(path, text).read(notes, problems);
}

}  // namespace ringwatch::detail
