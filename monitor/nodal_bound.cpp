#include <ringwatch/monitor/nodal_bound.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/nodal_shapes.h>
#include <ringwatch/monitor/scaled_tangent.h>

namespace ringwatch {
namespace {

constexpr int lanes = PatchLayout::lanes;

using P = NativePack;
typedef float Floats __attribute__((vector_size(lanes * sizeof(float))));

/// K_ab ← L_a⁻¹ K_ab L_b⁻ᵀ, D_a = L_a L_aᵀ, for the lower triangle.
void scaleByShapes(const Symmetric3<P>* shapes, int n, P* K) {
  P w[maxElementNodes][6];
  for (int a = 0; a < n; ++a) inverseCholesky(shapes[a], w[a]);
  scaleByFactors(w, n, K);
}

/// Zeroes the rows and columns of constrained degrees of freedom.
void clearConstrained(const Body& body, const ElementBlock& block, const std::int32_t* elements, P* K) {
  if (!body.constraints().any()) return;
  const int n = block.element().nodes;
  bool some = false;
  for (int lane = 0; lane < lanes; ++lane)
    for (const std::int32_t node : block.nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]))
      some |= body.constraints().freeComponents(node) < 3;
  if (!some) return;
  P factor[3 * maxElementNodes];
  for (int lane = 0; lane < lanes; ++lane) {
    const auto nodes = block.nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]);
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 3; ++c) factor[3 * a + c].set(lane, freeFactor(body, nodes[static_cast<std::size_t>(a)], c));
  }
  scaleSymmetric(K, 3 * n, factor);
}

}  // namespace

NodalBound::NodalBound(const Body& body) : body_(&body) {
  std::vector<std::int64_t> count(static_cast<std::size_t>(body.nodeCount()) + 1, 0);
  auto forEachIncidence = [&](auto&& visit) {
    for (std::size_t b = 0; b < body.blocks().size(); ++b) {
      const ElementBlock& block = *body.blocks()[b];
      const int n = block.element().nodes;
      for (std::int32_t e = 0; e < block.elementCount(); ++e) {
        const auto nodes = block.nodesOf(e);
        for (int a = 0; a < n; ++a)
          visit(nodes[static_cast<std::size_t>(a)], incidenceOf({static_cast<std::int32_t>(b), e}, a));
      }
    }
  };
  forEachIncidence([&](std::int32_t node, Incidence) { ++count[static_cast<std::size_t>(node) + 1]; });
  for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
  incidenceBegin_ = count;
  std::int64_t places = 0;
  for (const auto& block : body.blocks()) {
    const auto shapes =
        static_cast<std::size_t>(block->layout().batchCount()) * static_cast<std::size_t>(block->element().nodes);
    firstOfBlock_.push_back(static_cast<std::int32_t>(places));
    places += static_cast<std::int64_t>(shapes * lanes);
    if (places > std::numeric_limits<std::int32_t>::max())
      throw InputError("the nodal bound: more than 2^31 nodes of elements; use a metric for a body of this size");
    shapes_.emplace_back(shapes);
  }
  firstOfBlock_.push_back(static_cast<std::int32_t>(places));
  incidence_.resize(static_cast<std::size_t>(count.back()));
  forEachIncidence([&](std::int32_t node, Incidence i) {
    incidence_[static_cast<std::size_t>(count[static_cast<std::size_t>(node)]++)] =
        firstOfBlock_[static_cast<std::size_t>(i.block)] + i.place;
  });
}

Symmetric3<P> NodalBound::load(const StoredShape& stored) {
  Symmetric3<P> shape;
  for (int c = 0; c < 6; ++c) {
    Floats values;
    std::memcpy(&values, stored.m[c], sizeof values);
    shape.m[c] = P(__builtin_convertvector(values, P::Values));
  }
  return shape;
}

NodalBound::StoredShape NodalBound::rounded(const Symmetric3<P>& shape) {
  StoredShape stored;
  for (int c = 0; c < 6; ++c) {
    const Floats values = __builtin_convertvector(shape.m[c].v, Floats);
    std::memcpy(stored.m[c], &values, sizeof values);
  }
  return stored;
}

void NodalBound::prepareSums() {
  const std::size_t packs = (static_cast<std::size_t>(body_->nodeCount()) + lanes - 1) / lanes;
  if (sums_.size() == packs && values_.size() == shapes_.size()) return;
  for (const auto& block : body_->blocks())
    values_.emplace_back(static_cast<std::size_t>(block->layout().batchCount()));
  sums_.resize(packs);
  factors_.resize(packs);
  nodal_.resize(packs * lanes);
}

void NodalBound::releaseSums() {
  values_ = {};
  sums_ = {};
  factors_ = {};
  nodal_ = {};
}

void NodalBound::startShapes(const NodeVectors& x, Start start) {
  body_->forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, P* K) {
    const ElementBlock& block = *body_->blocks()[b];
    const int n = block.element().nodes, size = 3 * n;
    clearConstrained(*body_, block, block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, K);
    Symmetric3<P> shapes[maxElementNodes];
    for (int a = 0; a < n; ++a) {
      Symmetric3<P> k;
      for (int r = 0; r < 3; ++r)
        for (int c = r; c < 3; ++c) k(r, c) = K[(3 * a + r) * size + 3 * a + c];
      shapes[a] = startShape(k, start == Start::rootOfStiffness);
    }
    normaliseShapes(shapes, n);
    StoredShape* stored = shapes_[b].data() + static_cast<std::ptrdiff_t>(batch) * n;
    for (int a = 0; a < n; ++a) stored[a] = rounded(shapes[a]);
  });
}

void NodalBound::evaluateElements(const NodeVectors& x) {
  body_->forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, P* K) {
    const ElementBlock& block = *body_->blocks()[b];
    const int n = block.element().nodes, size = 3 * n;
    clearConstrained(*body_, block, block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, K);
    P work[12 * maxElementNodes];
    Symmetric3<P> shapes[maxElementNodes];
    for (int a = 0; a < n; ++a) shapes[a] = load(shapes_[b][static_cast<std::size_t>(batch * n + a)]);
    scaleByShapes(shapes, n, K);
    values_[b][static_cast<std::size_t>(batch)] = largestRoundedUp(K, size, work);
  });
  for (const auto& block : body_->blocks()) evaluations_ += block->elementCount();
}

double NodalBound::sumAtNodes() {
  const std::int32_t nodes = body_->nodeCount();
  parallelFor(
      0, static_cast<std::int64_t>(sums_.size()), body_->threads(),
      [&](std::int64_t pack) {
        Symmetric3<P> S;
        for (P& entry : S.m) entry = P(0.0);
        for (int lane = 0; lane < lanes; ++lane) {
          const auto node = static_cast<std::int32_t>(pack) * lanes + lane;
          if (node >= nodes) continue;
          double sum[6] = {0, 0, 0, 0, 0, 0};
          if (!outside_.empty())
            for (int r = 0; r < 3; ++r)
              for (int c = r; c < 3; ++c)
                sum[Symmetric3<P>::index(r, c)] = outside_[static_cast<std::size_t>(node)](r, c);
          for (const Incidence at : incidences(node)) {
            const auto block = static_cast<std::size_t>(at.block);
            const int l = at.place % lanes;
            const StoredShape& D = shapes_[block][static_cast<std::size_t>(at.place / lanes)];
            const double value =
                values_[block][static_cast<std::size_t>(at.place / lanes / body_->blocks()[block]->element().nodes)][l];
            for (int c = 0; c < 6; ++c) sum[c] += value * static_cast<double>(D.m[c][l]);
          }
          const double inverseMass = 1 / body_->lumpedMass()[node];
          // Constrained components leave the problem: their rows and columns count nothing.
          const double free[3] = {freeFactor(*body_, node, 0), freeFactor(*body_, node, 1),
                                  freeFactor(*body_, node, 2)};
          const double keep[6] = {free[0], free[1], free[2], free[1] * free[2], free[0] * free[2], free[0] * free[1]};
          for (int c = 0; c < 6; ++c) S.m[c].set(lane, keep[c] == 0 ? 0.0 : inverseMass * sum[c]);
        }
        sums_[static_cast<std::size_t>(pack)] = S;
        P A[9], work[12];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j <= i; ++j) A[3 * i + j] = S(i, j);
        const auto extremes = extremeEigenvalues(A, 3, work, false);
        (extremes.largest + P(eigenvalueRounding) * extremes.scale).store(nodal_.data() + pack * lanes);
      },
      64);
  double bound = 0;
  for (std::int32_t i = 0; i < nodes; ++i) {
    if (std::isnan(nodal_[static_cast<std::size_t>(i)])) return std::numeric_limits<double>::quiet_NaN();
    bound = std::max(bound, nodal_[static_cast<std::size_t>(i)]);
  }
  return bound;
}

void NodalBound::sweepShapes(double bound) {
  const std::int32_t nodes = body_->nodeCount();
  parallelFor(
      0, static_cast<std::int64_t>(sums_.size()), body_->threads(),
      [&](std::int64_t pack) {
        Symmetric3<P> S = P(1 / bound) * sums_[static_cast<std::size_t>(pack)];
        for (int lane = 0; lane < lanes; ++lane) {
          const auto node = static_cast<std::int32_t>(pack) * lanes + lane;
          if (node >= nodes)
            for (int c = 0; c < 3; ++c) S.m[c].set(lane, 1.0);
          else
            for (int c = 0; c < 3; ++c)
              if (freeFactor(*body_, node, c) == 0) S.m[c].set(lane, 1.0);
        }
        factors_[static_cast<std::size_t>(pack)] = sweepFactor(S);
      },
      64);
  for (std::size_t b = 0; b < body_->blocks().size(); ++b) {
    const ElementBlock& block = *body_->blocks()[b];
    const int n = block.element().nodes;
    parallelFor(
        0, block.layout().batchCount(), body_->threads(),
        [&](std::int64_t batch) {
          StoredShape* stored = shapes_[b].data() + batch * n;
          Symmetric3<P> shapes[maxElementNodes];
          for (int a = 0; a < n; ++a) {
            Symmetric3<P> R;
            forEachLane(block, static_cast<std::int32_t>(batch), [&](int lane, std::int32_t e) {
              const std::int32_t node = block.nodesOf(e)[static_cast<std::size_t>(a)];
              const Symmetric3<P>& from = factors_[static_cast<std::size_t>(node / lanes)];
              for (int c = 0; c < 6; ++c) R.m[c].set(lane, from.m[c][node % lanes]);
            });
            shapes[a] = congruence(R, load(stored[a]));
          }
          normaliseShapes(shapes, n);
          for (int a = 0; a < n; ++a) stored[a] = rounded(shapes[a]);
        },
        64);
  }
}

UpperBound NodalBound::evaluate(const NodeVectors& x, int sweeps, Start start, double leastGain) {
  evaluations_ = 0;
  prepareSums();
  if (!started_) startShapes(x, start);
  started_ = true;
  double best = std::numeric_limits<double>::infinity(), before[2] = {best, best};
  for (int sweep = 0;; ++sweep) {
    evaluateElements(x);
    const double bound = sumAtNodes();
    last_ = bound;
    if (std::isnan(bound)) {
      started_ = false;
      return {bound};
    }
    best = std::min(best, bound);
    if (sweep == sweeps || !(bound > 0) || (leastGain > 0 && bound >= (1 - leastGain) * before[0])) break;
    before[0] = before[1];
    before[1] = bound;
    sweepShapes(bound);
  }
  return {best};
}

ElementRef NodalBound::elementAt(Incidence at) const {
  const ElementBlock& block = *body_->blocks()[static_cast<std::size_t>(at.block)];
  const std::int32_t batch = at.place / lanes / block.element().nodes;
  return {at.block, block.layout().elements[static_cast<std::size_t>(batch * lanes + at.place % lanes)]};
}

NodalBound::Incidence NodalBound::incidenceOf(ElementRef e, int a) const {
  const ElementBlock& block = *body_->blocks()[static_cast<std::size_t>(e.block)];
  const std::int32_t place = block.layout().batchOfElement[static_cast<std::size_t>(e.element)];
  return {e.block, (place / lanes * block.element().nodes + a) * lanes + place % lanes};
}

Eigen::Matrix3d NodalBound::shape(Incidence at) const {
  const StoredShape& D = shapes_[static_cast<std::size_t>(at.block)][static_cast<std::size_t>(at.place / lanes)];
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result(i, j) = static_cast<double>(D.m[Symmetric3<P>::index(i, j)][at.place % lanes]);
  return result;
}

void NodalBound::setShape(Incidence at, const Eigen::Matrix3d& D) {
  StoredShape& target = shapes_[static_cast<std::size_t>(at.block)][static_cast<std::size_t>(at.place / lanes)];
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      target.m[Symmetric3<P>::index(i, j)][at.place % lanes] = static_cast<float>(0.5 * (D(i, j) + D(j, i)));
}

void NodalBound::normaliseElement(std::int32_t b, std::int32_t element) {
  const ElementBlock& block = *body_->blocks()[static_cast<std::size_t>(b)];
  const int n = block.element().nodes;
  const std::int32_t place = block.layout().batchOfElement[static_cast<std::size_t>(element)];
  StoredShape* stored = shapes_[static_cast<std::size_t>(b)].data() + static_cast<std::ptrdiff_t>(place / lanes) * n;
  const int lane = place % lanes;
  Symmetric3<P> own[maxElementNodes];
  for (int a = 0; a < n; ++a) own[a] = load(stored[a]);
  normaliseShapes(own, n);
  for (int a = 0; a < n; ++a)
    for (int c = 0; c < 6; ++c) stored[a].m[c][lane] = static_cast<float>(own[a].m[c][lane]);
}

void NodalBound::elementValues(std::int32_t b, const std::int32_t* elements, const NodeVectors& x, double* values,
                               double* reach) const {
  const ElementBlock& block = *body_->blocks()[static_cast<std::size_t>(b)];
  const int n = block.element().nodes, size = 3 * n;
  StoredShape gathered[maxElementNodes];
  for (int lane = 0; lane < lanes; ++lane) {
    const std::int32_t place =
        block.layout().batchOfElement[static_cast<std::size_t>(elements[lane] < 0 ? elements[0] : elements[lane])];
    const StoredShape* from =
        shapes_[static_cast<std::size_t>(b)].data() + static_cast<std::ptrdiff_t>(place / lanes) * n;
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 6; ++c) gathered[a].m[c][lane] = from[a].m[c][place % lanes];
  }
  Symmetric3<P> own[maxElementNodes];
  for (int a = 0; a < n; ++a) own[a] = load(gathered[a]);
  P K[9 * maxElementNodes * maxElementNodes], work[12 * maxElementNodes];
  block.tangentOf(elements, x.data(), reinterpret_cast<double*>(K));
  clearConstrained(*body_, block, elements, K);
  scaleByShapes(own, n, K);
  largestRoundedUp(K, size, work).store(values);
  if (!reach) return;
  P L[maxElementNodes * maxElementNodes];
  block.laplacianOf(elements, reinterpret_cast<double*>(L));
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) K[i * size + j] = i % 3 == j % 3 ? L[i / 3 * n + j / 3] : P(0.0);
  clearConstrained(*body_, block, elements, K);
  scaleByShapes(own, n, K);
  largestRoundedUp(K, size, work).store(reach);
}

const std::vector<double>& NodalBound::sumsOf(const std::vector<std::span<const float>>& values) {
  prepareSums();
  for (std::size_t b = 0; b < values_.size(); ++b)
    for (std::size_t place = 0; place < values[b].size(); ++place)
      values_[b][place / lanes].set(static_cast<int>(place % lanes), static_cast<double>(values[b][place]));
  sumAtNodes();
  return nodal_;
}

double NodalBound::value(ElementRef e) const {
  const ElementBlock& block = *body_->blocks()[static_cast<std::size_t>(e.block)];
  const std::int32_t place = block.layout().batchOfElement[static_cast<std::size_t>(e.element)];
  return values_[static_cast<std::size_t>(e.block)][static_cast<std::size_t>(place / lanes)][place % lanes];
}

}  // namespace ringwatch
