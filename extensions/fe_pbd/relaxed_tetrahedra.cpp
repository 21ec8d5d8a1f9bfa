#include <ringwatch/extensions/fe_pbd/relaxed_tetrahedra.h>

#include <algorithm>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/extensions/tetrahedra/corotated_tetrahedron.h>

namespace ringwatch {
namespace {

/// The highest eigenvalue of V C^½ B C^½, that is of M⁻¹K, rad²/s², with H = diag(eta).
double highestEigenvalue(Lame lame, double volume, const Eigen::Vector3d& eta) {
  const Eigen::Vector3d root = eta.cwiseSqrt();
  const Eigen::Matrix3d normal =
      2 * lame.mu * Eigen::Matrix3d(eta.asDiagonal()) + lame.lambda * root * root.transpose();
  const double highest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues()[2];
  return volume * std::max(highest, lame.mu * (eta[1] + eta[2]));  // eta ascends
}

}  // namespace

RelaxedTetrahedra::RelaxedTetrahedra(const Body& body, const std::vector<ElementRef>& elements, double h,
                                     GoalShape goal, int passes)
    : tetrahedra_(body, elements, h), goal_(goal), passes_(goal == GoalShape::rigid ? 1 : passes) {
  Batch none{};
  Memory rest{};
  for (int i = 0; i < 3; ++i) none.gradient[i][i] = rest.R(i, i) = P(1.0);
  batches_.assign(tetrahedra_.batchCount(), none);
  memory_.assign(batches_.size(), rest);
  std::vector<int> overlap(body.mesh().nodeCount(), 0);
  for (const ElementRef e : elements)
    for (const std::int32_t node : body.blocks()[e.block]->nodesOf(e.element)) ++overlap[node];
  alpha_.resize(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) setElement(i, body, elements[i], overlap, h);
}

void RelaxedTetrahedra::setElement(std::size_t i, const Body& body, ElementRef ref, const std::vector<int>& overlap,
                                   double h) {
  const bool rigid = goal_ == GoalShape::rigid;
  const ElementBlock& block = *body.blocks()[ref.block];
  const auto nodes = block.nodesOf(ref.element);
  const Lame lame = block.material().restModuli();
  Eigen::Vector4d inverseMass;
  bool constrained = false;
  for (int a = 0; a < 4; ++a) {
    const std::int32_t node = nodes[a];
    const int free = body.constraints().freeComponents(node);
    constrained = constrained || free < 3;
    // A rigid goal with a node of infinite mass would need another centre: all of its nodes count as free, and moves of
    // fixed ones are left out.
    inverseMass[a] = rigid ? overlap[node] / body.lumpedMass()[node] : free == 0 ? 0 : 1 / body.lumpedMass()[node];
  }
  const PrincipalTetrahedron shape = principalTetrahedron(body.mesh().X, nodes, inverseMass);
  const Eigen::Vector3d& eta = shape.eta;
  const double lambda = highestEigenvalue(lame, shape.volume, eta);
  alpha_[i] = h * h * lambda / (1 + h * h * lambda);

  const std::int32_t at = tetrahedra_.placeOf(i);
  Batch& batch = batches_[at / lanes];
  const int lane = at % lanes;
  for (int a = 0; a < 3; ++a) {
    for (int c = 0; c < 3; ++c) batch.gradient[a][c].set(lane, shape.gradient(c, a + 1));
    if (!constrained || rigid) batch.inertia[a].set(lane, 1 / eta[a]);
  }
  if (rigid) {
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
void RelaxedTetrahedra::visit(std::int32_t k) {
  const std::size_t at = k;
  const Batch& batch = batches_[at];
  Memory& memory = memory_[at];
  ColouredTetrahedra::Nodes nodes;
  tetrahedra_.load(k, nodes);
  Matrix3<P> F0, F;
  tetrahedra_.gradients(nodes, batch.gradient, F0, F);
  if constexpr (first) memory.R = followedRotation(F, memory.R);
  const Matrix3<P> R = memory.R;
  P strain[6];
  corotatedStrain(R, F, strain);
  Matrix3<P> stress, all;  // of this visit, of all so far
  if constexpr (goal == GoalShape::rigid) {
    const P(&n)[3] = batch.normal;
    stress = {{strain[0] * n[0], strain[5] * n[1], strain[4] * n[2], strain[5] * n[0], strain[1] * n[1],
               strain[3] * n[2], strain[4] * n[0], strain[3] * n[1], strain[2] * n[2]}};
    all = stress;
  } else {
    if constexpr (!first) {
      const P(&s)[6] = memory.stress;
      const P pressure = batch.dilatation * (s[0] + s[1] + s[2]);
      for (int i = 0; i < 6; ++i) strain[i] -= batch.compliance * s[i];
      for (int i = 0; i < 3; ++i) strain[i] += pressure;
    }
    P d[3], sum(0.0);
    for (int i = 0; i < 3; ++i) {
      d[i] = batch.normal[i] * strain[i];
      sum += d[i];
    }
    sum *= batch.coupling;
    P s[6], total[6];
    for (int i = 0; i < 3; ++i) {
      s[i] = d[i] + sum * batch.normal[i];
      s[i + 3] = batch.shear[i] * strain[i + 3];
    }
    for (int i = 0; i < 6; ++i) {
      total[i] = first ? s[i] : memory.stress[i] + s[i];
      if constexpr (!last) memory.stress[i] = total[i];
    }
    stress = symmetric(s);
    all = symmetric(total);
  }
  Matrix3<P> piola = R * stress;  // times the volume
  if constexpr (last) piola = piola - rotationAgainst(first ? piola : R * all, F0, batch.inertia);
  tetrahedra_.push(k, nodes, batch.gradient, piola);
}

bool RelaxedTetrahedra::relax(const NodeVectors& x, const NodeVectors& v, NodeVectors& a) {
  tetrahedra_.start(x, v, a);
  if (goal_ == GoalShape::rigid) {
    tetrahedra_.keepApart();
    tetrahedra_.sweep(true, [&](std::int32_t batch) { visit<GoalShape::rigid, true, true>(batch); });
  } else {
    tetrahedra_.sweepInPasses(*this, passes_, &RelaxedTetrahedra::visit<GoalShape::linear, true, false>,
                              &RelaxedTetrahedra::visit<GoalShape::linear, false, false>,
                              &RelaxedTetrahedra::visit<GoalShape::linear, false, true>);
  }
  return tetrahedra_.finish(v, a);
}

}  // namespace ringwatch
