#include <ringwatch/handlers/relaxed_tetrahedra.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <ringwatch/materials/rotation.h>

namespace ringwatch {
namespace {

constexpr int lanes = PatchLayout::lanes;
constexpr std::size_t rowsOfPatch = 1024;  // no patch has more nodes
constexpr std::int64_t chunk = 2048;       // nodes a thread sums at a time

/// A tetrahedron at rest.
struct RestShape {
  Eigen::Matrix<double, 3, 4> gradient;  // ∂N_a/∂X, 1/m
  double volume;
};
RestShape restShape(const NodeVectors& X, std::span<const std::int32_t> nodes) {
  Eigen::Matrix3d edges;
  for (int a = 0; a < 3; ++a) edges.col(a) = X.col(nodes[static_cast<std::size_t>(a) + 1]) - X.col(nodes[0]);
  RestShape shape;
  shape.gradient.rightCols<3>() = edges.inverse().transpose();
  shape.gradient.col(0) = -shape.gradient.rightCols<3>().rowwise().sum();
  shape.volume = edges.determinant() / 6;
  return shape;
}

bool isFixed(const Body& body, std::int32_t node) { return body.constraints().freeComponents(node) == 0; }

/// The highest eigenvalue of V C^½ B C^½, that is of M⁻¹K, rad²/s², with H = diag(eta).
double highestEigenvalue(Lame lame, double volume, const Eigen::Vector3d& eta) {
  const Eigen::Vector3d root = eta.cwiseSqrt();
  const Eigen::Matrix3d normal =
      2 * lame.mu * Eigen::Matrix3d(eta.asDiagonal()) + lame.lambda * root * root.transpose();
  const double highest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues()[2];
  return volume * std::max(highest, lame.mu * (eta[1] + eta[2]));  // eta ascends
}

/// Factors τ_j of the passes, such that what they leave of the residual at an eigenvalue 0 < μ <= 1 of a pass,
///   Π (1 - τ_j μ) = (1 + T_p(y))/(1 + T_p(y0)),   y = (1 + low - 2 μ)/(1 - low),  y0 = y(0),
/// stays within [0, 1], T_p Chebyshev's polynomial and low as small as leaves a tenth at most on [low, 1]. Below zero
/// the passes would overshoot, and P need not be positive. An odd number of them leaves nothing at μ = 1: what one
/// element alone needs is exact.
std::vector<double> passFactors(int passes, double least) {
  constexpr double left = 0.1;
  const double y0 = std::cosh(std::acosh(2 / left - 1) / passes), low = std::max(least, (y0 - 1) / (y0 + 1));
  std::vector<double> factors;
  for (int i = 0; i < passes; ++i) {
    const int j = i % 2 == 0 ? i / 2 : passes - 1 - i / 2;  // large and small in turn, so that rounding does not grow
    const int odd = j | 1;                                  // each root twice, but for -1
    const double y = std::cos(std::numbers::pi * odd / passes);
    factors.push_back(2 / (1 + low - y * (1 - low)));
  }
  return factors;
}

using P = NativePack;

RINGWATCH_INLINE Matrix3<P> symmetric(const P (&s)[6]) {
  return {{s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2]}};
}

/// The turn [w]× F A, A = diag(inertia), with the torque of a stress about F: (tr(C) I - C) w = axial(stress Fᵀ), C =
/// F A Fᵀ. Zero where the nodes lie on one line, which has no such axis.
RINGWATCH_INLINE Matrix3<P> turnAgainst(const Matrix3<P>& stress, const Matrix3<P>& F, const P (&inertia)[3]) {
  Matrix3<P> FA;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) FA(i, j) = F(i, j) * inertia[j];
  const Matrix3<P> C = timesTranspose(FA, F), T = timesTranspose(stress, F);
  const P size = trace(C);
  const Matrix3<P> J = Matrix3<P>::diagonal(size) - C, cof = cofactor(J);
  const P det = J.m[0] * cof.m[0] + J.m[1] * cof.m[1] + J.m[2] * cof.m[2];
  const auto turns = det > P(1e-13) * size * size * size;
  const P scale = select(turns, P(1.0) / select(turns, det, P(1.0)), P(0.0));
  const P t0 = scale * (T.m[7] - T.m[5]), t1 = scale * (T.m[2] - T.m[6]), t2 = scale * (T.m[3] - T.m[1]);
  const P w0 = cof.m[0] * t0 + cof.m[1] * t1 + cof.m[2] * t2, w1 = cof.m[3] * t0 + cof.m[4] * t1 + cof.m[5] * t2,
          w2 = cof.m[6] * t0 + cof.m[7] * t1 + cof.m[8] * t2;
  const P o(0.0);
  return Matrix3<P>{{o, -w2, w1, w2, o, -w0, -w1, w0, o}} * FA;
}

}  // namespace

RelaxedTetrahedra::RelaxedTetrahedra(const Body& body, const std::vector<ElementRef>& elements, double h,
                                     GoalShape goal, int passes)
    : body_(body), h_(h), goal_(goal), passes_(goal == GoalShape::rigid ? 1 : passes) {
  Mesh mesh;
  mesh.X = body.mesh().X;
  MeshBlock block{body.mesh().blocks[static_cast<std::size_t>(elements.front().block)].type, {}, {}};
  const auto nodesOf = [&](ElementRef e) {
    return body.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element);
  };
  for (const ElementRef e : elements)
    for (const std::int32_t node : nodesOf(e)) block.connectivity.push_back(node);
  block.ids.resize(elements.size());
  layout_ = layOutPatches(mesh, block);

  // What each element weighs at its nodes, and all of them together.
  std::vector<double> weight(4 * elements.size()), sum(mesh.nodeCount(), 0.0);
  std::vector<int> overlap(mesh.nodeCount(), 0);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto nodes = nodesOf(elements[i]);
    const RestShape shape = restShape(mesh.X, nodes);
    const Lame lame = body.blocks()[static_cast<std::size_t>(elements[i].block)]->material().lame();
    for (std::size_t a = 0; a < 4; ++a) {
      weight[4 * i + a] = goal == GoalShape::rigid ? 1
                                                   : shape.volume * (lame.lambda + 4 * lame.mu) *
                                                         shape.gradient.col(static_cast<Eigen::Index>(a)).squaredNorm();
      sum[static_cast<std::size_t>(nodes[a])] += weight[4 * i + a];
      largestOverlap_ = std::max(largestOverlap_, ++overlap[static_cast<std::size_t>(nodes[a])]);
    }
  }

  batches_.resize(static_cast<std::size_t>(layout_.batchCount()));
  std::fill_n(reinterpret_cast<double*>(batches_.data()), batches_.size() * sizeof(Batch) / sizeof(double), 0.0);
  if (passes_ > 1) memory_.resize(batches_.size());
  alpha_.resize(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto nodes = nodesOf(elements[i]);
    double share[4];
    for (std::size_t a = 0; a < 4; ++a)
      share[a] = body.lumpedMass()[nodes[a]] * weight[4 * i + a] / sum[static_cast<std::size_t>(nodes[a])];
    setElement(i, body, elements[i], share, h, goal);
  }

  factors_ = passFactors(passes_, 1 - *std::max_element(alpha_.begin(), alpha_.end()));

  std::vector<std::int32_t> place(mesh.nodeCount(), -1);
  for (std::size_t i = 0; i < overlap.size(); ++i)
    if (overlap[i] > 0) {
      place[i] = static_cast<std::int32_t>(nodes_.size());
      nodes_.push_back(static_cast<std::int32_t>(i));
      for (int c = 0; c < 3; ++c)
        inverseMass_.push_back(body.constraints().isConstrained(nodes_.back(), c)
                                   ? 0
                                   : 1 / body.lumpedMass()[static_cast<Eigen::Index>(i)]);
    }
  slotBegin_.assign(nodes_.size() + 1, 0);
  for (const std::int32_t node : layout_.nodes)
    ++slotBegin_[static_cast<std::size_t>(place[static_cast<std::size_t>(node)]) + 1];
  for (std::size_t i = 1; i < slotBegin_.size(); ++i) slotBegin_[i] += slotBegin_[i - 1];
  slot_.resize(layout_.nodes.size());
  std::vector<std::int32_t> next(slotBegin_.begin(), slotBegin_.end() - 1);
  for (std::size_t s = 0; s < layout_.nodes.size(); ++s)
    slot_[static_cast<std::size_t>(
        next[static_cast<std::size_t>(place[static_cast<std::size_t>(layout_.nodes[s])])]++)] =
        static_cast<std::int32_t>(s);
  slots_.resize(4 * layout_.nodes.size());
}

void RelaxedTetrahedra::setElement(std::size_t i, const Body& body, ElementRef ref, const double* share, double h,
                                   GoalShape goal) {
  const ElementBlock& block = *body.blocks()[static_cast<std::size_t>(ref.block)];
  const auto nodes = block.nodesOf(ref.element);
  const RestShape shape = restShape(body.mesh().X, nodes);
  const Lame lame = block.material().lame();
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  bool constrained = false;
  for (int a = 0; a < 4; ++a) {
    const std::int32_t node = nodes[static_cast<std::size_t>(a)];
    constrained = constrained || body.constraints().freeComponents(node) < 3;
    // A rigid goal with a node of infinite mass would need another centre: all of its nodes count as free, and moves of
    // fixed ones are left out.
    if (goal == GoalShape::rigid || !isFixed(body, node))
      H += shape.gradient.col(a) * shape.gradient.col(a).transpose() / share[a];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(H);
  const Eigen::Vector3d eta = axes.eigenvalues().cwiseMax(0.0);
  const double lambda = highestEigenvalue(lame, shape.volume, eta);
  alpha_[i] = h * h * lambda / (1 + h * h * lambda);

  Eigen::Matrix3d principal = axes.eigenvectors();
  if (principal.determinant() < 0) principal.col(0) *= -1;  // a rotation, or F would count as inverted in these axes

  const std::int32_t at = layout_.batchOfElement[i];
  Batch& batch = batches_[static_cast<std::size_t>(at / lanes)];
  const int lane = at % lanes;
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d g = principal.transpose() * shape.gradient.col(a + 1);
    for (int c = 0; c < 3; ++c) batch.gradient[a][c].set(lane, g[c]);
    if (!constrained || goal == GoalShape::rigid) batch.inertia[a].set(lane, 1 / eta[a]);
  }
  if (goal == GoalShape::rigid) {
    for (int a = 0; a < 3; ++a) batch.normal[a].set(lane, alpha_[i] / (h * h * eta[a]));
    return;
  }
  const double compliance = 1 / (2 * lame.mu * shape.volume),
               dilatation = compliance * lame.lambda / (2 * lame.mu + 3 * lame.lambda);
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    const double d = 1 / (compliance + h * h * eta[a]);
    sum += d;
    batch.normal[a].set(lane, d);
    batch.shear[a].set(lane, 1 / (compliance + 0.5 * h * h * (eta[(a + 1) % 3] + eta[(a + 2) % 3])));
  }
  batch.coupling.set(lane, dilatation / (1 - dilatation * sum));
  batch.compliance.set(lane, compliance);
  batch.dilatation.set(lane, dilatation);
}

template <GoalShape goal, bool first, bool last>
void RelaxedTetrahedra::relaxPatch(const Patch& patch, const NodeVectors& x, const NodeVectors& v, const NodeVectors& a,
                                   double factor, double* slots) {
  alignas(64) double predicted[4 * rowsOfPatch];
  alignas(64) double start[last ? 4 * rowsOfPatch : 1];
  const std::int32_t* nodes = layout_.nodes.data() + patch.nodeBegin;
  const int count = patch.nodeEnd - patch.nodeBegin;
  for (int i = 0; i < count; ++i) {
    const std::ptrdiff_t from = 3 * static_cast<std::ptrdiff_t>(nodes[i]);
    for (int c = 0; c < 3; ++c) {
      const double now = x.data()[from + c];
      predicted[4 * i + c] = now + h_ * (v.data()[from + c] + h_ * a.data()[from + c]);
      if constexpr (last) start[4 * i + c] = now;
    }
    predicted[4 * i + 3] = 0;
    if constexpr (last) start[4 * i + 3] = 0;
  }
  for (std::int32_t k = patch.batchBegin; k < patch.batchEnd; ++k) {
    const Batch& batch = batches_[static_cast<std::size_t>(k)];
    const std::uint16_t* local = layout_.localNodes.data() + static_cast<std::ptrdiff_t>(k) * 4 * lanes;
    const auto gradientOf = [&](const double* rows) {
      P corner[3], other[3];
      loadRows(rows, local, corner);
      Matrix3<P> F = Matrix3<P>::zero();
      for (int n = 0; n < 3; ++n) {
        loadRows(rows, local + (n + 1) * lanes, other);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) F(i, j) += (other[i] - corner[i]) * batch.gradient[n][j];
      }
      return F;
    };
    Matrix3<P> R, stress;
    const Matrix3<P> F = gradientOf(predicted);
    if constexpr (first)
      R = closestRotation(F);
    else
      for (int i = 0; i < 9; ++i) R.m[i] = memory_[static_cast<std::size_t>(k)].R[i];
    const Matrix3<P> S = transposeTimes(R, F);
    P strain[6] = {S.m[0] - P(1.0),
                   S.m[4] - P(1.0),
                   S.m[8] - P(1.0),
                   P(0.5) * (S.m[5] + S.m[7]),
                   P(0.5) * (S.m[2] + S.m[6]),
                   P(0.5) * (S.m[1] + S.m[3])};
    [[maybe_unused]] Matrix3<P> before = Matrix3<P>::zero();
    if constexpr (goal == GoalShape::rigid) {
      const P(&n)[3] = batch.normal;
      stress = {{strain[0] * n[0], strain[5] * n[1], strain[4] * n[2], strain[5] * n[0], strain[1] * n[1],
                 strain[3] * n[2], strain[4] * n[0], strain[3] * n[1], strain[2] * n[2]}};
    } else {
      if constexpr (!first) {
        const P(&s)[6] = memory_[static_cast<std::size_t>(k)].stress;
        const P pressure = batch.dilatation * (s[0] + s[1] + s[2]);
        for (int i = 0; i < 6; ++i) strain[i] -= batch.compliance * s[i];
        for (int i = 0; i < 3; ++i) strain[i] += pressure;
        before = symmetric(s);
      }
      for (P& e : strain) e *= P(factor);
      P d[3], all(0.0);
      for (int i = 0; i < 3; ++i) {
        d[i] = batch.normal[i] * strain[i];
        all += d[i];
      }
      all *= batch.coupling;
      P s[6];
      for (int i = 0; i < 3; ++i) {
        s[i] = d[i] + all * batch.normal[i];
        s[i + 3] = batch.shear[i] * strain[i + 3];
      }
      stress = symmetric(s);
      if constexpr (!last) {
        Memory& memory = memory_[static_cast<std::size_t>(k)];
        for (int i = 0; i < 6; ++i) memory.stress[i] = first ? s[i] : memory.stress[i] + s[i];
        if constexpr (first)
          for (int i = 0; i < 9; ++i) memory.R[i] = R.m[i];
      }
    }
    Matrix3<P> piola = R * stress;
    if constexpr (last) {
      const Matrix3<P> F0 = gradientOf(start);
      piola = piola - turnAgainst(first ? piola : R * (before + stress), F0, batch.inertia);
    }
    P force[3], sum[3] = {P(0.0), P(0.0), P(0.0)};
    for (int n = 0; n < 3; ++n) {
      const P(&g)[3] = batch.gradient[n];
      for (int i = 0; i < 3; ++i) {
        force[i] = -(piola(i, 0) * g[0] + piola(i, 1) * g[1] + piola(i, 2) * g[2]);
        sum[i] -= force[i];
      }
      addRows(slots, local + (n + 1) * lanes, force);
    }
    addRows(slots, local, sum);
  }
}

bool RelaxedTetrahedra::addForces(NodeVectors& a) {
  const auto count = static_cast<std::int64_t>(nodes_.size()), chunks = (count + chunk - 1) / chunk;
  finite_.assign(static_cast<std::size_t>(chunks), 1);
  parallelFor(0, chunks, body_.threads(), [&](std::int64_t c) {
    double all = 0;
    for (std::int64_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i) {
      const auto n = static_cast<std::size_t>(i);
      double sum[3] = {0, 0, 0};
      for (std::int32_t s = slotBegin_[n]; s < slotBegin_[n + 1]; ++s) {
        const double* row = slots_.data() + 4 * static_cast<std::ptrdiff_t>(slot_[static_cast<std::size_t>(s)]);
        for (int k = 0; k < 3; ++k) sum[k] += row[k];
      }
      for (int k = 0; k < 3; ++k) {
        a(k, nodes_[n]) += sum[k] * inverseMass_[3 * n + static_cast<std::size_t>(k)];
        all += a(k, nodes_[n]);
      }
    }
    finite_[static_cast<std::size_t>(c)] = std::isfinite(all);
  });
  return std::all_of(finite_.begin(), finite_.end(), [](std::uint8_t f) { return f != 0; });
}

bool RelaxedTetrahedra::relax(const NodeVectors& x, const NodeVectors& v, NodeVectors& a) {
  for (int pass = 0; pass < passes_; ++pass) {
    parallelFor(0, static_cast<std::int64_t>(layout_.patches.size()), body_.threads(), [&](std::int64_t p) {
      const Patch& patch = layout_.patches[static_cast<std::size_t>(p)];
      double* own = slots_.data() + 4 * static_cast<std::ptrdiff_t>(patch.nodeBegin);
      std::fill(own, own + 4 * static_cast<std::ptrdiff_t>(patch.nodeEnd - patch.nodeBegin), 0.0);
      const bool first = pass == 0, last = pass == passes_ - 1;
      const double factor = factors_[static_cast<std::size_t>(pass)];
      if (goal_ == GoalShape::rigid)
        relaxPatch<GoalShape::rigid, true, true>(patch, x, v, a, factor, own);
      else if (first && last)
        relaxPatch<GoalShape::linear, true, true>(patch, x, v, a, factor, own);
      else if (first)
        relaxPatch<GoalShape::linear, true, false>(patch, x, v, a, factor, own);
      else if (last)
        relaxPatch<GoalShape::linear, false, true>(patch, x, v, a, factor, own);
      else
        relaxPatch<GoalShape::linear, false, false>(patch, x, v, a, factor, own);
    });
    if (!addForces(a)) return false;
  }
  return true;
}

}  // namespace ringwatch
