#include <ringwatch/body/tangent_source.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <ringwatch/base/error.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/meshes/index_limits.h>

namespace ringwatch {
namespace {

/// Node pairs (a, b), a <= b, of an element in the order of `places`.
constexpr int pairCount(int n) { return n * (n + 1) / 2; }

template <class T>
std::size_t bytesOf(const std::vector<T>& v) {
  return v.size() * sizeof(T);
}

}  // namespace

std::size_t PatchPairs::bytes() const {
  std::size_t sum = bytesOf(pairs) + bytesOf(pairBegin) + bytesOf(shared) + slots.size() * sizeof(double);
  for (const auto& own : places) sum += bytesOf(own);
  return sum;
}

std::size_t BlockMatrix::patternBytes() const {
  std::size_t sum = bytesOf(rowBegin) + bytesOf(column) + bytesOf(loose) + patchPairs.bytes();
  for (const auto& own : elementBlocks) sum += bytesOf(own);
  return sum;
}

TangentSource::TangentSource(TangentSource&&) noexcept = default;
TangentSource& TangentSource::operator=(TangentSource&&) noexcept = default;
TangentSource::~TangentSource() = default;

TangentSource::TangentSource(Constraints constraints, int threads)
    : constraints_(std::move(constraints)), threads_(threads) {}

TangentSource::TangentSource(std::vector<const ElementTangents*> tangents, Eigen::VectorXd lumpedMass, int threads)
    : TangentSource(Constraints(lumpedMass.size()), threads) {
  setElements(std::move(tangents), std::move(lumpedMass));
}

void TangentSource::addNodalMass(std::int32_t node, double mass) {
  if (node < 0 || node >= nodeCount() || !(mass >= 0) || !std::isfinite(mass))
    throw InputError(joinText("node ", node, ", added mass ", mass, " kg: the node must be one of ", nodeCount(),
                              " and the mass >= 0 and finite"));
  if (mass == 0) return;
  lumpedMass_[node] += mass;
  massVersion_.add();
}

void TangentSource::setDiscreteForces(DiscreteForces forces) {
  if (forces.nodeCount() != nodeCount())
    throw InputError(joinText("discrete forces of ", forces.nodeCount(), " nodes: the body has ", nodeCount()));
  discrete_ = std::make_unique<DiscreteForces>(std::move(forces));
  discrete_->setThreads(threads());
  massVersion_.add();
}

void TangentSource::checkNodal(std::string_view name, NodeVectorsView values) const {
  if (values.cols() != nodeCount())
    throw InputError(
        joinText(name, " is 3 x ", values.cols(), ": must be 3 x ", nodeCount(), ", a column for each node"));
}

std::int64_t TangentSource::elementCount() const {
  std::int64_t count = 0;
  for (const ElementTangents* block : tangents_) count += block->elementCount();
  return count;
}

void TangentSource::setElements(std::vector<const ElementTangents*> tangents, Eigen::VectorXd lumpedMass) {
  tangents_ = std::move(tangents);
  lumpedMass_ = std::move(lumpedMass);
  std::vector<std::int64_t> count(static_cast<std::size_t>(nodeCount()) + 1, 0);
  for (std::size_t b = 0; b < tangents_.size(); ++b) {
    const ElementTangents* block = tangents_[b];
    const std::vector<Patch>& patches = block->layout().patches;
    for (std::size_t p = 0; p < patches.size(); ++p)
      patches_.push_back(
          {static_cast<std::int32_t>(b), static_cast<std::int32_t>(p), slotCount_ + patches[p].nodeBegin});
    for (std::int32_t node : block->layout().nodes) ++count[static_cast<std::size_t>(node) + 1];
    slotCount_ += static_cast<std::int64_t>(block->layout().nodes.size());
  }
  for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
  nodeSlotBegin_ = count;
  nodeSlot_.resize(slotCount_);
  std::int64_t slot = 0;
  for (const ElementTangents* block : tangents_)
    for (std::int32_t node : block->layout().nodes) nodeSlot_[count[node]++] = slot++;
}

void TangentSource::sumSlots(NodeVectors& result, const double* slots, const NodeRangeVisitor& visit) const {
  result.resize(3, nodeCount());
  constexpr std::int64_t grain = 256;  // nodes a thread: some 20 kB of slots, below which waking it costs more
  parallelParts(nodeCount(), threads(), grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) {
      double sum[3] = {0, 0, 0};
      for (std::int64_t s = nodeSlotBegin_[i]; s < nodeSlotBegin_[static_cast<std::size_t>(i) + 1]; ++s) {
        const double* row = slots + 4 * nodeSlot_[s];
        for (int k = 0; k < 3; ++k) sum[k] += row[k];
      }
      for (int k = 0; k < 3; ++k) result(k, i) = sum[k];
    }
    if (visit) visit(begin, end);
  });
}

void TangentSource::sumOverPatches(
    NodeVectors& result, Workspace& workspace,
    const std::function<void(std::size_t block, std::int32_t patch, double* slots)>& addPatch) const {
  workspace.slots.resize(4 * slotCount_);
  double* slots = workspace.slots.data();
  parallelFor(0, patches_.size(), threads(), [&](std::int64_t p) {
    const PatchRef& ref = patches_[p];
    double* own = slots + 4 * ref.firstSlot;
    const std::size_t block = ref.block;
    const Patch& patch = tangents_[block]->layout().patches[ref.patch];
    std::fill(own, own + 4 * static_cast<std::ptrdiff_t>(patch.nodeEnd - patch.nodeBegin), 0.0);
    addPatch(block, ref.patch, own);
  });
  sumSlots(result, slots);
}

void TangentSource::tangentProduct(NodeVectorsView x, NodeVectorsView v, NodeVectors& Kv, Workspace& workspace,
                                   std::optional<double> dampingFactor) const {
  sumOverPatches(Kv, workspace, [&](std::size_t b, std::int32_t p, double* slots) {
    const ElementTangents& block = *tangents_[b];
    const Patch& patch = block.layout().patches[p];
    block.addTangentProduct(patch, x.data(), v.data(), slots);
    if (damped_ && dampingFactor && *dampingFactor != damped_->factor())
      damped_->addDampingProduct(b, patch, x.data(), v.data(), *dampingFactor - damped_->factor(), slots);
  });
  if (discrete_) discrete_->addTangentProduct(x, v, Kv, dampingFactor);
}

double TangentSource::elementDampingForm(NodeVectorsView x, NodeVectorsView v, Workspace& workspace) const {
  if (!damped_ || damped_->factor() == 0) return 0;
  NodeVectors product;
  sumOverPatches(product, workspace, [&](std::size_t b, std::int32_t p, double* slots) {
    damped_->addDampingProduct(b, tangents_[b]->layout().patches[p], x.data(), v.data(), damped_->factor(), slots);
  });
  return product.cwiseProduct(v).sum();
}

void TangentSource::replaceElements(std::vector<const ElementTangents*> tangents, const DampedElements* damped) {
  tangents_ = std::move(tangents);
  damped_ = damped;
  massVersion_.add();
}

Eigen::VectorXd TangentSource::tangentRounding(NodeVectorsView x, Workspace& workspace) const {
  NodeVectors sums;
  sumOverPatches(sums, workspace, [&](std::size_t b, std::int32_t p, double* slots) {
    tangents_[b]->addTangentRounding(tangents_[b]->layout().patches[p], x.data(), slots);
  });
  return sums.row(0).transpose();
}

int TangentSource::mostNodesOfAnElement() const {
  int most = 0;
  for (const ElementTangents* block : tangents_) most = std::max(most, block->nodesPerElement());
  return most;
}

double TangentSource::formRounding(NodeVectorsView x, const NodeVectors& v, Workspace& workspace) const {
  const Eigen::VectorXd tau = tangentRounding(x, workspace);
  // A node at rest may be one of an element without a bound: 0 times infinity counts nothing.
  double sum = 0;
  for (std::int32_t i = 0; i < nodeCount(); ++i)
    if (const double size2 = v.col(i).squaredNorm(); size2 > 0) sum += tau[i] * size2;
  return mostNodesOfAnElement() * sum;
}

Eigen::MatrixXd TangentSource::elementTangent(ElementRef ref, NodeVectorsView x) const {
  const ElementTangents& block = *tangents_.at(ref.block);
  const std::int32_t place = block.layout().batchOfElement.at(ref.element);
  const int size = 3 * block.nodesPerElement(), lane = place % lanes;
  AlignedVector<NativePack> K(size * size);
  block.tangentBatch(place / lanes, x.data(), reinterpret_cast<double*>(K.data()));
  Eigen::MatrixXd result(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) result(i, j) = K[i * size + j][lane];
  return result;
}

// Assembled tangents: the pattern and the places of all elements' blocks once, then numbers only.
void TangentSource::makePattern(BlockMatrix& matrix) const {
  const std::size_t nodes = nodeCount();
  // Neighbours of every node with repetitions, row after row, then sorted and thinned in place. A node without
  // elements, in a part of a body, has its diagonal all the same.
  std::vector<std::int64_t> begin(nodes + 1, 1);
  begin[0] = 0;
  for (const ElementTangents* block : tangents_)
    for (std::int32_t e = 0; e < block->elementCount(); ++e)
      for (std::int32_t i : block->nodesOf(e)) begin[static_cast<std::size_t>(i) + 1] += block->nodesPerElement();
  // Springs and contact of surfaces couple nodes that need not share an element.
  for (const auto& [i, j] : matrix.coupled) {
    ++begin[static_cast<std::size_t>(i) + 1];
    ++begin[static_cast<std::size_t>(j) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::int32_t> neighbour(begin.back());
  {
    std::vector<std::int64_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < nodes; ++i) neighbour[next[i]++] = static_cast<std::int32_t>(i);
    for (const ElementTangents* block : tangents_)
      for (std::int32_t e = 0; e < block->elementCount(); ++e) {
        const auto own = block->nodesOf(e);
        for (std::int32_t i : own) {
          std::int64_t& to = next[i];
          std::copy(own.begin(), own.end(), neighbour.begin() + to);
          to += static_cast<std::int64_t>(own.size());
        }
      }
    for (const auto& [i, j] : matrix.coupled) {
      neighbour[next[i]++] = j;
      neighbour[next[j]++] = i;
    }
  }
  std::vector<std::int64_t> count(nodes);
  parallelFor(
      0, nodes, threads(),
      [&](std::int64_t i) {
        const auto first = neighbour.begin() + begin[i],
                   last = neighbour.begin() + begin[static_cast<std::size_t>(i) + 1];
        std::sort(first, last);
        count[i] = std::unique(first, last) - first;
      },
      256);
  matrix.rowBegin.assign(nodes + 1, 0);
  std::partial_sum(count.begin(), count.end(), matrix.rowBegin.begin() + 1);
  matrix.column.resize(matrix.rowBegin.back());
  for (std::size_t i = 0; i < nodes; ++i)
    std::copy_n(neighbour.begin() + begin[i], count[i], matrix.column.begin() + matrix.rowBegin[i]);
  matrix.block.assign(matrix.column.size(), Eigen::Matrix3d::Zero());
  for (const ElementTangents* block : tangents_) {
    const std::size_t n = block->nodesPerElement();
    auto& positions = matrix.elementBlocks.emplace_back(static_cast<std::size_t>(block->elementCount()) * n * n);
    parallelFor(
        0, block->elementCount(), threads(),
        [&](std::int64_t e) {
          const auto own = block->nodesOf(e);
          for (std::size_t a = 0; a < n; ++a) {
            const std::size_t row = own[a];
            const auto first = matrix.column.begin() + matrix.rowBegin[row],
                       last = matrix.column.begin() + matrix.rowBegin[row + 1];
            for (std::size_t b = 0; b < n; ++b)
              positions[(static_cast<std::size_t>(e) * n + a) * n + b] =
                  static_cast<std::int32_t>(std::lower_bound(first, last, own[b]) - matrix.column.begin());
          }
        },
        256);
  }
  placePairs(matrix);
  findLooseBlocks(matrix);
}

void TangentSource::findLooseBlocks(BlockMatrix& matrix) const {
  matrix.loose.clear();
  if (!discrete_) return;
  std::vector<bool> ofElements(matrix.column.size());
  for (const auto& positions : matrix.elementBlocks)
    for (const std::int32_t position : positions) ofElements[position] = true;
  for (std::size_t k = 0; k < ofElements.size(); ++k)
    if (!ofElements[k]) matrix.loose.push_back(static_cast<std::int32_t>(k));
}

void TangentSource::addDiscreteBlocks(NodeVectorsView x, BlockMatrix& matrix) const {
  for (const std::int32_t position : matrix.loose) matrix.block[position].setZero();
  discrete_->forEachBlock(x, [&](std::int32_t i, std::int32_t j, const Eigen::Matrix3d& block) {
    const auto first = matrix.column.begin() + matrix.rowBegin[i],
               last = matrix.column.begin() + matrix.rowBegin[static_cast<std::size_t>(i) + 1];
    // Stored by columns of the transpose: the block is symmetric.
    matrix.block[std::lower_bound(first, last, j) - matrix.column.begin()] += block;
  });
}

void TangentSource::placePairs(BlockMatrix& matrix) const {
  PatchPairs& own = matrix.patchPairs;
  std::vector<std::int32_t> placeOf(matrix.column.size(), -1);  // of the upper block, in the current patch
  std::vector<std::int32_t> patches(matrix.column.size(), 0);   // that have the pair
  own.places.resize(tangents_.size());
  own.pairBegin.assign(1, 0);
  for (std::size_t m = 0; m < tangents_.size(); ++m) {
    const ElementTangents& block = *tangents_[m];
    const int n = block.nodesPerElement();
    own.places[m].resize(block.layout().elements.size() * static_cast<std::size_t>(pairCount(n)));
    std::int32_t* place = own.places[m].data();
    for (const Patch& patch : block.layout().patches) {
      for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
        const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
        for (int a = 0; a < n; ++a)
          for (int b = a; b < n; ++b)
            for (int lane = 0; lane < lanes; ++lane) {
              // Lanes without an element add zeros where the first adds.
              const std::int32_t e = elements[lane] < 0 ? elements[0] : elements[lane];
              const auto nodes = block.nodesOf(e);
              const std::int32_t* positions = matrix.elementBlocks[m].data() + static_cast<std::ptrdiff_t>(e) * n * n;
              const bool flipped = nodes[a] > nodes[b];
              const std::int32_t upper = positions[flipped ? b * n + a : a * n + b];
              std::int32_t& known = placeOf[upper];
              if (known < 0) {
                known = static_cast<std::int32_t>(static_cast<std::int64_t>(own.pairs.size()) - own.pairBegin.back());
                own.pairs.push_back({upper, positions[flipped ? a * n + b : b * n + a], -1});
                ++patches[upper];
              }
              *place++ = flipped ? ~known : known;
            }
      }
      for (std::size_t p = own.pairBegin.back(); p < own.pairs.size(); ++p) placeOf[own.pairs[p].upper] = -1;
      own.pairBegin.push_back(own.pairs.size());
    }
  }
  // Slots of a pair lie beside one another, in the order of the patches.
  std::int64_t slotCount = 0;
  for (PatchPairs::Pair& pair : own.pairs) {
    const std::size_t upper = pair.upper;
    if (patches[upper] < 2) continue;
    if (placeOf[upper] < 0) {
      own.shared.push_back({pair.upper, pair.lower, slotCount});
      placeOf[upper] = static_cast<std::int32_t>(slotCount);
      slotCount += patches[upper];
    }
    pair.slot = placeOf[upper]++;
  }
  own.shared.push_back({0, 0, slotCount});
  own.slots.resize(9 * static_cast<std::size_t>(slotCount));
}

void TangentSource::assembleBlocks(NodeVectorsView x, BlockMatrix& matrix) const {
  // Which surfaces touch changes along a run.
  auto coupled = discrete_ ? discrete_->coupledNodes(x) : std::vector<std::array<std::int32_t, 2>>();
  if (matrix.rowBegin.empty() || matrix.coupled != coupled) {
    matrix = {};
    matrix.coupled = std::move(coupled);
    makePattern(matrix);
  }
  PatchPairs& own = matrix.patchPairs;
  double* values = matrix.block.data()->data();
  std::size_t firstPatch = 0;
  for (std::size_t m = 0; m < tangents_.size(); ++m) {
    const ElementTangents& block = *tangents_[m];
    const int n = block.nodesPerElement(), size = 3 * n, count = pairCount(n);
    const auto& patches = block.layout().patches;
    parallelFor(0, patches.size(), threads(), [&](std::int64_t p) {
      // A patch's sums stay in the second-level cache; kept from patch to patch, for fresh memory costs page faults.
      thread_local AlignedVector<double> sums;
      thread_local AlignedVector<NativePack> K;
      const Patch& patch = patches[p];
      const std::int64_t first = own.pairBegin[firstPatch + static_cast<std::size_t>(p)];
      const std::size_t pairs = own.pairBegin[firstPatch + static_cast<std::size_t>(p) + 1] - first;
      sums.assign(9 * pairs, 0.0);
      K.resize(size * size);
      // The first eight entries of a block fill a cache line; the ninth ones lie apart.
      double *eight = sums.data(), *ninth = sums.data() + 8 * pairs;
      const std::int32_t* place = own.places[m].data() + static_cast<std::ptrdiff_t>(patch.batchBegin) * count * lanes;
      for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
        block.tangentBatch(batch, x.data(), reinterpret_cast<double*>(K.data()));
        for (int a = 0; a < n; ++a)
          for (int b = a; b < n; ++b, place += lanes)
            addBlocks(eight, ninth, place, K.data() + static_cast<std::ptrdiff_t>(3 * a) * size + 3 * b, size);
      }
      for (std::size_t i = 0; i < pairs; ++i) {
        const PatchPairs::Pair& pair = own.pairs[static_cast<std::size_t>(first) + i];
        if (pair.slot >= 0) {
          double* slot = own.slots.data() + 9 * static_cast<std::ptrdiff_t>(pair.slot);
          std::copy_n(eight + 8 * i, 8, slot);
          slot[8] = ninth[i];
        } else {
          storeBlock(values, pair.upper, pair.lower, eight + 8 * i, ninth[i]);
        }
      }
    });
    firstPatch += patches.size();
  }
  parallelFor(
      0, static_cast<std::int64_t>(own.shared.size()) - 1, threads(),
      [&](std::int64_t i) {
        const PatchPairs::Shared& pair = own.shared[i];
        const std::int64_t end = own.shared[static_cast<std::size_t>(i) + 1].slotBegin;
        double sum[9] = {};
        for (std::int64_t s = pair.slotBegin; s < end; ++s)
          for (int k = 0; k < 9; ++k) sum[k] += own.slots[9 * s + k];
        storeBlock(values, pair.upper, pair.lower, sum, sum[8]);
      },
      1024);
  if (discrete_) addDiscreteBlocks(x, matrix);
}

void TangentSource::assembleTangent(NodeVectorsView x, SparseTangent& tangent) const {
  BlockMatrix& blocks = tangent.blocks;
  Eigen::SparseMatrix<double>& K = tangent.matrix;
  const auto coupledBefore = blocks.coupled;
  assembleBlocks(x, blocks);
  requireSparse(nodeCount(), std::ssize(blocks.column));
  const bool fresh = K.nonZeros() == 0 || blocks.coupled != coupledBefore;
  if (fresh) {
    K.resize(3 * nodeCount(), 3 * nodeCount());
    K.resizeNonZeros(9 * blocks.column.size());
  }
  // Symmetric: row i of blocks gives columns 3i to 3i+2.
  parallelFor(
      0, nodeCount(), threads(),
      [&](std::int64_t i) {
        const std::int64_t begin = blocks.rowBegin[i], count = blocks.rowBegin[static_cast<std::size_t>(i) + 1] - begin;
        if (fresh)
          for (std::int64_t c = 0; c < 3; ++c) {
            K.outerIndexPtr()[3 * i + c] = static_cast<int>(9 * begin + 3 * c * count);
            int* rows = K.innerIndexPtr() + 9 * begin + 3 * c * count;
            for (std::int64_t s = 0; s < 3 * count; ++s)
              rows[s] = 3 * blocks.column[begin + s / 3] + static_cast<int>(s % 3);
          }
        double* to = K.valuePtr() + 9 * begin;
        const double* from = blocks.block.data()->data() + 9 * begin;
        for (std::int64_t s = 0; s < count; ++s, from += 9, to += 3)
          for (std::int64_t c = 0; c < 3; ++c)
            for (std::int64_t r = 0; r < 3; ++r) to[3 * c * count + r] = from[c + 3 * r];
      },
      256);
  if (fresh) K.outerIndexPtr()[3 * nodeCount()] = static_cast<int>(9 * blocks.column.size());
}

Eigen::SparseMatrix<double> TangentSource::assembleTangent(NodeVectorsView x) const {
  SparseTangent tangent;
  assembleTangent(x, tangent);
  Eigen::SparseMatrix<double> K;
  K.swap(tangent.matrix);  // Eigen 3.4 has no move construction of sparse matrices
  return K;
}

}  // namespace ringwatch
