#include <bit>
#include <cstring>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;

std::vector<MeshFormat> losslessFormats() {
  std::vector<MeshFormat> formats{MeshFormat::msh41, MeshFormat::msh41Binary};
#ifdef RINGWATCH_WITH_VTK
  formats.push_back(MeshFormat::vtu);
#endif
  return formats;
}

TEST(MeshIo, LosslessFormatsKeepNumbersPositionsBlocksAndSets) {
  const TemporaryFolder folder;
  const Mesh mesh = mixedMesh();
  for (const MeshFormat format : losslessFormats()) {
    const auto path = folder / (format == MeshFormat::vtu ? "m.vtu" : "m.msh");
    writeMesh(mesh, path, format);
    expectSame(mesh, readMesh(path));
  }
  EXPECT_EQ(folder.fileCount(), losslessFormats().size() > 2 ? 2u : 1u) << "temporary files are left";
}

TEST(MeshIo, Msh22KeepsTheSmallestSetOfEachElement) {
  const TemporaryFolder folder;
  const Mesh mesh = mixedMesh();
  Mesh expected = mesh;
  expected.elementSets.clear();
  expected.elementSets["box"] = {{0, 0}, {0, 1}};
  expected.elementSets["tip"] = {{1, 1}};
  expected.elementSets["all"] = {{1, 0}};
  for (const MeshFormat format : {MeshFormat::msh22, MeshFormat::msh22Binary}) {
    writeMesh(mesh, folder / "m.msh", format);
    expectSame(expected, readMesh(folder / "m.msh"));
  }
}

TEST(MeshIo, GeneratedNumbersStartAtOneInTheFile) {
  const TemporaryFolder folder;
  const Mesh mesh = generateBar({.cells = {2, 1, 1}, .element = "hex8"});
  writeMesh(mesh, folder / "m.msh");
  const Mesh back = readMesh(folder / "m.msh");
  expectSame(mesh, back, false);
  EXPECT_EQ(back.nodeIds.front(), 1);
  EXPECT_EQ(back.blocks[0].ids.back(), 2);
}

// Made by hand from the format's description, so that reader and writer cannot agree on the same mistake.
template <class T>
void put(std::string& bytes, T value, bool swap) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (swap) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};

std::string binary22(bool swap) {
  std::string b = "$MeshFormat\n2.2 1 8\n";
  put<std::int32_t>(b, 1, swap);
  b += "\n$EndMeshFormat\n$PhysicalNames\n2\n2 4 \"base\"\n3 9 \"the solid\"\n$EndPhysicalNames\n$Nodes\n4\n";
  for (int i = 0; i < 4; ++i) {
    put<std::int32_t>(b, 10 + i, swap);
    for (const double x : corners[i]) put(b, x, swap);
  }
  b += "\n$EndNodes\n$Elements\n2\n";
  for (const int x : {2, 1, 2, 70, 4, 1, 10, 12, 11}) put<std::int32_t>(b, x, swap);
  for (const int x : {4, 1, 2, 71, 9, 1, 10, 11, 12, 13}) put<std::int32_t>(b, x, swap);
  return b + "\n$EndElements\n";
}

std::string binary41(bool swap) {
  std::string b = "$MeshFormat\n4.1 1 8\n";
  put<std::int32_t>(b, 1, swap);
  b += "\n$EndMeshFormat\n$PhysicalNames\n2\n2 4 \"base\"\n3 9 \"the solid\"\n$EndPhysicalNames\n$Entities\n";
  const auto size = [&](std::uint64_t v) { put(b, v, swap); };
  const auto integer = [&](std::int32_t v) { put(b, v, swap); };
  const auto real = [&](double v) { put(b, v, swap); };
  for (const int n : {1, 0, 1, 1}) size(static_cast<std::uint64_t>(n));
  integer(5), real(0), real(0), real(0), size(0);  // a point of no group
  integer(1);                                      // a surface
  for (int k = 0; k < 6; ++k) real(k);
  size(1), integer(4), size(2), integer(3), integer(-4);
  integer(1);  // a volume
  for (int k = 0; k < 6; ++k) real(k);
  size(1), integer(9), size(1), integer(1);
  b += "\n$EndEntities\n$Nodes\n";
  size(2), size(4), size(10), size(13);
  integer(2), integer(1), integer(1), size(3);  // parametric: two more numbers a node
  for (int i = 0; i < 3; ++i) size(10 + static_cast<std::uint64_t>(i));
  for (int i = 0; i < 3; ++i) {
    for (const double x : corners[i]) real(x);
    real(0.5), real(0.5);
  }
  integer(3), integer(1), integer(0), size(1), size(13);
  for (const double x : corners[3]) real(x);
  b += "\n$EndNodes\n$Elements\n";
  size(2), size(2), size(70), size(71);
  integer(2), integer(1), integer(2), size(1), size(70), size(10), size(12), size(11);
  integer(3), integer(1), integer(4), size(1), size(71), size(10), size(11), size(12), size(13);
  return b + "\n$EndElements\n";
}

void expectTetWithBase(const Mesh& mesh) {
  ASSERT_EQ(mesh.nodeCount(), 4u);
  EXPECT_EQ(mesh.nodeIds, (std::vector<std::int64_t>{10, 11, 12, 13}));
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].ids, std::vector<std::int64_t>{71});
  EXPECT_EQ(mesh.blocks[0].connectivity, (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_DOUBLE_EQ(meshVolume(mesh), 1.0);
  EXPECT_EQ(mesh.nodeSets.at("base"), (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.elementSets.at("the solid"), std::vector<ElementRef>{ElementRef{}});
}

TEST(MeshIo, BinaryMshMadeByHandInBothByteOrders) {
  const TemporaryFolder folder;
  for (const bool swap : {false, true})
    for (const std::string& bytes : {binary22(swap), binary41(swap)}) {
      writeBytes(folder / "m.msh", bytes);
      expectTetWithBase(loadMesh(folder / "m.msh"));
    }
}

TEST(MeshIo, TextMshOfEveryVersion) {
  const TemporaryFolder folder;
  const std::string names = "$PhysicalNames\n2\n2 4 \"base\"\n3 9 \"the solid\"\n$EndPhysicalNames\n";
  writeBytes(folder / "2.msh", "$MeshFormat\r\n2.2 0 8\r\n$EndMeshFormat\r\n" + names +
                                   "$Nodes\n4\n10 0 0 0\n11 1e0 0 0\n12 0 +2 0\n13 0 0 3.0\n$EndNodes\n"
                                   "$Elements\n2\n70 2 2 4 1 10 12 11\n71 4 2 9 1 10 11 12 13\n$EndElements\n"
                                   "$NodeData\n1\n\"anything\"\n$EndNodeData\n");
  expectTetWithBase(loadMesh(folder / "2.msh"));
  writeBytes(folder / "40.msh",
             "$MeshFormat\n4 0 8\n$EndMeshFormat\n" + names +
                 "$Entities\n1 0 1 1\n5 0 0 0 0 0 0 0\n1 0 0 0 1 1 1 1 4 0\n1 0 0 0 1 1 1 1 9 1 1\n$EndEntities\n"
                 "$Nodes\n2 4\n1 2 0 3\n10 0 0 0\n11 1 0 0\n12 0 2 0\n1 3 0 1\n13 0 0 3\n$EndNodes\n"
                 "$Elements\n2 2\n1 2 2 1\n70 10 12 11\n1 3 4 1\n71 10 11 12 13\n$EndElements\n");
  expectTetWithBase(loadMesh(folder / "40.msh"));
  writeBytes(folder / "41.msh",
             "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names +
                 "$Entities\n1 0 1 1\n5 0 0 0 0 \n1 0 0 0 1 1 1 1 4 0 \n1 0 0 0 1 1 1 1 9 1 1 \n$EndEntities\n"
                 "$Nodes\n2 4 10 13\n2 1 0 3\n10\n11\n12\n0 0 0\n1 0 0\n0 2 0\n3 1 0 1\n13\n0 0 3\n$EndNodes\n"
                 "$Elements\n2 2 70 71\n2 1 2 1\n70 10 12 11 \n3 1 4 1\n71 10 11 12 13 \n$EndElements\n");
  expectTetWithBase(loadMesh(folder / "41.msh"));
}

TEST(MeshIo, TetgenFromEitherFileOrTheStemWithAnyFirstNumber) {
  const TemporaryFolder folder;
  for (const int first : {0, 1}) {
    const auto n = [&](int i) { return std::to_string(first + i); };
    writeBytes(folder / "a.1.node", "# nodes\n\n 4 3 1 1 # four\n" + n(0) + " 0 0 0 9.5 0\n" + n(1) +
                                        " 1 0 0 9.5 2\n# in between\n" + n(2) + " 0 2 0 9.5 2\n" + n(3) +
                                        " 0 0 3 9.5 0 # last\n# made by hand\n");
    writeBytes(folder / "a.1.ele", "1 4 1\n" + n(0) + " " + n(0) + " " + n(1) + " " + n(2) + " " + n(3) + " 7\n");
    for (const char* name : {"a.1.node", "a.1.ele", "a.1"}) {
      const Mesh mesh = loadMesh(folder / name);
      EXPECT_EQ(mesh.nodeIds.front(), first);
      EXPECT_DOUBLE_EQ(meshVolume(mesh), 1.0);
      EXPECT_EQ(mesh.nodeSets.at("marker-2"), (std::vector<std::int32_t>{1, 2}));
      EXPECT_EQ(mesh.elementSets.at("region-7").size(), 1u);
    }
  }
}

TEST(MeshIo, UnusedNodesAreDroppedAndMirroredMeshesTurnedRoundWithANote) {
  const TemporaryFolder folder;
  writeBytes(folder / "m.msh",
             "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 9 9 9\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 0 0 1\n$EndNodes\n"
             "$Elements\n2\n1 15 2 8 1 1\n2 4 0 2 4 3 5\n$EndElements\n");
  std::vector<std::string> notes;
  const Mesh mesh = loadMesh(folder / "m.msh", &notes);
  EXPECT_EQ(mesh.nodeIds, (std::vector<std::int64_t>{2, 3, 4, 5}));
  EXPECT_NEAR(meshVolume(mesh), 1.0 / 6.0, 1e-15);
  EXPECT_TRUE(mesh.nodeSets.at("point-8").empty());
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_NE(notes[1].find("node 1"), std::string::npos);
  EXPECT_NE(notes[2].find("turned round"), std::string::npos);
  EXPECT_EQ(readMesh(folder / "m.msh").nodeCount(), 5u);
}

TEST(MeshIo, MirroredHexahedraAreTurnedRound) {
  Mesh mesh = generateBar({.cells = {2, 2, 1}, .element = "hex8", .jitter = 0.2});
  mesh.X.row(0) *= -1;
  std::vector<std::string> notes;
  requireSound(mesh, "m", &notes);
  EXPECT_EQ(notes.size(), 1u);
  EXPECT_NEAR(meshVolume(mesh), 1.0, 1e-14);
}

TEST(MeshIo, LegacyVtkText) {
  const TemporaryFolder folder;
  writeBytes(folder / "m.vtk",
             "# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 0\n0 2 "
             "0\n0 0 3\n"
             "\nCELLS 2 9\n3 0 2 1\n4 0 1 2 3\n\nCELL_TYPES 2\n5\n10\n");
  std::vector<std::string> notes;
  const Mesh mesh = loadMesh(folder / "m.vtk", &notes);
  EXPECT_DOUBLE_EQ(meshVolume(mesh), 1.0);
  EXPECT_EQ(mesh.blocks[0].ids, std::vector<std::int64_t>{1});
  EXPECT_EQ(notes.size(), 1u);
}

TEST(MeshIo, LegacyVtkVersion5) {
  const TemporaryFolder folder;
  writeBytes(
      folder / "m.vtk",
      "# vtk DataFile Version 5.1\n\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTimeValue 1 1 double\n0.5\n"
      "POINTS 4 float\n0 0 0 1 0 0 0 2 0\n0 0 3\nMETADATA\nINFORMATION 0\n\nCELLS 3 7\nOFFSETS vtktypeint64\n0 3 7\n"
      "CONNECTIVITY vtktypeint64\n0 2 1 0 1 2 3\nCELL_TYPES 2\n5 10\nCELL_DATA 2\nSCALARS a int\n1 2\n");
  EXPECT_DOUBLE_EQ(meshVolume(loadMesh(folder / "m.vtk")), 1.0);
}

}  // namespace
}  // namespace ringwatch
