#include <ringwatch/meshes/formats/vtu_writer.h>

#include <gmock/gmock.h>

#include <ringwatch/meshes/mesh_io.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;
using ::testing::HasSubstr;

TEST(VtuWriter, PvdListsItsFrames) {
  const TemporaryFolder folder;
  const PvdEntry entries[] = {{0, "frames/a&b.vtu"}, {0.1, "frames/2.vtu"}};
  writePvd(folder / "run.pvd", entries);
  const std::string text = readBytes(folder / "run.pvd");
  EXPECT_THAT(text, HasSubstr("timestep=\"0.1\" part=\"0\" file=\"frames/2.vtu\""));
  EXPECT_THAT(text, HasSubstr("a&amp;b"));
  EXPECT_EQ(folder.fileCount(), 1u);
}

#ifdef RINGWATCH_WITH_VTK
TEST(VtuWriter, FramesHoldPositionsFieldsTimeAndNumbers) {
  const TemporaryFolder folder;
  const Mesh mesh = mixedMesh();
  const NodeVectors x = 2 * mesh.X;
  const std::vector<double> velocity(3 * mesh.nodeCount(), 0.5), step{1, 2, 3, 4};
  const std::vector<std::int32_t> handled{0, 1, 0, 1};
  const VtuField pointFields[] = {{"velocity", 3, std::span<const double>(velocity)}};
  const VtuField cellFields[] = {{"critical_step", 1, std::span<const double>(step)},
                                 {"handled", 1, std::span<const std::int32_t>(handled)}};
  writeVtu(folder / "frame.vtu", mesh, x, pointFields, cellFields, 0.25);
  const std::string text = readBytes(folder / "frame.vtu");
  for (const char* part : {"velocity", "critical_step", "handled", "TimeValue", "originalNodeId", "originalElementId",
                           "vtkZLibDataCompressor"})  // meshio knows no LZ4
    EXPECT_THAT(text, HasSubstr(part));
  const Mesh back = readMesh(folder / "frame.vtu");
  EXPECT_TRUE(back.X == x);
  EXPECT_EQ(back.nodeIds, mesh.nodeIds);
  EXPECT_EQ(back.blocks[1].ids, mesh.blocks[1].ids);
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(VtuWriter, MeshesArePackedSoThatEveryReaderKnowsIt) {
  const TemporaryFolder folder;
  writeMesh(mixedMesh(), folder / "mesh.vtu");
  EXPECT_THAT(readBytes(folder / "mesh.vtu"), HasSubstr("vtkZLibDataCompressor"));
}

TEST(VtuWriter, NumbersAMeshWithoutNumbers) {
  const TemporaryFolder folder;
  Mesh mesh = mixedMesh();
  mesh.nodeIds.clear();
  for (MeshBlock& block : mesh.blocks) block.ids.clear();
  writeVtu(folder / "frame.vtu", mesh, mesh.X);
  const Mesh back = readMesh(folder / "frame.vtu");
  for (std::int32_t i = 0; i < 14; ++i) EXPECT_EQ(back.nodeId(i), i);
}

TEST(VtuWriter, WrongLengthsAndPlacesAreRefused) {
  const TemporaryFolder folder;
  const Mesh mesh = mixedMesh();
  const std::vector<double> three{1, 2, 3};
  const VtuField field[] = {{"short", 1, std::span<const double>(three)}};
  EXPECT_THAT(errorOf([&] { writeVtu(folder / "f.vtu", mesh, mesh.X, {}, field); }),
              HasSubstr("\"short\" has 3 values; 4 are needed"));
  EXPECT_THAT(errorOf([&] { writeVtu(folder / "f.vtu", mesh, NodeVectors::Zero(3, 2)); }), HasSubstr("2 positions"));
  EXPECT_THAT(errorOf([&] { writeVtu(folder / "no" / "f.vtu", mesh, mesh.X); }), HasSubstr("there is no folder"));
  EXPECT_EQ(folder.fileCount(), 0u);
}
#else
TEST(VtuWriter, WithoutVtkSaysHowToGetIt) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorOf([&] { writeMesh(mixedMesh(), folder / "f.vtu"); }), HasSubstr("RINGWATCH_WITH_VTK"));
  EXPECT_THAT(errorOf([&] { writeVtu(folder / "f.vtu", mixedMesh(), mixedMesh().X); }), HasSubstr("libvtk9-dev"));
}
#endif

}  // namespace
}  // namespace ringwatch
