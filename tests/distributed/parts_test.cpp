// A mesh of which each rank has read a share is cut into the parts of a mesh that all have.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/random.h>
#include <ringwatch/body/patch_layout.h>
#include <ringwatch/distributed/element_cut.h>
#include <ringwatch/distributed/element_order.h>
#include <ringwatch/distributed/exchange.h>
#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/shared_mesh.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/generators/generators.h>
#include <tests/distributed/some.h>

namespace ringwatch {
namespace {

using test::Some;
using test::worldSize;

/// A bar of all linear elements or of tetrahedra: in order with consecutive numbers, or in no order with numbers that
/// are far apart.
Mesh trialMesh(bool mixed, bool shuffled, std::array<int, 3> cells) {
  BarOptions options;
  options.size = {0.1, 0.04, 0.03};
  options.cells = cells;
  options.jitter = 0.15;
  Mesh mesh = mixed ? generateMixedBar(options) : generateBar(options);
  mesh.nodeIds.resize(mesh.nodeCount());
  std::iota(mesh.nodeIds.begin(), mesh.nodeIds.end(), 1);
  if (!shuffled) return mesh;
  Random random(7);
  const auto shuffle = [&](std::size_t count, const auto& swap) {
    for (std::size_t i = count; i-- > 1;) swap(i, static_cast<std::size_t>(random.index(static_cast<int>(i) + 1)));
  };
  std::vector<std::int32_t> place(mesh.nodeCount());  // of each node
  std::iota(place.begin(), place.end(), 0);
  shuffle(place.size(), [&](std::size_t i, std::size_t j) { std::swap(place[i], place[j]); });
  shuffle(place.size(), [&](std::size_t i, std::size_t j) { std::swap(mesh.nodeIds[i], mesh.nodeIds[j]); });
  for (std::int64_t& id : mesh.nodeIds) id = 3 + 1'000'003 * id;
  const NodeVectors X = mesh.X;
  for (std::size_t i = 0; i < place.size(); ++i) mesh.X.col(place[i]) = X.col(static_cast<Eigen::Index>(i));
  for (MeshBlock& block : mesh.blocks) {
    for (std::int32_t& node : block.connectivity) node = place[node];
    const int n = block.nodesPerElement();
    shuffle(block.elementCount(), [&](std::size_t i, std::size_t j) {
      std::int32_t* nodes = block.connectivity.data();
      if (i != j) std::swap_ranges(nodes + i * n, nodes + (i + 1) * n, nodes + j * n);
    });
  }
  for (auto& [name, nodes] : mesh.nodeSets) {
    for (std::int32_t& node : nodes) node = place[node];
    std::sort(nodes.begin(), nodes.end());
  }
  mesh.elementSets.clear();
  return mesh;
}

/// What a rank reads of a mesh: the pieces of a file that would have it in its order.
ReadShare shareOf(const Ranks& ranks, const Mesh& mesh) {
  const auto begin = [&](std::size_t count, int rank) {
    return count * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks.size());
  };
  ReadShare share;
  share.allNodes = static_cast<std::int64_t>(mesh.nodeCount());
  const std::size_t first = begin(mesh.nodeCount(), ranks.rank()), end = begin(mesh.nodeCount(), ranks.rank() + 1);
  share.firstNode = static_cast<std::int64_t>(first);
  share.X = mesh.X.middleCols(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(end - first));
  for (std::size_t i = first; i < end; ++i) share.nodeIds.push_back(mesh.nodeId(static_cast<std::int32_t>(i)));
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& from = mesh.blocks[b];
    const std::size_t own = begin(from.elementCount(), ranks.rank());
    ReadShare::Block& block =
        share.blocks.emplace_back(ReadShare::Block{from.type, static_cast<std::int32_t>(own), {}, {}});
    for (std::size_t e = own; e < begin(from.elementCount(), ranks.rank() + 1); ++e) {
      block.ids.push_back(from.id(e));
      for (int a = 0; a < from.nodesPerElement(); ++a) block.nodes.push_back(mesh.nodeId(from.element(e)[a]));
    }
  }
  for (const auto& [name, nodes] : mesh.nodeSets) {
    const auto set = static_cast<std::int32_t>(share.sets.ofNodes.size());
    share.sets.ofNodes.push_back(name);
    for (std::size_t i = begin(nodes.size(), ranks.rank()); i < begin(nodes.size(), ranks.rank() + 1); ++i)
      share.setNodes.push_back({mesh.nodeId(nodes[i]), i, set});
  }
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    share.sets.ofElements.push_back(
        {static_cast<std::int32_t>(b), 0, static_cast<std::int32_t>(mesh.blocks[b].elementCount()), {"all"}});
  share.repeatedNode = [](std::size_t, std::int64_t id) { return "again " + std::to_string(id); };
  share.missingNode = [](std::size_t b, std::size_t, std::int64_t id, std::int64_t node) {
    return std::to_string(b) + ":" + std::to_string(id) + " wants " + std::to_string(node);
  };
  share.missingSetNode = [](std::size_t at, std::int64_t node) {
    return std::to_string(at) + " wants " + std::to_string(node);
  };
  return share;
}

std::vector<NumberedElements> orderedPieces(Ranks& ranks, SharedMesh& shared, const Mesh& mesh) {
  return orderElements(ranks, shared, mesh.X.rowwise().minCoeff(), mesh.X.rowwise().maxCoeff());
}

struct Case {
  bool mixed, shuffled;
  std::array<int, 3> cells;
};
const std::vector<Case>& cases() {
  static const std::vector<Case> all{{false, false, {1, 1, 1}},
                                     {true, false, {7, 2, 2}},
                                     {true, true, {6, 3, 2}},
                                     {false, true, {14, 12, 10}},
                                     {false, false, {20, 9, 9}}};
  return all;
}

/// Every element is on one rank, at the place that the layout of the whole mesh gives it.
TEST(MeshInParts, HasTheLayoutOfTheWhole) {
  for (int count = 1; count <= worldSize(); ++count) {
    const Some some(count);
    if (!some.has()) continue;
    Ranks ranks(some.get());
    for (const Case& one : cases()) {
      const Mesh mesh = trialMesh(one.mixed, one.shuffled, one.cells);
      SharedMesh shared = shareMesh(ranks, shareOf(ranks, mesh));
      ASSERT_EQ(shared.nodeCount(), static_cast<std::int32_t>(mesh.nodeCount()));
      EXPECT_EQ(shared.droppedNodes, 0);
      const std::vector<NumberedElements> pieces = orderedPieces(ranks, shared, mesh);
      ASSERT_EQ(pieces.size(), mesh.blocks.size());
      for (std::size_t b = 0; b < pieces.size(); ++b) {
        const NumberedElements& piece = pieces[b];
        EXPECT_EQ(sumOver(ranks, static_cast<std::int64_t>(piece.count())),
                  static_cast<std::int64_t>(mesh.blocks[b].elementCount()));
        const PatchLayout whole = layOutPatches(mesh, mesh.blocks[b]);
        const std::vector<PatchPlace> places = placesOf(whole, piece.numbers);
        std::int32_t wrong = 0;
        for (std::size_t i = 0; i < piece.count(); ++i) {
          // Patches are called by the place of their first element here.
          const std::int32_t first = whole.patches[places[i].patch].batchBegin * lanes;
          wrong += piece.places[i].place != places[i].place || piece.places[i].patch != first ? 1 : 0;
          wrong += piece.ids[i] != mesh.blocks[b].id(piece.numbers[i]) ? 1 : 0;
          const std::int32_t* nodes = mesh.blocks[b].element(piece.numbers[i]);
          wrong += std::equal(nodes, nodes + piece.width(), piece.element(i)) ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0) << count << " ranks, block " << b;
      }
    }
  }
}

/// Parts by any cut are those of the whole mesh by the same cut.
TEST(MeshInParts, IsThePartOfTheWhole) {
  const Material material = makeMaterial("neo-hookean", 1e6, 0.3, 1000);
  for (int count = 1; count <= worldSize(); ++count) {
    const Some some(count);
    if (!some.has()) continue;
    Ranks ranks(some.get());
    for (std::size_t trial = 0; trial < cases().size(); ++trial) {
      const Case& one = cases()[trial];
      const Mesh mesh = trialMesh(one.mixed, one.shuffled, one.cells);
      SharedMesh shared = shareMesh(ranks, shareOf(ranks, mesh));
      std::vector<NumberedElements> pieces = orderedPieces(ranks, shared, mesh);
      // By PT-Scotch, or element by element as chance has it: by its number, so that all ranks cut alike.
      std::vector<std::vector<std::int32_t>> cut = cutElements(ranks, shared, pieces);
      if (trial % 2 == 1)
        for (std::size_t b = 0; b < cut.size(); ++b)
          for (std::size_t i = 0; i < cut[b].size(); ++i)
            cut[b][i] =
                static_cast<std::int32_t>(static_cast<std::uint32_t>(pieces[b].numbers[i]) * 2654435761U >> 7) % count;
      struct Cut {
        std::int32_t block, element, part;
      };
      std::vector<Cut> own;
      for (std::size_t b = 0; b < cut.size(); ++b)
        for (std::size_t i = 0; i < cut[b].size(); ++i)
          own.push_back({static_cast<std::int32_t>(b), pieces[b].numbers[i], cut[b][i]});
      std::vector<std::vector<std::int32_t>> ofBlock;
      for (const MeshBlock& block : mesh.blocks) ofBlock.emplace_back(block.elementCount(), -1);
      for (const Cut& element : gatherAll(ranks, own)) ofBlock[element.block][element.element] = element.part;
      std::vector<std::int32_t> parts;
      for (const auto& block : ofBlock) parts.insert(parts.end(), block.begin(), block.end());
      std::vector<std::int64_t> sizes(static_cast<std::size_t>(count), 0);
      for (const std::int32_t part : parts) ++sizes[static_cast<std::size_t>(part)];
      if (trial + 1 == cases().size()) {  // large enough for parts of about one size
        EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()) * count, 1.2 * static_cast<double>(parts.size()));
      }

      const RankPart part = gatherPart(ranks, std::move(shared), std::move(pieces), cut);
      const Body whole(mesh, material);
      const RankBody expected(whole, partitionOf(mesh, parts, count), ranks.rank());
      ASSERT_EQ(part.globalNodes, expected.globalNodes());
      EXPECT_EQ(part.ownedNodes, expected.ownedNodes());
      EXPECT_TRUE(part.mesh.X == expected.body().mesh().X);
      EXPECT_EQ(part.mesh.nodeIds, expected.body().mesh().nodeIds);
      EXPECT_EQ(part.mesh.nodeSets, expected.body().mesh().nodeSets);
      ASSERT_EQ(part.neighbours.size(), expected.neighbours().size());
      for (std::size_t i = 0; i < part.neighbours.size(); ++i) {
        EXPECT_EQ(part.neighbours[i].rank, expected.neighbours()[i].rank);
        EXPECT_EQ(part.neighbours[i].sent, expected.neighbours()[i].sent);
        EXPECT_EQ(part.neighbours[i].receivedBegin, expected.neighbours()[i].receivedBegin);
        EXPECT_EQ(part.neighbours[i].receivedCount, expected.neighbours()[i].receivedCount);
      }
      std::vector<std::unique_ptr<ElementBlock>> blocks;
      for (std::size_t b = 0; b < part.mesh.blocks.size(); ++b) {
        const MeshBlock &found = part.mesh.blocks[b], &block = expected.body().mesh().blocks[b];
        EXPECT_EQ(found.connectivity, block.connectivity);
        EXPECT_EQ(found.ids, block.ids);
        for (std::size_t e = 0; e < part.globalElements[b].size(); ++e)
          ASSERT_EQ(expected.globalElement({b, e}), ElementRef(b, part.globalElements[b][e]));
        const PatchLayout layout =
            layOutPart(part.mesh.nodeCount(), found.nodesPerElement(), found.connectivity, part.places[b]);
        EXPECT_EQ(layout.nodes, expected.body().blocks()[b]->layout().nodes);
        EXPECT_EQ(layout.elements, expected.body().blocks()[b]->layout().elements);
        EXPECT_EQ(layout.localNodes, expected.body().blocks()[b]->layout().localNodes);
        blocks.push_back(makeElementBlock(part.mesh, found, material, "", {}, layout));
      }
      // Masses at owned nodes have the bits of the whole.
      Eigen::VectorXd masses = lumpedMass(part.mesh, blocks, Lumping::rowSum).ofNode;
      copyToGhosts(ranks, part, masses.data(), 1);
      EXPECT_TRUE(masses == expected.body().lumpedMass());
    }
  }
}

/// Nodes that no element has are left out, and the others numbered without them.
TEST(MeshInParts, LeavesUnusedNodesOut) {
  Ranks ranks(MPI_COMM_WORLD);
  Mesh mesh = trialMesh(false, true, {5, 3, 2});
  // Every third element is gone, and with them some nodes; a set keeps one of those.
  MeshBlock& block = mesh.blocks[0];
  std::vector<std::int32_t> kept;
  for (std::size_t e = 0; e < block.elementCount(); ++e)
    if (block.element(e)[0] % 3 != 0 && block.element(e)[3] % 3 != 0)
      kept.insert(kept.end(), block.element(e), block.element(e) + 4);
  block = {block.type, kept, {}};
  std::vector<bool> used(mesh.nodeCount(), false);
  for (const std::int32_t node : kept) used[node] = true;
  const auto unused = static_cast<std::int32_t>(std::find(used.begin(), used.end(), false) - used.begin());
  ASSERT_LT(unused, static_cast<std::int32_t>(used.size()));
  mesh.nodeSets = {{"some", {unused, kept[0]}}};
  std::sort(mesh.nodeSets["some"].begin(), mesh.nodeSets["some"].end());
  SharedMesh shared = shareMesh(ranks, shareOf(ranks, mesh));
  EXPECT_EQ(shared.droppedNodes, std::count(used.begin(), used.end(), false));
  EXPECT_EQ(shared.firstDroppedNode, mesh.nodeId(unused));
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) ids.push_back(mesh.nodeId(static_cast<std::int32_t>(i)));
  EXPECT_EQ(gatherAll(ranks, shared.nodeIds), ids);
  const std::vector<SharedMesh::SetNode> sets = gatherAll(ranks, shared.setNodes);
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(ids[static_cast<std::size_t>(sets[0].node)], mesh.nodeId(kept[0]));
}

std::string faultOf(Ranks& ranks, ReadShare share) {
  try {
    shareMesh(ranks, std::move(share));
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "";
}

/// The first fault of all ranks is thrown on each of them.
TEST(MeshInParts, TellsAllRanksOfAFault) {
  Ranks ranks(MPI_COMM_WORLD);
  for (const bool shuffled : {false, true}) {
    const Mesh mesh = trialMesh(true, shuffled, {6, 3, 2});
    ReadShare share = shareOf(ranks, mesh);
    for (ReadShare::Block& block : share.blocks)
      if (!block.nodes.empty()) block.nodes.back() = 2;
    // Of the first block, the last element of the first rank that has some of it.
    std::size_t b = 0;
    const std::size_t end =
        ranks.size() == 1
            ? mesh.blocks[b].elementCount()
            : std::max<std::size_t>(1, mesh.blocks[b].elementCount() / static_cast<std::size_t>(ranks.size()));
    const std::string expected = "0:" + std::to_string(mesh.blocks[b].id(end - 1)) + " wants 2";
    EXPECT_EQ(faultOf(ranks, share), shuffled ? expected : "");  // where numbers are consecutive there is a node 2
    share = shareOf(ranks, mesh);
    if (!share.setNodes.empty()) share.setNodes.back().node = -5;
    EXPECT_NE(faultOf(ranks, share).find("wants -5"), std::string::npos);
    share = shareOf(ranks, mesh);
    if (ranks.rank() + 1 == ranks.size()) share.nodeIds.back() = mesh.nodeId(0);
    EXPECT_EQ(faultOf(ranks, share), "again " + std::to_string(mesh.nodeId(0)));
  }
}

}  // namespace
}  // namespace ringwatch
