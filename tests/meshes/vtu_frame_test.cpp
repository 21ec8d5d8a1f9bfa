// Frames with their fields: what writeVtu writes comes back, and fields follow their elements.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/formats/vtu_frame.h>
#include <ringwatch/meshes/formats/vtu_writer.h>
#include <tests/support/temporary_folder.h>

namespace ringwatch {
namespace {

class VtuFrameFile : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

#ifdef RINGWATCH_WITH_VTK
/// Two tetrahedra and a wedge on six nodes more.
Mesh meshOfFrame() {
  Mesh mesh;
  mesh.X.resize(3, 9);
  mesh.X << 0, 1, 0, 0, 1, 0, 1, 0, 0,  //
      0, 0, 1, 0, 1, 0, 0, 1, 0,        //
      0, 0, 0, 1, 1, 2, 2, 2, 3;
  mesh.blocks = {{elementTypeOf<Tet4>, {0, 1, 2, 3, 1, 2, 3, 4}, {7, 8}},
                 {elementTypeOf<Wedge6>, {3, 1, 2, 5, 6, 7}, {9}}};
  return mesh;
}

TEST_F(VtuFrameFile, ComesBackWithItsFields) {
  const Mesh mesh = meshOfFrame();
  const std::vector<double> steps{1e-3, 2.5e-4, 7e-5};
  const std::vector<std::int32_t> handled{0, 1, 0};
  const double h = 3e-4;
  const std::vector<VtuField> cells{{"step (s)", 1, std::span<const double>(steps)},
                                    {"handler", 1, std::span<const std::int32_t>(handled)}};
  const std::vector<VtuField> frame{{"step (s)", 1, std::span<const double>(&h, 1)}};
  writeVtu(folder_ / "f.vtu", mesh, mesh.X, {}, cells, 0.5, frame);
  const VtuFrame back = readVtuFrame(folder_ / "f.vtu");
  EXPECT_EQ(back.mesh.X, mesh.X);
  ASSERT_EQ(back.mesh.blocks.size(), 2u);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(back.mesh.blocks[b].connectivity, mesh.blocks[b].connectivity);
    EXPECT_EQ(back.mesh.blocks[b].ids, mesh.blocks[b].ids);
  }
  ASSERT_EQ(back.cells.size(), 2u);
  EXPECT_EQ(back.cells[0].name, "step (s)");
  EXPECT_EQ(back.cells[0].values, steps);
  EXPECT_FALSE(back.cells[0].integer);
  EXPECT_EQ(back.cells[1].values, (std::vector<double>{0, 1, 0}));
  EXPECT_TRUE(back.cells[1].integer);
  EXPECT_EQ(back.values.at("step (s)"), h);
  EXPECT_EQ(back.values.at("TimeValue"), 0.5);
}

#endif

TEST_F(VtuFrameFile, FieldsFollowTheirElementsWhateverLiesBetween) {
  // A tetrahedron, a triangle, a wedge in VTK's order, and a tetrahedron again.
  std::ofstream(folder_ / "f.vtu")
      << R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="4"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1 1 1 1 0 0 2 1 0 2 0 1 2</DataArray></Points><Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 0 1 2 3 2 1 5 7 6 1 2 3 4</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 7 13 17</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10 5 13 10</DataArray></Cells><CellData>
<DataArray type="Int32" Name="n" format="ascii">70 71 72 73</DataArray></CellData></Piece></UnstructuredGrid></VTKFile>)"
      << "\n";
  const VtuFrame frame = readVtuFrame(folder_ / "f.vtu");
  ASSERT_EQ(frame.mesh.blocks.size(), 2u);
  EXPECT_EQ(frame.mesh.blocks[1].connectivity, (std::vector<std::int32_t>{3, 1, 2, 5, 6, 7}));
  EXPECT_EQ(frame.cells.at(0).values, (std::vector<double>{70, 73, 72}));
}

}  // namespace
}  // namespace ringwatch
