#include <algorithm>
#include <charconv>
#include <fstream>
#include <numeric>
#include <set>
#include <unordered_set>

#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

/// Numbers that a file may hold: the mesh's own when they are all ≥ 1 and differ, else 1, 2, …
std::vector<std::int64_t> fileNumbers(const std::vector<std::int64_t>& ids, std::size_t count, std::int64_t limit) {
  std::unordered_set<std::int64_t> seen;
  const bool usable = ids.size() == count && std::all_of(ids.begin(), ids.end(), [&](std::int64_t id) {
                        return id >= 1 && id <= limit && seen.insert(id).second;
                      });
  if (usable) return ids;
  std::vector<std::int64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::int64_t{1});
  return numbers;
}

/// Text, or raw values in a binary file. Line ends and blanks exist in the text only.
class Out {
 public:
  explicit Out(bool binary) : binary_(binary) {}
  std::string content;
  void text(std::string_view t) { content += t; }
  void int32(std::int64_t value) { binary_ ? raw(static_cast<std::int32_t>(value)) : number(value); }
  void int64(std::int64_t value) { binary_ ? raw(value) : number(value); }
  void real(double value) { binary_ ? raw(value) : number(value); }
  void endLine() {
    if (binary_) return;
    content.back() = '\n';
  }

 private:
  template <class T>
  void raw(T value) {
    content.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  template <class T>
  void number(T value) {
    char buffer[40];
    content.append(buffer,
                   std::to_chars(buffer, buffer + sizeof buffer, value).ptr);  // shortest text that reads back the same
    content += ' ';
  }
  bool binary_;
};

struct Physical {
  int dimension;
  std::int64_t tag;
  std::string name;
};

constexpr int gmshPoint = 15;  // gmsh's type of an element of one node

/// A mesh as an .msh file of either version tells it: sets are physical groups, of elements and of points.
struct Content {
  const Mesh& mesh;
  const std::filesystem::path& path;
  std::vector<Physical> physicals;
  std::vector<std::vector<std::vector<std::int64_t>>> elementTags;  // of the sets of each element, by block
  std::vector<std::vector<std::int64_t>> nodeTags;                  // of the sets of each node
  std::vector<std::int64_t> nodeNumbers, elementNumbers;            // in the file
  std::int64_t nextNumber;                                          // of an element, for points

  Content(const Mesh& mesh, const std::filesystem::path& path, std::int64_t largestNumber);
  std::vector<std::size_t> fileOrder(const ElementInfo& info) const;

 private:
  void addPhysical(int dimension, const std::string& name);
};

Content::Content(const Mesh& of, const std::filesystem::path& to, std::int64_t largestNumber)
    : mesh(of), path(to), nodeTags(of.nodeCount()) {
  for (const MeshBlock& block : mesh.blocks) elementTags.emplace_back(block.elementCount());
  // Small sets first, so that the first tag of an element, the only one of MSH 2.2, says the most.
  std::vector<const std::pair<const std::string, std::vector<ElementRef>>*> ordered;
  for (const auto& set : mesh.elementSets) ordered.push_back(&set);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](auto* a, auto* b) { return a->second.size() < b->second.size(); });
  for (const auto* set : ordered) {
    addPhysical(3, set->first);
    const std::int64_t tag = physicals.back().tag;
    for (const ElementRef& ref : set->second) {
      auto& tags = elementTags.at(ref.block).at(ref.element);
      if (tags.empty() || tags.back() != tag) tags.push_back(tag);
    }
  }
  for (const auto& [name, nodes] : mesh.nodeSets) {
    addPhysical(0, name);
    for (const std::int32_t n : nodes) nodeTags.at(n).push_back(physicals.back().tag);
  }
  nodeNumbers = fileNumbers(mesh.nodeIds, mesh.nodeCount(), largestNumber);
  std::vector<std::int64_t> ids;
  for (const MeshBlock& block : mesh.blocks) ids.insert(ids.end(), block.ids.begin(), block.ids.end());
  elementNumbers = fileNumbers(ids, mesh.elementCount(), largestNumber);
  nextNumber = elementNumbers.empty() ? 1 : *std::max_element(elementNumbers.begin(), elementNumbers.end()) + 1;
}

void Content::addPhysical(int dimension, const std::string& name) {
  if (name.find_first_of("\"\r\n") != std::string::npos)
    throw InputError("cannot write " + path.string() + ": the set name " + detail::quoted(name) +
                     " holds a quote or line end");
  physicals.push_back({dimension, static_cast<std::int64_t>(physicals.size()) + 1, name});
}

/// Our node at each place of gmsh's order.
std::vector<std::size_t> Content::fileOrder(const ElementInfo& info) const {
  if (info.gmshType == 0)
    throw InputError(joinText("cannot write ", path.string(), ": gmsh has no element like ", info.name));
  std::vector<std::size_t> order(info.nodes);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!info.gmshOrder.empty())
    for (std::size_t i = 0; i < order.size(); ++i) order[info.gmshOrder[i]] = i;
  return order;
}

void writeHead(const Content& content, bool version4, bool binary, Out& out) {
  out.text(joinText("$MeshFormat\n", version4 ? "4.1" : "2.2", binary ? " 1" : " 0", " 8\n"));
  if (binary) {
    out.int32(1);
    out.text("\n");
  }
  out.text("$EndMeshFormat\n");
  if (content.physicals.empty()) return;
  out.text(joinText("$PhysicalNames\n", content.physicals.size(), "\n"));
  for (const Physical& p : content.physicals) out.text(joinText(p.dimension, " ", p.tag, " \"", p.name, "\"\n"));
  out.text("$EndPhysicalNames\n");
}

/// Nodes and elements of version 2.2. An element has the first of its tags; a node in several sets is a point of each.
void writeVersion2(Content& content, bool binary, Out& out) {
  const Mesh& mesh = content.mesh;
  out.text(joinText("$Nodes\n", mesh.nodeCount(), "\n"));
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
    out.int32(content.nodeNumbers[n]);
    for (int k = 0; k < 3; ++k) out.real(mesh.X(k, n));
    out.endLine();
  }
  if (binary) out.text("\n");
  std::size_t points = 0;
  for (const auto& tags : content.nodeTags) points += tags.size();
  out.text(joinText("$EndNodes\n$Elements\n", mesh.elementCount() + points, "\n"));
  const auto begin = [&](int type, std::size_t count) {
    if (!binary || count == 0) return;
    out.int32(type);
    out.int32(count);
    out.int32(2);
  };
  const auto element = [&](std::int64_t id, int type, std::int64_t physical, std::int64_t entity) {
    out.int32(id);
    if (!binary) {
      out.int32(type);
      out.int32(2);
    }
    out.int32(physical);
    out.int32(entity);
  };
  std::size_t running = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& block = mesh.blocks[b];
    const ElementInfo& info = elementInfo(block.type);
    const auto order = content.fileOrder(info);
    begin(info.gmshType, block.elementCount());
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const auto& tags = content.elementTags[b][e];
      element(content.elementNumbers[running++], info.gmshType, tags.empty() ? 0 : tags[0], 1);
      for (const std::size_t a : order) out.int32(content.nodeNumbers[block.element(e)[a]]);
      out.endLine();
    }
  }
  begin(gmshPoint, points);
  for (std::size_t n = 0; n < content.nodeTags.size(); ++n)
    for (const std::int64_t tag : content.nodeTags[n]) {
      element(content.nextNumber++, gmshPoint, tag, static_cast<std::int64_t>(n) + 1);
      out.int32(content.nodeNumbers[n]);
      out.endLine();
    }
}

/// The entities of version 4.1. One is a combination of sets: that is how an element belongs to several groups.
struct Entities {
  std::map<std::vector<std::int64_t>, std::int64_t> volumes, points;  // tags of the sets -> number
  std::map<std::vector<std::int64_t>, std::vector<std::size_t>> nodesOf;

  explicit Entities(const Content& content) {
    for (const auto& block : content.elementTags)
      for (const auto& tags : block) volumes.try_emplace(tags, static_cast<std::int64_t>(volumes.size()) + 1);
    for (std::size_t n = 0; n < content.nodeTags.size(); ++n)
      if (!content.nodeTags[n].empty()) {
        points.try_emplace(content.nodeTags[n], static_cast<std::int64_t>(points.size()) + 1);
        nodesOf[content.nodeTags[n]].push_back(n);
      }
  }
  void write(const Mesh& mesh, bool binary, Out& out) const;
};

void Entities::write(const Mesh& mesh, bool binary, Out& out) const {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
  if (mesh.nodeCount() > 0) low = mesh.X.rowwise().minCoeff(), high = mesh.X.rowwise().maxCoeff();
  out.text("$Entities\n");
  out.int64(points.size());
  out.int64(0);
  out.int64(0);
  out.int64(volumes.size());
  out.endLine();
  const auto groups = [&](const std::vector<std::int64_t>& tags) {
    out.int64(tags.size());
    for (const std::int64_t t : tags) out.int32(t);
  };
  for (const auto& [tags, entity] : points) {
    out.int32(entity);
    for (int k = 0; k < 3; ++k) out.real(mesh.X(k, nodesOf.at(tags)[0]));
    groups(tags);
    out.endLine();
  }
  for (const auto& [tags, entity] : volumes) {
    out.int32(entity);
    for (int k = 0; k < 3; ++k) out.real(low[k]);
    for (int k = 0; k < 3; ++k) out.real(high[k]);
    groups(tags);
    out.int64(0);
    out.endLine();
  }
  if (binary) out.text("\n");
  out.text("$EndEntities\n");
}

/// Least and largest of the numbers, the latter at least `extra`.
void writeRange(const std::vector<std::int64_t>& numbers, std::int64_t extra, Out& out) {
  out.int64(numbers.empty() ? 0 : *std::min_element(numbers.begin(), numbers.end()));
  out.int64(std::max(extra, numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end())));
  out.endLine();
}

void writeNodes4(const Content& content, bool binary, Out& out) {
  const Mesh& mesh = content.mesh;
  out.text("$Nodes\n");
  out.int64(1);
  out.int64(mesh.nodeCount());
  writeRange(content.nodeNumbers, 0, out);
  out.int32(3);
  out.int32(1);
  out.int32(0);
  out.int64(mesh.nodeCount());
  out.endLine();
  for (const std::int64_t number : content.nodeNumbers) {
    out.int64(number);
    out.endLine();
  }
  for (Eigen::Index n = 0; n < mesh.X.cols(); ++n) {
    for (int k = 0; k < 3; ++k) out.real(mesh.X(k, n));
    out.endLine();
  }
  if (binary) out.text("\n");
  out.text("$EndNodes\n");
}

void writeElements4(Content& content, const Entities& entities, Out& out) {
  const Mesh& mesh = content.mesh;
  // Runs of elements of one block and entity, in mesh order, so that reading gives the same order back.
  struct Run {
    std::size_t block, begin, end;
    std::int64_t entity;
  };
  std::vector<Run> runs;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (std::size_t e = 0; e < content.elementTags[b].size(); ++e) {
      const std::int64_t entity = entities.volumes.at(content.elementTags[b][e]);
      if (!runs.empty() && runs.back().block == b && runs.back().entity == entity)
        runs.back().end = e + 1;
      else
        runs.push_back({b, e, e + 1, entity});
    }
  std::size_t points = 0;
  for (const auto& [tags, nodes] : entities.nodesOf) points += nodes.size();
  out.text("$Elements\n");
  out.int64(runs.size() + entities.points.size());
  out.int64(mesh.elementCount() + points);
  writeRange(content.elementNumbers, content.nextNumber + static_cast<std::int64_t>(points) - 1, out);
  std::size_t running = 0;
  for (const Run& run : runs) {
    const MeshBlock& block = mesh.blocks[run.block];
    const ElementInfo& info = elementInfo(block.type);
    const auto order = content.fileOrder(info);
    out.int32(3);
    out.int32(run.entity);
    out.int32(info.gmshType);
    out.int64(run.end - run.begin);
    out.endLine();
    for (std::size_t e = run.begin; e < run.end; ++e) {
      out.int64(content.elementNumbers[running++]);
      for (const std::size_t a : order) out.int64(content.nodeNumbers[block.element(e)[a]]);
      out.endLine();
    }
  }
  for (const auto& [tags, entity] : entities.points) {
    const std::vector<std::size_t>& nodes = entities.nodesOf.at(tags);
    out.int32(0);
    out.int32(entity);
    out.int32(gmshPoint);
    out.int64(nodes.size());
    out.endLine();
    for (const std::size_t n : nodes) {
      out.int64(content.nextNumber++);
      out.int64(content.nodeNumbers[n]);
      out.endLine();
    }
  }
}

}  // namespace

void writeMsh(const Mesh& mesh, const std::filesystem::path& path, bool version4, bool binary) {
  Content content(
      mesh, path,
      version4 ? std::numeric_limits<std::int64_t>::max() / 2 : std::numeric_limits<std::int32_t>::max() / 2);
  Out out(binary);
  writeHead(content, version4, binary, out);
  if (version4) {
    const Entities entities(content);
    entities.write(mesh, binary, out);
    writeNodes4(content, binary, out);
    writeElements4(content, entities, out);
  } else {
    writeVersion2(content, binary, out);
  }
  if (binary) out.text("\n");
  out.text("$EndElements\n");
  writeFileAtomically(path, out.content);
}

}  // namespace ringwatch::detail
