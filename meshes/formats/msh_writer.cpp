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

}  // namespace

void writeMsh(const Mesh& mesh, const std::filesystem::path& path, bool version4, bool binary) {
  std::vector<Physical> physicals;
  // Membership of each element and node: tags of its sets.
  std::vector<std::vector<std::vector<std::int64_t>>> elementTags;
  for (const MeshBlock& block : mesh.blocks) elementTags.emplace_back(block.elementCount());
  std::vector<std::vector<std::int64_t>> nodeTags(mesh.nodeCount());
  const auto checkName = [&](const std::string& name) {
    if (name.find_first_of("\"\r\n") != std::string::npos)
      throw InputError("cannot write " + path.string() + ": the set name " + detail::quoted(name) +
                       " holds a quote or line end");
  };
  std::int64_t tag = 0;
  // Small sets first, so that the first tag of an element, the only one of MSH 2.2, says the most.
  std::vector<const std::pair<const std::string, std::vector<ElementRef>>*> ordered;
  for (const auto& set : mesh.elementSets) ordered.push_back(&set);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](auto* a, auto* b) { return a->second.size() < b->second.size(); });
  for (const auto* set : ordered) {
    checkName(set->first);
    physicals.push_back({3, ++tag, set->first});
    for (const ElementRef& ref : set->second) {
      auto& tags = elementTags.at(static_cast<std::size_t>(ref.block)).at(static_cast<std::size_t>(ref.element));
      if (tags.empty() || tags.back() != tag) tags.push_back(tag);
    }
  }
  for (const auto& [name, nodes] : mesh.nodeSets) {
    checkName(name);
    physicals.push_back({0, ++tag, name});
    for (const std::int32_t n : nodes) nodeTags.at(static_cast<std::size_t>(n)).push_back(tag);
  }

  const std::int64_t limit =
      version4 ? std::numeric_limits<std::int64_t>::max() / 2 : std::numeric_limits<std::int32_t>::max() / 2;
  const std::vector<std::int64_t> nodeNumbers = fileNumbers(mesh.nodeIds, mesh.nodeCount(), limit);
  std::vector<std::int64_t> ids;
  for (const MeshBlock& block : mesh.blocks) ids.insert(ids.end(), block.ids.begin(), block.ids.end());
  const std::vector<std::int64_t> elementNumbers = fileNumbers(ids, mesh.elementCount(), limit);
  std::int64_t nextNumber =
      elementNumbers.empty() ? 1 : *std::max_element(elementNumbers.begin(), elementNumbers.end()) + 1;

  Out out(binary);
  out.text(joinText("$MeshFormat\n", version4 ? "4.1" : "2.2", binary ? " 1" : " 0", " 8\n"));
  if (binary) {
    out.int32(1);
    out.text("\n");
  }
  out.text("$EndMeshFormat\n");
  if (!physicals.empty()) {
    out.text(joinText("$PhysicalNames\n", physicals.size(), "\n"));
    for (const Physical& p : physicals) out.text(joinText(p.dimension, " ", p.tag, " \"", p.name, "\"\n"));
    out.text("$EndPhysicalNames\n");
  }
  const auto pointNodes = [&] {
    std::size_t total = 0;
    for (const auto& tags : nodeTags) total += version4 ? (tags.empty() ? 0 : 1) : tags.size();
    return total;
  }();
  const std::size_t total = mesh.elementCount() + pointNodes;
  const auto fileOrder = [&](const ElementInfo& info) {
    if (info.gmshType == 0)
      throw InputError(joinText("cannot write ", path.string(), ": gmsh has no element like ", info.name));
    std::vector<std::size_t> order(static_cast<std::size_t>(info.nodes));
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!info.gmshOrder.empty())
      for (std::size_t i = 0; i < order.size(); ++i) order[info.gmshOrder[i]] = i;
    return order;
  };

  if (!version4) {
    out.text(joinText("$Nodes\n", mesh.nodeCount(), "\n"));
    for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
      out.int32(nodeNumbers[n]);
      for (int k = 0; k < 3; ++k) out.real(mesh.X(k, static_cast<Eigen::Index>(n)));
      out.endLine();
    }
    if (binary) out.text("\n");
    out.text(joinText("$EndNodes\n$Elements\n", total, "\n"));
    const auto begin = [&](int type, std::size_t count) {
      if (!binary || count == 0) return;
      out.int32(type);
      out.int32(static_cast<std::int64_t>(count));
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
      const auto order = fileOrder(info);
      begin(info.gmshType, block.elementCount());
      for (std::size_t e = 0; e < block.elementCount(); ++e) {
        element(elementNumbers[running++], info.gmshType, elementTags[b][e].empty() ? 0 : elementTags[b][e][0], 1);
        for (const std::size_t a : order) out.int32(nodeNumbers[block.element(e)[a]]);
        out.endLine();
      }
    }
    begin(15, pointNodes);
    for (std::size_t n = 0; n < nodeTags.size(); ++n)
      for (const std::int64_t t : nodeTags[n]) {
        element(nextNumber++, 15, t, static_cast<std::int64_t>(n) + 1);
        out.int32(nodeNumbers[n]);
        out.endLine();
      }
  } else {
    // An entity a combination of sets: that is how MSH 4 lets an element belong to several groups.
    std::map<std::vector<std::int64_t>, std::int64_t> volumes, points;
    for (const auto& block : elementTags)
      for (const auto& tags : block) volumes.try_emplace(tags, static_cast<std::int64_t>(volumes.size()) + 1);
    std::map<std::vector<std::int64_t>, std::vector<std::size_t>> nodesOf;
    for (std::size_t n = 0; n < nodeTags.size(); ++n)
      if (!nodeTags[n].empty()) {
        points.try_emplace(nodeTags[n], static_cast<std::int64_t>(points.size()) + 1);
        nodesOf[nodeTags[n]].push_back(n);
      }
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
    if (mesh.nodeCount() > 0) low = mesh.X.rowwise().minCoeff(), high = mesh.X.rowwise().maxCoeff();
    out.text("$Entities\n");
    out.int64(static_cast<std::int64_t>(points.size()));
    out.int64(0);
    out.int64(0);
    out.int64(static_cast<std::int64_t>(volumes.size()));
    out.endLine();
    const auto groups = [&](const std::vector<std::int64_t>& tags) {
      out.int64(static_cast<std::int64_t>(tags.size()));
      for (const std::int64_t t : tags) out.int32(t);
    };
    for (const auto& [tags, entity] : points) {
      out.int32(entity);
      for (int k = 0; k < 3; ++k) out.real(mesh.X(k, static_cast<Eigen::Index>(nodesOf[tags][0])));
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
    out.text("$EndEntities\n$Nodes\n");
    const auto range = [&](const std::vector<std::int64_t>& numbers, std::int64_t extra) {
      out.int64(numbers.empty() ? 0 : *std::min_element(numbers.begin(), numbers.end()));
      out.int64(std::max(extra, numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end())));
      out.endLine();
    };
    out.int64(1);
    out.int64(static_cast<std::int64_t>(mesh.nodeCount()));
    range(nodeNumbers, 0);
    out.int32(3);
    out.int32(1);
    out.int32(0);
    out.int64(static_cast<std::int64_t>(mesh.nodeCount()));
    out.endLine();
    for (const std::int64_t number : nodeNumbers) {
      out.int64(number);
      out.endLine();
    }
    for (Eigen::Index n = 0; n < mesh.X.cols(); ++n) {
      for (int k = 0; k < 3; ++k) out.real(mesh.X(k, n));
      out.endLine();
    }
    if (binary) out.text("\n");
    out.text("$EndNodes\n$Elements\n");
    // Runs of elements of one block and entity, in mesh order, so that reading gives the same order back.
    struct Run {
      std::size_t block, begin, end;
      std::int64_t entity;
    };
    std::vector<Run> runs;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      for (std::size_t e = 0; e < elementTags[b].size(); ++e) {
        const std::int64_t entity = volumes.at(elementTags[b][e]);
        if (!runs.empty() && runs.back().block == b && runs.back().entity == entity)
          runs.back().end = e + 1;
        else
          runs.push_back({b, e, e + 1, entity});
      }
    out.int64(static_cast<std::int64_t>(runs.size() + points.size()));
    out.int64(static_cast<std::int64_t>(total));
    range(elementNumbers, nextNumber + static_cast<std::int64_t>(pointNodes) - 1);
    std::size_t running = 0;
    for (const Run& run : runs) {
      const MeshBlock& block = mesh.blocks[run.block];
      const ElementInfo& info = elementInfo(block.type);
      const auto order = fileOrder(info);
      out.int32(3);
      out.int32(run.entity);
      out.int32(info.gmshType);
      out.int64(static_cast<std::int64_t>(run.end - run.begin));
      out.endLine();
      for (std::size_t e = run.begin; e < run.end; ++e) {
        out.int64(elementNumbers[running++]);
        for (const std::size_t a : order) out.int64(nodeNumbers[block.element(e)[a]]);
        out.endLine();
      }
    }
    for (const auto& [tags, entity] : points) {
      const std::vector<std::size_t>& nodes = nodesOf[tags];
      out.int32(0);
      out.int32(entity);
      out.int32(15);
      out.int64(static_cast<std::int64_t>(nodes.size()));
      out.endLine();
      for (const std::size_t n : nodes) {
        out.int64(nextNumber++);
        out.int64(nodeNumbers[n]);
        out.endLine();
      }
    }
  }
  if (binary) out.text("\n");
  out.text("$EndElements\n");
  writeFileAtomically(path, out.content);
}

}  // namespace ringwatch::detail
