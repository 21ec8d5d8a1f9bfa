#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/formats/msh_outline.h>

namespace ringwatch::detail {
namespace {

constexpr const char* dimensionNames[] = {"point", "curve", "surface", "volume"};

/// MSH 2.x, 4.0 and 4.1, as "MSH file format" of the gmsh manual has them.
class MshReader {
 public:
  MshReader(const std::string& source, std::string_view text)
      : cursor_(text, source),
        source_(source),
        builder_(
            source, [this](std::size_t p) { return cursor_.where(p); },
            [this](std::size_t p) { return cursor_.where(p); }) {
    builder_.noVolumeHint =
        "; where there are physical groups, gmsh saves those only: add a Physical Volume, or set Mesh.SaveAll = 1";
  }

  Mesh read(Notes* notes, Problems* problems) {
    readSections();
    return builder_.finish(notes, problems);
  }

  /// Of an MSH 4.1 binary file.
  MshOutline outline() {
    MshOutline outline;
    outline_ = &outline;
    readSections();
    outline.swapBytes = cursor_.swapBytes;
    outline.groups = builder_.groups();
    std::vector<FoundElements> found;
    for (const MshOutline::Elements& run : outline.elements) {
      const auto count = static_cast<std::size_t>(run.count);
      const auto known = std::ranges::find(found, run.type, &FoundElements::type);
      if (known == found.end())
        found.push_back({run.type, count, run.position});
      else
        known->count += count;
    }
    const std::size_t dropped = requireVolumes(
        found, static_cast<std::size_t>(outline.nodeCount), source_,
        [this](std::size_t position) { return cursor_.where(position); }, builder_.noVolumeHint);
    for (std::string& note : droppedNote(source_, dropped)) outline.notes.push_back(std::move(note));
    return outline;
  }

 private:
  void readSections() {
    readFormat();
    bool nodes = false, elements = false;
    while (cursor_.skipSpace()) {
      const std::size_t begin = cursor_.position();
      const std::string_view section = cursor_.line("a section");
      if (section.empty() || section[0] != '$' || section.rfind("$End", 0) == 0)
        cursor_.failAt(begin,
                       joinText("found ", detail::quoted(section), " where a section such as $Nodes is expected"));
      if (section == "$PhysicalNames") {
        readPhysicalNames();
      } else if (section == "$Entities" && version_ >= 4) {
        readEntities(false);
      } else if (section == "$PartitionedEntities" && version_ >= 4) {
        readEntities(true);
      } else if (section == "$Nodes" || (section == "$ParametricNodes" && version_ < 4)) {
        if (nodes) cursor_.failAt(begin, "a second $Nodes section; there must be one");
        nodes = true;
        version_ < 4 ? readNodes2(section == "$ParametricNodes") : readNodes4();
      } else if (section == "$Elements") {
        if (elements) cursor_.failAt(begin, "a second $Elements section; there must be one");
        elements = true;
        version_ < 4 ? readElements2() : readElements4();
      } else {
        skipSection(section, begin);
        continue;
      }
      cursor_.expectLine(joinText("$End", section.substr(1)));
    }
    if (!nodes)
      throw InputError(source_ + ": the file ends without a $Nodes section; is it cut short, or was nothing meshed?");
    if (!elements) throw InputError(source_ + ": the file ends without an $Elements section; is it cut short?");
  }

  void readFormat() {
    cursor_.skipSpace();
    for (std::size_t at = cursor_.position(); cursor_.startsWith("$Comments"); at = cursor_.position()) {
      skipSection(cursor_.line("a section"), at);
      cursor_.skipSpace();
    }
    cursor_.expectLine("$MeshFormat");
    cursor_.beginRecord("the MSH version");
    const std::size_t begin = cursor_.position();
    version_ = cursor_.numberText("the MSH version");
    const std::int64_t fileType = cursor_.integerText("the file type");
    const std::int64_t dataSize = cursor_.integerText("the data size");
    if (!((version_ >= 2 && version_ < 3) || version_ == 4.0 || version_ == 4.1))
      cursor_.failAt(begin, joinText("MSH version ", version_, " is not supported; 2.2 and 4.1 are"));
    if (fileType != 0 && fileType != 1)
      cursor_.failAt(begin, joinText("the file type is ", fileType, "; it must be 0 (text) or 1 (binary)"));
    if (dataSize != 8) cursor_.failAt(begin, joinText("the data size is ", dataSize, "; it must be 8"));
    cursor_.endRecord();
    if (version_ < 4) builder_.doubles = Doubles::ofOtherGroups;
    if (fileType == 1) {
      if (version_ == 4.0) cursor_.failAt(begin, "binary MSH 4.0 is not supported; save it as 4.1 or 2.2");
      if (cursor_.remaining() > 0) cursor_.skipOne();
      cursor_.binary = true;
      const auto one = cursor_.raw<std::int32_t>("the byte order mark");
      if (one == 0x01000000)
        cursor_.swapBytes = true;
      else if (one != 1)
        cursor_.fail(joinText("the byte order mark is ", one, "; it must be the integer 1"));
    }
    cursor_.expectLine("$EndMeshFormat");
  }

  void skipSection(std::string_view section, std::size_t begin) {
    const std::string end = joinText("$End", section.substr(1));
    while (cursor_.skipSpace()) {
      if (cursor_.binary ? cursor_.skipTo(end) : true)
        if (cursor_.line(end) == end) return;
    }
    cursor_.failAt(begin, joinText("section ", detail::quoted(section), " has no ", detail::quoted(end),
                                   "; is the file cut short?"));
  }

  void readPhysicalNames() {
    // Text also in binary files.
    cursor_.skipSpace();
    const std::size_t begin = cursor_.position();
    const std::size_t count =
        cursor_.checkedCount(cursor_.integerText("the number of physical names"), 7, "physical names", begin);
    for (std::size_t i = 0; i < count; ++i) {
      if (!cursor_.skipSpace()) cursor_.fail("the file ends within the physical names; is it cut short?");
      const std::size_t at = cursor_.position();
      const std::int64_t dimension = cursor_.integerText("the dimension of a physical name");
      const std::int64_t tag = cursor_.integerText("the number of a physical name");
      if (dimension < 0 || dimension > 3)
        cursor_.failAt(at, joinText("the dimension of a physical name is ", dimension, "; it must be 0 to 3"));
      const std::string_view rest = cursor_.line("a physical name in quotes");
      const std::size_t open = rest.find('"'), close = rest.rfind('"');
      if (open == std::string_view::npos || close == open)
        cursor_.failAt(at, joinText("the physical name is ", detail::quoted(rest), "; it must be in double quotes"));
      names_[{static_cast<int>(dimension), tag}] = std::string(rest.substr(open + 1, close - open - 1));
    }
  }

  std::string physicalName(int dimension, std::int64_t tag) const {
    const auto found = names_.find({dimension, tag});
    return found != names_.end() ? found->second : joinText(dimensionNames[dimension], "-", tag);
  }

  /// partitioned: the entities are parts of those of $Entities, whose elements belong to the parts, or lie between
  /// parts and have the groups of what is cut there, which are not theirs.
  void readEntities(bool partitioned) {
    if (partitioned) {
      cursor_.beginRecord("the number of partitions");
      cursor_.int64("the number of partitions");
      cursor_.beginRecord("the number of ghost entities");
      const std::size_t at = cursor_.position();
      const std::size_t ghosts =
          cursor_.checkedCount(cursor_.int64("the number of ghost entities"), 4, "ghost entities", at);
      for (std::size_t i = 0; i < ghosts; ++i) {
        cursor_.beginRecord("a ghost entity");
        cursor_.int32("the number of a ghost entity");
        cursor_.int32("the partition of a ghost entity");
      }
    }
    std::size_t counts[4];
    cursor_.beginRecord("the numbers of entities");
    for (int d = 0; d < 4; ++d) {
      const std::size_t at = cursor_.position();
      counts[d] = cursor_.checkedCount(cursor_.int64("a number of entities"), 8, "entities", at);
    }
    cursor_.endRecord();
    for (int d = 0; d < 4; ++d)
      for (std::size_t i = 0; i < counts[d]; ++i) {
        cursor_.beginRecord("an entity");
        const std::int64_t tag = cursor_.int32("the number of an entity");
        bool between = false;
        if (partitioned) {
          between = cursor_.int32("the dimension of a parent") != d;
          cursor_.int32("the number of a parent");
          const std::size_t where = cursor_.position();
          const std::size_t partitions =
              cursor_.checkedCount(cursor_.int64("the number of partitions"), 2, "partitions", where);
          for (std::size_t k = 0; k < partitions; ++k) cursor_.int32("a partition");
        }
        for (int k = 0; k < (d == 0 && version_ > 4.0 ? 3 : 6); ++k) cursor_.real("a coordinate of an entity");
        std::size_t at = cursor_.position();
        const std::size_t groups =
            cursor_.checkedCount(cursor_.int64("the number of physical groups"), 2, "physical groups", at);
        std::vector<std::string> names;
        for (std::size_t g = 0; g < groups; ++g) {
          // The sign of a group's number tells an orientation, which volumes and node sets do not have.
          names.push_back(physicalName(d, std::abs(cursor_.int32("the number of a physical group"))));
        }
        if (d > 0) {
          at = cursor_.position();
          const std::size_t bounds =
              cursor_.checkedCount(cursor_.int64("the number of bounding entities"), 2, "bounding entities", at);
          for (std::size_t k = 0; k < bounds; ++k) cursor_.int32("the number of a bounding entity");
        }
        cursor_.endRecord();
        if (!names.empty() && !between) entityGroups_[{d, tag}] = builder_.addGroup(std::move(names));
      }
  }

  std::int64_t nodeNumber(std::int64_t id, std::size_t at) const {
    if (id < 0) cursor_.failAt(at, joinText("the number of a node is ", id, "; it must not be negative"));
    return id;
  }

  /// A count on a line of its own, text also in binary files.
  std::size_t countLine(std::size_t bytesEach, std::string_view what) {
    cursor_.skipSpace();
    const std::size_t at = cursor_.position();
    const std::int64_t value = cursor_.integerText(joinText("the number of ", what));
    if (!cursor_.atLineEnd()) cursor_.fail(joinText("unexpected text after the number of ", what));
    if (cursor_.remaining() > 0) cursor_.skipOne();
    return cursor_.checkedCount(value, bytesEach, what, at);
  }

  void readNodes2(bool parametric) {
    const std::size_t count = countLine(cursor_.binary ? 28 : 8, "nodes");
    for (std::size_t i = 0; i < count; ++i) {
      cursor_.beginRecord("a node");
      const std::size_t at = cursor_.position();
      const std::int64_t id = nodeNumber(cursor_.int32("the number of a node"), at);
      const double x = cursor_.real("coordinate x"), y = cursor_.real("coordinate y"), z = cursor_.real("coordinate z");
      builder_.addNode(id, x, y, z, at);
      if (parametric) {
        const std::int64_t dimension = cursor_.int32("the dimension of an entity");
        cursor_.int32("the number of an entity");
        const std::int64_t own = dimension == 1 || dimension == 2 ? dimension : 0;
        for (std::int64_t k = 0; k < own; ++k) cursor_.real("a parametric coordinate");
      }
      cursor_.endRecord();
    }
  }

  void readNodes4() {
    cursor_.beginRecord("the numbers of nodes");
    const std::size_t begin = cursor_.position();
    const std::size_t blocks =
        cursor_.checkedCount(cursor_.int64("the number of node blocks"), 7, "node blocks", begin);
    const std::int64_t total = cursor_.int64("the number of nodes");
    cursor_.checkedCount(total, cursor_.binary ? 32 : 8, "nodes", begin);
    if (version_ > 4.0) {
      cursor_.int64("the smallest node number");
      cursor_.int64("the largest node number");
    }
    cursor_.endRecord();
    std::vector<std::pair<std::int64_t, std::size_t>> tags;
    for (std::size_t b = 0; b < blocks; ++b) {
      cursor_.beginRecord("a node block");
      const std::size_t at = cursor_.position();
      std::int64_t dimension = cursor_.int32("the dimension of an entity");
      std::int64_t entity = cursor_.int32("the number of an entity");
      if (version_ == 4.0) std::swap(dimension, entity);
      const bool parametric = cursor_.int32("the parametric flag") != 0;
      if (dimension < 0 || dimension > 3)
        cursor_.failAt(at, joinText("the dimension of an entity is ", dimension, "; it must be 0 to 3"));
      const std::int64_t announced = cursor_.int64("the number of nodes of a block");
      const std::size_t count = cursor_.checkedCount(announced, cursor_.binary ? 32 : 7, "nodes of a block", at);
      cursor_.endRecord();
      if (outline_ != nullptr) {
        const std::size_t bytesEach = sizeof(double) * (parametric ? 3 + static_cast<std::size_t>(dimension) : 3);
        const std::size_t numbers = cursor_.position();
        cursor_.skip(count, sizeof(std::int64_t), "the number of a node");
        outline_->nodes.push_back({outline_->nodeCount, announced, numbers, cursor_.position(), bytesEach});
        cursor_.skip(count, bytesEach, "a coordinate");
        outline_->nodeCount += announced;
        continue;
      }
      const auto coordinates = [&](std::int64_t id, std::size_t where) {
        const double x = cursor_.real("coordinate x"), y = cursor_.real("coordinate y"),
                     z = cursor_.real("coordinate z");
        if (parametric)
          for (std::int64_t k = 0; k < dimension; ++k) cursor_.real("a parametric coordinate");
        cursor_.endRecord();
        builder_.addNode(id, x, y, z, where);
      };
      if (version_ == 4.0) {
        for (std::size_t i = 0; i < count; ++i) {
          cursor_.beginRecord("a node");
          const std::size_t where = cursor_.position();
          coordinates(nodeNumber(cursor_.int64("the number of a node"), where), where);
        }
        continue;
      }
      tags.clear();
      for (std::size_t i = 0; i < count; ++i) {
        cursor_.beginRecord("the number of a node");
        const std::size_t where = cursor_.position();
        tags.emplace_back(nodeNumber(cursor_.int64("the number of a node"), where), where);
      }
      cursor_.endRecord();  // lines of several numbers are taken
      for (std::size_t i = 0; i < count; ++i) {
        cursor_.beginRecord("the coordinates of a node");
        coordinates(tags[i].first, cursor_.position());
      }
    }
    const std::int64_t found = outline_ ? outline_->nodeCount : static_cast<std::int64_t>(builder_.nodeCount());
    if (found != total)
      cursor_.failAt(begin, joinText("the number of nodes is ", total, ", but the blocks hold ", found));
  }

  const FileElement& elementType(std::int64_t type, std::size_t at) const {
    const FileElement* found = type > 0 && type < 1000 ? findGmshElement(static_cast<int>(type)) : nullptr;
    if (found == nullptr) cursor_.failAt(at, joinText("the element type is ", type, ", which is not known"));
    return *found;
  }

  int group2(int dimension, std::int64_t physical) {
    physical = std::abs(physical);
    if (physical == 0) return -1;
    const auto [found, isNew] = entityGroups_.try_emplace({dimension, physical}, 0);
    if (isNew) found->second = builder_.addGroup({physicalName(dimension, physical)});
    return found->second;
  }

  void readElements2() {
    const std::size_t count = countLine(cursor_.binary ? 8 : 5, "elements");
    std::int64_t nodes[125];
    const auto element = [&](const FileElement& type, std::int64_t id, std::int64_t tags, std::size_t at) {
      std::int64_t physical = 0;
      for (std::int64_t t = 0; t < tags; ++t) {
        const std::int64_t tag = cursor_.int32("a tag of an element");
        if (t == 0) physical = tag;
      }
      for (int a = 0; a < type.nodes; ++a) nodes[a] = cursor_.int32("the number of a node of an element");
      builder_.addElement(type, id, nodes, group2(type.dimension, physical), at, NodeOrder::gmsh);
    };
    const auto checkTags = [&](std::int64_t tags, std::size_t at) {
      if (tags < 0 || tags > 1000)
        cursor_.failAt(at, joinText("the number of tags is ", tags, "; it must be 0 to 1000"));
    };
    if (!cursor_.binary) {
      for (std::size_t i = 0; i < count; ++i) {
        cursor_.beginRecord("an element");
        const std::size_t at = cursor_.position();
        const std::int64_t id = cursor_.integerText("the number of an element");
        const FileElement& type = elementType(cursor_.integerText("the type of an element"), at);
        const std::int64_t tags = cursor_.integerText("the number of tags");
        checkTags(tags, at);
        element(type, id, tags, at);
        cursor_.endRecord();
      }
      return;
    }
    for (std::size_t done = 0; done < count;) {
      const std::size_t at = cursor_.position();
      const FileElement& type = elementType(cursor_.int32("the type of elements"), at);
      const std::int64_t follow = cursor_.int32("the number of elements that follow");
      const std::int64_t tags = cursor_.int32("the number of tags");
      checkTags(tags, at);
      if (follow <= 0 || static_cast<std::uint64_t>(follow) > count - done)
        cursor_.failAt(at,
                       joinText("the number of elements that follow is ", follow, "; it must be 1 to ", count - done));
      for (std::int64_t i = 0; i < follow; ++i) {
        const std::size_t where = cursor_.position();
        const std::int64_t id = cursor_.int32("the number of an element");
        element(type, id, tags, where);
      }
      done += static_cast<std::size_t>(follow);
    }
  }

  void readElements4() {
    cursor_.beginRecord("the numbers of elements");
    const std::size_t begin = cursor_.position();
    const std::size_t blocks =
        cursor_.checkedCount(cursor_.int64("the number of element blocks"), 7, "element blocks", begin);
    const std::int64_t total = cursor_.int64("the number of elements");
    cursor_.checkedCount(total, cursor_.binary ? 16 : 4, "elements", begin);
    if (version_ > 4.0) {
      cursor_.int64("the smallest element number");
      cursor_.int64("the largest element number");
    }
    cursor_.endRecord();
    std::int64_t nodes[125];
    std::int64_t found = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      cursor_.beginRecord("an element block");
      const std::size_t at = cursor_.position();
      std::int64_t dimension = cursor_.int32("the dimension of an entity");
      std::int64_t entity = cursor_.int32("the number of an entity");
      if (version_ == 4.0) std::swap(dimension, entity);
      const FileElement& type = elementType(cursor_.int32("the type of elements"), at);
      if (dimension != type.dimension)
        cursor_.failAt(at, joinText("the entity has dimension ", dimension, ", but its elements of type ", type.name(),
                                    " have ", type.dimension));
      const std::int64_t announced = cursor_.int64("the number of elements of a block");
      const std::size_t count = cursor_.checkedCount(announced, cursor_.binary ? 16 : 4, "elements of a block", at);
      cursor_.endRecord();
      const auto entry = entityGroups_.find({type.dimension, entity});
      const int group = entry == entityGroups_.end() ? -1 : entry->second;
      found += announced;
      if (outline_ != nullptr) {
        if (count == 0) continue;
        outline_->elements.push_back({&type, announced, group, cursor_.position()});
        cursor_.skip(count, outline_->elements.back().bytesEach(), "the number of a node of an element");
        continue;
      }
      for (std::size_t i = 0; i < count; ++i) {
        cursor_.beginRecord("an element");
        const std::size_t where = cursor_.position();
        const std::int64_t id = cursor_.int64("the number of an element");
        for (int a = 0; a < type.nodes; ++a) nodes[a] = cursor_.int64("the number of a node of an element");
        cursor_.endRecord();
        builder_.addElement(type, id, nodes, group, where, NodeOrder::gmsh);
      }
    }
    if (found != total)
      cursor_.failAt(begin, joinText("the number of elements is ", total, ", but the blocks hold ", found));
  }

  FileCursor cursor_;
  std::string source_;
  MeshBuilder builder_;
  MshOutline* outline_ = nullptr;  // nodes and elements are passed over, and where they are goes here
  double version_ = 0;
  std::map<std::pair<int, std::int64_t>, std::string> names_;
  std::map<std::pair<int, std::int64_t>, int> entityGroups_;  // by physical group in version 2, by entity in version 4
};

}  // namespace

Mesh readMsh(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  return MshReader(path.string(), text).read(notes, problems);
}

bool isMshBinary4(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::string text(64, '\0');  // more than the two lines that tell it
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  try {
    FileCursor cursor(text, path.string());
    cursor.expectLine("$MeshFormat");
    cursor.beginRecord("the MSH version");
    return cursor.numberText("the MSH version") == 4.1 && cursor.integerText("the file type") == 1;
  } catch (const InputError&) {
    return false;  // the reader says what is wrong
  }
}

MshOutline outlineMsh(const std::filesystem::path& path, std::string_view bytes) {
  return MshReader(path.string(), bytes).outline();
}

}  // namespace ringwatch::detail
