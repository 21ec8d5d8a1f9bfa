#include <ringwatch/monitor/metrics/rings.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <omp.h>

#include <ringwatch/base/random.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>
#include <ringwatch/monitor/small/lanczos.h>

namespace ringwatch {
namespace {

constexpr double residualTolerance = 3e-6;

/// The symmetric matrix of a ring, 3×3 blocks in rows, both triangles.
struct RingMatrix {
  std::vector<std::size_t> rowBegin;
  std::vector<std::int32_t> column;
  std::vector<Eigen::Matrix3d> block;

  Eigen::Index size() const { return 3 * static_cast<Eigen::Index>(rowBegin.size() - 1); }
  void multiply(const Eigen::VectorXd& v, Eigen::VectorXd& product) const {
    for (std::size_t i = 0; i + 1 < rowBegin.size(); ++i) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t s = rowBegin[i]; s < rowBegin[i + 1]; ++s)
        sum.noalias() += block[s] * v.segment<3>(3 * column[s]);
      product.segment<3>(3 * static_cast<Eigen::Index>(i)) = sum;
    }
  }
};

/// lambda_max, solved densely and lifted by its rounding: an upper bound of the matrix's own.
double denseLargest(const RingMatrix& matrix, std::vector<double>& dense) {
  const std::size_t n = matrix.size();
  dense.assign(n * n + 4 * n, 0.0);
  for (std::size_t i = 0; i + 1 < matrix.rowBegin.size(); ++i)
    for (std::size_t s = matrix.rowBegin[i]; s < matrix.rowBegin[i + 1]; ++s)
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
          dense[(3 * i + r) * n + 3 * static_cast<std::size_t>(matrix.column[s]) + c] = matrix.block[s](r, c);
  const auto extremes =
      extremeEigenvalues<double>(dense.data(), static_cast<int>(n), dense.data() + n * n, /*wantLeast=*/false);
  return extremes.largest + eigenvalueRounding * extremes.scale;
}

/// The largest eigenvalue of the matrices of rings by Lanczos' iteration; keeps its memory.
class TopOfRing {
 public:
  /// The top Ritz value, lowered by its rounding: never above lambda_max. v: the start, overwritten.
  double largest(const RingMatrix& matrix, Eigen::VectorXd& v) {
    const double norm = v.norm();
    if (!(norm > 0)) return 0;  // nothing is free
    const Eigen::Index size = matrix.size();
    const LanczosMatrix& T = lanczos_.matrix();
    product_.resize(size);
    v /= norm;
    lanczos_.begin(v);
    while (true) {
      matrix.multiply(lanczos_.current(), product_);
      lanczos_.advance(product_);
      const double beta = T.beta.back();
      if (!std::isfinite(T.alpha.back() + beta)) return std::numeric_limits<double>::quiet_NaN();
      const bool exhausted = T.size() == size || !(beta > 1e-13 * T.radius);
      if (exhausted || T.size() % 4 == 0) {
        const double ritz = topOfTridiagonal();
        if (exhausted || beta * lastComponent(ritz) <= residualTolerance * std::abs(ritz))
          return ritz - eigenvalueRounding * T.radius;
      }
      lanczos_.extend(product_);
    }
  }

 private:
  double topOfTridiagonal() {
    const LanczosMatrix& T = lanczos_.matrix();
    if (!(T.radius > 0)) return T.radius;
    const std::size_t size = T.alpha.size();
    scaledDiagonal_.resize(size);
    scaledSquare_.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      scaledDiagonal_[i] = T.alpha[i] / T.radius;
      scaledSquare_[i] = (T.beta[i] / T.radius) * (T.beta[i] / T.radius);
    }
    return T.radius * largestByLaguerre<0, double>(scaledDiagonal_.data(), scaledSquare_.data(), static_cast<int>(size),
                                                   1 + 1e-13);
  }
  /// |last component| of the tridiagonal matrix's unit eigenvector at its top eigenvalue.
  double lastComponent(double ritz) const {
    const LanczosMatrix& T = lanczos_.matrix();
    double u = 1, previous = 0, sum = 1;
    for (std::size_t i = 0; i + 1 < T.alpha.size(); ++i) {
      const double before = i > 0 ? T.beta[i - 1] : 0.0;
      const double next = ((ritz - T.alpha[i]) * u - before * previous) / T.beta[i];
      previous = u;
      u = next;
      sum += u * u;
    }
    return std::abs(u) / std::sqrt(sum);
  }

  Lanczos<Eigen::VectorXd> lanczos_;
  std::vector<double> scaledDiagonal_, scaledSquare_;  // to a spectral radius of at most one
  Eigen::VectorXd product_;
};

/// What all rings of a body share.
class Rings {
 public:
  Rings(const Body& body, NodeVectorsView x, RingKind kind)
      : body_(body), kind_(kind), elementsAt_(nodeElements(body.mesh())), offset_(blockOffsets(body.mesh())) {
    body.assembleBlocks(x, matrix_);
    TangentSource::Workspace workspace;
    rounding_ = body.tangentRounding(x, workspace).cwiseQuotient(body.lumpedMass());
    if (kind == RingKind::reduced2) return;
    // The rims' blocks are sums over the ring's own elements.
    for (const auto& block : body.blocks()) {
      const std::size_t n = block->element().nodes;
      const std::size_t count = block->elementCount();
      tangent_.emplace_back(count * n * n);
      mass_.emplace_back(count * n);
    }
    body.forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, const NativePack* K) {
      const ElementBlock& block = *body.blocks()[b];
      const std::size_t n = block.element().nodes;
      forEachLane(block, batch, [&](int lane, std::int32_t e) {
        // forEachLane fills empty lanes with the first element, whose tangent is not there.
        if (block.layout().elements[batch * lanes + lane] < 0) return;
        Eigen::Matrix3d* target = tangent_[b].data() + static_cast<std::size_t>(e) * n * n;
        for (std::size_t a = 0; a < n; ++a)
          for (std::size_t c = 0; c < n; ++c)
            for (std::size_t r = 0; r < 3; ++r)
              for (std::size_t k = 0; k < 3; ++k) target[a * n + c](r, k) = K[(3 * a + r) * 3 * n + 3 * c + k][lane];
        body.elementLumpedMass({b, e}, mass_[b].data() + static_cast<std::size_t>(e) * n);
      });
    });
  }

  /// Scratch memory of one thread.
  struct Scratch {
    std::vector<std::int32_t> place;      // of every node: its position in the ring, -1 outside
    std::vector<char> taken;              // of every element, counted through
    std::vector<std::int32_t> nodes;      // of the ring, the inner ones first
    std::vector<ElementRef> elements;     // of the ring
    std::vector<std::int32_t> slotPlace;  // of every assembled block: its position in the ring's matrix
    std::vector<double> mass, dense;
    RingMatrix matrix;
    Eigen::VectorXd start;
    TopOfRing top;
  };

  /// lambda_max of the ring around the seeds: a node, or the nodes of an element.
  double evaluate(std::span<const std::int32_t> seeds, Scratch& scratch) const {
    if (scratch.place.empty()) {
      scratch.place.assign(body_.nodeCount(), -1);
      scratch.taken.assign(offset_.back(), 0);
      scratch.slotPlace.assign(matrix_.block.size(), -1);
    }
    scratch.nodes.assign(seeds.begin(), seeds.end());
    scratch.elements.clear();
    for (std::size_t i = 0; i < seeds.size(); ++i) scratch.place[seeds[i]] = static_cast<std::int32_t>(i);
    const int layers = kind_ == RingKind::vertex2 || kind_ == RingKind::element2 ? 2 : 1;
    std::size_t inner = 0, from = 0;
    for (int layer = 0; layer < layers; ++layer) {
      inner = scratch.nodes.size();
      for (; from < inner; ++from) addElementsAt(scratch.nodes[from], scratch);
    }
    if (kind_ == RingKind::reduced2) inner = scratch.nodes.size();  // the whole body's blocks and masses everywhere
    gather(inner, scratch);
    double lambda = 0;
    if (kind_ == RingKind::vertex1) {
      lambda = denseLargest(scratch.matrix, scratch.dense) + roundingOf(scratch);
    } else {
      scratch.start.resize(scratch.matrix.size());
      for (std::size_t i = 0; i < scratch.nodes.size(); ++i)
        for (int c = 0; c < 3; ++c)
          scratch.start[3 * static_cast<Eigen::Index>(i) + c] =
              freeFactor(body_, scratch.nodes[i], c) *
              randomEntry(0, 3 * static_cast<std::uint64_t>(scratch.nodes[i]) + static_cast<std::uint64_t>(c));
      lambda = scratch.top.largest(scratch.matrix, scratch.start);
      if (kind_ == RingKind::reduced2) lambda -= roundingOf(scratch);
    }
    for (const std::int32_t node : scratch.nodes) scratch.place[node] = -1;
    for (const ElementRef e : scratch.elements) scratch.taken[counted(e)] = 0;
    return lambda;
  }

 private:
  std::size_t counted(ElementRef e) const { return offset_[e.block] + static_cast<std::size_t>(e.element); }

  /// Of the ring's matrix, in its norm. Nodes on a rim have less mass in the ring than in the body.
  double roundingOf(const Scratch& scratch) const {
    double sum = 0;
    for (std::size_t i = 0; i < scratch.nodes.size(); ++i)
      sum += rounding_[scratch.nodes[i]] * body_.lumpedMass()[scratch.nodes[i]] * scratch.mass[i] * scratch.mass[i];
    return sum;
  }

  void addElementsAt(std::int32_t node, Scratch& scratch) const {
    for (const ElementNode& at : elementsAt_.row(node)) {
      const ElementRef e{at.block, at.element};
      if (scratch.taken[counted(e)]) continue;
      scratch.taken[counted(e)] = 1;
      scratch.elements.push_back(e);
      for (const std::int32_t other : body_.blocks()[e.block]->nodesOf(e.element)) {
        std::int32_t& place = scratch.place[other];
        if (place >= 0) continue;
        place = static_cast<std::int32_t>(scratch.nodes.size());
        scratch.nodes.push_back(other);
      }
    }
  }

  /// The ring's M^-½ K M^-½. All elements at the first `inner` nodes are in the ring: their blocks and masses are the
  /// whole body's.
  void gather(std::size_t inner, Scratch& scratch) const {
    RingMatrix& ring = scratch.matrix;
    const std::size_t count = scratch.nodes.size();
    ring.rowBegin.assign(1, 0);
    ring.column.clear();
    ring.block.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t node = scratch.nodes[i];
      for (std::int64_t s = matrix_.rowBegin[node]; s < matrix_.rowBegin[node + 1]; ++s) {
        const std::size_t slot = s;
        const std::int32_t j = scratch.place[matrix_.column[slot]];
        if (j < 0) continue;
        const bool rim = i >= inner && static_cast<std::size_t>(j) >= inner;
        scratch.slotPlace[slot] = static_cast<std::int32_t>(ring.block.size());
        ring.column.push_back(j);
        ring.block.push_back(rim ? Eigen::Matrix3d::Zero().eval() : matrix_.block[slot]);
      }
      ring.rowBegin.push_back(ring.block.size());
    }
    scratch.mass.assign(count, 0.0);
    for (std::size_t i = 0; i < inner; ++i) scratch.mass[i] = body_.lumpedMass()[scratch.nodes[i]];
    if (inner < count)
      for (const ElementRef e : scratch.elements) addRim(e, inner, scratch);
    for (double& m : scratch.mass) m = 1 / std::sqrt(m);
    const bool constrained = body_.constraints().any();
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t s = ring.rowBegin[i]; s < ring.rowBegin[i + 1]; ++s) {
        const std::size_t j = ring.column[s];
        ring.block[s] *= scratch.mass[i] * scratch.mass[j];
        if (!constrained) continue;
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c)
            ring.block[s](r, c) *= freeFactor(body_, scratch.nodes[i], r) * freeFactor(body_, scratch.nodes[j], c);
      }
  }

  /// Adds what an element of the ring gives to the rim: masses, and blocks between its nodes there.
  void addRim(ElementRef e, std::size_t inner, Scratch& scratch) const {
    const std::size_t b = e.block;
    const auto nodes = body_.blocks()[b]->nodesOf(e.element);
    const std::size_t n = nodes.size(), first = static_cast<std::size_t>(e.element) * n;
    const auto isRim = [&](std::size_t a) { return static_cast<std::size_t>(scratch.place[nodes[a]]) >= inner; };
    for (std::size_t a = 0; a < n; ++a) {
      if (!isRim(a)) continue;
      scratch.mass[scratch.place[nodes[a]]] += mass_[b][first + a];
      for (std::size_t c = 0; c < n; ++c) {
        if (!isRim(c)) continue;
        const std::size_t slot = matrix_.elementBlocks[b][first * n + a * n + c];
        scratch.matrix.block[scratch.slotPlace[slot]] += tangent_[b][first * n + a * n + c];
      }
    }
  }

  const Body& body_;
  RingKind kind_;
  CompressedRows<ElementNode> elementsAt_;
  std::vector<std::size_t> offset_;
  BlockMatrix matrix_;
  Eigen::VectorXd rounding_;                           // of every node, rad²/s²
  std::vector<std::vector<Eigen::Matrix3d>> tangent_;  // [block][(element * n + a) * n + b]
  std::vector<std::vector<double>> mass_;              // [block][element * n + a]
};

}  // namespace

std::vector<std::vector<double>> ringEigenvalues(const Body& body, NodeVectorsView x, RingKind kind,
                                                 const MetricProgress& progress) {
  const Rings rings(body, x, kind);
  const int threads = threadCount(body.threads());
  std::vector<Rings::Scratch> scratch(threads);
  // Slice by slice, so that the caller hears of it between two.
  constexpr std::int64_t slice = 256;
  const auto forEachRing = [&](std::int64_t count, std::int64_t before, std::int64_t total, const auto& evaluate) {
    for (std::int64_t first = 0; first < count; first += slice) {
      const std::int64_t end = std::min(count, first + slice);
      parallelFor(first, end, threads, [&](std::int64_t i) { evaluate(i, scratch[omp_get_thread_num()]); });
      if (progress) progress(static_cast<double>(before + end) / static_cast<double>(total));
    }
  };
  std::vector<std::vector<double>> values;
  for (const auto& block : body.blocks()) values.emplace_back(static_cast<std::size_t>(block->elementCount()));
  if (kind == RingKind::vertex1 || kind == RingKind::vertex2) {
    std::vector<double> nodal(body.nodeCount());
    forEachRing(body.nodeCount(), 0, body.nodeCount(), [&](std::int64_t i, Rings::Scratch& s) {
      const std::int32_t node = i;
      nodal[i] = rings.evaluate({&node, 1}, s);
    });
    for (std::size_t b = 0; b < values.size(); ++b)
      for (std::size_t e = 0; e < values[b].size(); ++e) {
        bool first = true;
        for (const std::int32_t node : body.blocks()[b]->nodesOf(e)) {
          const double value = nodal[node];
          if (first || value > values[b][e] || std::isnan(value)) values[b][e] = value;
          first = false;
          if (std::isnan(value)) break;
        }
      }
    return values;
  }
  const std::int64_t total = body.mesh().elementCount();
  std::int64_t before = 0;
  for (std::size_t b = 0; b < values.size(); ++b) {
    const std::int64_t count = values[b].size();
    forEachRing(count, before, total, [&](std::int64_t e, Rings::Scratch& s) {
      values[b][e] = rings.evaluate(body.blocks()[b]->nodesOf(e), s);
    });
    before += count;
  }
  return values;
}

bool vertexRingsAreUpperBound(const Body& body) {
  for (const auto& block : body.blocks())
    if (block->element().nodes != body.blocks()[0]->element().nodes) return false;
  return true;
}

}  // namespace ringwatch
