// Single elements against the numbers of an independent program, to the digits that it printed.
#include <gtest/gtest.h>

#include <cmath>

#include <tests/support/body_cases.h>
#include <tests/verify/reference_elements.h>

namespace ringwatch {
namespace {

class ReferenceElementTest : public ::testing::TestWithParam<test::ReferenceElement> {
 public:
  const test::ReferenceElement& expected() const { return GetParam(); }
  Mesh makeMesh() const {
    const ElementInfo& element = *findElementByName(expected().element);
    Mesh mesh;
    mesh.X = NodeVectors::Map(expected().X.data(), 3, element.nodes);
    mesh.blocks.push_back({element.type, {}, {0}});
    for (int a = 0; a < element.nodes; ++a) mesh.blocks[0].connectivity.push_back(a);
    return mesh;
  }
  NodeVectors positions() const {
    NodeVectors displaced = body.mesh().X;
    if (expected().displaced)
      for (Eigen::Index k = 0; k < displaced.size(); ++k) {
        const auto d = static_cast<double>(k);
        displaced.data()[k] += 0.0015 * std::sin(1 + 1.7 * d + 0.3 * d * d);
      }
    return displaced;
  }
  const Body body{makeMesh(), makeMaterial("stvk", 30e3, 0.3, 1000)};
  const NodeVectors x = positions();
};
INSTANTIATE_TEST_SUITE_P(GetFem, ReferenceElementTest, ::testing::ValuesIn(test::referenceElements()),
                         [](const auto& test) {
                           return std::string(test.param.element) + (test.param.displaced ? "_displaced" : "_at_rest");
                         });

TEST_P(ReferenceElementTest, HasTheVolumeAndTheLumpedMasses) {
  EXPECT_NEAR(body.volume(), expected().volume, 1e-12 * expected().volume);
  for (std::size_t a = 0; a < expected().lumpedMass.size(); ++a)
    EXPECT_NEAR(body.lumpedMass()[a], expected().lumpedMass[a], 2e-12 * expected().lumpedMass[a]);
}

TEST_P(ReferenceElementTest, HasTheInternalForce) {
  NodeVectors f;
  Body::Workspace workspace;
  body.internalForce(x, f, workspace);
  for (Eigen::Index k = 0; k < f.size(); ++k) {
    const double force = expected().internalForce.empty() ? 0 : expected().internalForce[k];
    EXPECT_NEAR(f.data()[k], force, 2e-13) << k;
  }
}

TEST_P(ReferenceElementTest, HasTheTangent) {
  if (expected().tangent.empty()) return;  // of wedges and pyramids there is the spectrum
  const Eigen::MatrixXd K = body.elementTangent({0, 0}, x);
  std::size_t entry = 0;
  for (Eigen::Index i = 0; i < K.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++entry) {
      EXPECT_NEAR(K(i, j), expected().tangent[entry], 2e-13 * K.norm()) << i << " " << j;
      EXPECT_NEAR(K(j, i), expected().tangent[entry], 2e-13 * K.norm()) << j << " " << i;
    }
  EXPECT_EQ(entry, expected().tangent.size());
}

TEST_P(ReferenceElementTest, HasTheSpectrum) {
  const Eigen::MatrixXd K = body.elementTangent({0, 0}, x);
  const Eigen::VectorXd lambda = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    EXPECT_NEAR(lambda[i], expected().eigenvalues[i], 5e-10 * lambda.maxCoeff()) << i;
  const Eigen::VectorXd scale = body.lumpedMass().cwiseSqrt().cwiseInverse().transpose().replicate(3, 1).reshaped();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * K * scale.asDiagonal();
  const double largest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().maxCoeff();
  EXPECT_NEAR(largest, expected().largestOverLumped, 1e-12 * largest);
}

}  // namespace
}  // namespace ringwatch
