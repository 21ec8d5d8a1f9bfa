#include <ringwatch/extensions/modal_filter/filtered_tetrahedra.h>

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/extensions/modal_filter/filtered_stiffness.h>
#include <ringwatch/extensions/tetrahedra/corotated_tetrahedron.h>

namespace ringwatch {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

/// Gᵀ: strains 00 11 22 12 20 01 of displacements, by columns.
Eigen::Matrix<double, 12, 6> strainsOf(const Eigen::Matrix<double, 3, 4>& gradient) {
  Eigen::Matrix<double, 12, 6> result = Eigen::Matrix<double, 12, 6>::Zero();
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      result(3 * a + i, i) = gradient(i, a);
      result(3 * a + j, i + 3) = 0.5 * gradient(k, a);
      result(3 * a + k, i + 3) = 0.5 * gradient(j, a);
    }
  return result;
}

/// The stress, times the volume, that does the work s·E: shear strains count twice in it.
template <class P>
RINGWATCH_INLINE Matrix3<P> stressOf(const P (&s)[6]) {
  const P half(0.5), stress[6] = {s[0], s[1], s[2], half * s[3], half * s[4], half * s[5]};
  return symmetric(stress);
}

}  // namespace

FilteredTetrahedra::FilteredTetrahedra(const Body& body, const std::vector<ElementRef>& elements,
                                       const std::vector<Eigen::Vector4d>& allowance, double h)
    : tetrahedra_(body, elements, h) {
  Batch none{};
  Memory rest{};
  for (int i = 0; i < 3; ++i) none.gradient[i][i] = rest.R(i, i) = P(1.0);
  batches_.assign(tetrahedra_.batchCount(), none);
  memory_.assign(batches_.size(), rest);
  for (std::size_t i = 0; i < elements.size(); ++i) setElement(i, body, elements[i], allowance[i], h);
}

void FilteredTetrahedra::setElement(std::size_t i, const Body& body, ElementRef e, const Eigen::Vector4d& allowance,
                                    double h) {
  const auto nodes = body.blocks()[e.block]->nodesOf(e.element);
  Eigen::Vector4d inverseMass;
  bool constrained = false;
  for (int a = 0; a < 4; ++a) {
    const std::int32_t node = nodes[a];
    const int free = body.constraints().freeComponents(node);
    constrained = constrained || free < 3;
    inverseMass[a] = free == 0 ? 0 : 1 / body.lumpedMass()[node];
  }
  const PrincipalTetrahedron shape = principalTetrahedron(body.mesh().X, nodes, inverseMass);
  const Eigen::MatrixXd K = body.elementTangent(e, body.mesh().X);
  Eigen::Matrix<double, 12, 12> turned;  // K in the principal axes
  for (int a = 0; a < 12; a += 3)
    for (int b = 0; b < 12; b += 3)
      turned.block<3, 3>(a, b) = shape.axes.transpose() * K.block<3, 3>(a, b) * shape.axes;
  const FilteredStiffness filtered = filterModes(turned, allowance);
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 12, 6>> strains(strainsOf(shape.gradient));
  const Eigen::Matrix<double, 6, 12> half = strains.solve(filtered.kept);
  const Matrix6 kept = strains.solve(half.transpose().eval());

  modes_ += filtered.modes;
  Eigen::Matrix<double, 12, 6> mode = filtered.mode;
  for (int k = 0; k < 6; ++k) mode.col(k) /= std::sqrt(filtered.compliance[k]);
  Vector12 root;
  for (int d = 0; d < 12; ++d) root[d] = h * std::sqrt(inverseMass[d / 3]);
  const Eigen::Matrix<double, 12, 6> weighted = root.asDiagonal() * mode;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> mixed(
      Eigen::MatrixXd{Matrix6::Identity() + weighted.transpose() * weighted});
  const Matrix6 Y = strains.solve((mode * Matrix6(mixed.eigenvectors())).eval());

  const std::int32_t at = tetrahedra_.placeOf(i);
  Batch& batch = batches_[at / lanes];
  const int lane = at % lanes;
  for (int a = 0; a < 3; ++a) {
    for (int c = 0; c < 3; ++c) batch.gradient[a][c].set(lane, shape.gradient(c, a + 1));
    if (!constrained) batch.inertia[a].set(lane, 1 / shape.eta[a]);
  }
  P* entry = batch.kept;
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c) (entry++)->set(lane, 0.5 * (kept(r, c) + kept(c, r)));
  for (int k = 0; k < 6; ++k) {
    for (int c = 0; c < 6; ++c) batch.mode[k][c].set(lane, Y(c, k));
    batch.inverse[k].set(lane, 1 / mixed.eigenvalues()[k]);
  }
}

void FilteredTetrahedra::keep(std::int32_t k) {
  const Batch& batch = batches_[k];
  Memory& memory = memory_[k];
  ColouredTetrahedra::Nodes nodes;
  tetrahedra_.load(k, nodes);
  Matrix3<P> F0, F;
  tetrahedra_.gradients(nodes, batch.gradient, F0, F);
  const Matrix3<P> R = memory.R = followedRotation(F0, memory.R);
  P strain[6], s[6];
  corotatedStrain(R, F0, strain);
  for (P& own : s) own = P(0.0);
  const P* entry = batch.kept;
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c, ++entry) {
      s[r] += *entry * strain[c];
      if (c > r) s[c] += *entry * strain[r];
    }
  const Matrix3<P> piola = R * stressOf(s);
  tetrahedra_.push(k, nodes, batch.gradient, piola - rotationAgainst(piola, F0, batch.inertia));
}

template <bool first, bool last>
void FilteredTetrahedra::relax(std::int32_t k) {
  const Batch& batch = batches_[k];
  Memory& memory = memory_[k];
  ColouredTetrahedra::Nodes nodes;
  tetrahedra_.load(k, nodes);
  Matrix3<P> F0, F;
  tetrahedra_.gradients(nodes, batch.gradient, F0, F);
  const Matrix3<P> R = memory.R;
  P strain[6], added[6], all[6];
  corotatedStrain(R, F, strain);
  for (int c = 0; c < 6; ++c) added[c] = all[c] = P(0.0);
  for (int m = 0; m < 6; ++m) {
    const P(&mode)[6] = batch.mode[m];
    P residual = first ? P(0.0) : -memory.s[m];
    for (int c = 0; c < 6; ++c) residual += mode[c] * strain[c];
    const P change = batch.inverse[m] * residual, s = first ? change : memory.s[m] + change;
    memory.s[m] = s;
    for (int c = 0; c < 6; ++c) {
      added[c] += mode[c] * change;
      if constexpr (last) all[c] += mode[c] * s;
    }
  }
  Matrix3<P> piola = R * stressOf(added);
  if constexpr (last) piola = piola - rotationAgainst(R * stressOf(all), F0, batch.inertia);
  tetrahedra_.push(k, nodes, batch.gradient, piola);
}

bool FilteredTetrahedra::act(const NodeVectors& x, const NodeVectors& v, NodeVectors& a, int passes) {
  tetrahedra_.start(x, v, a);
  tetrahedra_.sweep(true, [&](std::int32_t batch) { keep(batch); });
  tetrahedra_.sweepInPasses(*this, passes, &FilteredTetrahedra::relax<true, false>,
                            &FilteredTetrahedra::relax<false, false>, &FilteredTetrahedra::relax<false, true>);
  return tetrahedra_.finish(v, a);
}

}  // namespace ringwatch
