#include <ringwatch/meshes/adjacency.h>

#include <algorithm>
#include <array>
#include <numeric>

#include <ringwatch/base/sort_unique.h>

namespace ringwatch {

CompressedRows<ElementNode> nodeElements(const Mesh& mesh) {
  CompressedRows<ElementNode> rows;
  rows.offsets.assign(mesh.nodeCount() + 1, 0);
  for (const MeshBlock& block : mesh.blocks)
    for (const std::int32_t n : block.connectivity) ++rows.offsets[static_cast<std::size_t>(n) + 1];
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  rows.values.resize(rows.offsets.back());
  std::vector<std::size_t> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& block = mesh.blocks[b];
    const int width = block.nodesPerElement();
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      for (int a = 0; a < width; ++a)
        rows.values[next[block.element(e)[a]]++] = {static_cast<std::int32_t>(b), static_cast<std::int32_t>(e), a};
  }
  return rows;
}

CompressedRows<std::int32_t> nodeNeighbours(const Mesh& mesh) {
  const CompressedRows<ElementNode> incidence = nodeElements(mesh);
  CompressedRows<std::int32_t> rows;
  rows.offsets.reserve(mesh.nodeCount() + 1);
  std::vector<std::int32_t> own;
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
    own.clear();
    for (const ElementNode& at : incidence.row(n)) {
      const MeshBlock& block = mesh.blocks[at.block];
      const std::int32_t* nodes = block.element(at.element);
      own.insert(own.end(), nodes, nodes + block.nodesPerElement());
    }
    sortUnique(own);
    std::erase(own, n);
    rows.values.insert(rows.values.end(), own.begin(), own.end());
    rows.offsets.push_back(rows.values.size());
  }
  return rows;
}

std::vector<std::size_t> blockOffsets(const Mesh& mesh) {
  std::vector<std::size_t> offsets{0};
  for (const MeshBlock& block : mesh.blocks) offsets.push_back(offsets.back() + block.elementCount());
  return offsets;
}

FaceNeighbours faceNeighbours(const Mesh& mesh) {
  struct Entry {
    std::array<std::int32_t, 4> key;  // corner nodes, sorted; a triangle begins with -1
    ElementFace face;
  };
  // Equal faces have the same least node: sorted by that, in one pass, few are left to be compared with each other.
  const auto forEachFace = [&mesh](const auto& visit) {
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      const MeshBlock& block = mesh.blocks[b];
      const auto faces = elementInfo(block.type).faces;
      for (std::size_t e = 0; e < block.elementCount(); ++e)
        for (std::size_t f = 0; f < faces.size(); ++f) {
          Entry entry{{}, {static_cast<std::int32_t>(b), static_cast<std::int32_t>(e), static_cast<std::int32_t>(f)}};
          for (std::size_t k = 0; k < 4; ++k) entry.key[k] = faces[f][k] < 0 ? -1 : block.element(e)[faces[f][k]];
          std::sort(entry.key.begin(), entry.key.end());
          visit(entry, static_cast<std::size_t>(entry.key[0] < 0 ? entry.key[1] : entry.key[0]));
        }
    }
  };
  std::vector<std::size_t> end(mesh.nodeCount() + 1, 0);  // of the faces of each least node, once they are in place
  forEachFace([&](const Entry&, std::size_t least) { ++end[least + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Entry> entries(end.back());
  forEachFace([&](const Entry& entry, std::size_t least) { entries[end[least]++] = entry; });

  FaceNeighbours result;
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      result.rows.offsets.push_back(result.rows.offsets.back() + elementInfo(block.type).faces.size());
  result.rows.values.resize(entries.size());
  const std::vector<std::size_t> first = blockOffsets(mesh);
  const auto slot = [&](const ElementFace& f) -> ElementFace& {
    const std::size_t row = first[f.block] + static_cast<std::size_t>(f.element);
    return result.rows.values[result.rows.offsets[row] + static_cast<std::size_t>(f.face)];
  };
  std::size_t begin = 0;
  for (std::size_t node = 0; node < mesh.nodeCount(); begin = end[node++]) {
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(begin),
              entries.begin() + static_cast<std::ptrdiff_t>(end[node]),
              [](const Entry& p, const Entry& q) { return p.key != q.key ? p.key < q.key : p.face < q.face; });
    for (std::size_t i = begin, j; i < end[node]; i = j) {
      for (j = i + 1; j < end[node] && entries[j].key == entries[i].key;) ++j;
      if (j - i == 2) {
        slot(entries[i].face) = entries[i + 1].face;
        slot(entries[i + 1].face) = entries[i].face;
      } else if (j - i > 2) {
        for (std::size_t k = i; k < j; ++k) result.overfull.push_back(entries[k].face);
      }
    }
  }
  std::sort(result.overfull.begin(), result.overfull.end());
  return result;
}

std::vector<ElementFace> boundaryFaces(const Mesh& mesh) {
  const FaceNeighbours neighbours = faceNeighbours(mesh);
  std::vector<ElementFace> faces;
  std::size_t row = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e, ++row)
      for (std::size_t f = 0; f < neighbours.rows.row(row).size(); ++f) {
        const ElementFace face{static_cast<std::int32_t>(b), static_cast<std::int32_t>(e),
                               static_cast<std::int32_t>(f)};
        if (neighbours.rows.row(row)[f].element < 0 &&
            !std::binary_search(neighbours.overfull.begin(), neighbours.overfull.end(), face))
          faces.push_back(face);
      }
  return faces;
}

MeshParts connectedParts(const Mesh& mesh) {
  std::vector<std::int32_t> parent(mesh.nodeCount());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t n) {
    while (parent[n] != n) n = parent[n] = parent[parent[n]];
    return n;
  };
  std::vector<bool> used(mesh.nodeCount());
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      for (int a = 0; a < block.nodesPerElement(); ++a) {
        used[block.element(e)[a]] = true;
        const std::int32_t p = root(block.element(e)[0]), q = root(block.element(e)[a]);
        parent[std::max(p, q)] = std::min(p, q);  // so a root is the first node of its part
      }
  MeshParts parts;
  parts.partOfNode.assign(mesh.nodeCount(), -1);
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
    if (!used[n]) continue;
    const std::int32_t r = root(n);
    parts.partOfNode[n] = r == static_cast<std::int32_t>(n) ? parts.count++ : parts.partOfNode[r];
  }
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      parts.partOfElement.push_back(parts.partOfNode[block.element(e)[0]]);
  return parts;
}

}  // namespace ringwatch
