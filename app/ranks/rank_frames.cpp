#include <ringwatch/app/ranks/rank_frames.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/part_of_mesh.h>

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
  std::vector<std::vector<bool>> counted;
  std::size_t through = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    std::vector<bool>& own = counted.emplace_back(mesh.blocks[b].elementCount());
    for (std::size_t e = 0; e < own.size(); ++e, ++through) {
      own[e] = part.counts({b, e});
      if (own[e]) elements_.push_back(through);
    }
  }
  piece_ = meshOfElements(mesh, counted);
  piece_.X = mesh.X;
  piece_.nodeIds = mesh.nodeIds;
  piece_.nodeSets = mesh.nodeSets;
  nodes_ = keepUsedNodes(piece_);
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
