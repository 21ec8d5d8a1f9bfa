#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>

namespace ringwatch::detail {

/// Where the nodes and elements of an MSH 4.1 binary file are, so that a process can read some of them. As large as the
/// file has blocks of entities and groups, whatever it has of nodes and elements. Positions are bytes of the file.
struct MshOutline {
  /// Nodes of one entity, whose coordinates lie behind all of their numbers.
  struct Nodes {
    std::int64_t first, count;         // counted through the file
    std::size_t numbers, coordinates;  // positions: 8 bytes a number, coordinateBytes a node
    std::size_t coordinateBytes;       // three coordinates of 8 bytes, and parametric ones behind them
  };
  /// Elements of one entity: a number and the numbers of the nodes, 8 bytes each.
  struct Elements {
    const FileElement* type;
    std::int64_t count;
    int group;  // of groups; -1 for none
    std::size_t position;
    std::size_t bytesEach() const { return 8 * (1 + static_cast<std::size_t>(type->nodes)); }
  };

  bool swapBytes = false;  // the file comes from a machine of the other byte order
  std::int64_t nodeCount = 0;
  std::vector<Nodes> nodes;
  std::vector<Elements> elements;                // in the file's order, none of them empty
  std::vector<std::vector<std::string>> groups;  // names of the sets that an element of the group goes to, ascending
  std::vector<std::string> notes;                // as readMesh has them

  /// The raw number at a position of the file's bytes.
  template <class T>
  T at(std::string_view bytes, std::size_t position) const {
    return rawAt<T>(bytes, position, swapBytes);
  }
  /// "file: byte n"
  static std::string where(const std::string& source, std::size_t position) {
    return joinText(source, ": byte ", position);
  }
};

/// Whether a file begins as MSH 4.1 binary does. False where it cannot be read.
bool isMshBinary4(const std::filesystem::path& path);

/// The outline of a file's bytes. Throws InputError as readMesh does for all that can be told without the nodes and the
/// elements: the file is cut short, sections or counts do not fit, or elements are not supported.
MshOutline outlineMsh(const std::filesystem::path& path, std::string_view bytes);

}  // namespace ringwatch::detail
