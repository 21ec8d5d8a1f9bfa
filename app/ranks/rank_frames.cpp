#include <ringwatch/app/ranks/rank_frames.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>

namespace ringwatch {
namespace {

/// Fields of some of the places alone; their values are kept here.
class PickedFields {
 public:
  PickedFields(std::span<const VtuField> fields, const std::vector<std::size_t>& places) {
    values_.reserve(fields.size());
    for (const VtuField& field : fields) {
      const auto components = static_cast<std::size_t>(field.components);
      std::visit(
          [&](auto from) {
            std::vector<std::remove_const_t<typename decltype(from)::element_type>> picked;
            picked.reserve(places.size() * components);
            for (const std::size_t place : places)
              for (std::size_t c = 0; c < components; ++c) picked.push_back(from[place * components + c]);
            values_.emplace_back(std::move(picked));
          },
          field.values);
      VtuField& own = fields_.emplace_back(VtuField{field.name, field.components, {}});
      std::visit([&](const auto& picked) { own.values = std::span(std::as_const(picked)); }, values_.back());
    }
  }
  PickedFields(const PickedFields&) = delete;
  PickedFields& operator=(const PickedFields&) = delete;
  std::span<const VtuField> fields() const { return fields_; }

 private:
  std::vector<std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>>> values_;
  std::vector<VtuField> fields_;
};

std::string pieceName(int rank) { return fmt::format("rank_{}.vtu", rank); }

}  // namespace

RankFrames::RankFrames(Ranks& ranks, const RankBody& part) : ranks_(ranks) {
  const Mesh& mesh = part.body().mesh();
  std::vector<std::int32_t> placeOfNode(mesh.nodeCount(), -1);
  std::vector<std::vector<std::int32_t>> placeOfElement;
  std::size_t through = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& from = mesh.blocks[b];
    MeshBlock& block = piece_.blocks.emplace_back(MeshBlock{from.type, {}, {}});
    std::vector<std::int32_t>& places = placeOfElement.emplace_back(from.elementCount(), -1);
    for (std::size_t e = 0; e < from.elementCount(); ++e, ++through) {
      if (!part.counts({b, e})) continue;
      places[e] = static_cast<std::int32_t>(block.elementCount());
      elements_.push_back(through);
      block.ids.push_back(from.id(e));
      for (int a = 0; a < from.nodesPerElement(); ++a) {
        const std::int32_t node = from.element(e)[a];
        block.connectivity.push_back(node);  // of the part, until all nodes are known
        nodes_.push_back(static_cast<std::size_t>(node));
      }
    }
  }
  sortUnique(nodes_);
  piece_.X.resize(3, static_cast<Eigen::Index>(nodes_.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    placeOfNode[nodes_[i]] = static_cast<std::int32_t>(i);
    piece_.X.col(static_cast<Eigen::Index>(i)) = mesh.X.col(static_cast<Eigen::Index>(nodes_[i]));
    piece_.nodeIds.push_back(mesh.nodeId(nodes_[i]));
  }
  for (MeshBlock& block : piece_.blocks)
    for (std::int32_t& node : block.connectivity) node = placeOfNode[node];
  for (const auto& [name, members] : mesh.nodeSets)
    for (std::vector<std::int32_t>& own = piece_.nodeSets[name]; const std::int32_t node : members)
      if (placeOfNode[node] >= 0) own.push_back(placeOfNode[node]);
  for (const auto& [name, members] : mesh.elementSets)
    for (std::vector<ElementRef>& own = piece_.elementSets[name]; const ElementRef e : members)
      if (const std::int32_t place = placeOfElement[e.block][e.element]; place >= 0) own.push_back({e.block, place});

  const int writes = elements_.empty() ? 0 : 1;
  std::vector<int> all(ranks.rank() == 0 ? ranks.size() : 0);
  MPI_Gather(&writes, 1, MPI_INT, all.data(), 1, MPI_INT, 0, ranks.communicator());
  for (std::size_t rank = 0; rank < all.size(); ++rank)
    if (all[rank] != 0) writers_.push_back(static_cast<int>(rank));
}

void RankFrames::write(const std::filesystem::path& path, const NodeVectors& x, std::span<const VtuField> pointFields,
                       std::span<const VtuField> cellFields, double time, std::span<const VtuField> frameFields) {
  const std::filesystem::path folder = path.parent_path() / path.stem();
  if (ranks_.rank() == 0) {
    std::error_code error;
    std::filesystem::remove_all(folder, error);  // pieces of an earlier run, of more ranks
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(fmt::format("{}: cannot write: {}", folder.string(), error.message()));
  }
  MPI_Barrier(ranks_.communicator());
  if (!elements_.empty()) {
    NodeVectors places(3, static_cast<Eigen::Index>(nodes_.size()));
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      places.col(static_cast<Eigen::Index>(i)) = x.col(static_cast<Eigen::Index>(nodes_[i]));
    const PickedFields points(pointFields, nodes_), cells(cellFields, elements_);
    writeVtu(folder / pieceName(ranks_.rank()), piece_, places, points.fields(), cells.fields(), time, frameFields);
  }
  MPI_Barrier(ranks_.communicator());
  if (ranks_.rank() != 0) return;
  std::vector<std::filesystem::path> pieces;
  for (const int rank : writers_) pieces.push_back(path.stem() / pieceName(rank));
  writePvtu(path, piece_, pointFields, cellFields, pieces);
}

}  // namespace ringwatch
