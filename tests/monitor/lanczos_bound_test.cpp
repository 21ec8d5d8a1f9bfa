// The probabilistic bound by Lanczos against dense eigenvalues: with 1 - eta near 1 it never fails, with a large eta it
// fails no more often than it may.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/lanczos_bound.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

TEST(LanczosBound, HoldsOnHundredsOfRandomBodies) {
  const auto subdivisions = test::allSubdivisions();
  const Hold holds[] = {Hold::nothing, Hold::face, Hold::components};
  int bodies = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    for (const LawInfo& law : allLaws()) {
      test::Random random(seed);
      const Subdivision& subdivision = subdivisions[random.index(static_cast<int>(subdivisions.size()))];
      const std::array<int, 3> cells{1 + random.index(3), 1 + random.index(2), 1 + random.index(2)};
      Body body = test::boxBody(subdivision, law.name, cells, random.uniform(0, 0.25), seed);
      test::holdBody(body, holds[random.index(3)], seed);
      const NodeVectors x = (random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.5))) * body.mesh().X +
                            random.nodeVectors(body.nodeCount(), random.uniform(0, 0.3) * test::cellSize);
      const DenseTangent dense(body, x);
      const std::string what = joinText(subdivision.name, ", ", law.name, ", seed ", seed);
      if (!dense.finite()) {
        EXPECT_TRUE(std::isnan(lanczosUpperBound(body, x).upper.value)) << what;
        continue;
      }
      const double lambda = std::max(0.0, dense.largest());
      for (const double width : {1e-4, 1e-3, 0.01, 0.1}) {
        const LanczosBound bound = lanczosUpperBound(body, x, width, 1e-9, seed);
        EXPECT_EQ(bound.upper.eta, 1e-9);
        EXPECT_GE(bound.upper.value, lambda * (1 - 1e-12)) << what << ", width " << width;
        EXPECT_LE(bound.ritz.value, lambda * (1 + 1e-10)) << what << ", width " << width;
        EXPECT_TRUE(bound.achieved) << what << ", width " << width;
        EXPECT_LE(std::sqrt(bound.upper.value), (1 + width) * std::sqrt(lambda) * (1 + 1e-9)) << what;
      }
      ++bodies;
    }
  EXPECT_GE(bodies, 150);
}

TEST(LanczosBound, FailsNoMoreOftenThanItMay) {
  // Wide brackets end early, when the start still matters: with eta = 0.5 half of d, kept for rounding, still leaves an
  // eta of 0.25 in truth. 600 seeds: the share of failures is below eta by far more than chance.
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {3, 2, 2});
  const double lambda = DenseTangent(body, body.mesh().X).largest();
  int failed = 0;
  constexpr int seeds = 600;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    failed += lanczosUpperBound(body, body.mesh().X, 0.3, 0.5, seed).upper.value < lambda;
  EXPECT_LE(failed, seeds / 2);
  RecordProperty("failures_of_600", failed);
}

TEST(LanczosBound, IsExactWhereLittleIsFree) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const int components : {1, 2, 3}) {
      Body body = test::boxBody(subdivision, "stvk");
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        for (int c = 0; c < 3; ++c)
          if (i != 13 || c >= components) body.constraints().fix(i, c);
      const double lambda = DenseTangent(body, body.mesh().X).largest();
      const LanczosBound bound = lanczosUpperBound(body, body.mesh().X, 1e-3);
      EXPECT_GE(bound.upper.value, lambda * (1 - 1e-12)) << subdivision.name << ", " << components;
      EXPECT_LE(bound.upper.value, lambda * 1.003) << subdivision.name << ", " << components;
      EXPECT_LE(bound.products, components + 1) << subdivision.name << ", " << components;
    }
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  const LanczosBound bound = lanczosUpperBound(body, body.mesh().X);
  EXPECT_EQ(bound.upper.value, 0);
  EXPECT_EQ(bound.products, 0);
  EXPECT_TRUE(bound.achieved);
}

/// Copies of a mesh side by side, each larger than the one before by `growth`.
Mesh copies(const Mesh& mesh, int count, double growth) {
  Mesh all = mesh;
  const std::int32_t nodes = mesh.nodeCount();
  all.X.resize(3, mesh.X.cols() * count);
  all.nodeIds.clear();
  all.nodeSets.clear();
  all.elementSets.clear();
  MeshBlock block{mesh.blocks[0].type, {}, {}};
  double size = 1;
  for (int k = 0; k < count; ++k, size *= growth) {
    for (std::int32_t i = 0; i < nodes; ++i) {
      all.X.col(k * nodes + i) = size * mesh.X.col(i) + Eigen::Vector3d(k, 0, 0);
      all.nodeIds.push_back(k * nodes + i);
    }
    for (const std::int32_t node : mesh.blocks[0].connectivity) block.connectivity.push_back(k * nodes + node);
    for (std::size_t e = 0; e < mesh.blocks[0].elementCount(); ++e) block.ids.push_back(block.ids.size());
  }
  all.blocks = {block};
  return all;
}

TEST(LanczosBound, SeesEveryPartOfABodyInParts) {
  // The top mode lives in the last and smallest part alone; many equal parts end Lanczos early.
  const Mesh one = test::box(test::allSubdivisions()[0], {1, 1, 1});
  for (const double growth : {1.0, 0.9, 0.5})
    for (const int count : {2, 7, 40}) {
      if (growth < 0.9 && count > 7) continue;  // an element of 1e-14 m
      const Body body(copies(one, count, growth), makeMaterial("stvk", test::young, test::poisson, test::density),
                      test::onThreads(1));
      const Body last(copies(one, 1, 1), makeMaterial("stvk", test::young, test::poisson, test::density),
                      test::onThreads(1));
      const double lambda =
          DenseTangent(last, last.mesh().X).largest() / std::pow(growth, 2 * (count - 1));  // omega² ~ 1/size²
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const LanczosBound bound = lanczosUpperBound(body, body.mesh().X, 0.01, 1e-9, seed);
        EXPECT_GE(bound.upper.value, lambda * (1 - 1e-9)) << count << " parts, growth " << growth;
        EXPECT_LE(bound.upper.value, 1.03 * lambda) << count << " parts, growth " << growth;
      }
    }
}

TEST(LanczosBound, HoldsWithinTheProductsItIsGiven) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {4, 3, 3});
  const double lambda = DenseTangent(body, body.mesh().X).largest();
  for (const int products : {1, 2, 3, 5, 8}) {
    const LanczosBound bound = lanczosUpperBound(body, body.mesh().X, 1e-3, 1e-9, 5, products);
    EXPECT_EQ(bound.products, products);
    EXPECT_FALSE(bound.achieved);
    EXPECT_GE(bound.upper.value, lambda);
  }
}

TEST(LanczosBound, RefusesWhatItCannotKeep) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    double width, eta;
    int products;
    std::string key;
  } cases[] = {{0, 1e-9, 9, "width"},   {1e-6, 1e-9, 9, "width"}, {1, 1e-9, 9, "width"},
               {nan, 1e-9, 9, "width"}, {0.01, 0, 9, "eta"},      {0.01, 0.6, 9, "eta"},
               {0.01, nan, 9, "eta"},   {0.01, 1e-13, 9, "eta"},  {0.01, 1e-9, 0, "maxPr"}};
  for (const auto& c : cases) {
    try {
      lanczosUpperBound(body, body.mesh().X, c.width, c.eta, 1, c.products);
      ADD_FAILURE() << c.key << " was accepted: " << c.width << ", " << c.eta << ", " << c.products;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(c.key), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace ringwatch
