#include <ringwatch/handlers/imex/cluster_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/small/power_iteration.h>

namespace ringwatch {
namespace {

using P = NativePack;
// Of |F|², for laws that stiffen, where all elements are turned as soon as one needs it, and where each is on its own:
// at 1.1 the graded cube of `verify handlers` gains energy there without dissipation.
constexpr double stretchOfAll = 1.1, stretchOfEach = 1.01;
constexpr std::int32_t chunkBatches = 32;  // nodes of a chunk must have 16-bit numbers
constexpr int longestWait = 4;

/// Of each lane's matrix, to some per cent: it only scales K̂.
P highest(const P* K, int size) {
  AlignedVector<P> v(size), Kv(v);
  return highestByPowerIteration<0>(K, size, v.data(), Kv.data());
}

}  // namespace

Eigen::Matrix3d UpperBlocks::block(std::int32_t k) const {
  Eigen::Matrix3d B;
  const std::size_t at = k;
  std::copy_n(eight.data() + 8 * at, 8, B.data());
  B(2, 2) = ninth[at];
  return B;
}

ClusterMatrix::ClusterMatrix(const Body& body, const std::vector<ElementRef>& elements,
                             const std::vector<std::int32_t>& nodes, double w)
    : body_(body), w_(w), nodes_(nodes), changed_(nodes.size(), 1) {
  std::vector<std::vector<std::int32_t>> rows(nodes.size());
  std::vector<std::vector<std::int32_t>> ofBlock(body.blocks().size());
  for (const ElementRef e : elements) {
    ofBlock[e.block].push_back(e.element);
    std::vector<std::int32_t> local;
    for (const std::int32_t node : body.blocks()[e.block]->nodesOf(e.element))
      local.push_back(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
    for (const std::int32_t i : local)
      for (const std::int32_t j : local)
        if (i <= j) rows[i].push_back(j);
  }
  upper_.rowBegin.assign(1, 0);
  for (auto& row : rows) {
    sortUnique(row);
    upper_.column.insert(upper_.column.end(), row.begin(), row.end());
    upper_.rowBegin.push_back(upper_.column.size());
  }
  upper_.eight.resize(8 * (upper_.column.size() + 1));
  upper_.ninth.resize(upper_.column.size() + 1);
  for (std::size_t b = 0; b < ofBlock.size(); ++b)
    if (!ofBlock[b].empty()) addGroup(b, std::move(ofBlock[b]));
}

bool ClusterMatrix::objective() const {
  return std::all_of(groups_.begin(), groups_.end(), [](const Group& g) { return g.objective; });
}

void ClusterMatrix::addGroup(std::int32_t block, std::vector<std::int32_t> elements) {
  Group& g = groups_.emplace_back();
  g.block = body_.blocks()[block].get();
  g.blockNumber = block;
  g.n = g.block->element().nodes;
  g.pairs = g.n * (g.n + 1) / 2;
  const LawInfo law = g.block->material().info();
  g.objective = law.objective;
  g.stiffens = law.tangentStiffens;
  // Along the space-filling curve: elements of a batch turn together, chunks share few nodes.
  const auto& order = g.block->layout().batchOfElement;
  std::sort(elements.begin(), elements.end(), [&](std::int32_t a, std::int32_t b) { return order[a] < order[b]; });
  elements.resize((elements.size() + lanes - 1) / lanes * lanes, -1);
  g.elements = std::move(elements);
  const std::int32_t batches = g.elements.size() / lanes;
  for (std::int32_t b = 0; b < batches; b += chunkBatches) addChunk(g, b, std::min(batches, b + chunkBatches));
  fillGroup(g);
}

void ClusterMatrix::addChunk(Group& g, std::int32_t batchBegin, std::int32_t batchEnd) {
  Chunk c{batchBegin, batchEnd, static_cast<std::int32_t>(g.nodes.size()), 0};
  std::vector<std::int32_t> nodes;
  for (std::int32_t i = batchBegin * lanes; i < batchEnd * lanes; ++i)
    if (const std::int32_t e = g.elements[i]; e >= 0)
      for (const std::int32_t node : g.block->nodesOf(e))
        nodes.push_back(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
  sortUnique(nodes);
  for (std::int32_t batch = batchBegin; batch < batchEnd; ++batch) {
    const std::int32_t* e = g.elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    // A lane without element reads what the first one does, and adds nothing.
    std::array<std::span<const std::int32_t>, lanes> of;
    for (int lane = 0; lane < lanes; ++lane) of[lane] = g.block->nodesOf(e[e[lane] < 0 ? 0 : lane]);
    const auto rowOf = [&](int lane, int a) {
      const std::int32_t node = of[lane][a];
      return static_cast<std::int32_t>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
    };
    for (int a = 0; a < g.n; ++a)
      for (int lane = 0; lane < lanes; ++lane)
        g.localNodes.push_back(
            static_cast<std::uint16_t>(std::lower_bound(nodes.begin(), nodes.end(), rowOf(lane, a)) - nodes.begin()));
    for (int a = 0; a < g.n; ++a)
      for (int b = a; b < g.n; ++b)
        for (int lane = 0; lane < lanes; ++lane) {
          const std::int32_t i = rowOf(lane, a), j = rowOf(lane, b);
          const auto begin = upper_.column.begin() + upper_.rowBegin[std::min(i, j)];
          const auto end = upper_.column.begin() + upper_.rowBegin[static_cast<std::size_t>(std::min(i, j)) + 1];
          const std::int32_t place = std::lower_bound(begin, end, std::max(i, j)) - upper_.column.begin();
          const std::int32_t nowhere = upper_.column.size();
          g.places.push_back(e[lane] < 0 ? nowhere : (i <= j ? place : ~place));
        }
  }
  g.nodes.insert(g.nodes.end(), nodes.begin(), nodes.end());
  c.nodeEnd = static_cast<std::int32_t>(g.nodes.size());
  g.chunks.push_back(c);
}

void ClusterMatrix::fillGroup(Group& g) {
  const NodeVectors& X = body_.mesh().X;
  const auto batches = g.elements.size() / lanes, n = static_cast<std::size_t>(g.n);
  const std::size_t between = n * (n - 1) / 2;
  g.fittedGradient.resize(batches * 3 * n);
  g.rest.resize(batches * between * 9);
  for (auto* values : {&g.restHighest, &g.slack, &g.stretch, &g.scale, &g.gone}) values->resize(batches);
  g.rotation.resize(batches);
  const int size = 3 * g.n;
  K_.resize(9 * n * n);
  std::vector<double> mass(n);
  for (std::size_t batch = 0; batch < batches; ++batch) {
    const std::int32_t* elements = g.elements.data() + batch * lanes;
    g.block->tangentOf(elements, X.data(), reinterpret_cast<double*>(K_.data()));
    g.restHighest[batch] = highest(K_.data(), size);
    std::size_t pair = batch * between * 9;
    for (int a = 0; a < g.n; ++a)
      for (int b = a + 1; b < g.n; ++b)
        for (int i = 0; i < 9; ++i) g.rest[pair++] = K_[(3 * a + i / 3) * size + 3 * b + i % 3];
    for (int lane = 0; lane < lanes; ++lane) {
      const ElementRef ref{g.blockNumber, elements[elements[lane] < 0 ? 0 : lane]};
      const auto nodes = g.block->nodesOf(ref.element);
      Eigen::MatrixXd shape(g.n, 3);
      for (int a = 0; a < g.n; ++a) shape.row(a) = X.col(nodes[a]).transpose();
      shape.rowwise() -= shape.colwise().mean().eval();
      const Eigen::MatrixXd fitted = shape * (shape.transpose() * shape).inverse();
      for (int a = 0; a < g.n; ++a)
        for (int k = 0; k < 3; ++k)
          g.fittedGradient[(batch * n + static_cast<std::size_t>(a)) * 3 + static_cast<std::size_t>(k)].set(
              lane, fitted(a, k));
      double slack = infinity;
      if (elements[lane] >= 0) {
        body_.elementLumpedMass(ref, mass.data());
        const double lambda = g.restHighest[batch][lane] / *std::min_element(mass.begin(), mass.end());
        // h² <= 4 w. |ΔR|² = 2 θ² for small angles.
        slack = 2 * std::clamp(rotationShare / (4 * w_ * lambda), leastRotation * leastRotation,
                               mostRotation * mostRotation);
      }
      g.slack[batch].set(lane, slack);
    }
  }
}

void ClusterMatrix::gather(const Group& g, const Chunk& c, const NodeVectors& x, const Eigen::Matrix3d& frame) {
  table_.resize(std::max(table_.size(), 4 * static_cast<std::size_t>(c.nodeEnd - c.nodeBegin)));
  double* row = table_.data();
  for (std::int32_t i = c.nodeBegin; i < c.nodeEnd; ++i, row += 4) {
    const double* y = x.data() + 3 * static_cast<std::ptrdiff_t>(nodes_[g.nodes[i]]);
    for (int k = 0; k < 3; ++k) row[k] = frame(0, k) * y[0] + frame(1, k) * y[1] + frame(2, k) * y[2];
  }
}

Matrix3<P> ClusterMatrix::gradientOf(const Group& g, std::int32_t batch) const {
  const auto n = static_cast<std::size_t>(g.n), at = static_cast<std::size_t>(batch) * n;
  Matrix3<P> F = Matrix3<P>::zero();
  for (std::size_t a = 0; a < n; ++a) {
    P y[3];
    loadRows(table_.data(), g.localNodes.data() + (at + a) * lanes, y);
    const P* gradient = g.fittedGradient.data() + (at + a) * 3;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) F(i, j) += y[i] * gradient[j];
  }
  return F;
}

bool ClusterMatrix::follow(Group& g, Chunk& c, const NodeVectors& x, const Eigen::Matrix3d& frame, double stretch) {
  gather(g, c, x, frame);
  P fastest(0);
  for (std::int32_t batch = c.batchBegin; batch < c.batchEnd; ++batch) {
    const std::size_t at = batch;
    const Matrix3<P> F = gradientOf(g, batch), A = transposeTimes(g.rotation[at], F);
    // With F = R U, A = Q U and Q turning by θ about n, the axial vector a of A - Aᵀ has n·a = sin θ nᵀ(tr U I - U)n,
    // so that sin θ <= |a|/stretches with the sum of the two least ones; a bound of that follows from tr A <= tr U and
    // |F|².
    const P size = innerProduct(F, F), t = trace(A);
    const P ax = A.m[7] - A.m[5], ay = A.m[2] - A.m[6], az = A.m[3] - A.m[1];
    const P stretches = P(2.0 / 3) * t - math::sqrt(P(2.0 / 3) * math::max(P(0), size - P(1.0 / 3) * t * t));
    const P off = P(2) * (ax * ax + ay * ay + az * az), limit = g.slack[at] * stretches * stretches;
    const auto stretched = g.stiffens ? (size <= P(stretch) * g.stretch[at]) : (size <= size);
    const P gone = math::sqrt(off / limit);
    fastest = math::max(fastest, gone - g.gone[at]);
    g.gone[at] = gone;
    if (allOf((off <= limit) & (stretches > P(0)) & stretched)) continue;
    if (!allOf(size < P(infinity))) return false;
    const Matrix3<P> R = closestRotation(F), change = R - g.rotation[at];
    if (!allOf((innerProduct(change, change) <= g.slack[at]) & stretched))
      rotations_.push_back({R, size, g.scale[at], &g, batch});
  }
  double speed = 0;
  for (int lane = 0; lane < lanes; ++lane) speed = std::max(speed, fastest[lane]);
  speed /= c.waited;
  // Overdue by a quarter of the tolerance at most, at this speed. Not a number after a division by zero counts as none.
  c.wait = c.waited = std::max(1, static_cast<int>(std::min<double>(longestWait, 0.25 / speed)));
  return true;
}

bool ClusterMatrix::stiffen(Rotation& rotation, const NodeVectors& x) {
  const Group& g = *rotation.group;
  const std::size_t at = rotation.batch;
  K_.resize(9 * static_cast<std::size_t>(g.n * g.n));
  g.block->tangentOf(g.elements.data() + at * lanes, x.data(), reinterpret_cast<double*>(K_.data()));
  const P ratio = highest(K_.data(), 3 * g.n) / g.restHighest[at];
  for (int lane = 0; lane < lanes; ++lane) {
    if (g.elements[at * lanes + static_cast<std::size_t>(lane)] < 0) continue;
    if (!std::isfinite(ratio[lane])) return false;
    rotation.scale.set(lane, w_ * std::max(1.0, ratio[lane]));
  }
  return true;
}

void ClusterMatrix::add(const Rotation& rotation, bool fromScratch) {
  Group& g = *rotation.group;
  const auto at = static_cast<std::size_t>(rotation.batch), n = static_cast<std::size_t>(g.n);
  const std::size_t pairs = g.pairs;
  const Matrix3<P>&R = rotation.R, &before = g.rotation[at];
  sums_.assign(9 * pairs, P(0));
  const auto diagonalOf = [&](std::size_t a) { return sums_.data() + 9 * (a * n - a * (a - 1) / 2); };
  const P* rest = g.rest.data() + at * (pairs - n) * 9;
  std::size_t pair = 0;
  for (std::size_t a = 0; a < n; ++a) {
    ++pair;  // the diagonal's
    for (std::size_t b = a + 1; b < n; ++b, ++pair, rest += 9) {
      Matrix3<P> K;
      for (int i = 0; i < 9; ++i) K.m[i] = rest[i];
      Matrix3<P> D = rotation.scale * timesTranspose(R * K, R);
      if (!fromScratch) D = D - g.scale[at] * timesTranspose(before * K, before);
      P *own = sums_.data() + 9 * pair, *first = diagonalOf(a), *second = diagonalOf(b);
      for (int i = 0; i < 9; ++i) {
        own[i] = D.m[i];
        first[i] -= D.m[i];
        second[i] -= D.m[i % 3 * 3 + i / 3];
      }
    }
  }
  const std::int32_t* places = g.places.data() + at * pairs * lanes;
  for (pair = 0; pair < pairs; ++pair)
    addBlocks(upper_.eight.data(), upper_.ninth.data(), places + pair * lanes, sums_.data() + 9 * pair, 3);
  const Chunk& c = g.chunks[at / chunkBatches];
  for (std::size_t i = at * n * lanes; i < (at + 1) * n * lanes; ++i)
    changed_[g.nodes[static_cast<std::size_t>(c.nodeBegin) + g.localNodes[i]]] = 1;
  g.gone[at] = P(0);
  g.rotation[at] = R;
  g.stretch[at] = rotation.stretch;
  g.scale[at] = rotation.scale;
}

bool ClusterMatrix::make(const NodeVectors& x, const Eigen::Matrix3d& frame) {
  rotations_.clear();
  for (Group& g : groups_)
    for (Chunk& c : g.chunks) {
      gather(g, c, x, frame);
      for (std::int32_t batch = c.batchBegin; batch < c.batchEnd; ++batch) {
        const Matrix3<P> F = gradientOf(g, batch);
        const P size = innerProduct(F, F);
        if (!allOf(size < P(infinity))) return false;
        rotations_.push_back({g.objective ? closestRotation(F) : Matrix3<P>::identity(), size, P(w_), &g, batch});
        if (g.stiffens && !stiffen(rotations_.back(), x)) return false;
      }
      c.wait = c.waited = 1;
    }
  std::fill(upper_.eight.begin(), upper_.eight.end(), 0.0);
  std::fill(upper_.ninth.begin(), upper_.ninth.end(), 0.0);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t k = upper_.rowBegin[i];
    upper_.eight[8 * k] = upper_.eight[8 * k + 4] = upper_.ninth[k] = body_.lumpedMass()[nodes_[i]];
  }
  for (const Rotation& rotation : rotations_) add(rotation, true);
  return true;
}

ClusterMatrix::Change ClusterMatrix::follow(const NodeVectors& x, const Eigen::Matrix3d& frame, bool whole) {
  rotations_.clear();
  for (Group& g : groups_)
    if (g.objective)
      for (Chunk& c : g.chunks)
        if (--c.wait <= 0 && !follow(g, c, x, frame, whole ? stretchOfAll : stretchOfEach)) return Change::notFinite;
  if (rotations_.empty()) return Change::none;
  if (whole) return make(x, frame) ? Change::some : Change::notFinite;
  for (Rotation& rotation : rotations_)
    if (rotation.group->stiffens && !stiffen(rotation, x)) return Change::notFinite;
  for (const Rotation& rotation : rotations_) add(rotation, false);
  return Change::some;
}

}  // namespace ringwatch
