// Hexahedra of uniform strain: hourglass control in closed form. That force, tangent and energy belong together, and
// what is asked of every rule, is in body_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/sub_body.h>
#include <tests/support/meshes.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr double young = 30e3, density = 1000, edge = 0.01;

Body uniformStrainBody(const Mesh& mesh, const Material& material, double stiffness) {
  BodyOptions options{{{"hex8", "uniform-strain"}}, Lumping::rowSum, 1};
  options.hourglassControl.stiffness = stiffness;
  return Body(mesh, material, options);
}
Mesh box(test::Cells cells, double jitter = 0) {
  return test::gridMesh("hex8", cells, {edge * cells[0], edge * cells[1], edge * cells[2]}, jitter, 3);
}
NodeVectors forceOf(const Body& body, const NodeVectors& x) {
  Body::Workspace workspace;
  NodeVectors f;
  body.internalForce(x, f, workspace);
  return f;
}
/// The signs of ηζ, ξζ, ξη and ξηζ at the nodes of the only element of a box.
std::vector<Eigen::VectorXd> hourglassModes(const Mesh& mesh) {
  const Vector3d centre = mesh.X.rowwise().mean();
  std::vector<Eigen::VectorXd> modes;
  for (const std::vector<int>& axes : {std::vector{1, 2}, {0, 2}, {0, 1}, {0, 1, 2}}) {
    Eigen::VectorXd& mode = modes.emplace_back(Eigen::VectorXd::Ones(8));
    for (int a = 0; a < 8; ++a)
      for (const int j : axes) mode[a] *= mesh.X(j, a) > centre[j] ? 1 : -1;
  }
  return modes;
}

// Of a cube of edge a: V Σ_a |g_a|² = 3/2 a, and the unit hourglass modes have the stiffness κ/2 M · 3/2 a, in any
// direction, at any strain.
TEST(UniformStrain, HourglassModesOfACubeHaveThePublishedStiffness) {
  const Mesh cube = box({1, 1, 1});
  for (const double stiffness : {0.05, 0.3}) {
    const Material material = makeMaterial("linear", young, 0.3, density);
    const Body body = uniformStrainBody(cube, material, stiffness);
    const Eigen::MatrixXd K = body.elementTangent({0, 0}, cube.X);
    const double modulus = material.density * material.waveSpeed() * material.waveSpeed();
    const auto nodes = body.blocks()[0]->nodesOf(0);
    for (const Eigen::VectorXd& mode : hourglassModes(cube))
      for (int i = 0; i < 3; ++i) {
        Eigen::VectorXd v = Eigen::VectorXd::Zero(24);
        for (int a = 0; a < 8; ++a) v[3 * a + i] = mode[nodes[static_cast<std::size_t>(a)]] / std::sqrt(8);
        const double expected = 0.75 * stiffness * modulus * edge;
        EXPECT_LE((K * v - expected * v).norm(), 1e-13 * K.norm());
      }
  }
}

// Uniform deformations of distorted elements have no hourglass forces and no hourglass energy, and rates that are
// linear in the positions at rest no hourglass damping.
TEST(UniformStrain, UniformDeformationsFeelNoHourglassControl) {
  const Mesh mesh = box({3, 2, 2}, 0.25);
  const Material material = makeMaterial("stvk", young, 0.3, density);
  const Body without = uniformStrainBody(mesh, material, 0), with = uniformStrainBody(mesh, material, 1);
  test::Random random(5);
  Body::Workspace workspace;
  for (int trial = 0; trial < 10; ++trial) {
    const Matrix3d F = Matrix3d::Identity() + random.matrix(0.3);
    const NodeVectors x = (F * mesh.X).colwise() + random.vector(0.1);
    EXPECT_LE((forceOf(with, x) - forceOf(without, x)).norm(), 1e-13 * forceOf(without, x).norm());
    EXPECT_NEAR(with.energy(x, workspace), without.energy(x, workspace), 1e-13 * with.energy(x, workspace));
    Body damped = uniformStrainBody(mesh, material, 1);
    damped.setElementDamping({{.hourglassViscosity = 0.1}});
    NodeVectors f = NodeVectors::Zero(3, x.cols());
    damped.addElementDampingForce(x, x, f, workspace);
    const NodeVectors shake = random.nodeVectors(x.cols(), x.norm() / std::sqrt(3.0 * static_cast<double>(x.cols())));
    NodeVectors ofShake = NodeVectors::Zero(3, x.cols());
    damped.addElementDampingForce(x, shake, ofShake, workspace);
    EXPECT_LE(f.norm(), 1e-13 * ofShake.norm());
  }
}

// Pure bending about z of n layers of cubes, ν = 0: u_x = -c x y, u_y = c x²/2. The mean strains have the energy
// (1 - 1/n²) of the beam's, and hourglass modes 9/2 κ of the rest, of E I c² L / 2.
TEST(UniformStrain, BendsAsStiffAsItsLayersAndItsHourglassStiffnessAre) {
  constexpr double curvature = 1e-3;
  Body::Workspace workspace;
  for (const int layers : {1, 2, 4, 7})
    for (const double stiffness : {0.0, 0.05, 2.0 / 9}) {
      const Mesh mesh = box({5, layers, 3});
      const double height = layers * edge, width = 3 * edge, length = 5 * edge;
      NodeVectors x = mesh.X;
      for (Eigen::Index a = 0; a < x.cols(); ++a) {
        const double along = mesh.X(0, a), up = mesh.X(1, a) - height / 2;
        x(0, a) -= curvature * along * up;
        x(1, a) += curvature * along * along / 2;
      }
      const double beam = 0.5 * young * width * std::pow(height, 3) / 12 * curvature * curvature * length;
      const double expected = 1 - (1 - 4.5 * stiffness) / (layers * layers);
      const double energy =
          uniformStrainBody(mesh, makeMaterial("linear", young, 0, density), stiffness).energy(x, workspace);
      // The strains of 1e-5 are differences of positions of some 0.1 m.
      EXPECT_NEAR(energy / beam, expected, 3e-9) << layers << " layers, " << stiffness;
    }
}

// C = ε/4 ρ c a² Σ γ γᵀ of a cube: the unit hourglass modes have the damping 2 ε ρ c a².
TEST(UniformStrain, HourglassModesOfACubeHaveTheViscosityOfTheirFormula) {
  const Mesh cube = box({1, 1, 1});
  const Material material = makeMaterial("stvk", young, 0.3, density);
  Body body = uniformStrainBody(cube, material, 0.05);
  body.setElementDamping({{.hourglassViscosity = 0.1}});
  Body::Workspace workspace;
  const NodeVectors x = Matrix3d(Vector3d(1.2, 0.9, 1.1).asDiagonal()) * cube.X;
  for (const Eigen::VectorXd& mode : hourglassModes(cube))
    for (int i = 0; i < 3; ++i) {
      NodeVectors v = NodeVectors::Zero(3, 8), f = v;
      v.row(i) = mode.transpose() / std::sqrt(8);
      body.addElementDampingForce(x, v, f, workspace);
      EXPECT_LE((f - 2 * 0.1 * density * material.waveSpeed() * edge * edge * v).norm(), 1e-13 * f.norm());
    }
}

// An element and a part of a body keep their coefficients.
TEST(UniformStrain, PartsOfABodyHaveItsControl) {
  const Mesh mesh = box({3, 2, 2}, 0.2);
  Body whole = uniformStrainBody(mesh, makeMaterial("stvk", young, 0.3, density), 0.4);
  whole.setElementDamping({{.hourglassViscosity = 0.1}});
  whole.elementDamping()->setFactor(0.01);
  const std::vector<ElementRef> elements{{0, 4}};
  std::vector<std::int32_t> nodes;
  for (const std::int32_t node : whole.blocks()[0]->nodesOf(4)) nodes.push_back(node);
  std::sort(nodes.begin(), nodes.end());
  Eigen::VectorXd mass(8);
  NodeVectors x = mesh.X + test::Random(2).nodeVectors(mesh.X.cols(), 0.001), own(3, 8);
  for (int a = 0; a < 8; ++a) {
    mass[a] = whole.lumpedMass()[nodes[static_cast<std::size_t>(a)]];
    own.col(a) = x.col(nodes[static_cast<std::size_t>(a)]);
  }
  const Body part = subBody(whole, elements, nodes, mass, 1);
  const Eigen::MatrixXd K = whole.elementTangent({0, 4}, x);
  EXPECT_LE((part.elementTangent({0, 0}, own) - K).norm(), 1e-14 * K.norm());
  EXPECT_EQ(part.blocks()[0]->hourglassControl().stiffness, 0.4);
}

TEST(UniformStrain, RefusesWhatDoesNotFit) {
  const Material material = makeMaterial("stvk", young, 0.3, density);
  EXPECT_THROW(uniformStrainBody(box({1, 1, 1}), material, -0.1), InputError);
  Mesh flat = box({1, 1, 1});
  flat.X.row(2) *= 1e-13;
  try {
    uniformStrainBody(flat, material, 0.05);
    ADD_FAILURE() << "a flat element was taken";
  } catch (const NumericalError& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("hex8 element"));
    EXPECT_THAT(fault.what(), HasSubstr("volume"));
  }
  Body other(box({1, 1, 1}), material, {{}, Lumping::rowSum, 1});
  EXPECT_THROW(other.setElementDamping({{.hourglassViscosity = 0.1}}), InputError);
}

}  // namespace
}  // namespace ringwatch
