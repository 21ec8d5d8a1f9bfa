// Contact of surfaces: closest points, forces against energies, tangents against forces, momentum, majorants against
// tangents, lists against all pairs, and their place in a body.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/relative_motion.h>
#include <ringwatch/body/sub_body.h>
#include <ringwatch/body/surface_contact.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/meshes/surface.h>
#include <tests/body/discrete_matrices.h>
#include <tests/support/body_cases.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::denseOf;

double meshVolumeOf(const Mesh& mesh) {
  // By Gauss, of the surface's triangles.
  double sum = 0;
  for (const SurfaceTriangle& t : surfaceTriangles(mesh))
    sum += mesh.X.col(t.nodes[0]).dot(mesh.X.col(t.nodes[1]).cross(mesh.X.col(t.nodes[2]))) / 6;
  return sum;
}

TEST(Surface, TrianglesAreClosedAndPointOutwards) {
  for (const CellSubdivision& split : allCellSubdivisions()) {
    BarOptions options{.size = {2, 1, 1}, .cells = {2, 2, 2}};
    options.element = split.element;
    options.split = split.elementsPerCell;
    const Mesh mesh = generateBar(options);
    EXPECT_NEAR(meshVolumeOf(mesh), 2, 1e-13) << split.element;
    // Every edge once in each direction.
    std::vector<std::array<std::int32_t, 2>> edges;
    std::vector<std::int32_t> nodes;
    for (const SurfaceTriangle& t : surfaceTriangles(mesh))
      for (int i = 0; i < 3; ++i) {
        edges.push_back({t.nodes[i], t.nodes[(i + 1) % 3]});
        nodes.push_back(t.nodes[i]);
      }
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end()) << split.element;
    for (const auto& [a, b] : edges)
      EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), std::array<std::int32_t, 2>{b, a})) << split.element;
    sortUnique(nodes);
    EXPECT_EQ(nodes, surfaceNodes(mesh)) << split.element;
  }
}

/// Two boxes of 2 × 2 × 2 cells of 1 cm, the upper one smaller and turned.
Mesh twoBoxes(std::string_view element = "tet4", double jitter = 0.2, std::uint64_t seed = 3) {
  StackOptions options;
  options.lower.size = {0.02, 0.02, 0.02};
  options.lower.cells = {2, 2, 2};
  options.lower.element = element;
  options.lower.jitter = jitter;
  options.lower.seed = seed;
  options.upperSize = {0.016, 0.018, 0.02};
  options.upperCells = {2, 2, 2};
  options.gap = 0.001;
  return generateStack(options);
}

/// The upper box pressed into the lower one, tilted, and both shaken.
NodeVectors pressed(const Mesh& mesh, test::Random& random, double depth = 0.002) {
  NodeVectors x = mesh.X;
  const Eigen::AngleAxisd turn(random.uniform(-0.15, 0.15), random.vector(1).normalized());
  const Vector3d shift(random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004), -0.001 - random.uniform(0, depth));
  for (const std::int32_t node : mesh.nodeSets.at("upper"))
    x.col(node) = turn * (x.col(node) - Vector3d(0.01, 0.01, 0.021)) + Vector3d(0.01, 0.01, 0.021) + shift;
  return x + random.nodeVectors(x.cols(), 4e-4);
}

SurfaceContact contactOf(const Mesh& mesh, test::Random& random, double friction = 0) {
  SurfaceContact contact = surfaceContact(mesh, surfaceNodes(mesh), surfaceNodes(mesh));
  for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
    contact.penalty.push_back(random.uniform(50, 150));
    contact.damping.push_back(random.uniform(0, 1));
    contact.split[k] = std::exp(random.uniform(-1, 1));
  }
  contact.friction = friction;
  contact.slip.speed = 0.3;
  return contact;
}

TEST(SurfaceContact, ForcesAreDerivativesOfTheEnergyAndTangentsOfForces) {
  int compared = 0, touching = 0;
  std::array<int, 3> free{};
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    test::Random random(seed);
    const Mesh mesh = twoBoxes(seed % 2 == 0 ? "tet4" : "hex8", 0.2, seed);
    DiscreteForces forces(static_cast<std::int32_t>(mesh.nodeCount()));
    forces.add(contactOf(mesh, random));
    // Deep ones of a strongly bent surface touch edges and corners, too.
    const NodeVectors x = pressed(mesh, random, 0.004) + random.nodeVectors(mesh.X.cols(), seed % 3 == 0 ? 1e-3 : 0);
    const NodeVectors u = random.nodeVectors(x.cols(), 1);
    constexpr double h = 1e-8;
    const NodeVectors after = x + h * u, before = x - h * u;
    NodeVectors f = NodeVectors::Zero(3, x.cols()), fAfter = f, fBefore = f, Ku = f;
    const double slope = (forces.energy(after) - forces.energy(before)) / (2 * h);
    forces.addInternalForce(after, fAfter);
    forces.addInternalForce(before, fBefore);
    forces.addInternalForce(x, f);
    for (const SurfaceSearch::Touch& touch : forces.surfaces()[0].touching()) ++free[touch.free];
    forces.addTangentProduct(x, u, Ku);
    const auto state = forces.contactState(x);
    touching += state.touching > 0;
    EXPECT_LE((denseOf(forces, x) * u.reshaped() - Ku.reshaped()).norm(), 1e-12 * (Ku.norm() + 1)) << seed;
    EXPECT_NEAR(forces.form(x, u), u.cwiseProduct(Ku).sum(), 1e-12 * (Ku.norm() + 1) * u.norm()) << seed;
    EXPECT_LE((denseOf(forces, x) - denseOf(forces, x).transpose()).norm(), 1e-12 * (Ku.norm() + 1)) << seed;
    // Between them contact can begin, end or turn to another face.
    if (forces.contactState(after).touching != state.touching || forces.contactState(before).touching != state.touching)
      continue;
    const double scale = f.norm() * u.norm();
    if (std::abs(f.cwiseProduct(u).sum() - slope) > 1e-6 * scale) continue;
    EXPECT_NEAR(f.cwiseProduct(u).sum(), slope, 1e-6 * scale) << seed;
    if (((fAfter - fBefore) / (2 * h) - Ku).norm() > 1e-5 * Ku.norm()) continue;
    ++compared;
  }
  RecordProperty("faces", free[2]);
  RecordProperty("edges", free[1]);
  RecordProperty("corners", free[0]);
  EXPECT_GT(touching, 110);
  EXPECT_GT(compared, 100);
  EXPECT_GT(free[2], 300);
  EXPECT_GT(free[1], 10);
  EXPECT_GT(free[0], 0);
}

TEST(SurfaceContact, ForcesSumToNothing) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    test::Random random(seed);
    const Mesh mesh = twoBoxes("tet4", 0.2, seed);
    DiscreteForces forces(static_cast<std::int32_t>(mesh.nodeCount()));
    forces.add(contactOf(mesh, random, seed % 2 == 0 ? 0.4 : 0));
    const NodeVectors x = pressed(mesh, random), v = random.nodeVectors(x.cols(), 1);
    NodeVectors f = NodeVectors::Zero(3, x.cols()), resisted = f;
    forces.addInternalForce(x, f);
    forces.addDampingForce(x, v, resisted);
    ASSERT_GT(f.norm(), 0);
    const auto moment = [&](const NodeVectors& force) {
      Vector3d sum = Vector3d::Zero();
      for (Eigen::Index i = 0; i < x.cols(); ++i) sum += x.col(i).cross(force.col(i));
      return sum;
    };
    EXPECT_LE(f.rowwise().sum().norm(), 1e-14 * f.norm());
    EXPECT_LE(resisted.rowwise().sum().norm(), 1e-14 * resisted.norm());
    EXPECT_LE(moment(f).norm(), 1e-14 * x.norm() * f.norm());
    if (!forces.friction()) {
      EXPECT_LE(moment(resisted).norm(), 1e-14 * x.norm() * resisted.norm());
    }
    // What damping and friction take is never less than nothing.
    EXPECT_GT(resisted.cwiseProduct(v).sum(), 0);
  }
}

TEST(SurfaceContact, DampingForcesAreThoseOfTheDampingMatrix) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    test::Random random(seed);
    const Mesh mesh = twoBoxes("hex8", 0.2, seed);
    DiscreteForces forces(static_cast<std::int32_t>(mesh.nodeCount()));
    forces.add(contactOf(mesh, random));
    const NodeVectors x = pressed(mesh, random), v = random.nodeVectors(x.cols(), 1);
    NodeVectors force = NodeVectors::Zero(3, x.cols()), Kv = force, both = force;
    forces.addDampingForce(x, v, force);
    forces.addTangentProduct(x, v, Kv, 0.0);
    forces.addTangentProduct(x, v, both, 7.0);
    EXPECT_LE((7 * force - (both - Kv)).norm(), 1e-12 * both.norm()) << seed;
    forces.setDampingFactor(7);
    EXPECT_NEAR(forces.dampingForm(x, v).value, 7 * force.cwiseProduct(v).sum(), 1e-12 * both.norm() * v.norm());
  }
}

// Coulomb's law on a flat face: two blocks of one cell, the upper one slides.
TEST(SurfaceContact, FrictionResistsAlongTheFace) {
  StackOptions options;
  options.lower.element = "hex8";
  options.upperSize = {0.5, 0.5, 0.5};
  const Mesh mesh = generateStack(options);
  SurfaceContact contact = surfaceContact(mesh, mesh.nodeSets.at("upper z-min"), mesh.nodeSets.at("lower"));
  contact.penalty.assign(4, 100);
  contact.damping.assign(4, 0);
  contact.friction = 0.5;
  contact.slip.speed = 0.01;
  DiscreteForces forces(static_cast<std::int32_t>(mesh.nodeCount()));
  forces.add(contact);
  NodeVectors x = mesh.X, v = NodeVectors::Zero(3, x.cols()), f = v;
  for (const std::int32_t node : mesh.nodeSets.at("upper")) {
    x(2, node) -= 0.02;  // 2 N at each node
    v.col(node) = Vector3d(3, 4, 7);
  }
  forces.addDampingForce(x, v, f);
  for (const std::int32_t node : mesh.nodeSets.at("upper z-min"))
    EXPECT_LE((f.col(node) - Vector3d(0.6, 0.8, 0)).norm(), 1e-14);
  EXPECT_LE((f(Eigen::all, mesh.nodeSets.at("lower")).rowwise().sum() + 4 * Vector3d(0.6, 0.8, 0)).norm(), 1e-13);
  EXPECT_EQ(forces.contactState(x).touching, 4);
  EXPECT_NEAR(forces.contactState(x).deepest, 0.02, 1e-15);
  EXPECT_EQ(forces.contactState(x).deepestObstacle, DiscreteForces::ofSurface);
}

// Theorem 53 and 54 of single pairs: the tangent k (Bᵀ B - C G⁻¹ Cᵀ), damping and all, below its block diagonal.
TEST(SurfaceContact, MajorantsOfRandomPairsHold) {
  test::Random random(5);
  std::int64_t pairs = 0;
  std::array<std::int64_t, 3> free{};
  // Two tetrahedra, the first corner of the one in front of or behind a face of the other.
  Mesh mesh;
  mesh.blocks.push_back({findElementByName("tet4")->type, {0, 1, 2, 3, 4, 5, 6, 7}, {}});
  mesh.X.resize(3, 8);
  while (pairs < 100000) {
    mesh.X = random.nodeVectors(8, 1);
    for (int e = 0; e < 2; ++e) {
      Matrix3d J;
      for (int i = 0; i < 3; ++i) J.col(i) = mesh.X.col(4 * e + 1 + i) - mesh.X.col(4 * e);
      if (J.determinant() < 0) mesh.X.col(4 * e + 1).swap(mesh.X.col(4 * e + 2));
    }
    SurfaceContact contact = surfaceContact(mesh, {0, 1, 2, 3}, {4, 5, 6, 7});
    contact.penalty.assign(4, 1);
    contact.damping.assign(4, random.uniform(0, 1));
    contact.split.assign(4, std::exp(random.uniform(-2, 2)));
    contact.depth.assign(4, 1);
    contact.nodeDepth.assign(4, 1);
    DiscreteForces forces(8);
    forces.add(std::move(contact));
    forces.setDampingFactor(random.uniform(0, 1));
    forces.setReach(random.index(2) == 0 ? 0 : random.uniform(0, 0.2));
    // The same pair at several places.
    for (int trial = 0; trial < 8; ++trial) {
      const NodeVectors x = mesh.X + random.nodeVectors(8, 0.3);
      const Eigen::MatrixXd K = denseOf(forces, x);
      const auto& touching = forces.surfaces()[0].touching();
      if (touching.empty()) continue;
      test::expectAbove(test::majorantOf(forces, x, random.index(2) == 0), K, pairs);
      for (const SurfaceSearch::Touch& touch : touching) ++free[touch.free];
      pairs += static_cast<std::int64_t>(touching.size());
    }
  }
  EXPECT_GE(pairs, 100000);
  for (const std::int64_t count : free) EXPECT_GT(count, 1000);
}

// What can touch before nodes have moved by the reach against one another counts already.
TEST(SurfaceContact, MajorantsHoldWithinTheReach) {
  std::int64_t states = 0, begun = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    test::Random random(seed);
    const Mesh mesh = twoBoxes(seed % 2 == 0 ? "tet4" : "hex8", 0.2, seed);
    DiscreteForces forces(static_cast<std::int32_t>(mesh.nodeCount()));
    forces.add(contactOf(mesh, random));
    constexpr double reach = 6e-4;
    const NodeVectors x = pressed(mesh, random, 0.001);
    forces.setReach(reach);
    const Eigen::MatrixXd bound = test::majorantOf(forces, x);
    const std::int64_t before = forces.contactState(x).touching;
    for (int trial = 0; trial < 5; ++trial) {
      // No two nodes move by more than the reach against one another.
      NodeVectors moved = x;
      for (Eigen::Index i = 0; i < x.cols(); ++i) moved.col(i) += random.vector(1).normalized() * 0.5 * reach;
      for (const std::int32_t node : mesh.nodeSets.at("upper")) moved(2, node) = x(2, node) - 0.3 * reach;
      test::expectAbove(bound, denseOf(forces, moved), static_cast<std::int64_t>(seed));
      begun += forces.contactState(moved).touching != before;
      ++states;
    }
  }
  EXPECT_EQ(states, 300);
  EXPECT_GT(begun, 100);
}

/// The square of the distance of a point from a triangle, by the regions of its corners, edges and face (Ericson,
/// Real-Time Collision Detection, 2005, section 5.1.5); inside: whether the closest point is inside the face.
double distanceByRegions(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c, bool& inside) {
  inside = false;
  const Vector3d ab = b - a, ac = c - a;
  const double d1 = ab.dot(p - a), d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return (p - a).squaredNorm();
  const double d3 = ab.dot(p - b), d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return (p - b).squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (p - a - d1 / (d1 - d3) * ab).squaredNorm();
  const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return (p - c).squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (p - a - d2 / (d2 - d6) * ac).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return (p - b - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
  inside = true;
  const Vector3d n = ab.cross(ac);
  return std::pow((p - a).dot(n), 2) / n.squaredNorm();
}

// Random motions of two bodies that meet, slide, roll, shake and fly apart, with a reach that changes: what is kept
// from look to look finds what a search without a past finds, and what all pairs give.
TEST(SurfaceContact, MissesNothingAlongRandomMotions) {
  std::int64_t touches = 0, expected = 0, pairs = 0, freshPairs = 0, lists = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    test::Random random(seed);
    const Mesh mesh = twoBoxes("tet4", 0.2, seed);
    const auto nodes = static_cast<std::int32_t>(mesh.nodeCount());
    const SurfaceContact contact = contactOf(mesh, random);
    SurfaceSearch kept(contact, nodes);
    NodeVectors x = pressed(mesh, random), v = NodeVectors::Zero(3, x.cols());
    Vector3d drift = Vector3d::Zero(), turn = drift;
    for (int step = 0; step < 150; ++step) {
      if (step % 30 == 0) {
        drift = random.vector(step % 60 == 0 ? 1e-4 : 4e-4);
        turn = random.vector(0.02);
        // Now and then back to where they press on each other, in one jump.
        if (step % 90 == 60) x = pressed(mesh, random);
      }
      const double noise = step % 50 < 25 ? 2e-5 : 1e-6;
      const Vector3d centre = x(Eigen::all, mesh.nodeSets.at("upper")).rowwise().mean();
      for (const std::int32_t node : mesh.nodeSets.at("upper")) x.col(node) += drift + turn.cross(x.col(node) - centre);
      x += random.nodeVectors(x.cols(), noise);
      const double reach = random.index(3) == 0 ? 0 : random.uniform(0, 4e-4);
      kept.locate(x, reach, 1 + step % 3);
      SurfaceSearch fresh(contact, nodes);
      fresh.locate(x, reach, 1);
      freshPairs += fresh.statistics().pairs;
      ASSERT_EQ(kept.touching().size(), fresh.touching().size()) << seed << " " << step;
      for (std::size_t i = 0; i < fresh.touching().size(); ++i) {
        EXPECT_EQ(kept.touching()[i].entry, fresh.touching()[i].entry);
        EXPECT_EQ(kept.touching()[i].triangle, fresh.touching()[i].triangle);
        EXPECT_EQ(kept.touching()[i].r, fresh.touching()[i].r);
        EXPECT_EQ(kept.touching()[i].b, fresh.touching()[i].b);
      }
      ASSERT_EQ(kept.near().size(), fresh.near().size()) << seed << " " << step;
      for (std::size_t i = 0; i < fresh.near().size(); ++i) {
        EXPECT_EQ(kept.near()[i].entry, fresh.near()[i].entry);
        EXPECT_EQ(kept.near()[i].triangle, fresh.near()[i].triangle);
        EXPECT_EQ(kept.near()[i].depth, fresh.near()[i].depth);
        EXPECT_EQ(kept.near()[i].weight, fresh.near()[i].weight);
      }
      // All pairs.
      std::size_t next = 0;
      for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
        const std::int32_t node = contact.nodes[k];
        std::vector<Vector3d> own{Vector3d::Zero()};
        for (const auto& [b, c] : contact.fan.row(k)) {
          own.push_back((x.col(b) - x.col(node)).cross(x.col(c) - x.col(node)));
          own[0] += own.back();
        }
        double least = 1, second = 1, side = 0, depth = 0;
        bool face = false;
        // Of all, seen or not: in front of one that is nearer the node is outside.
        double leastOfAll = 1, sideOfAll = 0;
        bool faceOfAll = false;
        Vector3d normalOfAll = Vector3d::Zero();
        for (std::size_t t = 0; t < contact.triangles.size(); ++t) {
          const auto& at = contact.triangles[t];
          const auto near = contact.neighbours.row(k);
          if (std::any_of(at.begin(), at.end(), [&](std::int32_t corner) {
                return corner == node || std::binary_search(near.begin(), near.end(), corner);
              }))
            continue;
          const Vector3d a = x.col(at[0]), normal = (x.col(at[1]) - a).cross(x.col(at[2]) - a);
          bool inside = false;
          const double distance = std::sqrt(distanceByRegions(x.col(node), a, x.col(at[1]), x.col(at[2]), inside));
          if (distance < leastOfAll) {
            leastOfAll = distance;
            faceOfAll = inside;
            sideOfAll = normal.dot(x.col(node) - a);
            normalOfAll = normal.normalized();
          }
          // Seen by the node's normal, or by that of a face at it.
          double most = 1;
          for (const Vector3d& one : own) most = std::min(most, one.normalized().dot(normal.normalized()));
          if (!(most < -0.3)) continue;
          if (distance < least) {
            second = least;
            least = distance;
            face = inside;
            side = normal.dot(x.col(node) - a);
            depth = std::min(contact.depth[t], contact.nodeDepth[k]);
          } else {
            second = std::min(second, distance);
          }
        }
        const bool found = next < kept.touching().size() && kept.touching()[next].entry == static_cast<int>(k);
        if (found) {
          EXPECT_NEAR(kept.touching()[next].depth, least, 1e-14) << seed << " " << step;
          ++next;
        }
        if (!face || std::abs(least - depth) < 1e-12 || second - least < 1e-12) continue;
        if (leastOfAll < least - 1e-12 && !faceOfAll) continue;
        // At a rim that is flush with that face it is held still.
        const bool flush =
            leastOfAll < std::tan(std::asin(0.3)) * least && std::ranges::any_of(own, [&](const Vector3d& one) {
              return one.normalized().dot(normalOfAll) > std::cos(std::asin(0.3));
            });
        const bool outside = leastOfAll < least - 1e-12 && sideOfAll > 0 && !flush;
        EXPECT_EQ(found, side < 0 && least <= depth && !outside) << seed << " " << step << " node " << node;
        expected += found;
      }
      EXPECT_EQ(next, kept.touching().size());
      touches += static_cast<std::int64_t>(next);
    }
    pairs += kept.statistics().pairs;
    lists += kept.statistics().lists;
  }
  RecordProperty("pairs", joinText(pairs, " of ", freshPairs, ", lists ", lists, ", touches ", touches));
  EXPECT_GT(touches, 5000);
  EXPECT_GT(expected, touches / 2);
  EXPECT_LT(pairs, freshPairs / 2);
  EXPECT_LT(lists, 12 * 150 / 3);
}

// Vectors between neighbours change by no more than paths grew, and what was apart is apart while that is said.
TEST(RelativeMotion, BoundsWhatNeighboursMoveAgainstOneAnother) {
  std::int64_t compared = 0, said = 0, refused = 0;
  double closest = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    test::Random random(seed);
    constexpr int count = 60;
    RelativeMotion::Points x = RelativeMotion::Points::Zero(4, count);
    const double edge = random.uniform(0.05, 0.6);
    for (int i = 0; i < count; ++i) x.col(i).head<3>() = random.vector(1);
    const RelativeMotion::Points start = x;
    RelativeMotion motion;
    motion.start(x, edge);
    std::vector<double> path(count, 0.0);
    for (int step = 0; step < 20; ++step) {
      RelativeMotion::Points to = x;
      const Vector3d together = random.vector(2), turn = random.vector(0.02);
      for (int i = 0; i < count; ++i)
        to.col(i).head<3>() += together + turn.cross(x.col(i).head<3>()) + random.vector(1e-3);
      motion.move(to, 1 + step % 3);
      for (int i = 0; i < count; ++i) {
        const double grown = motion.pathTo(motion.cellOf(i)) - path[i];
        path[i] = motion.pathFrom(motion.cellOf(i));
        for (int j = 0; j < count; ++j) {
          if ((start.col(j) - start.col(i)).cwiseAbs().maxCoeff() > edge) continue;
          const double changed = ((to.col(j) - to.col(i)) - (x.col(j) - x.col(i))).norm();
          ASSERT_LE(changed, grown * (1 + 1e-12)) << seed << " " << step;
          if (j != i) closest = std::max(closest, changed / grown);
          ++compared;
        }
      }
      x = to;
      const double apart = random.uniform(0, 1) * edge, needed = random.uniform(0, 1) * apart;
      if (!motion.keepsApart(apart, 0, needed, to, 1)) {
        ++refused;
        continue;
      }
      ++said;
      for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j)
          if ((start.col(j) - start.col(i)).norm() > apart) {
            ASSERT_GE((x.col(j) - x.col(i)).norm(), needed) << seed;
          }
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(said, 100);
  EXPECT_GT(refused, 100);
  EXPECT_GT(closest, 0.9);
}

// Nearest faces by brute force: the depth of a node under a flat face is its height, and a node beside it is free.
TEST(SurfaceContact, HoldsWhatIsBehindAFaceAndNothingBesideIt) {
  StackOptions options;
  options.lower.cells = {4, 4, 4};
  options.upperSize = {0.4, 0.4, 0.4};
  options.upperCells = {1, 1, 1};
  const Mesh mesh = generateStack(options);
  SurfaceContact contact = surfaceContact(mesh, mesh.nodeSets.at("upper z-min"), mesh.nodeSets.at("lower"));
  contact.penalty.assign(contact.nodes.size(), 1);
  contact.damping.assign(contact.nodes.size(), 0);
  DiscreteForces forces(static_cast<std::int32_t>(mesh.nodeCount()));
  forces.add(contact);
  const auto touching = [&](const Vector3d& shift) {
    NodeVectors x = mesh.X;
    for (const std::int32_t node : mesh.nodeSets.at("upper")) x.col(node) += shift;
    return forces.contactState(x);
  };
  EXPECT_EQ(touching({0, 0, 0}).touching, 0);
  EXPECT_EQ(touching({0, 0, 0.01}).touching, 0);
  EXPECT_EQ(touching({0, 0, -0.01}).touching, 4);
  EXPECT_NEAR(touching({0.013, 0.027, -0.01}).deepest, 0.01, 1e-15);
  EXPECT_EQ(touching({0.5, 0, -0.01}).touching, 2);    // two nodes hang over the edge
  EXPECT_EQ(touching({0.303, 0, -0.01}).touching, 4);  // by less than a third of their depth, flush: still held
  EXPECT_EQ(touching({0.304, 0, -0.01}).touching, 2);
  EXPECT_EQ(touching({0, 0, -0.12}).touching, 4);
  EXPECT_EQ(touching({0, 0, -0.13}).touching, 0);  // deeper than half an element: gone through
  EXPECT_EQ(touching({2, 0, -0.01}).touching, 0);
}

/// A convex body: its nodes, outward directions of faces and of edges.
struct Convex {
  NodeVectors x;
  std::vector<Vector3d> normals, edges;
};
/// The largest distance of two convex bodies along a direction that parts them (separating axes), and that direction,
/// from the first to the second; negative where they overlap.
std::pair<double, Vector3d> partedBy(const Convex& a, const Convex& b) {
  std::vector<Vector3d> axes = a.normals;
  axes.insert(axes.end(), b.normals.begin(), b.normals.end());
  for (const Vector3d& one : a.edges)
    for (const Vector3d& other : b.edges)
      if (one.cross(other).norm() > 1e-6 * one.norm() * other.norm()) axes.push_back(one.cross(other));
  std::pair<double, Vector3d> best{-1e300, Vector3d::Zero()};
  for (const Vector3d& axis : axes)
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d along = sign * axis.normalized();
      const double apart = (along.transpose() * b.x).minCoeff() - (along.transpose() * a.x).maxCoeff();
      if (apart > best.first) best = {apart, along};
    }
  return best;
}
Convex convexOf(const NodeVectors& x, const Mesh& mesh, const std::vector<std::int32_t>& nodes) {
  Convex body{x(Eigen::all, nodes), {}, {}};
  for (const SurfaceTriangle& t : surfaceTriangles(mesh)) {
    if (!std::binary_search(nodes.begin(), nodes.end(), t.nodes[0])) continue;
    const Vector3d a = x.col(t.nodes[0]), b = x.col(t.nodes[1]), c = x.col(t.nodes[2]);
    const std::array<Vector3d, 3> edges{b - a, c - b, a - c};
    const auto add = [](std::vector<Vector3d>& directions, const Vector3d& own) {
      if (std::ranges::none_of(directions, [&](const Vector3d& known) {
            return known.cross(own).norm() < 1e-9 * known.norm() * own.norm();
          }))
        directions.push_back(own);
    };
    add(body.normals, edges[0].cross(edges[1]));
    for (const Vector3d& edge : edges) add(body.edges, edge);
  }
  return body;
}

/// Contact of all of two parts, and of one part with the faces of the other all of whose corners are selected.
std::vector<SurfaceContact> everyContact(const Mesh& mesh, const std::vector<std::int32_t>& first,
                                         const std::vector<std::int32_t>& second,
                                         const std::vector<std::int32_t>& someOfFirst) {
  std::vector<SurfaceContact> contacts;
  const std::vector<std::int32_t> surface = surfaceNodes(mesh);
  const auto add = [&](const std::vector<std::int32_t>& nodes, const std::vector<std::int32_t>& to, bool edges) {
    std::vector<std::int32_t> own;
    std::set_intersection(surface.begin(), surface.end(), nodes.begin(), nodes.end(), std::back_inserter(own));
    contacts.push_back(surfaceContact(mesh, own, to, edges ? std::optional(0.35) : std::nullopt));
    contacts.back().penalty.assign(own.size(), 1);
    contacts.back().damping.assign(own.size(), 0);
    for (SurfaceContact::Edge& edge : contacts.back().edges) edge.penalty = 1;
  };
  add(surface, surface, true);
  if (!first.empty()) add(second, first, false);
  if (!someOfFirst.empty()) add(second, someOfFirst, false);
  return contacts;
}
std::size_t touchesOf(const Mesh& mesh, const std::vector<SurfaceContact>& contacts, const NodeVectors& x) {
  std::size_t touches = 0;
  for (const SurfaceContact& contact : contacts) {
    SurfaceSearch search(contact, static_cast<std::int32_t>(mesh.nodeCount()));
    search.locate(x, 0, 1);
    touches += search.touching().size();
  }
  return touches;
}

// Boxes of any proportions and cells, coarse against fine, above, beside and at the rim of one another, flush or
// turned, that a plane parts: nothing touches, by separating axes (Gottschalk, Lin and Manocha, 1996).
TEST(SurfaceContact, BoxesThatAPlanePartsDoNotTouch) {
  std::size_t touched = 0;
  int flush = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    test::Random random(seed);
    StackOptions options;
    options.lower.element = random.index(2) == 0 ? "hex8" : "tet4";
    for (int i = 0; i < 3; ++i) {
      options.lower.size[i] = std::exp(random.uniform(-1.6, 1.6));
      options.lower.cells[i] = 1 + static_cast<int>(random.index(3));
      options.upperSize[i] = std::exp(random.uniform(-1.6, 1.6));
      options.upperCells[i] = 1 + static_cast<int>(random.index(4));
    }
    const Mesh mesh = generateStack(options);
    const auto &lower = mesh.nodeSets.at("lower"), &upper = mesh.nodeSets.at("upper");
    NodeVectors x = mesh.X;
    const Vector3d middle = x(Eigen::all, upper).rowwise().mean();
    const Matrix3d turn = random.index(2) == 0 ? random.rotation() : Matrix3d::Identity();
    Vector3d shift = random.vector(1);
    for (int i = 0; i < 3; ++i) {
      shift[i] *= 0.5 * (options.lower.size[i] + options.upperSize[i]);
      // A face of the one in the plane of a face of the other.
      if (random.index(3) == 0) {
        shift[i] = (random.index(2) == 0 ? 0.5 : -0.5) * (options.lower.size[i] - options.upperSize[i]);
        ++flush;
      }
    }
    const Vector3d centre = x(Eigen::all, lower).rowwise().mean();
    for (const std::int32_t node : upper) x.col(node) = turn * (x.col(node) - middle) + centre + shift;
    const auto [apart, along] = partedBy(convexOf(x, mesh, lower), convexOf(x, mesh, upper));
    const double gap = std::exp(random.uniform(-9, -0.5));
    if (apart < gap)
      for (const std::int32_t node : upper) x.col(node) += (gap - apart) * along;
    if (random.index(2) == 0) x = random.rotation() * x;
    const std::size_t own = touchesOf(mesh, everyContact(mesh, lower, upper, mesh.nodeSets.at("lower z-max")), x);
    EXPECT_EQ(own, 0U) << seed << ", parted by " << std::max(apart, gap);
    touched += own;
  }
  EXPECT_EQ(touched, 0U);
  EXPECT_GT(flush, 200);
}

// The same of sharp bodies: two tetrahedra of any shape.
TEST(SurfaceContact, TetrahedraThatAPlanePartsDoNotTouch) {
  Mesh mesh;
  mesh.blocks.push_back({findElementByName("tet4")->type, {0, 1, 2, 3, 4, 5, 6, 7}, {}});
  const std::vector<std::int32_t> first{0, 1, 2, 3}, second{4, 5, 6, 7};
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    test::Random random(seed);
    mesh.X = random.nodeVectors(8, 1);
    mesh.X.rightCols(4) *= std::exp(random.uniform(-2, 1));
    for (int e = 0; e < 2; ++e) {
      Matrix3d J;
      for (int i = 0; i < 3; ++i) J.col(i) = mesh.X.col(4 * e + 1 + i) - mesh.X.col(4 * e);
      if (J.determinant() < 0) mesh.X.col(4 * e + 1).swap(mesh.X.col(4 * e + 2));
    }
    const auto [apart, along] = partedBy(convexOf(mesh.X, mesh, first), convexOf(mesh.X, mesh, second));
    const double gap = std::exp(random.uniform(-9, -0.5));
    if (apart < gap) mesh.X.rightCols(4).colwise() += (gap - apart) * along;
    EXPECT_EQ(touchesOf(mesh, everyContact(mesh, first, second, {}), mesh.X), 0U) << seed;
  }
}

// A body at rest does not touch itself: L-shapes, channels and boxes with a slot, of cells of any proportions, turned.
TEST(SurfaceContact, ABodyAtRestDoesNotTouchItself) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    test::Random random(seed);
    const test::Cells cells{4 + static_cast<int>(random.index(4)), 1 + static_cast<int>(random.index(3)),
                            4 + static_cast<int>(random.index(4))};
    Mesh mesh = test::gridMesh(random.index(2) == 0 ? "hex8" : "tet4", cells, {1, 1, 1});
    // Cells that are taken out: a corner, a channel along y from above, or a slot within.
    const auto kind = random.index(3);
    const double from = kind == 0 ? 0 : 1.0 / cells[0],
                 to = from + static_cast<double>(1 + random.index(cells[0] - 2)) / cells[0],
                 top = kind == 2 ? 1 - 1.0 / cells[2] : 1,
                 bottom = static_cast<double>(1 + random.index(cells[2] - 2)) / cells[2];
    MeshBlock& block = mesh.blocks[0];
    std::vector<std::int32_t> kept;
    const int nodes = block.nodesPerElement();
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      Vector3d middle = Vector3d::Zero();
      for (int i = 0; i < nodes; ++i) middle += mesh.X.col(block.element(e)[i]) / nodes;
      if (middle[0] > from && middle[0] < to && middle[2] > bottom && middle[2] < top) continue;
      kept.insert(kept.end(), block.element(e), block.element(e) + nodes);
    }
    block.connectivity = kept;
    block.ids.clear();
    // Planes of nodes at any distance from one another.
    for (int i = 0; i < 3; ++i) {
      std::vector<double> at(cells[i] + 1);
      for (int k = 0; k < cells[i]; ++k) at[k + 1] = at[k] + std::exp(random.uniform(-1.5, 1.5));
      for (Eigen::Index n = 0; n < mesh.X.cols(); ++n)
        mesh.X(i, n) = at[static_cast<std::size_t>(std::lround(mesh.X(i, n) * cells[i]))];
    }
    mesh.X = (random.rotation() * mesh.X).eval();
    EXPECT_EQ(touchesOf(mesh, everyContact(mesh, {}, surfaceNodes(mesh), {}), mesh.X), 0U) << seed;
  }
}

// Self-contact: a strip bent into a ring, whose ends come together.
TEST(SurfaceContact, OfABodyWithItself) {
  Mesh mesh = test::gridMesh("hex8", {24, 2, 1}, {1, 0.1, 0.04});
  SurfaceContact contact = surfaceContact(mesh, surfaceNodes(mesh), surfaceNodes(mesh));
  contact.penalty.assign(contact.nodes.size(), 1);
  contact.damping.assign(contact.nodes.size(), 0);
  DiscreteForces forces(static_cast<std::int32_t>(mesh.nodeCount()));
  forces.add(contact);
  const auto bent = [&](double turn) {
    NodeVectors x = mesh.X;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      const double angle = turn * mesh.X(0, i), r = 1 / turn + mesh.X(2, i);
      x.col(i) = Vector3d(r * std::sin(angle), mesh.X(1, i), r * std::cos(angle));
    }
    return x;
  };
  EXPECT_EQ(forces.contactState(mesh.X).touching, 0);
  EXPECT_EQ(forces.contactState(bent(5)).touching, 0);
  EXPECT_EQ(forces.contactState(bent(2 * std::numbers::pi * 0.998)).touching, 0);
  const auto state = forces.contactState(bent(2 * std::numbers::pi * 1.002));
  EXPECT_EQ(state.touching, 12);  // the nodes of both ends
  EXPECT_LT(state.deepest, 0.004);
}

TEST(SurfaceContact, IsPartOfABody) {
  for (const char* element : {"tet4", "hex8"}) {
    test::Random random(6);
    Body body(twoBoxes(element), makeMaterial("stvk", test::young, test::poisson, test::density));
    const Mesh& mesh = body.mesh();
    DiscreteForces forces(body.nodeCount());
    forces.add(std::vector<Spring>{{.node = 0, .other = body.nodeCount() - 1, .length = 0.01, .stiffness = 30}});
    forces.add(contactOf(mesh, random));
    SparseTangent tangent;
    Body::Workspace workspace;
    const Body bare(twoBoxes(element), makeMaterial("stvk", test::young, test::poisson, test::density));
    body.setDiscreteForces(std::move(forces));
    const DiscreteForces& discrete = *body.discreteForces();
    // What touches changes from state to state, and the pattern with it.
    for (int state = 0; state < 6; ++state) {
      const NodeVectors x = pressed(mesh, random);
      ASSERT_GT(discrete.contactState(x).touching, 0);
      const Eigen::MatrixXd own = denseOf(discrete, x), K(bare.assembleTangent(x));
      body.assembleTangent(x, tangent);
      EXPECT_LE((Eigen::MatrixXd(tangent.matrix) - K - own).norm(), 1e-12 * K.norm()) << element << state;
      NodeVectors Kv;
      const NodeVectors v = random.nodeVectors(x.cols(), 1);
      body.tangentProduct(x, v, Kv, workspace);
      EXPECT_LE((Kv.reshaped() - tangent.matrix * v.reshaped()).norm(), 1e-12 * Kv.norm());

      // A part has its principal submatrix.
      std::vector<std::int32_t> nodes;
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        if (random.index(2) == 0) nodes.push_back(i);
      const DiscreteForces part = discrete.restrictedTo(nodes);
      const NodeVectors xPart = x(Eigen::all, nodes);
      Eigen::MatrixXd expected(3 * nodes.size(), 3 * nodes.size());
      const std::int32_t last = body.nodeCount() - 1;
      const Eigen::MatrixXd contactAlone = [&] {
        DiscreteForces alone(body.nodeCount());
        alone.add(discrete.surfaces()[0].contact());
        return denseOf(alone, x);
      }();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
          expected.block<3, 3>(3 * i, 3 * j) = contactAlone.block<3, 3>(3 * nodes[i], 3 * nodes[j]);
      Eigen::MatrixXd found = denseOf(part, xPart);
      const bool hasSpring = nodes.front() == 0 && nodes.back() == last;
      if (!hasSpring) {
        EXPECT_LE((found - expected).norm(), 1e-12 * own.norm()) << element << state;
      }
      NodeVectors u = random.nodeVectors(xPart.cols(), 1), Ku = NodeVectors::Zero(3, xPart.cols());
      part.addTangentProduct(xPart, u, Ku);
      EXPECT_LE((Ku.reshaped() - found * u.reshaped()).norm(), 1e-12 * (Ku.norm() + 1));
      // At other positions than those of the whole nothing is known of it.
      EXPECT_THROW(denseOf(part, xPart + random.nodeVectors(xPart.cols(), 1e-3)), NumericalError);
    }
  }
}

TEST(SurfaceContact, RefusesWhatIsNoContact) {
  const auto text = [](const auto& call) {
    try {
      call();
    } catch (const InputError& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  const Mesh mesh = test::gridMesh("hex8", {2, 2, 2}, {1, 1, 1});
  EXPECT_EQ(text([&] { surfaceContact(mesh, {13}, surfaceNodes(mesh)); }), "node 13 is not on the surface");
  EXPECT_EQ(text([&] {
              surfaceContact(mesh, {0}, {0, 1});
            }),
            "no face of the surface has all of its corners among the nodes");
  SurfaceContact contact = surfaceContact(mesh, {0}, surfaceNodes(mesh));
  DiscreteForces forces(27);
  EXPECT_EQ(text([&] { forces.add(contact); }),
            "surface contact: a penalty, a damping, a split and its rows are needed for each node");
  contact.penalty = {-1};
  contact.damping = {0};
  EXPECT_EQ(text([&] { forces.add(contact); }), "penalty = -1: must be >= 0");
  contact.penalty = {1};
  contact.friction = 0.1;
  contact.slip.speed = 0;
  EXPECT_EQ(text([&] { forces.add(contact); }),
            "slip = 0 m/s or 0 of the depth a second: one of them must be > 0 where there is friction");
  // Positions that are not finite touch nothing, and are no fault.
  contact.friction = 0;
  forces.add(contact);
  NodeVectors x = mesh.X;
  x(0, 3) = std::nan("");
  EXPECT_EQ(forces.contactState(x).touching, 0);
}

}  // namespace
}  // namespace ringwatch
