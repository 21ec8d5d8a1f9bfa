// One body of tetrahedra, hexahedra, wedges and pyramids that share faces: a dynamic run with the monitor.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

BarOptions barOptions() {
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = {10, 2, 2};
  options.jitter = 0.1;
  return options;
}

TEST(MixedMesh, SharesFacesAndHoldsEveryLinearElement) {
  for (const int cells : {5, 6, 7, 8, 9, 10, 11, 20}) {
    BarOptions options = barOptions();
    options.cells = {cells, 3, 2};
    const Mesh mesh = generateMixedBar(options);
    EXPECT_TRUE(checkMesh(mesh).empty()) << cells;
    ASSERT_EQ(mesh.blocks.size(), 4u);
    for (const MeshBlock& block : mesh.blocks) EXPECT_GT(block.elementCount(), 0u) << cells;
    // Conforming: what is on the boundary is on the box.
    for (const ElementFace& face : boundaryFaces(mesh)) {
      const MeshBlock& block = mesh.blocks[face.block];
      Eigen::Vector3d low = Eigen::Vector3d::Constant(1), high = -low;
      for (const int corner : elementInfo(block.type).faces[face.face])
        if (corner >= 0) {
          const Eigen::Vector3d X = mesh.X.col(block.element(face.element)[corner]);
          low = low.cwiseMin(X);
          high = high.cwiseMax(X);
        }
      const bool onBox = (high.array() < 1e-12).any() || (low.array() > Eigen::Array3d(0.2, 0.04, 0.04) - 1e-12).any();
      EXPECT_TRUE(onBox) << cells << " block " << face.block << " element " << face.element;
    }
  }
}

struct FallReport {
  double worstBalance = 0;  // largest balance error over the largest energy
  int brackets = 0;
};
FallReport fall(const Mesh& mesh) {
  Body body(mesh, makeMaterial("stvk", 30e3, 0.3, 1000));
  for (const std::int32_t node : mesh.nodeSets.at("x-min")) body.constraints().fix(node);
  body.addBodyForce({0, 0, -1});
  BodySystem system(body);
  State state = system.initialState();
  StormerVerlet verlet;
  StabilityMonitor monitor(body, {});
  EnergyBalance balance(body);
  const double h = 0.5 * criticalStep(body, state.x, 2).safe;
  const int steps = static_cast<int>(0.5 / h);
  double largest = 0, error = 0;
  FallReport run;
  for (int i = 0; i <= steps; ++i) {
    if (i % 50 == 0) {
      const MonitorReport& report = monitor.observe(i, state.time, state.x, state.v, h);
      EXPECT_TRUE(report.bracket.has_value());
      EXPECT_EQ(report.verdict, Verdict::certified);
      const GlobalFrequency top = globalFrequency(body, state.x);
      EXPECT_TRUE(top.converged);
      const double critical = 2 / std::sqrt(top.lambda);
      EXPECT_LE(report.bracket->safe, critical * (1 + 1e-9)) << "step " << i;
      EXPECT_GE(report.bracket->optimistic, critical * (1 - 1e-9)) << "step " << i;
      ++run.brackets;
      const Energies e = balance.evaluate(state.x, state.v);
      largest = std::max({largest, e.kinetic, e.strain, std::abs(e.externalWork)});
      error = std::max(error, std::abs(e.balanceError));
    }
    verlet.step(system, state, h);
  }
  run.worstBalance = error / largest;
  return run;
}

TEST(MixedMesh, RunsWithAValidBracketAndTheEnergyBalanceOfSingleTypeRuns) {
  const FallReport mixed = fall(generateMixedBar(barOptions()));
  EXPECT_GT(mixed.brackets, 5);
  double worstSingle = 0;
  for (const char* element : {"tet4", "hex8", "wedge6", "pyramid5"}) {
    BarOptions options = barOptions();
    options.element = element;
    const FallReport single = fall(generateBar(options));
    RecordProperty(element, std::to_string(single.worstBalance));
    worstSingle = std::max(worstSingle, single.worstBalance);
  }
  RecordProperty("mixed", std::to_string(mixed.worstBalance));
  EXPECT_LE(mixed.worstBalance, 1.5 * worstSingle);
  EXPECT_LE(mixed.worstBalance, 1e-3);
}

TEST(MixedMesh, RunsTheSameFromMshAndVtuFiles) {
  const Mesh mesh = generateMixedBar(barOptions());
  const FallReport direct = fall(mesh);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / joinText("ringwatch-mixed-", ::getpid());
  std::filesystem::create_directories(folder);
  for (const char* extension : {".msh", ".vtu"}) {
    const std::filesystem::path file = folder / joinText("mixed", extension);
    writeMesh(mesh, file);
    const Mesh read = loadMesh(file);
    ASSERT_EQ(read.blocks.size(), 4u) << extension;
    EXPECT_EQ(read.nodeSets.count("x-min"), 1u) << extension;
    const FallReport again = fall(read);
    EXPECT_EQ(again.brackets, direct.brackets) << extension;
    EXPECT_NEAR(again.worstBalance, direct.worstBalance, 1e-6 * direct.worstBalance) << extension;
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ringwatch
