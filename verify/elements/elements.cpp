#include <ringwatch/verify/elements/elements.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/random.h>
#include <ringwatch/body/law_of_packs.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/verify/elements/elements_studies.h>
#include <ringwatch/verify/static_solver.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace detail {
namespace {

constexpr double edge = 0.03;                       // m, of the cubes below
constexpr double forceScale = young * 0.01 * 0.01;  // N, order one strain on a face of 1 cm
constexpr double rounding = 1e-14;                  // of sums of some tens of terms: 45 units in the last place

class Draw : public Random {
 public:
  using Random::Random;
  double operator()() { return uniform(-1, 1); }
  Eigen::Matrix3d matrix(double scale) {
    return Eigen::Matrix3d::NullaryExpr([&] { return uniform(-scale, scale); });
  }
  NodeVectors nodes(Eigen::Index count, double scale) {
    return NodeVectors::NullaryExpr(3, count, [&] { return uniform(-scale, scale); });
  }
};

Mesh jitteredCube(std::string_view element, double jitter = 0.2) {
  BarOptions options;
  options.element = element;
  options.jitter = jitter;
  options.seed = 7;
  return generateCube(edge, 3, options);
}
Mesh mixedBar(double jitter) {
  BarOptions options;
  options.size = {0.06, 0.02, 0.02};
  options.cells = {10, 3, 3};
  options.jitter = jitter;
  return generateMixedBar(options);
}
/// One element: the reference element scaled to about a centimetre, corners moved by `jitter` of that; middles of edges
/// follow their ends.
Mesh oneElement(const ElementInfo& info, double jitter) {
  Draw draw(11);
  Mesh mesh;
  mesh.X.resize(3, info.nodes);
  mesh.blocks.push_back({info.type, {}, {0}});
  const int corners = cornerCount(info);
  for (int a = 0; a < info.nodes; ++a) {
    mesh.X.col(a) = 0.01 * Eigen::Vector3d::Map(info.referenceNodes[a].data());
    if (a < corners)
      mesh.X.col(a) += 0.01 * jitter * Eigen::Vector3d(draw(), draw(), draw());
    else {
      const auto& ends = info.edges[a - corners];
      mesh.X.col(a) = (mesh.X.col(ends[0]) + mesh.X.col(ends[1])) / 2;
    }
    mesh.nodeIds.push_back(a);
    mesh.blocks[0].connectivity.push_back(a);
  }
  return mesh;
}
NodeVectors strained(const Mesh& mesh, double scale) {
  Draw draw(5);
  const Eigen::Matrix3d F = Eigen::Matrix3d::Identity() + draw.matrix(0.15);
  return F * mesh.X + draw.nodes(mesh.X.cols(), scale);
}
std::vector<bool> boundaryNodes(const Mesh& mesh) {
  std::vector<bool> boundary(mesh.nodeCount());
  for (const auto& [name, nodes] : mesh.nodeSets)
    for (const std::int32_t node : nodes) boundary[node] = true;
  return boundary;
}

}  // namespace

void studyShapes(StudyReport& report) {
  StudyTable table{
      "shapes",
      "Shape functions, volume and mass of a distorted cube (largest errors, relative)",
      {"element", "sum of shapes - 1", "gradient of linear fields", "volume", "mass", "least nodal mass share"},
      {}};
  for (const ElementInfo& info : allElements()) {
    Draw draw(3);
    double unity = 0, completeness = 0;
    std::vector<double> N(info.nodes), dN(3 * info.nodes);
    for (int i = 0; i < 100; ++i) {
      Eigen::VectorXd weights = Eigen::VectorXd::NullaryExpr(info.nodes, [&] { return 1.01 + draw(); });
      weights /= weights.sum();
      Eigen::Vector3d xi = Eigen::Vector3d::Zero();
      for (int a = 0; a < info.nodes; ++a) xi += weights[a] * Eigen::Vector3d::Map(info.referenceNodes[a].data());
      info.shape(xi.data(), N.data());
      info.shapeGradient(xi.data(), reinterpret_cast<double(*)[3]>(dN.data()));
      double sum = -1;
      Eigen::Matrix3d J = -Eigen::Matrix3d::Identity();
      Eigen::RowVector3d slope = Eigen::RowVector3d::Zero();
      for (int a = 0; a < info.nodes; ++a) {
        const Eigen::RowVector3d gradient = Eigen::RowVector3d::Map(dN.data() + 3 * a);
        sum += N[a];
        slope += gradient;
        J += Eigen::Vector3d::Map(info.referenceNodes[a].data()) * gradient;
      }
      unity = std::max({unity, std::abs(sum), slope.cwiseAbs().maxCoeff()});
      completeness = std::max(completeness, J.cwiseAbs().maxCoeff());
    }
    const Body body(jitteredCube(info.name), makeMaterial("linear", young, poisson, density));
    const double volume = std::abs(body.volume() / std::pow(edge, 3) - 1);
    const double mass = std::abs(body.totalMass() / (density * std::pow(edge, 3)) - 1);
    const Body single(oneElement(info, 0), makeMaterial("linear", young, poisson, density));
    const double least = single.lumpedMass().minCoeff() / single.totalMass();
    table.rows.push_back({std::string(info.name), unity, completeness, volume, mass, least});
    const std::string name(info.name);
    checkBelow(report, name + ": shape functions sum to one", unity, rounding);
    checkBelow(report, name + ": linear fields have their gradient", completeness, rounding);
    checkBelow(report, name + ": volume of a distorted cube", volume, rounding);
    checkBelow(report, name + ": mass of a distorted cube", mass, rounding);
    // A corner of tet10 has the least of all, 1/36.
    checkAtLeast(report, name + ": least share of a node in the lumped mass", least, 1.0 / 36, rounding);
  }
  report.tables.push_back(std::move(table));
}

void studyRank(StudyReport& report) {
  StudyTable table{
      "rank",
      "Zero modes of a free element at rest (6 rigid ones; eigenvalues below 1e-10 of the largest)",
      {"element", "rule", "points", "zero modes", "spurious", "declared", "zero modes, distorted", "verdict"},
      {}};
  for (const ElementRule& c : allElementRules()) {
    const auto zeroModes = [&](double jitter) {
      const Body body(oneElement(*c.element, jitter), makeMaterial("stvk", young, poisson, density), c.options());
      const Eigen::MatrixXd K = body.elementTangent({0, 0}, body.mesh().X);
      const Eigen::VectorXd lambda =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
      return static_cast<std::int64_t>((lambda.array().abs() < 1e-10 * lambda.maxCoeff()).count());
    };
    const std::int64_t regular = zeroModes(0), distorted = zeroModes(0.1), declared = c.rule->spuriousModes;
    table.rows.push_back({std::string(c.element->name), std::string(c.rule->name),
                          static_cast<std::int64_t>(c.rule->points.size()), regular, regular - 6, declared, distorted,
                          std::string(regular == 6 ? "full rank" : "deficient")});
    checkNear(report, c.name() + ": zero modes", static_cast<double>(regular), static_cast<double>(6 + declared), 0);
    if (declared == 0) checkNear(report, c.name() + ": zero modes, distorted", static_cast<double>(distorted), 6, 0);
  }
  report.tables.push_back(std::move(table));
}

namespace {

/// Largest force at an inner node under x = F X, and largest error of inner nodes after solving from a disturbed start.
struct PatchErrors {
  double force, position;
};
PatchErrors constantStrain(const Mesh& mesh, const BodyOptions& options) {
  Body body(mesh, makeMaterial("stvk", young, poisson, density), options);
  Eigen::Matrix3d F;
  F << 1.1, 0.06, -0.04, 0.03, 0.92, 0.05, -0.02, 0.04, 1.06;
  const NodeVectors exact = F * mesh.X;
  const std::vector<bool> boundary = boundaryNodes(mesh);
  NodeVectors f;
  Body::Workspace workspace;
  body.internalForce(exact, f, workspace);
  PatchErrors errors{0, 0};
  NodeVectors start = exact;
  Draw draw(9);
  for (std::int32_t node = 0; node < body.nodeCount(); ++node) {
    if (boundary[node])
      body.constraints().fix(node);
    else {
      errors.force = std::max(errors.force, f.col(node).cwiseAbs().maxCoeff() / forceScale);
      start.col(node) += 2e-4 * Eigen::Vector3d(draw(), draw(), draw());
    }
  }
  const StaticSolution solution = solveStatic(body, start);
  errors.position = solution.converged ? (solution.x - exact).cwiseAbs().maxCoeff() / edge : std::nan("");
  return errors;
}

/// A displacement quadratic in X has constant stress divergence under the linear law; an element with complete
/// quadratics and straight sides holds it exactly. Largest force left at an inner node, relative to the load there.
double linearStrain(const ElementRule& c, double jitter) {
  const Mesh mesh = jitteredCube(c.element->name, jitter);
  const Material material = makeMaterial("linear", young, poisson, density);
  const Body body(mesh, material, c.options());
  // u_i = X·Q_i X with symmetric Q_i: grad div u and Laplacian are constant.
  Draw draw(13);
  Eigen::Matrix3d Q[3];
  for (auto& q : Q) {
    const Eigen::Matrix3d m = draw.matrix(1.0);
    q = m + m.transpose();
  }
  NodeVectors x = mesh.X;
  for (Eigen::Index node = 0; node < x.cols(); ++node)
    for (int i = 0; i < 3; ++i) x(i, node) += mesh.X.col(node).dot(Q[i] * mesh.X.col(node));
  const Lame lame = material.restModuli();
  Eigen::Vector3d divergence;  // μ Δu + (λ + μ) grad div u
  for (int i = 0; i < 3; ++i) {
    double gradDiv = 0;
    for (int k = 0; k < 3; ++k) gradDiv += 2 * Q[k](k, i);
    divergence[i] = lame.mu * 2 * Q[i].trace() + (lame.lambda + lame.mu) * gradDiv;
  }
  const NodeVectors load =
      consistentBodyForce(mesh, [&](const Eigen::Vector3d&) { return Eigen::Vector3d(-divergence); });
  NodeVectors f;
  Body::Workspace workspace;
  body.internalForce(x, f, workspace);
  const std::vector<bool> boundary = boundaryNodes(mesh);
  double error = 0;
  for (Eigen::Index node = 0; node < x.cols(); ++node)
    if (!boundary[node]) error = std::max(error, (f - load).col(node).cwiseAbs().maxCoeff());
  return error / load.cwiseAbs().maxCoeff();
}

}  // namespace

void studyPatch(StudyReport& report) {
  StudyTable table{
      "patch",
      "Patch test, St. Venant-Kirchhoff at 10 % strain: force at inner nodes / (E cm²), position error / edge",
      {"mesh", "rule", "force", "position"},
      {}};
  for (const ElementRule& c : allElementRules()) {
    if (c.rule->spuriousModes > 0) continue;
    const PatchErrors errors = constantStrain(jitteredCube(c.element->name), c.options());
    table.rows.push_back({std::string(c.element->name), std::string(c.rule->name), errors.force, errors.position});
    checkBelow(report, c.name() + ": patch test, force", errors.force, rounding);
    checkBelow(report, c.name() + ": patch test, position", errors.position, rounding);
  }
  for (const double jitter : {0.0, 0.2}) {
    const PatchErrors errors = constantStrain(mixedBar(jitter), {});
    const std::string name = jitter == 0 ? "mixed" : "mixed, distorted";
    table.rows.push_back({name, std::string("default"), errors.force, errors.position});
    checkBelow(report, name + ": patch test, force", errors.force, rounding);
    checkBelow(report, name + ": patch test, position", errors.position, rounding);
  }
  report.tables.push_back(std::move(table));
  StudyTable quadratic{"patch-linear-strain",
                       "Linear strain in quadratic elements: force left at inner nodes / largest load",
                       {"element", "rule", "mesh", "force"},
                       {}};
  for (const ElementRule& c : allElementRules()) {
    if (c.element->order < 2) continue;
    // Serendipity elements lose complete quadratics when distorted (Arnold, Boffi & Falk 2002); tetrahedra keep them.
    const double jitter = c.element->faces.size() == 4 ? 0.2 : 0.0, error = linearStrain(c, jitter);
    quadratic.rows.push_back({std::string(c.element->name), std::string(c.rule->name),
                              std::string(jitter > 0 ? "distorted" : "regular"), error});
    // Rounding of positions, times stiffness over load: 9e-14.
    checkBelow(report, c.name() + ": linear strain", error, 2.5e-13);
  }
  report.tables.push_back(std::move(quadratic));
}

void studyDerivatives(StudyReport& report) {
  StudyTable table{"derivatives",
                   "Energy, force and tangent at a state strained by 15 % (relative errors)",
                   {"element", "rule", "law", "force - energy'", "tangent - force'", "asymmetry", "rotation"},
                   {}};
  for (const ElementRule& c : allElementRules()) {
    const Mesh mesh = jitteredCube(c.element->name);
    const NodeVectors x = strained(mesh, 4e-4);
    for (const LawInfo& law : allLaws()) {
      const Material material = makeMaterial(law.name, young, poisson, density);
      if (!hasShares(material, c.rule->shares)) continue;
      const Body body(mesh, material, c.options());
      Body::Workspace workspace;
      Draw draw(17);
      const NodeVectors v = draw.nodes(x.cols(), 1.0);
      NodeVectors f, Kv, ahead, behind, difference;
      body.internalForce(x, f, workspace);
      body.tangentProduct(x, v, Kv, workspace);
      // Central differences, the h² of their error taken out by a second step width.
      const auto energySlope = [&](double h) {
        return (body.energy(x + h * v, workspace) - body.energy(x - h * v, workspace)) / (2 * h);
      };
      const auto forceSlope = [&](double h) {
        body.internalForce(x + h * v, ahead, workspace);
        body.internalForce(x - h * v, behind, workspace);
        return NodeVectors((ahead - behind) / (2 * h));
      };
      const double h = 4e-6, slope = (4 * energySlope(h) - energySlope(2 * h)) / 3;
      const double forceError =
          std::abs(slope - f.cwiseProduct(v).sum()) / std::sqrt(f.squaredNorm() * v.squaredNorm());
      difference = (4 * forceSlope(h) - forceSlope(2 * h)) / 3 - Kv;
      const double tangentError = difference.norm() / Kv.norm();
      const Eigen::MatrixXd K = body.elementTangent({0, 0}, x);
      const double asymmetry = (K - K.transpose()).cwiseAbs().maxCoeff() / K.cwiseAbs().maxCoeff();
      const Eigen::Matrix3d R = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
      body.internalForce(R * x, ahead, workspace);
      const bool objective = law.objective;
      const double rotation = objective ? (ahead - R * f).norm() / f.norm() : std::nan("");
      table.rows.push_back({std::string(c.element->name), std::string(c.rule->name), std::string(law.name), forceError,
                            tangentError, asymmetry, rotation});
      const std::string name = c.name() + " " + std::string(law.name);
      // The differences' own errors, of the fourth order in h, and rounding over h: 3.6e-12 and 1.5e-10.
      checkBelow(report, name + ": force is the slope of the energy", forceError, 1e-11);
      checkBelow(report, name + ": tangent is the slope of the force", tangentError, 4e-10);
      checkBelow(report, name + ": tangent is symmetric", asymmetry, rounding);
      if (objective) checkBelow(report, name + ": force turns with the body", rotation, rounding);
    }
  }
  report.tables.push_back(std::move(table));
}

}  // namespace detail

StudyReport verifyElements(StudyEffort effort) {
  StudyReport report;
  report.study = "elements";
  detail::studyShapes(report);
  detail::studyRank(report);
  detail::studyPatch(report);
  detail::studyDerivatives(report);
  detail::studyConvergence(report, effort);
  detail::studyFrequencies(report, effort);
  detail::studyCantilever(report, effort);
  return report;
}

}  // namespace ringwatch
