#include <ringwatch/distributed/element_cut.h>

#include <algorithm>
#include <array>
#include <compare>
#include <cstdio>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <ptscotch.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/distributed/exchange.h>

namespace ringwatch {
namespace {

/// A graph of PT-Scotch's, given back with its owner, and the strategy that it has by default. It works without
/// threads, which would talk to other ranks beside this one: that takes an MPI that was started for several threads.
class SharedGraph {
 public:
  explicit SharedGraph(Ranks& ranks) : ranks_(ranks) {
    bool fails = SCOTCH_dgraphInit(&graph_, ranks.communicator()) != 0;
    fails = SCOTCH_dgraphInit(&bound_, ranks.communicator()) != 0 || fails;
    fails = SCOTCH_stratInit(&strategy_) != 0 || fails;
    fails = SCOTCH_contextInit(&context_) != 0 || fails;
    fails = SCOTCH_contextThreadSpawn(&context_, 1, nullptr) != 0 || fails;
    requireDone(!fails);
  }
  ~SharedGraph() {
    SCOTCH_stratExit(&strategy_);
    SCOTCH_dgraphExit(&bound_);
    SCOTCH_dgraphExit(&graph_);
    SCOTCH_contextExit(&context_);
  }
  SharedGraph(const SharedGraph&) = delete;
  SharedGraph& operator=(const SharedGraph&) = delete;

  /// Vertices of this rank: vertex i is joined to adjacent[begin[i]] … adjacent[begin[i + 1] - 1], counted through all
  /// ranks. The arrays must outlive this, and have an entry more than they need, so that none is empty.
  void build(std::vector<SCOTCH_Num>& begin, std::vector<SCOTCH_Num>& adjacent, std::vector<SCOTCH_Num>& weight) {
    const auto count = static_cast<SCOTCH_Num>(begin.size() - 1);
    bool fails = SCOTCH_dgraphBuild(&graph_, 0, count, count, begin.data(), nullptr, weight.data(), nullptr,
                                    begin.back(), begin.back(), adjacent.data(), nullptr, nullptr) != 0;
    fails = SCOTCH_contextBindDgraph(&context_, &graph_, &bound_) != 0 || fails;
    requireDone(!fails);
  }
  void cut(std::vector<SCOTCH_Num>& part) {
    requireDone(SCOTCH_dgraphPart(&bound_, ranks_.size(), &strategy_, part.data()) == 0);
  }

 private:
  /// Throws on all ranks where one has failed.
  void requireDone(bool done) {
    if (ranks_.least(done ? 0 : -1) != 0) throw InputError("PT-Scotch could not cut the mesh");
  }

  Ranks& ranks_;
  SCOTCH_Dgraph graph_, bound_;  // the second is the first with the context
  SCOTCH_Strat strategy_;
  SCOTCH_Context context_;
};

/// A face of an element, which is counted through all ranks.
struct Face {
  std::array<std::int32_t, 4> corners;  // ascending; a triangle begins with -1
  SCOTCH_Num element;
  auto operator<=>(const Face&) const = default;
  std::int32_t leastNode() const { return corners[0] < 0 ? corners[1] : corners[0]; }
};
struct Joined {
  SCOTCH_Num element, other;
};

/// Calls join for both elements of each face that two of these have, and returns the faces that one has. Faces of three
/// and more elements join none.
template <class Join>
std::vector<Face> joinFaces(std::vector<Face> faces, const Join& join) {
  std::sort(faces.begin(), faces.end());
  std::vector<Face> single;
  for (std::size_t i = 0, j; i < faces.size(); i = j) {
    for (j = i + 1; j < faces.size() && faces[j].corners == faces[i].corners;) ++j;
    if (j - i == 1) single.push_back(faces[i]);
    if (j - i == 2) join(faces[i].element, faces[i + 1].element);
  }
  return single;
}

/// Pairs of elements that meet in a face, of each element of this rank, whose numbers begin with `first`.
std::vector<Joined> joinedElements(Ranks& ranks, const SharedMesh& mesh, const std::vector<NumberedElements>& pieces,
                                   SCOTCH_Num first) {
  std::vector<Face> faces;
  SCOTCH_Num element = first;
  for (const NumberedElements& block : pieces)
    for (std::size_t i = 0; i < block.count(); ++i, ++element)
      for (const auto& corners : elementInfo(block.type).faces) {
        Face& face = faces.emplace_back(Face{{}, element});
        for (std::size_t k = 0; k < 4; ++k)
          face.corners[k] = corners[k] < 0 ? -1 : block.element(i)[static_cast<std::size_t>(corners[k])];
        std::sort(face.corners.begin(), face.corners.end());
      }
  std::vector<Joined> joined;
  const std::vector<Face> single = joinFaces(std::move(faces), [&](SCOTCH_Num a, SCOTCH_Num b) {
    joined.push_back({a, b});
    joined.push_back({b, a});
  });
  // The others meet at the rank where their least node is at home.
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<Face>> to(size);
  for (const Face& face : single) to[static_cast<std::size_t>(mesh.homeOf(face.leastNode()))].push_back(face);
  const std::vector<SCOTCH_Num> firstOf = gatherAll(ranks, std::vector<SCOTCH_Num>{first});
  std::vector<std::vector<Joined>> back(size);
  const auto send = [&](SCOTCH_Num a, SCOTCH_Num b) {
    // Ranks without elements begin where the next one does.
    const auto owner = std::upper_bound(firstOf.begin(), firstOf.end(), a) - firstOf.begin() - 1;
    back[static_cast<std::size_t>(owner)].push_back({a, b});
  };
  joinFaces(std::move(exchange(ranks, to).values), [&](SCOTCH_Num a, SCOTCH_Num b) {
    send(a, b);
    send(b, a);
  });
  const std::vector<Joined> came = std::move(exchange(ranks, back).values);
  joined.insert(joined.end(), came.begin(), came.end());
  return joined;
}

struct NodeInPart {
  std::int32_t node, part;
  auto operator<=>(const NodeInPart&) const = default;
};
struct CountedNode {
  std::int32_t node, part, elements;
  auto operator<=>(const CountedNode&) const = default;
};

/// The owner of each node at home here.
std::vector<std::int32_t> ownersAtHome(Ranks& ranks, const SharedMesh& mesh,
                                       const std::vector<NumberedElements>& pieces,
                                       const std::vector<std::vector<std::int32_t>>& parts) {
  std::vector<NodeInPart> found;
  for (std::size_t b = 0; b < pieces.size(); ++b)
    for (std::size_t i = 0; i < pieces[b].count(); ++i)
      for (std::size_t a = 0; a < pieces[b].width(); ++a) found.push_back({pieces[b].element(i)[a], parts[b][i]});
  std::sort(found.begin(), found.end());
  std::vector<std::vector<CountedNode>> to(static_cast<std::size_t>(ranks.size()));
  for (std::size_t i = 0, j; i < found.size(); i = j) {
    for (j = i + 1; j < found.size() && found[j] == found[i];) ++j;
    to[static_cast<std::size_t>(mesh.homeOf(found[i].node))].push_back(
        {found[i].node, found[i].part, static_cast<std::int32_t>(j - i)});
  }
  found = {};
  std::vector<CountedNode> counted = std::move(exchange(ranks, to).values);
  std::sort(counted.begin(), counted.end());
  const std::int32_t first = mesh.firstNode[static_cast<std::size_t>(ranks.rank())];
  std::vector<std::int32_t> owners(mesh.nodeIds.size(), 0), most(mesh.nodeIds.size(), 0);
  for (std::size_t i = 0, j; i < counted.size(); i = j) {
    std::int32_t elements = 0;
    for (j = i; j < counted.size() && counted[j].node == counted[i].node && counted[j].part == counted[i].part; ++j)
      elements += counted[j].elements;
    const std::int32_t at = counted[i].node - first;
    if (elements <= most[at]) continue;  // parts ascend, so that the first of several stays
    most[at] = elements;
    owners[at] = counted[i].part;
  }
  return owners;
}

std::vector<std::int32_t> nodesOfPieces(const std::vector<NumberedElements>& pieces) {
  std::vector<std::int32_t> nodes;
  for (const NumberedElements& block : pieces) nodes.insert(nodes.end(), block.nodes.begin(), block.nodes.end());
  sortUnique(nodes);
  nodes.shrink_to_fit();
  return nodes;
}

/// The elements of a block that touch a node of this rank. nodes, owners: of all nodes of the piece, ascending.
NumberedElements sendToOwners(Ranks& ranks, NumberedElements piece, const std::vector<std::int32_t>& nodes,
                              const std::vector<std::int32_t>& owners) {
  const std::size_t n = piece.width(), size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<SentElement>> heads(size);
  std::vector<std::vector<std::int32_t>> corners(size);
  std::vector<std::int32_t> to;
  for (std::size_t i = 0; i < piece.count(); ++i) {
    const std::int32_t* element = piece.element(i);
    to.clear();
    for (std::size_t a = 0; a < n; ++a)
      to.push_back(owners[std::lower_bound(nodes.begin(), nodes.end(), element[a]) - nodes.begin()]);
    sortUnique(to);
    for (const std::int32_t rank : to) {
      heads[static_cast<std::size_t>(rank)].push_back({0, piece.ids[i], piece.numbers[i], piece.places[i]});
      std::vector<std::int32_t>& list = corners[static_cast<std::size_t>(rank)];
      list.insert(list.end(), element, element + n);
    }
  }
  piece = NumberedElements{piece.type, {}, {}, {}, {}};
  return exchangeElements(ranks, piece.type, heads, corners);
}

struct NodeOfPart {
  std::int64_t id;
  double X[3];
  std::int32_t owner;
};

/// Fills in the sets of nodes, which their homes know.
void fetchNodeSets(Ranks& ranks, const SharedMesh& mesh, RankPart& part) {
  std::vector<std::vector<std::int32_t>> questions(static_cast<std::size_t>(ranks.size()));
  for (const std::int32_t node : part.globalNodes)
    questions[static_cast<std::size_t>(mesh.homeOf(node))].push_back(node);
  const Received<std::int32_t> asked = exchange(ranks, questions);
  std::vector<std::vector<SharedMesh::SetNode>> back(static_cast<std::size_t>(ranks.size()));
  for (int r = 0; r < ranks.size(); ++r)
    for (const std::int32_t node : asked.of(r))
      for (auto at = std::lower_bound(mesh.setNodes.begin(), mesh.setNodes.end(), SharedMesh::SetNode{node, 0});
           at != mesh.setNodes.end() && at->node == node; ++at)
        back[static_cast<std::size_t>(r)].push_back(*at);
  for (const std::string& name : mesh.sets.ofNodes) part.mesh.nodeSets[name];
  for (const SharedMesh::SetNode& entry : exchange(ranks, back).values)
    part.mesh.nodeSets[mesh.sets.ofNodes[static_cast<std::size_t>(entry.set)]].push_back(part.localNode(entry.node));
  for (auto& [name, nodes] : part.mesh.nodeSets) std::sort(nodes.begin(), nodes.end());
}

void fillElementSets(const SetNames& sets, RankPart& part) {
  for (const SetNames::Run& run : sets.ofElements)
    for (const std::string& name : run.sets) {
      std::vector<ElementRef>& set = part.mesh.elementSets[name];  // also where it is empty here
      const std::vector<std::int32_t>& numbers = part.globalElements[static_cast<std::size_t>(run.block)];
      const auto begin = std::lower_bound(numbers.begin(), numbers.end(), run.first);
      for (auto at = begin; at != numbers.end() && *at - run.first < run.count; ++at)
        set.push_back({run.block, at - numbers.begin()});
    }
}

}  // namespace

std::vector<std::vector<std::int32_t>> cutElements(Ranks& ranks, const SharedMesh& mesh,
                                                   const std::vector<NumberedElements>& pieces) {
  std::vector<std::vector<std::int32_t>> parts;
  std::int64_t own = 0;
  for (const NumberedElements& block : pieces) {
    parts.emplace_back(block.count(), 0);
    own += static_cast<std::int64_t>(block.count());
  }
  if (ranks.size() == 1) return parts;
  const std::int64_t all = sumOver(ranks, own);
  if (all > std::numeric_limits<SCOTCH_Num>::max())
    throw InputError(joinText(all, " elements: PT-Scotch cuts at most ", std::numeric_limits<SCOTCH_Num>::max()));
  const auto first = static_cast<SCOTCH_Num>(sumBefore(ranks, own));
  const auto count = static_cast<std::size_t>(own);
  std::vector<SCOTCH_Num> begin(count + 1, 0), adjacent, weight, part(count + 1);
  {
    const std::vector<Joined> joined = joinedElements(ranks, mesh, pieces, first);
    for (const Joined& pair : joined) ++begin[static_cast<std::size_t>(pair.element - first) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    adjacent.resize(joined.size() + 1);  // an array for elements that meet in no face
    std::vector<SCOTCH_Num> next(begin.begin(), begin.end() - 1);
    for (const Joined& pair : joined) adjacent[next[static_cast<std::size_t>(pair.element - first)]++] = pair.other;
  }
  for (const NumberedElements& block : pieces)
    weight.insert(weight.end(), block.count(), static_cast<SCOTCH_Num>(block.width()));
  weight.push_back(0);  // an array for a rank without elements
  SharedGraph graph(ranks);
  SCOTCH_randomReset();
  graph.build(begin, adjacent, weight);
  graph.cut(part);
  auto from = part.begin();
  for (std::vector<std::int32_t>& block : parts) {
    std::copy_n(from, block.size(), block.begin());
    from += static_cast<std::ptrdiff_t>(block.size());
  }
  return parts;
}

RankPart gatherPart(Ranks& ranks, SharedMesh mesh, std::vector<NumberedElements> pieces,
                    const std::vector<std::vector<std::int32_t>>& parts) {
  const std::int32_t first = mesh.firstNode[static_cast<std::size_t>(ranks.rank())];
  const std::vector<std::int32_t> owners = ownersAtHome(ranks, mesh, pieces, parts);
  const auto homeOf = [&](std::int32_t node) { return mesh.homeOf(node); };
  std::vector<MeshBlock> blocks;
  std::vector<std::vector<std::int32_t>> numbers;
  std::vector<std::vector<PatchPlace>> places;
  {
    const std::vector<std::int32_t> nodes = nodesOfPieces(pieces);
    const auto ownersOf = ask<std::int32_t>(ranks, std::span<const std::int32_t>(nodes), homeOf,
                                            [&](std::int32_t node) { return owners[node - first]; });
    for (NumberedElements& piece : pieces) {
      NumberedElements own = sendToOwners(ranks, std::move(piece), nodes, ownersOf);
      numbers.push_back(std::move(own.numbers));
      places.push_back(std::move(own.places));
      blocks.push_back({own.type, std::move(own.nodes), std::move(own.ids)});
    }
  }
  std::vector<std::int32_t> nodes;
  for (const MeshBlock& block : blocks) nodes.insert(nodes.end(), block.connectivity.begin(), block.connectivity.end());
  sortUnique(nodes);
  const auto known = ask<NodeOfPart>(ranks, std::span<const std::int32_t>(nodes), homeOf, [&](std::int32_t node) {
    const Eigen::Vector3d X = mesh.X.col(node - first);
    return NodeOfPart{mesh.nodeIds[node - first], {X[0], X[1], X[2]}, owners[node - first]};
  });
  const auto nodeOf = [&](std::int32_t node) -> const NodeOfPart& {
    return known[std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin()];
  };
  std::vector<std::int32_t> owned;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (known[i].owner == ranks.rank()) owned.push_back(nodes[i]);
  RankPart part(ranks.rank(), std::move(blocks), std::move(numbers), std::move(owned),
                [&](std::int32_t node) { return nodeOf(node).owner; });
  part.places = std::move(places);
  part.mesh.X.resize(3, static_cast<Eigen::Index>(part.globalNodes.size()));
  for (std::size_t i = 0; i < part.globalNodes.size(); ++i) {
    const NodeOfPart& node = nodeOf(part.globalNodes[i]);
    part.mesh.X.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::Vector3d>(node.X);
    part.mesh.nodeIds.push_back(node.id);
  }
  fetchNodeSets(ranks, mesh, part);
  fillElementSets(mesh.sets, part);
  return part;
}

void copyToGhosts(Ranks& ranks, const RankPart& part, double* values, int numbers) {
  std::vector<std::vector<double>> to(static_cast<std::size_t>(ranks.size()));
  for (const RankPart::Neighbour& neighbour : part.neighbours)
    for (const std::int32_t node : neighbour.sent) {
      const double* from = values + static_cast<std::ptrdiff_t>(node) * numbers;
      std::vector<double>& list = to[static_cast<std::size_t>(neighbour.rank)];
      list.insert(list.end(), from, from + numbers);
    }
  const std::vector<double> came = std::move(exchange(ranks, to).values);  // by rank, as ghosts are
  std::copy(came.begin(), came.end(), values + static_cast<std::ptrdiff_t>(part.ownedNodes) * numbers);
}

}  // namespace ringwatch
