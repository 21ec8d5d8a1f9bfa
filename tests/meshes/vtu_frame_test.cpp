// Frames with their fields: what writeVtu writes comes back, type by type; files in another order are refused.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/formats/vtu_frame.h>
#include <ringwatch/meshes/formats/vtu_writer.h>

namespace ringwatch {
namespace {

class VtuFrameFile : public ::testing::Test {
 protected:
  VtuFrameFile() {
    std::string name = (std::filesystem::temp_directory_path() / "ringwatch-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    folder_ = name;
  }
  ~VtuFrameFile() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
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

TEST_F(VtuFrameFile, RefusesAnOrderInWhichFieldsWouldGoToOtherElements) {
  // A tetrahedron, a wedge and a tetrahedron again, and then a triangle.
  const auto write = [&](const char* connectivity, const char* offsets, const char* types, int count) {
    std::ofstream(folder_ / "f.vtu")
        << R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells=")" << count
        << R"("><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1 1 1 1 0 0 2 1 0 2 0 1 2</DataArray></Points><Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">)"
        << connectivity << R"(</DataArray><DataArray type="Int64" Name="offsets" format="ascii">)" << offsets
        << R"(</DataArray><DataArray type="UInt8" Name="types" format="ascii">)" << types
        << "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n";
    std::string said;
    try {
      readVtuFrame(folder_ / "f.vtu");
    } catch (const InputError& fault) {
      said = fault.what();
    }
    return said;
  };
  EXPECT_EQ(write("0 1 2 3 3 1 2 5 6 7 1 2 3 4", "4 10 14", "10 13 10", 3),
            (folder_ / "f.vtu").string() + ": element types are mixed; a frame has them type by type");
  EXPECT_THAT(write("0 1 2 3 0 1 2", "4 7", "10 5", 2), ::testing::HasSubstr("has cells of surfaces"));
  EXPECT_EQ(write("0 1 2 3 1 2 3 4 3 1 2 5 6 7", "4 8 14", "10 10 13", 3), "");
}

}  // namespace
}  // namespace ringwatch
