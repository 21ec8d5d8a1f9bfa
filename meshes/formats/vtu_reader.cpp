#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/formats/vtu_frame.h>
#include <ringwatch/meshes/formats/vtu_writer.h>

namespace ringwatch::detail {
namespace {

constexpr std::string_view setPrefix = "set:";
// Deflate packs at most about 1032:1, so a file can hold no more bytes than this times its size.
constexpr std::size_t mostPacking = 1100;

struct Tag {
  std::string name;
  bool closing = false, selfClosing = false;
  std::map<std::string, std::string, std::less<>> attributes;
  std::size_t begin = 0, end = 0;  // of "<…>"
  std::string get(std::string_view key) const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string() : found->second;
  }
};

struct DataType {
  std::string_view name;
  std::size_t bytes;
  bool real, isSigned;
};
constexpr DataType dataTypes[] = {{"Float64", 8, true, true},  {"Float32", 4, true, true},  {"Int64", 8, false, true},
                                  {"UInt64", 8, false, false}, {"Int32", 4, false, true},   {"UInt32", 4, false, false},
                                  {"Int16", 2, false, true},   {"UInt16", 2, false, false}, {"Int8", 1, false, true},
                                  {"UInt8", 1, false, false}};

struct Array {
  std::string section, name, format;
  const DataType* type;
  std::int64_t components;
  std::int64_t offset;         // into the appended data
  std::size_t at, begin, end;  // of the tag, and of its text
};

/// Files of type UnstructuredGrid ("VTK XML formats"): text, inline and appended data, packed or not. Read here and not
/// by VTK's own reader, which crashes on some damaged files; VTK unpacks the data.
class VtuReader {
 public:
  VtuReader(const std::string& source, const std::string& text)
      : source_(source),
        text_(text),
        cursor_(text_, source),
        builder_(
            source, [this](std::size_t p) { return joinText(source_, ": point ", p); },
            [this](std::size_t p) { return joinText(source_, ": cell ", p); }) {}

  Mesh read(Notes* notes, Problems* problems) {
    std::string_view trimmed = text_;
    while (!trimmed.empty() && std::string_view(" \t\r\n").find(trimmed.back()) != std::string_view::npos)
      trimmed.remove_suffix(1);
    if (!trimmed.ends_with("</VTKFile>"))
      throw InputError(source_ + ": the file does not end with </VTKFile>; is it cut short?");
    scan();
    if (pieces_.empty()) throw InputError(source_ + ": there is no <Piece>");
    for (const Piece& piece : pieces_) readPiece(piece);
    if (cellCount_ == 0) throw InputError(source_ + ": there are no cells");
    if (flat_ > 0 && notes != nullptr)
      notes->push_back(joinText(source_, ": ", flat_, " cells of surfaces, lines or points are left out"));
    builder_.leftOut = flat_;
    Mesh mesh = builder_.finish(notes, problems);
    nodesHaveNumbers_ = nodeIds_.size() == mesh.nodeCount();
    if (nodesHaveNumbers_) mesh.nodeIds = nodeIds_;
    return mesh;
  }
  /// After read(): whether the file has numbers of its own, those of ringwatch's files.
  bool nodesHaveNumbers() const { return nodesHaveNumbers_; }
  bool elementsHaveNumbers() const { return elementsHaveNumbers_; }

  /// After read(): the displacement of that name at all points, 3×N, and whether the points are deformed positions.
  NodeVectors displacement(const std::string& name, std::size_t nodes) const {
    NodeVectors result(3, nodes);
    std::size_t first = 0;
    for (const Piece& piece : pieces_) {
      if (piece.points == 0) continue;
      std::string known;
      const Array* found = nullptr;
      for (const Array& a : piece.arrays) {
        if (a.section != "PointData") continue;
        if (a.name == name) found = &a;
        if (a.components == 3 && a.type->real) known += (known.empty() ? "" : ", ") + detail::quoted(a.name);
      }
      if (found == nullptr) throw InputError(joinText(source_, ": ", detail::noField(name, known)));
      if (found->components != 3 || !found->type->real)
        throw InputError(joinText(source_, ": the field ", detail::quoted(name), " has ", found->components,
                                  found->type->real ? " components, not 3; " : " integer components; ",
                                  fieldChoice(known)));
      const std::vector<double> u = values<double>(*found, 3 * piece.points);
      for (std::size_t i = 0; i < u.size(); ++i) {
        if (!std::isfinite(u[i]))
          throw InputError(joinText(source_, ": ", detail::quoted(name), " at point ", first + i / 3, " is ", u[i],
                                    "; it must be finite"));
        result.data()[3 * first + i] = u[i];
      }
      first += piece.points;
    }
    return result;
  }
  bool deformedPoints() const { return deformedPoints_; }

  /// After read(): a number at each point; empty where some piece has no such field.
  std::vector<double> pointNumbers(const std::string& name) const {
    std::vector<double> numbers;
    for (const Piece& piece : pieces_) {
      const Array* a = find(piece, "PointData", name);
      if (piece.points > 0 && (a == nullptr || a->components != 1)) return {};
      if (piece.points == 0) continue;
      const std::vector<double> own = values<double>(*a, piece.points);
      numbers.insert(numbers.end(), own.begin(), own.end());
    }
    return numbers;
  }

  /// After read(): whether every piece has a field of three components of that name at its points.
  bool hasVectors(const std::string& name) const {
    return std::all_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
      return std::any_of(piece.arrays.begin(), piece.arrays.end(), [&](const Array& a) {
        return a.section == "PointData" && a.components == 3 && a.type->real && a.name == name;
      });
    });
  }
  std::string vectorNames() const {
    std::string names;
    for (const Array& a : pieces_.front().arrays)
      if (a.section == "PointData" && a.components == 3 && a.type->real)
        names += (names.empty() ? "" : ", ") + detail::quoted(a.name);
    return names;
  }
  /// One that hasVectors, 3×N; it may be not finite.
  NodeVectors vectors(const std::string& name, std::size_t nodes) const {
    NodeVectors result(3, nodes);
    std::size_t first = 0;
    for (const Piece& piece : pieces_)
      for (const Array& a : piece.arrays) {
        if (a.section != "PointData" || a.name != name || piece.points == 0) continue;
        const std::vector<double> u = values<double>(a, 3 * piece.points);
        std::copy(u.begin(), u.end(), result.data() + 3 * first);
        first += piece.points;
        break;
      }
    return result;
  }

  /// After read(): the numbers at the elements of the mesh, in the order of blocks and elements. only: fields of these
  /// names; empty for all.
  std::vector<FrameField> cellFields(std::span<const std::string_view> only = {}) {
    std::vector<FrameField> fields;
    for (const Piece& piece : pieces_)
      for (const Array& a : piece.arrays) {
        if (a.section != "CellData" || a.components != 1 || a.name == "originalElementId" ||
            a.name.starts_with(setPrefix) || (!only.empty() && std::ranges::find(only, a.name) == only.end()))
          continue;
        auto field = std::find_if(fields.begin(), fields.end(), [&](const FrameField& f) { return f.name == a.name; });
        if (field == fields.end()) field = fields.insert(fields.end(), {a.name, !a.type->real, {}});
        const std::vector<double> own = values<double>(a, piece.cells);
        field->values.insert(field->values.end(), own.begin(), own.end());
      }
    std::erase_if(fields, [this](const FrameField& field) { return field.values.size() != cellCount_; });
    for (FrameField& field : fields) {
      std::vector<double> ofElements;
      for (const std::vector<std::size_t>& cells : builder_.positions())
        for (const std::size_t cell : cells) ofElements.push_back(field.values[cell]);
      field.values = std::move(ofElements);
    }
    return fields;
  }
  /// The field data that are a single number.
  std::map<std::string, double> numbers() const {
    std::map<std::string, double> result;
    for (const Array& a : fieldData_) result[a.name] = values<double>(a, 1)[0];
    return result;
  }

 private:
  struct Piece {
    std::size_t points, cells, at;
    std::vector<Array> arrays;
  };

  [[noreturn]] void fail(std::size_t at, const std::string& what) const { cursor_.failAt(at, what); }

  /// The next tag from `at` on; nothing at the end.
  std::optional<Tag> nextTag(std::size_t at) const {
    while (true) {
      at = text_.find('<', at);
      if (at == std::string_view::npos) return {};
      const auto skipBehind = [&](std::string_view end) {
        const std::size_t stop = text_.find(end, at);
        if (stop == std::string_view::npos) fail(at, joinText("there is no ", end));
        at = stop + end.size();
      };
      if (text_.substr(at, 4) == "<!--")
        skipBehind("-->");
      else if (text_.substr(at, 2) == "<?")
        skipBehind("?>");
      else
        break;
    }
    Tag tag;
    tag.begin = at++;
    const auto peek = [&] {
      if (at >= text_.size()) fail(tag.begin, "the tag does not end");
      return text_[at];
    };
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    if (peek() == '/') tag.closing = true, ++at;
    const std::size_t nameBegin = at;
    while (!isBlank(peek()) && peek() != '>' && peek() != '/') ++at;
    tag.name = std::string(text_.substr(nameBegin, at - nameBegin));
    while (true) {
      while (isBlank(peek())) ++at;
      if (peek() == '>') break;
      if (peek() == '/') {
        tag.selfClosing = true;
        ++at;
        continue;
      }
      const std::size_t keyBegin = at;
      while (peek() != '=' && peek() != '>' && !isBlank(peek())) ++at;
      const std::string key(text_.substr(keyBegin, at - keyBegin));
      if (peek() != '=') fail(keyBegin, joinText("the attribute ", detail::quoted(key), " has no value"));
      ++at;
      const char quote = peek();
      if (quote != '"' && quote != '\'')
        fail(keyBegin, joinText("the value of ", detail::quoted(key), " is not in quotes"));
      const std::size_t valueBegin = ++at;
      while (peek() != quote) ++at;
      tag.attributes[key] = plain(text_.substr(valueBegin, at - valueBegin));
      ++at;
    }
    tag.end = at + 1;
    return tag;
  }

  static std::string plain(std::string_view value) {
    std::string result;
    for (std::size_t i = 0; i < value.size(); ++i) {
      bool replaced = false;
      for (const auto& [entity, c] : {std::pair<std::string_view, char>{"&amp;", '&'},
                                      {"&lt;", '<'},
                                      {"&gt;", '>'},
                                      {"&quot;", '"'},
                                      {"&apos;", '\''}})
        if (value.substr(i, entity.size()) == entity) {
          result += c;
          i += entity.size() - 1;
          replaced = true;
          break;
        }
      if (!replaced) result += value[i];
    }
    return result;
  }

  std::int64_t integerAttribute(const Tag& tag, std::string_view key, std::int64_t absent) const {
    const std::string value = tag.get(key);
    if (value.empty()) return absent;
    std::int64_t number = 0;
    const auto [stop, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || stop != value.data() + value.size() || number < 0)
      fail(tag.begin, joinText(key, " is ", detail::quoted(value), "; it must be an integer, 0 or more"));
    return number;
  }
  std::size_t countAttribute(const Tag& tag, std::string_view key) const {
    const std::int64_t number = integerAttribute(tag, key, -1);
    if (number < 0) fail(tag.begin, joinText("the <", tag.name, "> has no ", key));
    if (static_cast<std::uint64_t>(number) > text_.size() * mostPacking)
      fail(tag.begin, joinText(key, " is ", number, ", more than the file can hold"));
    return static_cast<std::size_t>(number);
  }

  void scan() {
    std::vector<std::string> open;
    std::size_t at = 0;
    bool ended = false;
    while (auto found = nextTag(at)) {
      Tag& tag = *found;
      at = tag.end;
      if (tag.closing) {
        if (open.empty() || open.back() != tag.name)
          fail(tag.begin,
               joinText("</", tag.name, "> does not match <", open.empty() ? std::string() : open.back(), ">"));
        open.pop_back();
        ended = open.empty();
        continue;
      }
      if (open.empty()) {
        if (tag.name != "VTKFile")
          fail(tag.begin, joinText("found <", tag.name, ">; a .vtu file begins with <VTKFile>"));
        readHead(tag);
      } else if (tag.name == "Piece") {
        pieces_.push_back({countAttribute(tag, "NumberOfPoints"), countAttribute(tag, "NumberOfCells"), tag.begin, {}});
      } else if (tag.name == "DataArray" && open.back() == "FieldData") {
        deformedPoints_ = deformedPoints_ || tag.get("Name") == deformedPointsMark;
        if (tag.get("NumberOfTuples") == "1") addArray(tag, "FieldData");
      } else if (tag.name == "DataArray" && !pieces_.empty()) {
        addArray(tag, open.back());
      } else if (tag.name == "AppendedData") {
        const std::string encoding = tag.get("encoding");
        if (encoding != "raw" && encoding != "base64")
          fail(tag.begin, joinText("the encoding is ", detail::quoted(encoding), "; it must be raw or base64"));
        const std::size_t mark = text_.find('_', tag.end);
        const std::size_t last = text_.rfind("</AppendedData>");
        if (mark == std::string_view::npos || last == std::string_view::npos || last < mark)
          fail(tag.begin, "the appended data have no begin _ or no end");
        rawAppended_ = encoding == "raw";
        appended_ = text_.substr(mark + 1, last - mark - 1);
        at = last;  // bytes in between may look like anything
      }
      if (!tag.selfClosing) open.push_back(tag.name);
    }
    if (!ended) throw InputError(source_ + ": the tags do not close");
  }

  void readHead(const Tag& tag) {
    if (tag.get("type") != "UnstructuredGrid")
      fail(tag.begin,
           joinText("the type is ", detail::quoted(tag.get("type")), "; only UnstructuredGrid is supported"));
    const std::string order = tag.get("byte_order"), header = tag.get("header_type");
    if (order != "LittleEndian" && order != "BigEndian" && !order.empty())
      fail(tag.begin, joinText("the byte_order is ", detail::quoted(order), "; it must be LittleEndian or BigEndian"));
    swap_ = (order == "BigEndian") != (std::endian::native == std::endian::big);
    if (header != "UInt32" && header != "UInt64" && !header.empty())
      fail(tag.begin, joinText("the header_type is ", detail::quoted(header), "; it must be UInt32 or UInt64"));
    wordBytes_ = header == "UInt64" ? 8 : 4;
    compressor_ = tag.get("compressor");
  }

  void addArray(const Tag& tag, const std::string& section) {
    const std::string typeName = tag.get("type");
    const auto* type =
        std::find_if(std::begin(dataTypes), std::end(dataTypes), [&](const DataType& t) { return t.name == typeName; });
    if (type == std::end(dataTypes)) {
      if (section == "Points" || section == "Cells")
        fail(tag.begin,
             joinText("the type is ", detail::quoted(typeName), "; it must be one such as Float64 or Int64"));
      return;  // texts among the point and cell data
    }
    Array array{section,
                tag.get("Name"),
                tag.get("format"),
                type,
                integerAttribute(tag, "NumberOfComponents", 1),
                integerAttribute(tag, "offset", -1),
                tag.begin,
                tag.end,
                tag.end};
    if (!tag.selfClosing) array.end = std::min(text_.find('<', tag.end), text_.size());
    (section == "FieldData" ? fieldData_ : pieces_.back().arrays).push_back(std::move(array));
  }

  const Array* find(const Piece& piece, std::string_view section, std::string_view name) const {
    for (const Array& a : piece.arrays)
      if (a.section == section && (name.empty() || a.name == name)) return &a;
    return nullptr;
  }
  const Array& need(const Piece& piece, std::string_view section, std::string_view name) const {
    const Array* found = find(piece, section, name);
    if (found == nullptr) fail(piece.at, joinText("the piece has no ", name.empty() ? section : name));
    return *found;
  }

  /// Bytes of base64 from a text, at most so many.
  std::string base64(std::string_view text, std::size_t most, const Array& array) const {
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
      if (bytes.size() >= most || c == '=') break;
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
      int value = -1;
      if (c >= 'A' && c <= 'Z')
        value = c - 'A';
      else if (c >= 'a' && c <= 'z')
        value = c - 'a' + 26;
      else if (c >= '0' && c <= '9')
        value = c - '0' + 52;
      else if (c == '+')
        value = 62;
      else if (c == '/')
        value = 63;
      if (value < 0) fail(array.at, joinText("the data of ", detail::quoted(array.name), " are not base64"));
      bits = bits << 6 | static_cast<std::uint32_t>(value);
      held += 6;
      if (held >= 8) {
        held -= 8;
        bytes += static_cast<char>(bits >> held & 0xFF);
      }
    }
    return bytes;
  }

  std::uint64_t word(std::string_view bytes, std::size_t index, const Array& array) const {
    if (bytes.size() < (index + 1) * wordBytes_)
      fail(array.at, joinText("the data of ", detail::quoted(array.name), " end early; is the file cut short?"));
    std::uint64_t value = 0;
    for (std::size_t b = 0; b < wordBytes_; ++b) {
      const bool littleFile = (std::endian::native == std::endian::little) != swap_;
      const std::size_t at = index * wordBytes_ + (littleFile ? wordBytes_ - 1 - b : b);
      value = value << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return value;
  }

  /// The raw bytes of a binary array, which must be so many.
  std::string bytes(const Array& array, std::size_t expected) const {
    const auto refuse = [&](const std::string& what) {
      fail(array.at, joinText("the data of ", detail::quoted(array.name), " ", what));
    };
    std::string_view stored;
    bool raw = false;
    if (array.format == "appended") {
      if (array.offset < 0 || static_cast<std::uint64_t>(array.offset) >= appended_.size())
        refuse(joinText("begin at offset ", array.offset, " of the appended data, which have ", appended_.size(),
                        " bytes"));
      stored = appended_.substr(array.offset);
      raw = rawAppended_;
    } else if (array.format == "binary") {
      stored = text_.substr(array.begin, array.end - array.begin);
      const std::size_t first = stored.find_first_not_of(" \t\r\n");
      const std::size_t last = stored.find_last_not_of(" \t\r\n");
      stored = first == std::string_view::npos ? std::string_view() : stored.substr(first, last - first + 1);
    } else {
      refuse(joinText("have the format ", detail::quoted(array.format), "; it must be ascii, binary or appended"));
    }
    const auto take = [&](std::string_view from, std::size_t count) {
      return raw ? std::string(from.substr(0, count)) : base64(from, count, array);
    };
    if (compressor_.empty()) {
      const std::uint64_t size = word(take(stored, wordBytes_), 0, array);
      if (size != expected) refuse(joinText("are ", size, " bytes; they must be ", expected));
      // In base64 the header is in one text with the data, or apart: then the text of it alone is padded.
      const std::size_t head = (8 * wordBytes_ + 5) / 6;
      if (!raw && stored.find('=') == head) {
        std::string apart = take(stored.substr(std::min(stored.size(), (head + 3) / 4 * 4)), expected);
        if (apart.size() != expected) refuse("end early; is the file cut short?");
        return apart;
      }
      std::string all = take(stored, wordBytes_ + expected);
      if (all.size() != wordBytes_ + expected) refuse("end early; is the file cut short?");
      return all.substr(wordBytes_);
    }
    // Header: number of blocks, size of each, size of a shorter last one (0: none), packed sizes.
    const std::uint64_t blocks = word(take(stored, wordBytes_), 0, array);
    if (blocks == 0 && expected == 0) return {};
    if (blocks == 0 || blocks > stored.size() / wordBytes_)
      refuse(joinText("announce ", blocks, " blocks, which the file does not hold"));
    const std::size_t headBytes = (3 + static_cast<std::size_t>(blocks)) * wordBytes_;
    const std::string head = take(stored, headBytes);
    const std::uint64_t size = word(head, 1, array), last = word(head, 2, array);
    const std::uint64_t whole = last == 0 ? blocks : blocks - 1;
    if (last > size || (size != 0 && whole > expected / size) || whole * size + last != expected) {
      // VTK announces its usual block size also when the only block is shorter.
      if (!(blocks == 1 && last == expected && last != 0))
        refuse(joinText("unpack to ", blocks, " blocks of ", size, " bytes; ", expected, " bytes are needed in all"));
    }
    const std::size_t headStored = raw ? headBytes : (headBytes + 2) / 3 * 4;
    if (stored.size() < headStored) refuse("end early; is the file cut short?");
    std::uint64_t packed = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::uint64_t own = word(head, 3 + b, array);
      if (own > stored.size() - packed)
        refuse(joinText("announce a packed block of ", own, " bytes, more than the file holds"));
      packed += own;
    }
    const std::string body = take(stored.substr(headStored), packed);
    if (body.size() != packed) refuse("end early; is the file cut short?");
    std::string result(expected, '\0');
    std::size_t in = 0, out = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t own = word(head, 3 + b, array);
      const std::size_t length = b + 1 == blocks && last != 0 ? last : size;
      if (!unpack(source_, compressor_, body.data() + in, own, result.data() + out, length))
        refuse(joinText("cannot be unpacked by ", compressor_));
      in += own;
      out += length;
    }
    return result;
  }

  template <class T>
  static T convert(const char* raw, const DataType& type, bool swap) {
    const auto as = [&]<class U>(U value) {
      std::array<char, sizeof(U)> stored;
      std::memcpy(stored.data(), raw, sizeof(U));
      if (swap) std::reverse(stored.begin(), stored.end());
      std::memcpy(&value, stored.data(), sizeof(U));
      return static_cast<T>(value);
    };
    if (type.real) {
      if constexpr (std::is_integral_v<T>)
        return -1;  // indices are never stored so; refused later as out of range
      else
        return type.bytes == 8 ? as(double{}) : as(float{});
    }
    switch (type.bytes) {
      case 8:
        return type.isSigned ? as(std::int64_t{}) : as(std::uint64_t{});
      case 4:
        return type.isSigned ? as(std::int32_t{}) : as(std::uint32_t{});
      case 2:
        return type.isSigned ? as(std::int16_t{}) : as(std::uint16_t{});
      default:
        return type.isSigned ? as(std::int8_t{}) : as(std::uint8_t{});
    }
  }

  template <class T>
  std::vector<T> values(const Array& array, std::size_t count) const {
    if (std::is_integral_v<T> && array.type->real)
      fail(array.at,
           joinText(detail::quoted(array.name), " is of type ", array.type->name, "; it must be an integer type"));
    std::vector<T> result;
    if (array.format == "ascii" || array.format.empty()) {
      FileCursor cursor(text_.substr(0, array.end), source_);
      cursor.seek(array.begin);
      cursor.checkedCount(count, 1, "values", array.at);
      result.reserve(count);
      for (std::size_t i = 0; i < count; ++i) {
        if (!cursor.skipSpace())
          fail(array.at, joinText(detail::quoted(array.name), " has ", i, " values; it must have ", count));
        if constexpr (std::is_integral_v<T>)
          result.push_back(cursor.integerText("a value"));
        else
          result.push_back(cursor.numberText("a value"));
      }
      if (cursor.skipSpace()) cursor.fail(joinText(detail::quoted(array.name), " has more than ", count, " values"));
      return result;
    }
    if (count > text_.size() * mostPacking)
      fail(array.at,
           joinText(detail::quoted(array.name), " should have ", count, " values, more than the file can hold"));
    const std::string raw = bytes(array, count * array.type->bytes);
    result.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      result[i] = convert<T>(raw.data() + i * array.type->bytes, *array.type, swap_);
    return result;
  }

  void readPiece(const Piece& piece) {
    const std::int64_t firstPoint = builder_.nodeCount();
    if (piece.points > 0) {
      const Array& points = need(piece, "Points", "");
      if (points.components != 3)
        fail(points.at, joinText("the points have ", points.components, " components; they must have 3"));
      const std::vector<double> x = values<double>(points, 3 * piece.points);
      for (std::size_t n = 0; n < piece.points; ++n) {
        const auto number = builder_.nodeCount();
        builder_.addNode(number, x[3 * n], x[3 * n + 1], x[3 * n + 2], number);
      }
    }
    for (const Array& a : piece.arrays) {
      if (a.section != "PointData" || a.components != 1) continue;
      if (a.name == "originalNodeId" && !a.type->real) {
        const auto ids = values<std::int64_t>(a, piece.points);
        nodeIds_.insert(nodeIds_.end(), ids.begin(), ids.end());
      } else if (a.name.rfind(setPrefix, 0) == 0 && !a.type->real) {
        const auto flags = values<std::int64_t>(a, piece.points);
        for (std::size_t n = 0; n < piece.points; ++n)
          if (flags[n] != 0)
            builder_.addToNodeSet(a.name.substr(setPrefix.size()), firstPoint + static_cast<std::int64_t>(n));
      }
    }
    if (piece.cells == 0) return;
    const Array& connectivityArray = need(piece, "Cells", "connectivity");
    const Array& offsetArray = need(piece, "Cells", "offsets");
    const auto offsets = values<std::int64_t>(offsetArray, piece.cells);
    const auto types = values<std::int64_t>(need(piece, "Cells", "types"), piece.cells);
    std::int64_t before = 0;
    for (std::size_t c = 0; c < piece.cells; ++c) {
      if (offsets[c] < before)
        fail(offsetArray.at, joinText("offset ", c, " is ", offsets[c], "; it must not be below ", before));
      before = offsets[c];
    }
    const auto connectivity = values<std::int64_t>(connectivityArray, static_cast<std::size_t>(before));
    std::vector<std::pair<std::string, std::vector<std::int64_t>>> sets;
    std::vector<std::int64_t> ids;
    for (const Array& a : piece.arrays) {
      if (a.section != "CellData" || a.components != 1 || a.type->real) continue;
      if (a.name == "originalElementId")
        ids = values<std::int64_t>(a, piece.cells);
      else if (a.name.rfind(setPrefix, 0) == 0)
        sets.emplace_back(a.name.substr(setPrefix.size()), values<std::int64_t>(a, piece.cells));
    }
    elementsHaveNumbers_ = elementsHaveNumbers_ || !ids.empty();
    std::map<std::vector<std::string>, int> groups;
    std::int64_t nodes[125];
    for (std::size_t c = 0; c < piece.cells; ++c, ++cellCount_) {
      const std::int64_t begin = c == 0 ? 0 : offsets[c - 1], end = offsets[c];
      const int type = types[c] >= 0 && types[c] < 256 ? static_cast<int>(types[c]) : 255;
      const auto [known, order] = vtkCell(type, static_cast<std::size_t>(end - begin));
      const auto refuse = [&](const std::string& what) {
        throw InputError(joinText(source_, ": cell ", cellCount_, " ", what));
      };
      if (known == nullptr && isVtkVolumeCell(type))
        refuse(
            joinText("is of VTK type ", types[c], ", which is not supported; tetrahedra (10) and hexahedra (12) are"));
      if (known == nullptr || known->dimension < 3) {
        ++flat_;
        continue;
      }
      if (end - begin != known->nodes)
        refuse(joinText("(", known->name(), ") has ", end - begin, " nodes; it must have ", known->nodes));
      for (std::int64_t i = begin; i < end; ++i) {
        const std::int64_t node = connectivity[i];
        // A piece counts its own points; what is out of its range must not fall into another piece's.
        nodes[i - begin] = node < 0 || static_cast<std::uint64_t>(node) >= piece.points
                               ? std::min<std::int64_t>(node, 0) - 1
                               : node + firstPoint;
        if (nodes[i - begin] < 0 && pieces_.size() == 1) nodes[i - begin] = node;  // the number itself for the message
      }
      int group = -1;
      std::vector<std::string> member;
      for (const auto& [name, flags] : sets)
        if (flags[c] != 0) member.push_back(name);
      if (!member.empty()) {
        const auto [found, isNew] = groups.try_emplace(member, 0);
        if (isNew) found->second = builder_.addGroup(member);
        group = found->second;
      }
      builder_.addElement(*known, ids.empty() ? static_cast<std::int64_t>(cellCount_) : ids[c], nodes, group,
                          cellCount_, order);
    }
  }

  std::string source_;
  std::string_view text_;
  FileCursor cursor_;
  MeshBuilder builder_;
  std::vector<Piece> pieces_;
  std::string compressor_;
  std::size_t wordBytes_ = 4;
  bool swap_ = false, rawAppended_ = false, deformedPoints_ = false;
  bool nodesHaveNumbers_ = false, elementsHaveNumbers_ = false;
  std::vector<Array> fieldData_;
  std::string_view appended_;
  std::vector<std::int64_t> nodeIds_;
  std::size_t cellCount_ = 0, flat_ = 0;
};

}  // namespace

std::string fieldChoice(const std::string& vectors) {
  return vectors.empty() ? "there is no field of three components at the points"
                         : "fields of three components at the points: " + vectors;
}
std::string noField(const std::string& name, const std::string& vectors) {
  return joinText("no field ", detail::quoted(name), "; ", fieldChoice(vectors));
}

namespace {

/// Takes what the file says of its nodes and elements.
void takeVtuFields(VtuReader& reader, ResultFrame& frame, const std::string& source, Notes* notes) {
  for (const FrameField& field : reader.cellFields(resultFields))
    takeCellField(frame, field.name, field.values, source, notes);
  takeNodeNumbers(frame, reader.pointNumbers(nodeNumberField), source, notes);
}

}  // namespace

Mesh readVtu(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  VtuReader reader(path.string(), text);
  ResultFrame frame;
  frame.mesh = reader.read(notes, problems);
  if (mayTellOfElements(text)) takeVtuFields(reader, frame, path.string(), notes);
  return standingMesh(std::move(frame), path.string(), notes);
}

MeshState readVtuState(const std::filesystem::path& path, const std::string& text, const std::string& displacement,
                       Notes* notes) {
  VtuReader reader(path.string(), text);
  ResultFrame frame;
  frame.mesh = reader.read(notes, nullptr);
  if (mayTellOfElements(text)) takeVtuFields(reader, frame, path.string(), notes);
  MeshState state{standingMesh(std::move(frame), path.string(), notes), {}};
  const NodeVectors u = reader.displacement(displacement, state.mesh.nodeCount());
  state.x = reader.deformedPoints() ? state.mesh.X : NodeVectors(state.mesh.X + u);
  if (reader.deformedPoints()) state.mesh.X -= u;
  return state;
}

ResultFrame readVtuResult(const std::filesystem::path& path, const std::string& text,
                          const std::vector<std::string>& names, Notes* notes) {
  VtuReader reader(path.string(), text);
  ResultFrame frame;
  Problems problems;  // points that are not finite are the audit's business
  frame.mesh = reader.read(notes, &problems);
  requireElements(problems);
  frame.vectors = reader.vectorNames();
  frame.deformedPoints = reader.deformedPoints();
  frame.nodesHaveNumbers = reader.nodesHaveNumbers();
  frame.elementsHaveNumbers = reader.elementsHaveNumbers();
  for (const std::string& name : names)
    if (reader.hasVectors(name)) {
      frame.displacement = name;
      frame.u = reader.vectors(name, frame.mesh.nodeCount());
      break;
    }
  takeVtuFields(reader, frame, path.string(), notes);
  const std::map<std::string, double> numbers = reader.numbers();
  for (const char* name : {"TimeValue", "TIME", "time"})
    if (const auto known = numbers.find(name); known != numbers.end()) frame.time = known->second;
  if (const auto known = numbers.lower_bound("step ("); known != numbers.end() && known->first.starts_with("step ("))
    frame.step = known->second;  // "step (s)" of a frame of ringwatch, in its unit of time
  return frame;
}

}  // namespace ringwatch::detail

namespace ringwatch {

VtuFrame readVtuFrame(const std::filesystem::path& path) {
  const std::string text = detail::readWholeFile(path);
  detail::VtuReader reader(path.string(), text);
  VtuFrame frame;
  frame.mesh = reader.read(nullptr, nullptr);
  frame.cells = reader.cellFields();
  frame.values = reader.numbers();
  return frame;
}

}  // namespace ringwatch
