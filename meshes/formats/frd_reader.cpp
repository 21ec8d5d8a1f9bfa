#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include <ringwatch/base/number_format.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

/// CalculiX GraphiX user's manual, "Results format (.frd)": records of fixed columns; the first six characters of a
/// line are its key.
class FrdText {
 public:
  FrdText(const std::filesystem::path& path, const std::string& text) : text_(text), cursor_(text, path.string()) {}

  struct Line {
    std::string_view text;
    std::size_t position;
    /// Columns [first, first + width), without blanks around; "" behind the end.
    std::string_view field(std::size_t first, std::size_t width) const {
      std::string_view part = first < text.size() ? text.substr(first, width) : std::string_view();
      while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
      while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
      return part;
    }
  };
  std::optional<Line> next() {
    if (at_ >= text_.size()) return std::nullopt;
    const std::size_t begin = at_, end = std::min(text_.find('\n', begin), text_.size());
    at_ = end + 1;
    std::string_view line(text_.data() + begin, end - begin);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    return Line{line, begin};
  }
  void seek(std::size_t position) { at_ = position; }
  std::string where(std::size_t position) const { return cursor_.where(position); }
  [[noreturn]] void failAt(std::size_t position, const std::string& what) const { cursor_.failAt(position, what); }

  std::int64_t integer(std::string_view word, std::string_view what, std::size_t position) const {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size() || word.empty())
      failAt(position, joinText(what, " is ", detail::quoted(word), "; it must be an integer"));
    return value;
  }
  /// The numbers from a column on, as %12.5E writes them, at most so many. what(i): the name of the ith. An exponent of
  /// three digits, which C on Windows always writes, makes some wider than 12 columns, so the text tells where each
  /// ends; none is narrower. Words such as -NAN and INF are numbers, and 1.00000-100 is one without its E.
  template <class What>
  std::vector<double> reals(const Line& line, std::size_t first, std::size_t most, const What& what) const {
    const std::string_view text = line.text;
    const auto isDigit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    const auto isOneOf = [&](std::size_t i, std::string_view set) {
      return i < text.size() && set.find(text[i]) != std::string_view::npos;
    };
    std::vector<double> values;
    for (std::size_t at = first; at < text.size() && values.size() < most;) {
      const std::size_t field = at;
      while (isOneOf(at, " ")) ++at;  // none ends the line
      const std::size_t begin = at;
      std::string number;
      if (isOneOf(at, "+-")) number += text[at++];
      if (isDigit(at)) {
        while (isDigit(at)) number += text[at++];
        if (isOneOf(at, ".")) number += text[at++];
        while (isDigit(at)) number += text[at++];
        const bool letter = isOneOf(at, "EeDd");
        // A sign alone begins an exponent where no point follows its first digit: else it is the next number's.
        if (letter || (isOneOf(at, "+-") && isDigit(at + 1) && !isOneOf(at + 2, "."))) {
          if (letter) ++at;
          number += 'e';
          if (isOneOf(at, "+-")) number += text[at++];
          for (int digits = 0; digits < 3 && isDigit(at) && !isOneOf(at + 1, "."); ++digits) number += text[at++];
        }
      } else {
        while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at]))) number += text[at++];
      }
      const std::optional<double> value = readNumber(number);
      if (!value || at < field + 12 || (at < text.size() && !isOneOf(at, " +-0123456789")))
        failAt(line.position,
               joinText(what(values.size()), " is ", detail::quoted(text.substr(begin, text.find(' ', begin) - begin)),
                        "; it must be a number"));
      values.push_back(*value);
    }
    return values;
  }
  /// The three numbers of a node's line, or the first three of more. name: what each of them is, without its axis.
  Eigen::Vector3d vector(const Line& line, std::size_t first, std::size_t most, std::string_view name) const {
    const std::vector<double> values =
        reals(line, first, most, [&](std::size_t i) { return joinText(name, " ", i < 3 ? "xyz"[i] : '?'); });
    if (values.size() < 3 || values.size() > most - 1)
      failAt(line.position, joinText("the line has ", values.size(), " numbers behind its node; it must have 3"));
    return Eigen::Vector3d::Map(values.data());
  }
  /// Characters of a number of a node or an element, by the format that ends a block's first line: 0 short, 1 long.
  int idWidth(const Line& line) const {
    const std::string_view format = line.text.substr(line.text.find_last_of(' ') + 1);
    if (format == "0") return 5;
    if (format == "1") return 10;
    failAt(line.position, joinText("the block has the format ", detail::quoted(format),
                                   "; 0 and 1, text, are read: let CalculiX write with *NODE FILE, not *NODE OUTPUT"));
  }

 private:
  const std::string& text_;
  FileCursor cursor_;
  std::size_t at_ = 0;
};

/// The element types of the file, 1 to 12, by their VTK cells.
const FileElement* elementOfFrd(std::int64_t type) {
  constexpr int cells[] = {12, 13, 10, 25, 26, 24, 5, 22, 9, 23, 3, 21};
  return type < 1 || type > 12 ? nullptr : findVtkElement(cells[type - 1]);
}

constexpr std::string_view nodeBlock = "    2C", elementBlock = "    3C", resultBlock = "  100C",
                           stepLine = "    1PSTEP";

class FrdMeshReader {
 public:
  FrdMeshReader(const std::filesystem::path& path, const std::string& text)
      : source_(path.string()),
        text_(path, text),
        builder_(
            source_, [this](std::size_t p) { return text_.where(p); },
            [this](std::size_t p) { return text_.where(p); }) {}

  Mesh read(Notes* notes, Problems* problems) {
    bool nodes = false, elements = false;
    while (const auto line = text_.next()) {
      if (line->text.starts_with(nodeBlock) && !nodes) {
        nodes = true;
        readNodes(text_.idWidth(*line));
      } else if (line->text.starts_with(elementBlock) && !elements) {
        elements = true;
        readElements(text_.idWidth(*line));
      }
      if (nodes && elements) break;
    }
    if (!nodes || !elements)
      throw InputError(
          joinText(source_, ": the file ends without its ", nodes ? "elements" : "nodes", "; is it cut short?"));
    return builder_.finish(notes, problems);
  }

 private:
  void readNodes(int width) {
    while (const auto line = text_.next()) {
      if (line->text.starts_with(" -3")) return;
      if (!line->text.starts_with(" -1"))
        text_.failAt(line->position, "a line of the nodes begins with neither -1 nor -3");
      const Eigen::Vector3d X = text_.vector(*line, 3 + static_cast<std::size_t>(width), 4, "coordinate");
      builder_.addNode(text_.integer(line->field(3, width), "the number of a node", line->position), X[0], X[1], X[2],
                       line->position);
    }
    throw InputError(source_ + ": the file ends within its nodes; is it cut short?");
  }
  void readElements(int width) {
    const FileElement* type = nullptr;
    std::int64_t id = 0;
    std::size_t position = 0;
    std::vector<std::int64_t> nodes;
    const auto finish = [&] {
      if (type == nullptr) return;
      if (nodes.size() != static_cast<std::size_t>(type->nodes))
        text_.failAt(position, joinText("element ", id, " (", type->name(), ") has ", nodes.size(),
                                        " nodes; it must have ", type->nodes));
      // The middles of the edges along the height of a hex20 and a wedge15 stand before those of its top, which VTK has
      // before them.
      if (type->vtkCellType == 25) std::rotate(nodes.begin() + 12, nodes.begin() + 16, nodes.end());
      if (type->vtkCellType == 26) std::rotate(nodes.begin() + 9, nodes.begin() + 12, nodes.end());
      builder_.addElement(*type, id, nodes.data(), -1, position);
      nodes.clear();
      type = nullptr;
    };
    while (const auto line = text_.next()) {
      if (line->text.starts_with(" -3")) return finish();
      if (line->text.starts_with(" -1")) {
        finish();
        id = text_.integer(line->field(3, width), "the number of an element", line->position);
        const std::int64_t number = text_.integer(line->field(3 + width, 5), "the type of an element", line->position);
        type = elementOfFrd(number);
        position = line->position;
        if (type == nullptr)
          text_.failAt(position, joinText("element ", id, " is of type ", number, "; types are 1 to 12"));
      } else if (line->text.starts_with(" -2") && type != nullptr) {
        for (std::size_t at = 3; at < line->text.size(); at += static_cast<std::size_t>(width))
          nodes.push_back(text_.integer(line->field(at, width), joinText("a node of element ", id), line->position));
      } else {
        text_.failAt(line->position, "a line of the elements begins with neither -1, -2 nor -3");
      }
    }
    throw InputError(source_ + ": the file ends within its elements; is it cut short?");
  }

  std::string source_;
  FrdText text_;
  MeshBuilder builder_;
};

}  // namespace

Mesh readFrd(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  return FrdMeshReader(path, text).read(notes, problems);
}

std::vector<FrdState> frdStates(const std::filesystem::path& path, const std::string& text, const std::string& field) {
  FrdText lines(path, text);
  std::vector<FrdState> states;
  FrdState state{};
  while (const auto line = lines.next()) {
    if (line->text.starts_with(stepLine)) {
      state.increment = lines.integer(line->field(36, 12), "the increment", line->position);
      state.step = lines.integer(line->field(48, 12), "the step", line->position);
    } else if (line->text.starts_with(resultBlock)) {
      const std::vector<double> numbers = lines.reals(*line, 12, 1, [](std::size_t) { return "the time"; });
      if (numbers.empty()) lines.failAt(line->position, "the line of the results has no time");
      state.time = numbers.front();
      state.idWidth = lines.idWidth(*line);
    } else if (line->text.starts_with(" -4") && line->field(5, 8) == field) {
      std::optional<FrdText::Line> value = line;
      std::size_t at = line->position;
      while (value && !value->text.starts_with(" -1") && !value->text.starts_with(" -3")) {
        value = lines.next();
        if (value) at = value->position;
      }
      state.position = at;
      states.push_back(state);
    }
  }
  return states;
}

std::vector<std::pair<std::int64_t, Eigen::Vector3d>> frdVectors(const std::filesystem::path& path,
                                                                 const std::string& text, const FrdState& state) {
  FrdText lines(path, text);
  lines.seek(state.position);
  std::vector<std::pair<std::int64_t, Eigen::Vector3d>> vectors;
  while (const auto line = lines.next()) {
    if (line->text.starts_with(" -3")) return vectors;
    if (!line->text.starts_with(" -1")) lines.failAt(line->position, "a line of a field begins with neither -1 nor -3");
    vectors.emplace_back(lines.integer(line->field(3, state.idWidth), "the number of a node", line->position),
                         lines.vector(*line, 3 + static_cast<std::size_t>(state.idWidth), 7, "component"));
  }
  throw InputError(path.string() + ": the file ends within a field; is it cut short?");
}

}  // namespace ringwatch::detail
