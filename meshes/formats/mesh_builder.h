#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch::detail {

/// An element type of a mesh file.
struct FileElement {
  int gmshType;
  std::string_view shape;
  int dimension;
  int nodes;
  int vtkCellType;

  std::string name() const { return joinText(shape, nodes); }  ///< "hex8"
};
/// nullptr for a type that is not known.
const FileElement* findGmshElement(int gmshType);
const FileElement* findVtkElement(int vtkCellType);
/// False for points, lines and surfaces.
bool isVtkVolumeCell(int vtkCellType);

/// In which order a file has an element's nodes. ours: that of decks.
enum class NodeOrder { ours, gmsh, vtkWedge, vtkVoxel };
/// Ours is node vtkWedgeOrder[i] of VTK's linear wedge, and the other way round: the first triangle faces outward there
/// (vtkWedge.h, vtkCellSizeFilter) and inward here, as in gmsh and in decks, and in VTK's other wedges.
inline constexpr std::array<std::uint8_t, 6> vtkWedgeOrder{0, 2, 1, 3, 5, 4};
/// A cell of VTK. type: nullptr for one that is not known.
struct VtkCell {
  const FileElement* type;
  NodeOrder order = NodeOrder::ours;
};
VtkCell vtkCell(int vtkCellType, std::size_t nodes);

/// The element that the library or its user has for it; nullptr for none.
const ElementInfo* elementOf(const FileElement& type);

/// How many elements of a type a file has, and where the first one is.
struct FoundElements {
  const FileElement* type;
  std::size_t count;
  std::size_t firstPosition;
};
/// Throws InputError where the elements of a file are no mesh: volume elements that the library does not have, none, or
/// too many. Returns the number of elements of surfaces, lines and points. hint, leftOut: as MeshBuilder's.
std::size_t requireVolumes(std::span<const FoundElements> found, std::size_t nodes, const std::string& source,
                           const std::function<std::string(std::size_t position)>& where, const std::string& hint,
                           std::size_t leftOut = 0);
/// The note of these elements; empty without any.
std::vector<std::string> droppedNote(const std::string& source, std::size_t dropped);

/// Which volume elements with the nodes of one above are left out, so that this one belongs to the groups of both.
enum class Doubles {
  none,
  ofOtherGroups,  // with the nodes in the same order: the file names it once for each group
  all             // with the nodes in any order
};

/// Collects what a reader finds, with its position in the file, and makes the Mesh of it: numbers become indices,
/// volume elements become blocks in order of first appearance, groups become sets. Throws InputError, with the
/// position, on repeated or missing nodes, coordinates that are not finite, and volume elements that the library does
/// not have.
class MeshBuilder {
 public:
  using Where = std::function<std::string(std::size_t position)>;
  /// What a user of this format may do about a file without volume elements; added to the message.
  std::string noVolumeHint;
  /// Elements of surfaces, lines and points that the reader leaves out itself.
  std::size_t leftOut = 0;
  Doubles doubles = Doubles::none;

  MeshBuilder(std::string source, Where nodeWhere, Where elementWhere)
      : source_(std::move(source)), nodeWhere_(std::move(nodeWhere)), elementWhere_(std::move(elementWhere)) {}

  void addNode(std::int64_t id, double x, double y, double z, std::size_t position) {
    nodeIds_.push_back(id);
    coordinates_.insert(coordinates_.end(), {x, y, z});
    nodePositions_.push_back(position);
  }
  std::size_t nodeCount() const { return nodeIds_.size(); }
  /// After finish(): the positions of the elements of each block.
  std::vector<std::vector<std::size_t>>& positions() { return positions_; }
  /// The names of each group.
  const std::vector<std::vector<std::string>>& groups() const { return groups_; }

  /// A new group (a combination of set names); -1 stands for none.
  int addGroup(std::vector<std::string> names) {
    sortUnique(names);  // two groups of a file may share a name
    groups_.push_back(std::move(names));
    return static_cast<int>(groups_.size()) - 1;
  }
  /// nodes: in the file's order. A linear element that holds a node several times becomes what is left of it: a
  /// hexahedron of six nodes a wedge. Of a hexahedron with nodes in its faces the first 20 nodes are kept, of a
  /// quadratic wedge or pyramid the corners. Elements of surfaces, lines and points leave only their nodes in the sets
  /// of their group.
  void addElement(const FileElement& type, std::int64_t id, const std::int64_t* nodes, int group, std::size_t position,
                  NodeOrder order = NodeOrder::ours);
  void addToNodeSet(const std::string& name, std::int64_t nodeId) { nodeSetIds_[name].push_back(nodeId); }

  /// problems: when given, missing nodes (index -1 in the mesh) and non-finite coordinates are put there instead of
  /// thrown.
  Mesh finish(std::vector<std::string>* notes, std::vector<MeshProblem>* problems);

 private:
  struct Elements {
    const FileElement* type;
    const ElementInfo* info;  // nullptr: not a volume element, or not one that the library has
    std::vector<std::int64_t> nodes, ids;
    std::vector<int> groups;
    std::vector<std::size_t> positions;
    std::size_t count = 0;
  };
  Elements& listOf(const FileElement& type);
  std::size_t leaveDoublesOut(Elements& list);
  int groupOfBoth(int one, int other);
  void requireNoneHangs() const;

  std::string source_;
  Where nodeWhere_, elementWhere_;
  std::vector<std::int64_t> nodeIds_;
  std::vector<double> coordinates_;
  std::vector<std::size_t> nodePositions_;
  std::vector<std::vector<std::string>> groups_;
  std::vector<Elements> elements_;
  std::map<std::string, std::vector<std::int64_t>> nodeSetIds_;
  std::vector<std::vector<std::size_t>> positions_;
  /// Numbers of elements by their type in the file and the one that is left.
  std::map<std::pair<std::string, std::string>, std::size_t> collapsed_;
  std::map<std::pair<int, int>, int> bothGroups_;
  std::map<std::pair<std::string, std::string>, std::size_t> reduced_;  // likewise
  /// Nodes that are left out of elements which become linear, with one of these.
  struct OfReduced {
    std::string type;
    std::int64_t id;
    std::size_t position;
  };
  std::unordered_map<std::int64_t, OfReduced> hanging_;
};

}  // namespace ringwatch::detail
