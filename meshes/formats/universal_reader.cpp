#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <span>
#include <unordered_map>

#include <ringwatch/meshes/formats/deck_lines.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

/// A solid of the file by its FE descriptor. order: node i of VTK is node order[i] of the file; {}: the same.
struct SolidType {
  std::int64_t descriptor;
  int vtkCellType;
  std::span<const std::uint8_t> order = {};
};
// Parabolic elements go round each face, corners and middles in turn, with the upright middles in between.
constexpr std::uint8_t tet10Order[] = {0, 2, 4, 9, 1, 3, 5, 6, 7, 8};
constexpr std::uint8_t wedge15Order[] = {0, 2, 4, 9, 11, 13, 1, 3, 5, 10, 12, 14, 6, 7, 8};
constexpr std::uint8_t hex20Order[] = {0, 2, 4, 6, 12, 14, 16, 18, 1, 3, 5, 7, 13, 15, 17, 19, 8, 9, 10, 11};
constexpr SolidType solidTypes[] = {{101, 13},
                                    {102, 26, wedge15Order},
                                    {104, 12},
                                    {105, 25, hex20Order},  // thick shells
                                    {111, 10},
                                    {112, 13},
                                    {115, 12},
                                    {113, 26, wedge15Order},
                                    {116, 25, hex20Order},
                                    {118, 24, tet10Order}};
/// Descriptors of beams, which have a line more than others, end here; solids are between the other two.
constexpr std::int64_t endOfBeams = 40, beginOfSolids = 100, endOfSolids = 120;
constexpr std::size_t nodesOfLine = 8;  // and numbers of any other line at most

constexpr std::int64_t newNodes = 2411, doubleNodes = 781, singleNodes = 15, newElements = 2412, oldElements = 780,
                       units = 164, newAxes = 2420, oldAxes = 18;
constexpr std::int64_t header = 151, modelHeader = 2400;  // say nothing of the mesh
struct GroupDataset {
  std::int64_t number;
  std::size_t fields;  // of each entity
};
constexpr GroupDataset groupDatasets[] = {{2417, 2}, {2429, 2}, {2430, 2}, {2432, 2},
                                          {2435, 4}, {2452, 4}, {2467, 4}, {2477, 4}};
constexpr std::int64_t nodeEntity = 7, elementEntity = 8;

class UniversalMesh {
 public:
  UniversalMesh(const std::filesystem::path& path, const std::string& text)
      : source_(path.string()),
        cursor_(text, source_),
        builder_(
            source_, [this](std::size_t p) { return cursor_.where(p); },
            [this](std::size_t p) { return cursor_.where(p); }) {
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      std::string_view line(text.data() + at, end - at);
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
      lines_.push_back({line, at});
      at = end + 1;
    }
  }

  Mesh read(Notes* notes, Problems* problems) {
    for (std::size_t at = 0; at + 1 < lines_.size(); ++at) {
      if (!isMark(at)) continue;
      const std::string name = joinText(wordsOf(at + 1).empty() ? "" : wordsOf(at + 1).front());
      end_ = at + 2;
      while (end_ < lines_.size() && !isMark(end_)) ++end_;
      if (end_ == lines_.size())
        fail(at, joinText("this is a universal file (UNV) whose dataset ", name,
                          " has no end, a line of -1; is it cut short?"));
      at_ = at + 2;
      dataset(name);
      at = end_;
    }
    if (numbers_.empty() && builder_.nodeCount() == 0)
      throw InputError(
          joinText(source_, ": there are no nodes, dataset 2411, 781 or 15, and no elements, 2412 or 780"));
    requireOneSystem();
    addElements();
    addNodeGroups();
    Mesh mesh = builder_.finish(notes, problems);
    if (notes != nullptr) addNotes(*notes);
    return mesh;
  }

 private:
  struct Line {
    std::string_view text;
    std::size_t position;
  };
  struct Element {
    std::int64_t id, descriptor, property, material;
    std::vector<std::int64_t> nodes;
    std::size_t position;
    std::vector<std::string> groups;
  };

  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    cursor_.failAt(lines_[line].position, what);
  }
  std::vector<std::string_view> wordsOf(std::size_t line) const {
    std::vector<std::string_view> words;
    const std::string_view text = lines_[line].text;
    constexpr std::string_view blanks = " \t";
    for (std::size_t at = text.find_first_not_of(blanks); at < text.size(); at = text.find_first_not_of(blanks, at)) {
      const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
      words.push_back(text.substr(at, end - at));
      at = end;
    }
    return words;
  }
  /// Numbers of ten letters fill their columns, so that no blank is between them.
  std::vector<std::string_view> integersOf(std::size_t line) const {
    constexpr std::size_t width = 10;
    std::vector<std::string_view> words;
    for (std::string_view word : wordsOf(line)) {
      if (const std::size_t first = word.size() % width; word.size() > width && first > 0) {
        words.push_back(word.substr(0, first));
        word.remove_prefix(first);
      }
      for (; word.size() > width; word.remove_prefix(width)) words.push_back(word.substr(0, width));
      words.push_back(word);
    }
    return words;
  }
  bool isMark(std::size_t line) const {
    const std::string_view text = lines_[line].text;
    const std::size_t first = text.find_first_not_of(" \t");
    return first != std::string_view::npos && text.substr(first) == "-1";
  }
  std::int64_t whole(std::size_t line, std::string_view word, std::string_view what) const {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size())
      fail(line, joinText(what, " is ", detail::quoted(word), "; it must be an integer"));
    return value;
  }
  /// The next line of the dataset, which has so many numbers at least.
  std::vector<std::int64_t> record(std::size_t least, std::string_view what) {
    if (at_ >= end_) fail(end_, joinText("the dataset ends where ", what, " is expected"));
    std::vector<std::int64_t> values;
    for (const std::string_view word : integersOf(at_))
      values.push_back(whole(at_, word, joinText("a number of ", what)));
    if (values.size() < least)
      fail(at_, joinText("the line of ", what, " has ", values.size(), " numbers; it must have ", least));
    ++at_;
    return values;
  }
  /// Numbers in columns of this width from one on; between blanks where the file keeps no columns.
  std::array<double, 3> reals(std::size_t line, std::size_t begin, std::size_t width, std::string_view what) const {
    std::vector<std::string_view> words = wordsOf(line);
    const auto read = [&](std::string_view word) {
      return fortranNumber(word.substr(std::min(word.find_first_not_of(" \t"), word.size())));
    };
    const std::string_view text = lines_[line].text;
    std::array<double, 3> values{};
    const std::size_t before = begin == 0 ? 0 : 4;  // integers
    const bool inWords = words.size() == before + values.size();
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::string_view word =
          inWords ? words[before + k] : text.substr(std::min(begin + k * width, text.size()), width);
      const std::optional<double> value = read(word);
      if (!value) fail(line, joinText(what, " ", "xyz"[k], " is ", detail::quoted(word), "; it must be a number"));
      values[k] = *value;
    }
    return values;
  }

  void dataset(const std::string& name) {
    std::int64_t number = -1;
    std::from_chars(name.data(), name.data() + name.size(), number);
    const auto* const groups = std::ranges::find(groupDatasets, number, &GroupDataset::number);
    if (number == newNodes || number == doubleNodes)
      readNodes(false);
    else if (number == singleNodes)
      readNodes(true);
    else if (number == newElements)
      readElements(2, 3, 6);
    else if (number == oldElements)
      readElements(3, 5, 8);
    else if (number == units)
      readUnits();
    else if (number == newAxes)
      readAxes();
    else if (number == oldAxes)
      readOldAxes();
    else if (groups != std::end(groupDatasets))
      readGroups(groups->fields);
    else if (number != header && number != modelHeader)
      skipped_.insert(name);
  }

  /// inLine: the coordinates stand behind the numbers, else in a line of their own.
  void readNodes(bool inLine) {
    constexpr std::size_t column = 10, single = 13, full = 25;
    while (at_ < end_) {
      const std::size_t first = at_;
      const auto words = integersOf(at_);
      if (words.empty()) {
        ++at_;
        continue;
      }
      if (words.size() < 2) fail(at_, "the line of a node has no coordinate system");
      const std::int64_t id = whole(at_, words[0], "the number of a node"),
                         axes = whole(at_, words[1], "the coordinate system of a node");
      if (!inLine && ++at_ >= end_) fail(first, joinText("node ", id, " has no line of coordinates"));
      const auto X = reals(at_, inLine ? 4 * column : 0, inLine ? single : full, joinText("node ", id, ": coordinate"));
      ++at_;
      builder_.addNode(id, X[0], X[1], X[2], lines_[first].position);
      nodes_.insert(id);
      systems_.try_emplace(axes, std::pair{id, first});
    }
  }

  /// Which numbers of its first line are an element's property and material, and how many it has.
  void readElements(std::size_t property, std::size_t material, std::size_t width) {
    while (at_ < end_) {
      if (wordsOf(at_).empty()) {
        ++at_;
        continue;
      }
      const std::size_t first = at_;
      const std::vector<std::int64_t> head = record(width, "an element");
      const std::int64_t count = head[width - 1];
      // None has more; a count that is damaged would ask for memory that there is not.
      if (count < 0 || static_cast<std::size_t>(count) > nodesOfLine * (end_ - at_))
        fail(first, joinText("element ", head[0], " has ", count, " nodes, more than the lines that follow"));
      Element element{head[0], head[1], head[property], head[material], {}, lines_[first].position, {}};
      const auto nodes = static_cast<std::size_t>(count);
      if (element.descriptor < endOfBeams && hasOrientation(nodes, width)) ++at_;
      while (element.nodes.size() < nodes) {
        const std::vector<std::int64_t> more = record(1, joinText("the nodes of element ", element.id));
        element.nodes.insert(element.nodes.end(), more.begin(), more.end());
      }
      if (element.nodes.size() > nodes)
        fail(at_ - 1,
             joinText("element ", element.id, " has ", element.nodes.size(), " nodes; its first line says ", nodes));
      if (!numbers_.emplace(element.id, elements_.size()).second)
        fail(first, joinText("element ", element.id, " is defined a second time"));
      elements_.push_back(std::move(element));
    }
  }
  /// Whether a line of a beam's section stands before that of its nodes, which are as many as the line has numbers.
  bool hasOrientation(std::size_t nodes, std::size_t width) const {
    const auto has = [&](std::size_t line, std::size_t numbers) {
      return line < end_ && integersOf(line).size() == numbers;
    };
    return !has(at_, nodes) || (has(at_ + 1, nodes) && !has(at_ + 1, width));
  }

  void readUnits() {
    if (at_ + 1 >= end_) return;
    const std::string_view text = lines_[at_].text;
    constexpr std::size_t code = 10, name = 20;
    unitName_ = text.substr(std::min(code, text.size()), name);
    while (!unitName_.empty() && unitName_.back() == ' ') unitName_.pop_back();
    unitName_.erase(0, std::min(unitName_.find_first_not_of(' '), unitName_.size()));
    constexpr std::size_t column = 25;
    perMetre_ = reals(at_ + 1, 0, column, "the unit factor")[0];
  }

  /// Axes of their own are noted; those that are the file's are as good as none.
  void readAxes() {
    at_ += 2;  // number and name of the part
    constexpr std::size_t column = 25, rows = 4;
    while (at_ < end_) {
      const std::vector<std::int64_t> head = record(2, "a coordinate system");
      bool same = head[1] == 0;  // Cartesian
      if (at_ + rows >= end_) fail(at_ - 1, joinText("coordinate system ", head[0], " has no matrix of four lines"));
      for (std::size_t row = 0; row < rows; ++row) {
        const auto values = reals(at_ + 1 + row, 0, column, joinText("coordinate system ", head[0], ": axis"));
        for (std::size_t k = 0; k < values.size(); ++k) same = same && values[k] == (row == k ? 1 : 0);
      }
      at_ += 1 + rows;
      if (!same) others_.insert(head[0]);
    }
  }
  void readOldAxes() {
    constexpr std::size_t more = 3;  // a name and two lines of coordinates
    while (at_ < end_) {
      others_.insert(record(1, "a coordinate system")[0]);
      at_ += more;
    }
  }
  void requireOneSystem() const {
    for (const auto& [axes, node] : systems_)
      if (others_.contains(axes))
        fail(node.second, joinText("node ", node.first, " is in coordinate system ", axes,
                                   ", which is not followed; write nodes in that of the whole"));
  }

  void readGroups(std::size_t fields) {
    while (at_ < end_) {
      if (wordsOf(at_).empty()) {
        ++at_;
        continue;
      }
      const std::size_t first = at_;
      const std::vector<std::int64_t> head = record(7, "a group");  // older ones know no contact sets
      const std::int64_t count = head[std::min(head.size(), nodesOfLine) - 1];
      if (count < 0 || static_cast<std::size_t>(count) > nodesOfLine / fields * (end_ - at_))
        fail(first, joinText("group ", head[0], " has ", count, " members, more than the lines that follow"));
      if (at_ >= end_) fail(first, joinText("group ", head[0], " has no line of its name"));
      std::string_view name = lines_[at_++].text;
      name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
      Group& group =
          groups_.emplace_back(Group{name.empty() ? joinText("group-", head[0]) : std::string(name), {}, {}, first});
      for (std::size_t left = static_cast<std::size_t>(count); left > 0;) {
        const std::vector<std::int64_t> numbers = record(fields, joinText("group ", detail::quoted(group.name)));
        for (std::size_t i = 0; i + fields <= numbers.size() && left > 0; i += fields, --left) {
          if (numbers[i] == nodeEntity)
            group.nodes.push_back(numbers[i + 1]);
          else if (numbers[i] == elementEntity)
            group.elements.push_back(numbers[i + 1]);
          else
            ++otherMembers_;
        }
      }
    }
  }

  /// Names of the groups of an element, with its material and property where the solids have several.
  void addElements() {
    for (const Group& group : groups_)
      for (const std::int64_t id : group.elements) {
        const auto found = numbers_.find(id);
        if (found == numbers_.end())
          fail(group.line,
               joinText("group ", detail::quoted(group.name), " holds element ", id, ", which the file does not have"));
        elements_[found->second].groups.push_back(group.name);
      }
    const auto several = [&](std::int64_t Element::*number) {
      std::set<std::int64_t> values;
      for (const Element& element : elements_)
        if (isSolid(element)) values.insert(element.*number);
      return values.size() > 1;
    };
    const bool materials = several(&Element::material), properties = several(&Element::property);
    std::map<std::vector<std::string>, int> known;
    for (Element& element : elements_) {
      if (!isSolid(element)) {
        ++builder_.leftOut;
        for (const std::string& name : element.groups)
          for (const std::int64_t node : element.nodes)
            if (nodes_.contains(node)) builder_.addToNodeSet(name, node);
        continue;
      }
      const auto* const type = std::ranges::find(solidTypes, element.descriptor, &SolidType::descriptor);
      if (type == std::end(solidTypes))
        cursor_.failAt(element.position, joinText("element ", element.id, " is of type ", element.descriptor,
                                                  "; solids of types 111, 112, 113, 115, 116 and 118 are read"));
      const FileElement& read = *findVtkElement(type->vtkCellType);
      if (element.nodes.size() != static_cast<std::size_t>(read.nodes))
        cursor_.failAt(element.position, joinText("element ", element.id, " (", read.name(), ") has ",
                                                  element.nodes.size(), " nodes; it must have ", read.nodes));
      if (materials) element.groups.push_back(joinText("material-", element.material));
      if (properties) element.groups.push_back(joinText("property-", element.property));
      int group = -1;
      if (!element.groups.empty()) {
        const auto [own, isNew] = known.try_emplace(element.groups, 0);
        if (isNew) own->second = builder_.addGroup(element.groups);
        group = own->second;
      }
      std::vector<std::int64_t> nodes = element.nodes;
      for (std::size_t i = 0; i < type->order.size(); ++i) nodes[i] = element.nodes[type->order[i]];
      builder_.addElement(read, element.id, nodes.data(), group, element.position);
    }
  }
  void addNodeGroups() {
    for (const Group& group : groups_)
      for (const std::int64_t node : group.nodes) {
        if (!nodes_.contains(node))
          fail(group.line,
               joinText("group ", detail::quoted(group.name), " holds node ", node, ", which the file does not have"));
        builder_.addToNodeSet(group.name, node);
      }
  }
  static bool isSolid(const Element& element) {
    return element.descriptor > beginOfSolids && element.descriptor < endOfSolids;
  }

  void addNotes(Notes& notes) const {
    if (perMetre_ != 1)
      notes.push_back(
          joinText(source_, ": a metre has ", perMetre_, " of its units of length (", unitName_,
                   "); its coordinates are taken as they stand, so give every number in units that belong together"));
    if (otherMembers_ > 0)
      notes.push_back(joinText(source_, ": ", otherMembers_,
                               " members of groups that are neither nodes nor elements are left out"));
    std::string list;
    for (const std::string& name : skipped_) list += (list.empty() ? "" : ", ") + name;
    if (!list.empty())
      notes.push_back(joinText(source_, ": skipped, only nodes, elements and their groups are read: dataset ", list));
  }

  struct Group {
    std::string name;
    std::vector<std::int64_t> nodes, elements;
    std::size_t line;
  };
  std::string source_;
  FileCursor cursor_;
  MeshBuilder builder_;
  std::vector<Line> lines_;
  std::size_t at_ = 0, end_ = 0;  // the next line of the dataset, and its last one, the mark
  std::vector<Element> elements_;
  std::unordered_map<std::int64_t, std::size_t> numbers_;                 // of elements, to their places
  std::set<std::int64_t> nodes_;                                          // numbers
  std::map<std::int64_t, std::pair<std::int64_t, std::size_t>> systems_;  // the first node of each, and its line
  std::set<std::int64_t> others_;                                         // systems that are not the file's
  std::vector<Group> groups_;
  std::set<std::string> skipped_;
  std::size_t otherMembers_ = 0;
  double perMetre_ = 1;
  std::string unitName_;
};

}  // namespace

bool startsWithUniversal(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (!text.starts_with("-1")) return false;
  text.remove_prefix(2);
  const std::size_t next = text.find_first_not_of(" \t\r\n");
  return next < text.size() && text.substr(0, next).find('\n') != std::string_view::npos && text[next] >= '0' &&
         text[next] <= '9';
}

// I-DEAS, "Universal File Datasets".
Mesh readUniversal(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  return UniversalMesh(path, text).read(notes, problems);
}

}  // namespace ringwatch::detail
