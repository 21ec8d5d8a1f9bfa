#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>
#include <optional>

#include <ringwatch/base/number_format.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

/// "VTK File Formats", legacy unstructured grids of versions 1 to 5. Read here and not by VTK's own reader, which
/// crashes on many damaged files.
class LegacyReader {
 public:
  LegacyReader(const std::string& source, const std::string& text)
      : cursor_(text, source),
        source_(source),
        builder_(
            source, [this](std::size_t p) { return cursor_.where(p); },
            [this](std::size_t cell) { return cursor_.where(positions_[cell]); }) {}

  Mesh read(Notes* notes, Problems* problems) {
    cursor_.line("the version");
    cursor_.skipLine();  // the title, which may be empty
    const std::string mode = inUpperCase(cursor_.line("ASCII or BINARY"));
    if (mode != "ASCII" && mode != "BINARY")
      cursor_.fail(joinText("found ", detail::quoted(mode), " where ASCII or BINARY is expected"));
    binary_ = mode == "BINARY";
    // A last line without its end may have lost digits, and a shorter number is still a number.
    if (!binary_ && !cursor_.endsWithNewline())
      cursor_.fail("the last line of the file has no line end; is the file cut short?");
    if (const std::string set = inUpperCase(cursor_.line("DATASET")); set != "DATASET UNSTRUCTURED_GRID")
      cursor_.fail(joinText("found ", detail::quoted(set), "; only DATASET UNSTRUCTURED_GRID is supported"));
    while ((!points_ || !cells_ || types_.empty()) && cursor_.skipSpace()) {
      const std::size_t at = cursor_.position();
      const std::string key = inUpperCase(cursor_.word("a section"));
      if (key == "POINTS" && !points_)
        readPoints(at);
      else if (key == "CELLS" && !cells_)
        readCells(at);
      else if (key == "CELL_TYPES" && types_.empty())
        readTypes(at);
      else if (key == "METADATA")
        skipMetadata();
      else if (key == "FIELD")
        readFields(at);
      else
        cursor_.failAt(at, joinText("found ", detail::quoted(key), " where POINTS, CELLS or CELL_TYPES is expected"));
    }
    if (!points_ || !cells_ || types_.empty())
      throw InputError(joinText(source_, ": the file ends without ",
                                !points_  ? "POINTS"
                                : !cells_ ? "CELLS"
                                          : "CELL_TYPES",
                                "; is it cut short?"));
    return build(notes, problems);
  }

  /// A field of one or three components at the points or the cells, component fastest.
  struct DataField {
    std::string name;
    std::size_t components;
    bool atPoints;
    std::vector<double> values;
  };
  /// After read(): the fields, and the single numbers of the file.
  std::vector<DataField> dataFields() {
    std::vector<DataField> found;
    std::size_t tuples = 0;
    bool atPoints = false;
    while (cursor_.skipSpace()) {
      const std::size_t at = cursor_.position();
      const std::string key = inUpperCase(cursor_.word("a section"));
      if (key == "POINT_DATA" || key == "CELL_DATA") {
        atPoints = key == "POINT_DATA";
        tuples = atPoints ? *points_ : begins_.size() - 1;
        const std::int64_t told = cursor_.integerText(joinText("the number of ", key));
        if (told != static_cast<std::int64_t>(tuples))
          cursor_.failAt(at, joinText("the number of ", key, " is ", told, "; there are ", tuples));
        cursor_.endRecord();
      } else if (key == "VECTORS" || key == "NORMALS") {
        const std::string name(cursor_.word("the name of the field"));
        const Format f = format(cursor_.word("the data type"), at);
        found.push_back({name, 3, atPoints, numbersOf(f, 3, tuples, at)});
      } else if (key == "SCALARS") {
        const std::string name(cursor_.word("the name of the field"));
        const Format f = format(cursor_.word("the data type"), at);
        const std::size_t components = cursor_.atLineEnd() ? 1 : count("components", 1, at);
        if (!cursor_.startsWith("LOOKUP_TABLE")) cursor_.failAt(at, "LOOKUP_TABLE is expected behind SCALARS");
        cursor_.word("LOOKUP_TABLE");
        cursor_.word("the name of the table");
        std::vector<double> values = numbersOf(f, components, tuples, at);
        if (components == 1) found.push_back({name, 1, atPoints, std::move(values)});
      } else if (key == "TENSORS") {
        cursor_.word("the name of the field");
        numbersOf(format(cursor_.word("the data type"), at), 9, tuples, at);
      } else if (key == "FIELD") {
        for (Field& field : readFields(at))
          if ((field.components == 3 || field.components == 1) && field.values.size() == field.components * tuples)
            found.push_back({field.name, field.components, atPoints, std::move(field.values)});
      } else if (key == "METADATA") {
        skipMetadata();
      } else {
        cursor_.failAt(at, joinText("found ", detail::quoted(key),
                                    " where VECTORS, SCALARS, FIELD, POINT_DATA or "
                                    "CELL_DATA is expected"));
      }
    }
    return found;
  }
  const std::map<std::string, double>& numbers() const { return numbers_; }
  /// After read(): the numbers at the elements of the mesh of those at the cells.
  std::vector<double> atElements(const std::vector<double>& atCells) {
    std::vector<double> values;
    for (const std::vector<std::size_t>& cells : builder_.positions())
      for (const std::size_t cell : cells) values.push_back(atCells[cell]);
    return values;
  }
  std::size_t cellCount() const { return positions_.size(); }

 private:
  struct Field {
    std::string name;
    std::size_t components;
    std::vector<double> values;
  };
  struct Format {
    std::size_t bytes;
    bool real, isSigned;
  };
  Format format(std::string_view name, std::size_t at) const {
    const std::string type = inUpperCase(name);
    if (type == "DOUBLE") return {8, true, true};
    if (type == "FLOAT") return {4, true, true};
    if (type == "LONG" || type == "VTKTYPEINT64" || type == "VTKIDTYPE" || type == "UNSIGNED_LONG")
      return {8, false, true};
    if (type == "INT" || type == "VTKTYPEINT32") return {4, false, true};
    if (type == "UNSIGNED_INT") return {4, false, false};
    if (type == "SHORT" || type == "UNSIGNED_SHORT") return {2, false, true};
    if (type == "CHAR" || type == "UNSIGNED_CHAR") return {1, false, true};
    cursor_.failAt(at, joinText("the data type is ", detail::quoted(name),
                                "; it must be one such as double, float, int or vtktypeint64"));
  }

  /// The numbers of a section, behind its header line. Binary values are big-endian.
  void beginData() {
    cursor_.endRecord();
    if (!binary_) return;
    cursor_.skipLine();
    cursor_.binary = true;
    cursor_.swapBytes = std::endian::native == std::endian::little;
  }
  void endData() { cursor_.binary = false; }
  double real(const Format& f, std::string_view what) {
    if (!binary_)
      return nextWord(what), f.real ? cursor_.numberText(what) : static_cast<double>(cursor_.integerText(what));
    if (f.real) return f.bytes == 8 ? cursor_.raw<double>(what) : static_cast<double>(cursor_.raw<float>(what));
    return static_cast<double>(integer(f, what));
  }
  std::int64_t integer(const Format& f, std::string_view what) {
    if (!binary_) return nextWord(what), cursor_.integerText(what);
    if (f.bytes == 8) return cursor_.raw<std::int64_t>(what);
    return f.isSigned ? std::int64_t{cursor_.raw<std::int32_t>(what)} : std::int64_t{cursor_.raw<std::uint32_t>(what)};
  }
  void nextWord(std::string_view what) { cursor_.beginRecord(what); }  // numbers may stand on lines as they like
  std::size_t count(std::string_view what, std::size_t bytesEach, std::size_t at) {
    return cursor_.checkedCount(cursor_.integerText(joinText("the number of ", what)), bytesEach, what, at);
  }

  void readPoints(std::size_t at) {
    const std::size_t n = count("POINTS", 5, at);
    points_ = n;
    const Format f = format(cursor_.word("the data type"), at);
    if (!f.real) cursor_.failAt(at, "the data type of POINTS must be float or double");
    if (binary_) cursor_.checkedCount(n, 3 * f.bytes, "POINTS", at);
    beginData();
    for (std::size_t i = 0; i < n; ++i) {
      if (!binary_) nextWord("a point");
      const std::size_t where = cursor_.position();
      const double x = real(f, "coordinate x"), y = real(f, "coordinate y"), z = real(f, "coordinate z");
      builder_.addNode(i, x, y, z, where);
    }
    endData();
  }

  void readCells(std::size_t at) {
    cells_ = true;
    const std::size_t first = count("CELLS", 2, at);
    const std::size_t second = count("entries of CELLS", 2, at);
    beginData();
    const Format int32{4, false, true};
    // Version 5 has offsets and connectivity apart. In a binary file the size of the raw block tells nothing, but a
    // header in words cannot be mistaken for the small number that the older form begins with.
    if (cursor_.startsWith("OFFSETS")) {
      const auto list = [&](const char* key, std::size_t n, std::vector<std::int64_t>& values) {
        endData();
        if (!cursor_.skipSpace() || inUpperCase(cursor_.word(key)) != key)
          cursor_.fail(joinText(key, " is expected here"));
        const std::size_t where = cursor_.position();
        const Format f = format(cursor_.word("the data type"), where);
        if (f.real || f.bytes < 4)
          cursor_.failAt(where, joinText("the data type of ", key, " must be an integer of 4 or 8 bytes"));
        beginData();
        for (std::size_t i = 0; i < n; ++i) values.push_back(integer(f, key));
        endData();
      };
      std::vector<std::int64_t> offsets;
      list("OFFSETS", first, offsets);
      list("CONNECTIVITY", second, nodes_);
      if (offsets.empty() || offsets.front() != 0 || offsets.back() != static_cast<std::int64_t>(second) ||
          !std::is_sorted(offsets.begin(), offsets.end()))
        cursor_.failAt(at, joinText("the OFFSETS must ascend from 0 to ", second));
      for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
        begins_.push_back(offsets[c]);
        positions_.push_back(at);
      }
      begins_.push_back(second);
      return;
    }
    std::size_t used = 0;
    for (std::size_t c = 0; c < first; ++c) {
      if (!binary_) nextWord("a cell");
      const std::size_t where = cursor_.position();
      const std::int64_t n = integer(int32, "the number of nodes of a cell");
      ++used;
      if (n < 0 || static_cast<std::uint64_t>(n) > second - std::min(second, used))
        cursor_.failAt(where, joinText("the number of nodes of cell ", c, " is ", n, "; the CELLS have ", second,
                                       " entries in all"));
      begins_.push_back(nodes_.size());
      positions_.push_back(where);
      for (std::int64_t k = 0; k < n; ++k) nodes_.push_back(integer(int32, "a node of a cell"));
      used += static_cast<std::size_t>(n);
    }
    begins_.push_back(nodes_.size());
    if (used != second) cursor_.failAt(at, joinText("the CELLS announce ", second, " entries, but have ", used));
    endData();
  }

  void readTypes(std::size_t at) {
    const std::size_t n = count("CELL_TYPES", 2, at);
    if (n == 0) cursor_.failAt(at, "there are no cells");
    beginData();
    for (std::size_t i = 0; i < n; ++i) types_.push_back(integer({4, false, true}, "a cell type"));
    endData();
    typesAt_ = at;
  }

  void skipMetadata() {
    cursor_.skipLine();
    while (cursor_.remaining() > 0 && !cursor_.atLineEnd()) cursor_.skipLine();  // it ends with an empty line
  }

  /// The numbers of a field, behind its header line; words such as nan and inf are numbers here.
  std::vector<double> numbersOf(const Format& f, std::size_t components, std::size_t tuples, std::size_t at) {
    const std::size_t bytes = binary_ ? f.bytes : 2;
    if (components > 0 && tuples > cursor_.remaining() / bytes / components)
      cursor_.failAt(at,
                     joinText("the field announces ", components, " x ", tuples, " values, more than the file holds"));
    std::vector<double> values(components * tuples);
    if (values.empty()) return values;
    beginData();
    for (double& value : values) {
      if (binary_) {
        value = f.bytes >= 4 ? real(f, "a field value") : smallInteger(f);
        continue;
      }
      nextWord("a field value");
      const std::string_view word = cursor_.word("a field value");
      const std::optional<double> read = readNumber(word);
      if (!read) cursor_.fail(joinText("a field value is ", detail::quoted(word), "; it must be a number"));
      value = *read;
    }
    endData();
    return values;
  }
  double smallInteger(const Format& f) {
    return f.bytes == 2 ? static_cast<double>(cursor_.raw<std::int16_t>("a field value"))
                        : static_cast<double>(cursor_.raw<std::int8_t>("a field value"));
  }

  std::vector<Field> readFields(std::size_t at) {
    cursor_.word("the name of the fields");
    const std::size_t n = count("fields", 8, at);
    cursor_.endRecord();
    std::vector<Field> fields;
    for (std::size_t i = 0; i < n; ++i) {
      if (!cursor_.skipSpace()) cursor_.fail("the file ends within a FIELD; is it cut short?");
      const std::size_t where = cursor_.position();
      const std::string name(cursor_.word("the name of a field"));
      const std::size_t components = count("components", 1, where), tuples = count("tuples", 1, where);
      const Format f = format(cursor_.word("the data type"), where);
      Field& field = fields.emplace_back(Field{name, components, numbersOf(f, components, tuples, where)});
      if (field.values.size() == 1) numbers_[name] = field.values[0];
    }
    return fields;
  }

  Mesh build(Notes* notes, Problems* problems) {
    const std::size_t count = begins_.size() - 1;
    if (types_.size() != count)
      cursor_.failAt(typesAt_,
                     joinText("the number of CELL_TYPES is ", types_.size(), ", but there are ", count, " CELLS"));
    cursor_.binary = binary_;  // so that positions are told as bytes
    std::int64_t nodes[125];
    std::size_t flat = 0;
    for (std::size_t c = 0; c < count; ++c) {
      const int type = types_[c] >= 0 && types_[c] < 256 ? static_cast<int>(types_[c]) : 255;
      const std::size_t n = begins_[c + 1] - begins_[c];
      const auto [known, order] = vtkCell(type, n);
      if (known == nullptr && isVtkVolumeCell(type))
        cursor_.failAt(positions_[c], joinText("cell ", c, " is of VTK type ", types_[c],
                                               ", which is not supported; tetrahedra (10) and hexahedra (12) are"));
      if (known == nullptr || known->dimension < 3) {
        ++flat;
        continue;
      }
      if (n != static_cast<std::size_t>(known->nodes))
        cursor_.failAt(positions_[c],
                       joinText("cell ", c, " (", known->name(), ") has ", n, " nodes; it must have ", known->nodes));
      std::copy_n(nodes_.begin() + static_cast<std::ptrdiff_t>(begins_[c]), n, nodes);
      builder_.addElement(*known, c, nodes, -1, c, order);
    }
    if (flat > 0 && notes != nullptr)
      notes->push_back(joinText(source_, ": ", flat, " cells of surfaces, lines or points are left out"));
    builder_.leftOut = flat;
    return builder_.finish(notes, problems);
  }

  FileCursor cursor_;
  std::string source_;
  MeshBuilder builder_;
  bool binary_ = false, cells_ = false;
  std::optional<std::size_t> points_;  // how many there are
  std::map<std::string, double> numbers_;
  std::vector<std::int64_t> nodes_, types_;
  std::vector<std::size_t> begins_, positions_;
  std::size_t typesAt_ = 0;
};

}  // namespace

bool isVtkVolumeCell(int type) {
  if (const FileElement* known = findVtkElement(type)) return known->dimension == 3;
  // Flat cells without a fixed order, or that gmsh does not have (vtkCellType.h).
  constexpr int flat[] = {0, 2, 4, 6, 7, 8, 30, 34, 36, 51, 52, 55, 56, 60, 61, 62, 68, 69, 70, 75, 76, 77};
  return std::find(std::begin(flat), std::end(flat), type) == std::end(flat);
}

namespace {

/// Takes what the file says of its nodes and elements.
void takeLegacyFields(LegacyReader& reader, const std::vector<LegacyReader::DataField>& fields, ResultFrame& frame,
                      const std::string& source, Notes* notes) {
  for (const LegacyReader::DataField& field : fields) {
    if (field.atPoints && field.name == nodeNumberField)
      takeNodeNumbers(frame, field.values, source, notes);
    else if (!field.atPoints && field.components == 1 && field.values.size() == reader.cellCount())
      takeCellField(frame, field.name, reader.atElements(field.values), source, notes);
  }
}

}  // namespace

Mesh readLegacyVtk(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  LegacyReader reader(path.string(), text);
  ResultFrame frame;
  frame.mesh = reader.read(notes, problems);
  if (mayTellOfElements(text)) takeLegacyFields(reader, reader.dataFields(), frame, path.string(), notes);
  return standingMesh(std::move(frame), path.string(), notes);
}

ResultFrame readLegacyVtkResult(const std::filesystem::path& path, const std::string& text,
                                const std::vector<std::string>& names, Notes* notes) {
  LegacyReader reader(path.string(), text);
  ResultFrame frame;
  Problems problems;
  frame.mesh = reader.read(notes, &problems);
  requireElements(problems);
  const auto nodes = static_cast<Eigen::Index>(frame.mesh.nodeCount());
  const std::vector<LegacyReader::DataField> fields = reader.dataFields();
  for (const LegacyReader::DataField& field : fields)
    if (field.atPoints && field.components == 3)
      frame.vectors += (frame.vectors.empty() ? "" : ", ") + detail::quoted(field.name);
  takeLegacyFields(reader, fields, frame, path.string(), notes);
  for (const std::string& name : names) {
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) {
      return field.atPoints && field.components == 3 && field.name == name;
    });
    if (found == fields.end()) continue;
    frame.displacement = name;
    frame.u = Eigen::Map<const NodeVectors>(found->values.data(), 3, nodes);
    break;
  }
  const std::map<std::string, double>& numbers = reader.numbers();
  for (const char* name : {"TIME", "TimeValue", "time"})
    if (const auto known = numbers.find(name); known != numbers.end()) frame.time = known->second;
  if (const auto known = numbers.find("CYCLE"); known != numbers.end())
    frame.increment = static_cast<std::int64_t>(known->second);
  return frame;
}

}  // namespace ringwatch::detail
