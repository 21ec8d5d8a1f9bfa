#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>  // needs gtest.h before it

#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;

BarOptions anyBar() {
  BarOptions o;
  for (std::size_t k = 0; k < 3; ++k) {
    o.cells[k] = *rc::gen::inRange(1, 5);
    o.size[k] = *rc::gen::inRange(1, 100) * 1e-2;
  }
  const auto splits = allCellSubdivisions();
  const CellSubdivision& split = splits[*rc::gen::inRange<std::size_t>(0, splits.size())];
  o.element = split.element;
  o.split = split.elementsPerCell;
  o.jitter = *rc::gen::inRange(0, 12) * 1e-2;
  o.seed = *rc::gen::arbitrary<std::uint64_t>();
  o.grading = 1 + *rc::gen::inRange(0, 30) * 0.1;
  return o;
}

RC_GTEST_PROP(MeshProperties, EveryBarIsSoundAndOfTheRightVolume, ()) {
  const BarOptions o = anyBar();
  const Mesh mesh = generateBar(o);
  const double volume = o.size[0] * o.size[1] * o.size[2];
  RC_ASSERT(std::abs(meshVolume(mesh) - volume) <= 1e-13 * volume);
  RC_ASSERT(checkMesh(mesh).empty());
  RC_ASSERT(faceNeighbours(mesh).overfull.empty());
}

RC_GTEST_PROP(MeshProperties, MshRoundTripsToTheLastBit, ()) {
  const TemporaryFolder folder;
  Mesh mesh = generateBar(anyBar());
  mesh.elementSets["some"] = {{0, 0}};
  for (const MeshFormat format : {MeshFormat::msh41, MeshFormat::msh41Binary}) {
    writeMesh(mesh, folder / "m.msh", format);
    expectSame(mesh, loadMesh(folder / "m.msh"), false);
  }
  // Version 2.2 keeps one set an element.
  Mesh one = mesh;
  one.elementSets.erase("some");
  for (const MeshFormat format : {MeshFormat::msh22, MeshFormat::msh22Binary}) {
    writeMesh(one, folder / "m.msh", format);
    expectSame(one, loadMesh(folder / "m.msh"), false);
  }
}

RC_GTEST_PROP(MeshProperties, MirroringIsFoundAndUndone, ()) {
  Mesh mesh = generateBar(anyBar());
  const double volume = meshVolume(mesh);
  mesh.X.row(*rc::gen::inRange(0, 3)) *= -1;
  std::vector<std::string> notes;
  requireSound(mesh, "m", &notes);
  RC_ASSERT(notes.size() == 1u);
  RC_ASSERT(std::abs(meshVolume(mesh) - volume) <= 1e-13 * volume);
}

RC_GTEST_PROP(MeshProperties, RandomBytesAfterAGoodStartNeverCrash, ()) {
  const TemporaryFolder folder;
  const auto tail =
      *rc::gen::container<std::string>(rc::gen::elementOf(std::string("0123456789.-e \n$\"\0\xFF"
                                                                      "abcNE",
                                                                      24)));
  for (const char* start : {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n",
                            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n"}) {
    writeBytes(folder / "m.msh", start + tail);
    RC_ASSERT_THROWS_AS(readMesh(folder / "m.msh"), InputError);
  }
}

}  // namespace
}  // namespace ringwatch
