#include <ringwatch/app/ranks/msh_share.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <ringwatch/app/ranks/together.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/distributed/exchange.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/msh_outline.h>

namespace ringwatch {
namespace {

using detail::MshOutline;

/// The piece [begin, end) of a count that is this rank's.
struct Piece {
  std::int64_t begin, end;
  /// What of it is in [first, first + count), counted from first.
  Piece within(std::int64_t first, std::int64_t count) const {
    return {std::clamp(begin - first, std::int64_t{0}, count), std::clamp(end - first, std::int64_t{0}, count)};
  }
};
Piece pieceOf(const Ranks& ranks, std::int64_t count) {
  // Without a product that overflows.
  const std::int64_t each = count / ranks.size(), rest = count % ranks.size();
  const auto begin = [&](std::int64_t rank) { return each * rank + std::min(rest, rank); };
  return {begin(ranks.rank()), begin(ranks.rank() + 1)};
}

/// Elements of a block that lie together in the file.
struct BlockRun {
  const MshOutline::Elements* elements;
  std::int64_t first;  // its number in the block
};
struct OutlinedBlock {
  const detail::FileElement* type;
  const ElementInfo* info;
  std::int64_t count = 0;
  std::vector<BlockRun> runs;
};

std::vector<OutlinedBlock> blocksOf(const MshOutline& outline) {
  std::vector<OutlinedBlock> blocks;
  for (const MshOutline::Elements& run : outline.elements) {
    const ElementInfo* info = detail::elementOf(*run.type);
    if (info == nullptr) continue;
    const auto known = std::ranges::find(blocks, run.type, &OutlinedBlock::type);
    OutlinedBlock& block = known != blocks.end() ? *known : blocks.emplace_back(OutlinedBlock{run.type, info, 0, {}});
    block.runs.push_back({&run, block.count});
    block.count += run.count;
  }
  return blocks;
}

class ShareReader {
 public:
  ShareReader(Ranks& ranks, const std::filesystem::path& path) : ranks_(ranks), source_(path.string()), path_(path) {
    together(ranks, [&] {
      file_.emplace(path);
      outline_ = detail::outlineMsh(path, file_->bytes());
    });
  }

  MshShare read() {
    MshShare result;
    result.notes = outline_.notes;
    readNodes(result.share);
    readElements(result);
    readSets(result.share);
    tellFaults(result.share);
    return result;
  }

 private:
  std::int64_t number(std::size_t position) const { return outline_.at<std::int64_t>(file_->bytes(), position); }
  std::string where(std::size_t position) const { return MshOutline::where(source_, position); }

  void readNodes(ReadShare& share) {
    share.allNodes = outline_.nodeCount;
    const Piece piece = pieceOf(ranks_, share.allNodes);
    share.firstNode = piece.begin;
    share.X.resize(3, piece.end - piece.begin);
    share.nodeIds.reserve(static_cast<std::size_t>(piece.end - piece.begin));
    std::int64_t negative = noFault, notFinite = noFault;  // places of the first
    std::string negativeText, notFiniteText;
    for (const MshOutline::Nodes& run : outline_.nodes) {
      const Piece own = piece.within(run.first, run.count);
      for (std::int64_t i = own.begin; i < own.end; ++i) {
        const std::size_t at = run.numbers + sizeof(std::int64_t) * static_cast<std::size_t>(i);
        const std::int64_t id = number(at);
        if (id < 0 && negative == noFault) {
          negative = run.first + i;
          negativeText = joinText(where(at), ": the number of a node is ", id, "; it must not be negative");
        }
        const std::size_t coordinates = run.coordinates + run.coordinateBytes * static_cast<std::size_t>(i);
        const auto column = static_cast<Eigen::Index>(share.nodeIds.size());
        for (int c = 0; c < 3; ++c) {
          const auto value =
              outline_.at<double>(file_->bytes(), coordinates + sizeof(double) * static_cast<std::size_t>(c));
          share.X(c, column) = value;
          if (std::isfinite(value) || notFinite != noFault) continue;
          notFinite = run.first + i;
          // readMesh names the place behind what it has read.
          notFiniteText = joinText(where(coordinates), ": coordinate ", "xyz"[c], " of node ", id, " is ", value,
                                   "; it must be finite");
        }
        share.nodeIds.push_back(id);
      }
    }
    throwFirst(ranks_, negative, [&] { return negativeText; });
    throwFirst(ranks_, notFinite, [&] { return notFiniteText; });
  }

  void readElements(MshShare& result) {
    const std::vector<OutlinedBlock> blocks = blocksOf(outline_);
    std::int64_t all = 0;
    for (const OutlinedBlock& block : blocks) all += block.count;
    const Piece piece = pieceOf(ranks_, all);
    std::int64_t before = 0;  // elements of earlier blocks
    for (const OutlinedBlock& block : blocks) {
      const Piece ofBlock = piece.within(before, block.count);
      before += block.count;
      result.elementCounts.push_back(block.count);
      ReadShare::Block& own = result.share.blocks.emplace_back(
          ReadShare::Block{block.info->type, static_cast<std::int32_t>(ofBlock.begin), {}, {}});
      const auto n = static_cast<std::size_t>(block.type->nodes);
      const auto count = static_cast<std::size_t>(ofBlock.end - ofBlock.begin);
      own.ids.reserve(count);
      own.nodes.reserve(n * count);
      for (const BlockRun& run : block.runs) {
        const Piece ofRun = ofBlock.within(run.first, run.elements->count);
        for (std::int64_t i = ofRun.begin; i < ofRun.end; ++i) {
          const std::size_t at = run.elements->position + run.elements->bytesEach() * static_cast<std::size_t>(i);
          own.ids.push_back(number(at));
          for (std::size_t a = 0; a < n; ++a) {
            const auto from = block.info->gmshOrder.empty() ? a : static_cast<std::size_t>(block.info->gmshOrder[a]);
            own.nodes.push_back(number(at + sizeof(std::int64_t) * (1 + from)));
          }
        }
        if (run.elements->group >= 0)
          result.share.sets.ofElements.push_back({static_cast<std::int32_t>(result.share.blocks.size() - 1),
                                                  static_cast<std::int32_t>(run.first),
                                                  static_cast<std::int32_t>(run.elements->count),
                                                  outline_.groups[static_cast<std::size_t>(run.elements->group)]});
      }
    }
  }

  /// Nodes of surfaces, lines and points with groups.
  void readSets(ReadShare& share) {
    std::vector<const MshOutline::Elements*> runs;
    std::int64_t all = 0;
    for (const MshOutline::Elements& run : outline_.elements) {
      if (run.type->dimension == 3 || run.group < 0) continue;
      runs.push_back(&run);
      all += run.count;
      const std::vector<std::string>& names = outline_.groups[static_cast<std::size_t>(run.group)];
      share.sets.ofNodes.insert(share.sets.ofNodes.end(), names.begin(), names.end());
    }
    sortUnique(share.sets.ofNodes);
    const Piece piece = pieceOf(ranks_, all);
    std::int64_t before = 0;
    for (const MshOutline::Elements* run : runs) {
      const Piece own = piece.within(before, run->count);
      before += run->count;
      for (const std::string& name : outline_.groups[static_cast<std::size_t>(run->group)]) {
        const auto set =
            static_cast<std::int32_t>(std::ranges::lower_bound(share.sets.ofNodes, name) - share.sets.ofNodes.begin());
        for (std::int64_t i = own.begin; i < own.end; ++i) {
          const std::size_t at = run->position + run->bytesEach() * static_cast<std::size_t>(i);
          for (int a = 0; a < run->type->nodes; ++a)
            share.setNodes.push_back({number(at + sizeof(std::int64_t) * static_cast<std::size_t>(1 + a)), at, set});
        }
      }
    }
  }

  /// Gives the share the texts of faults that show when it is put together with the others'.
  void tellFaults(ReadShare& share) {
    const auto missing = [](const std::string& at, std::int64_t id, const detail::FileElement& type,
                            std::int64_t node) {
      return joinText(at, ": element ", id, " (", type.name(), ") refers to node ", node,
                      ", which the file does not have");
    };
    std::vector<std::int32_t> first;
    for (const ReadShare::Block& block : share.blocks) first.push_back(block.first);
    share.repeatedNode = [outline = outline_, source = source_, firstNode = share.firstNode](std::size_t i,
                                                                                             std::int64_t id) {
      const std::int64_t place = firstNode + static_cast<std::int64_t>(i);
      const auto run = std::ranges::find_if(
          outline.nodes, [&](const MshOutline::Nodes& one) { return place < one.first + one.count; });
      const std::size_t at = run->coordinates + run->coordinateBytes * static_cast<std::size_t>(place - run->first);
      return joinText(MshOutline::where(source, at), ": node ", id, " is defined a second time");
    };
    share.missingNode = [outline = outline_, source = source_, first, missing](std::size_t b, std::size_t i,
                                                                               std::int64_t id, std::int64_t node) {
      const std::vector<OutlinedBlock> blocks = blocksOf(outline);
      const std::int64_t element = first[b] + static_cast<std::int64_t>(i);
      const auto run = std::ranges::find_if(
          blocks[b].runs, [&](const BlockRun& one) { return element < one.first + one.elements->count; });
      const std::size_t at =
          run->elements->position + run->elements->bytesEach() * static_cast<std::size_t>(element - run->first);
      return missing(MshOutline::where(source, at), id, *blocks[b].type, node);
    };
    share.missingSetNode = [outline = outline_, source = source_, path = path_, missing](std::size_t at,
                                                                                         std::int64_t node) {
      const auto run = std::ranges::find_if(outline.elements, [&](const MshOutline::Elements& one) {
        return at >= one.position && at < one.position + one.bytesEach() * static_cast<std::size_t>(one.count);
      });
      const detail::MappedFile file(path);
      return missing(MshOutline::where(source, at), outline.at<std::int64_t>(file.bytes(), at), *run->type, node);
    };
  }

  Ranks& ranks_;
  std::string source_;
  std::filesystem::path path_;
  std::optional<detail::MappedFile> file_;
  MshOutline outline_;
};

}  // namespace

MshShare readMshShare(Ranks& ranks, const std::filesystem::path& path) { return ShareReader(ranks, path).read(); }

}  // namespace ringwatch
