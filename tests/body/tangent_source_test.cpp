// A source of tangents that is no body: what it assembles and multiplies is the sum of the matrices it was given.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/tangent_source.h>
#include <ringwatch/meshes/generators/generators.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

std::vector<std::int32_t> ascending(std::size_t count) {
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Chains of n nodes each that overlap by one, with random symmetric matrices.
struct Chains final : ElementTangents {
  Chains(std::size_t nodeCount, int n, const std::vector<std::int32_t>& connectivity, test::Random& random)
      : ElementTangents(n, layOutPatches(nodeCount, n, connectivity, ascending(connectivity.size() / n)),
                        connectivity) {
    for (std::int32_t e = 0; e < elementCount(); ++e) {
      Eigen::MatrixXd A(3 * n, 3 * n);
      for (double& entry : A.reshaped()) entry = random.uniform(-1, 1);
      matrices.push_back(A + A.transpose());
    }
  }
  void tangentBatch(std::int32_t batch, const double* x, double* K, double* rounding) const override {
    tangentOf(layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, x, K, rounding);
  }
  void tangentOf(const std::int32_t* elements, const double*, double* K, double* rounding) const override {
    if (rounding) std::fill_n(rounding, nodesPerElement() * lanes, 0.0);
    const int size = 3 * nodesPerElement();
    for (int i = 0; i < size * size; ++i)
      for (int lane = 0; lane < lanes; ++lane)
        K[i * lanes + lane] = elements[lane] < 0 ? 0 : matrices[elements[lane]](i / size, i % size);
  }
  void addTangentRounding(const Patch&, const double*, double*) const override {}
  void addTangentProduct(const Patch& patch, const double*, const double* v, double* slots) const override {
    std::vector<double> rows(4 * (patch.nodeEnd - patch.nodeBegin));
    gatherRows(patch, v, rows.data());
    const int n = nodesPerElement();
    for (std::int32_t i = patch.batchBegin * lanes; i < patch.batchEnd * lanes; ++i) {
      const std::int32_t e = layout().elements[i];
      if (e < 0) continue;
      const auto local = [&](int a) { return 4 * layout().localNodes[(i / lanes * n + a) * lanes + i % lanes]; };
      Eigen::VectorXd own(3 * n);
      for (int k = 0; k < 3 * n; ++k) own[k] = rows[local(k / 3) + k % 3];
      own = matrices[e] * own;
      for (int k = 0; k < 3 * n; ++k) slots[local(k / 3) + k % 3] += own[k];
    }
  }

  std::vector<Eigen::MatrixXd> matrices;
};

TEST(TangentSource, AssemblesAndMultipliesElementsOfAnyNumberOfNodes) {
  test::Random random(3);
  for (const int n : {2, 3, 7, 20}) {
    constexpr int elements = 50;
    const int nodes = elements * (n - 1) + 1;
    std::vector<std::int32_t> connectivity;
    for (int e = 0; e < elements; ++e)
      for (int a = 0; a < n; ++a) connectivity.push_back(e * (n - 1) + a);
    const Chains chains(nodes, n, connectivity, random);
    const TangentSource source({&chains}, Eigen::VectorXd::Ones(nodes), 1);
    EXPECT_EQ(source.elementCount(), elements);
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
    for (int e = 0; e < elements; ++e)
      whole.block(3 * e * (n - 1), 3 * e * (n - 1), 3 * n, 3 * n) += chains.matrices[e];
    const NodeVectors none;
    EXPECT_EQ(Eigen::MatrixXd(source.assembleTangent(none)), whole);  // at most two numbers an entry
    const NodeVectors v = random.nodeVectors(nodes, 1);
    NodeVectors product;
    TangentSource::Workspace workspace;
    source.tangentProduct(none, v, product, workspace);
    EXPECT_LE((product.reshaped() - whole * v.reshaped()).cwiseAbs().maxCoeff(), 2e-14) << n;  // 9e-15
    EXPECT_EQ(source.elementTangent({0, 17}, none), chains.matrices[17]);
  }
}

TEST(TangentSource, IsWhatABodyIs) {
  BarOptions options;
  options.cells = {4, 2, 2};
  const Body body(generateBar(options), makeMaterial("stvk", 1e4, 0.3, 1000));
  std::vector<const ElementTangents*> tangents;
  for (const auto& block : body.blocks()) tangents.push_back(block.get());
  const TangentSource source(tangents, body.lumpedMass(), 1);
  const NodeVectors x = 1.1 * body.mesh().X;
  EXPECT_EQ(Eigen::MatrixXd(source.assembleTangent(x)), Eigen::MatrixXd(body.assembleTangent(x)));
  EXPECT_EQ(source.tangents(), body.tangents());
}

TEST(TangentSource, CountsChangesOfMassAndConstraints) {
  const std::vector<std::int32_t> connectivity{0, 1};
  test::Random random(3);
  const Chains chains(2, 2, connectivity, random);
  TangentSource source({&chains}, Eigen::Vector2d(1, 2), 1);
  const std::int64_t before = source.version();
  source.addNodalMass(1, 0.5);
  EXPECT_EQ(source.lumpedMass()[1], 2.5);
  EXPECT_GT(source.version(), before);
  const std::int64_t between = source.version();
  source.constraints().fix(0, 1);
  EXPECT_GT(source.version(), between);
  EXPECT_THROW(source.addNodalMass(2, 1), InputError);
  EXPECT_THROW(source.checkNodal("v", NodeVectors::Zero(3, 3)), InputError);
}

}  // namespace
}  // namespace ringwatch
