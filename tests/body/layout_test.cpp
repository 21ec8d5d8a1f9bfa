// Patches and batches: every element once, local nodes that lead back to the mesh.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include <tests/support/body_cases.h>

namespace ringwatch {
namespace {

void expectSoundLayout(const Mesh& mesh) {
  const MeshBlock& block = mesh.blocks[0];
  const PatchLayout layout = layOutPatches(mesh, block);
  const std::size_t n = block.nodesPerElement();
  ASSERT_EQ(layout.batchOfElement.size(), block.elementCount());
  ASSERT_EQ(layout.elements.size() % lanes, 0u);
  ASSERT_EQ(layout.localNodes.size(), layout.elements.size() * n);
  // Patches follow one another without gap.
  std::int32_t batch = 0, node = 0;
  for (const Patch& patch : layout.patches) {
    EXPECT_EQ(patch.batchBegin, batch);
    EXPECT_EQ(patch.nodeBegin, node);
    EXPECT_GT(patch.batchEnd, batch);
    batch = patch.batchEnd;
    node = patch.nodeEnd;
    const std::set<std::int32_t> distinct(layout.nodes.begin() + patch.nodeBegin, layout.nodes.begin() + patch.nodeEnd);
    EXPECT_EQ(distinct.size(), patch.nodeEnd - patch.nodeBegin);
    for (std::int32_t b = patch.batchBegin; b < patch.batchEnd; ++b)
      for (int lane = 0; lane < lanes; ++lane) {
        const std::size_t place = b * lanes + lane;
        const std::int32_t e = layout.elements[place];
        EXPECT_GE(layout.elements[b * lanes], 0) << "a batch begins with an element";
        if (e < 0) continue;
        EXPECT_EQ(layout.batchOfElement[e], place);
        for (std::size_t a = 0; a < n; ++a) {
          const std::uint16_t local =
              layout.localNodes[(static_cast<std::size_t>(b) * n + a) * lanes + static_cast<std::size_t>(lane)];
          ASSERT_LT(local, patch.nodeEnd - patch.nodeBegin);
          EXPECT_EQ(layout.nodes[patch.nodeBegin + local], block.element(e)[a]);
        }
      }
  }
  EXPECT_EQ(batch, layout.batchCount());
  EXPECT_EQ(node, layout.nodes.size());
  // Each element has a place of its own.
  const std::set<std::int32_t> places(layout.batchOfElement.begin(), layout.batchOfElement.end());
  EXPECT_EQ(places.size(), block.elementCount());
}

TEST(PatchLayout, HoldsEveryElementOnce) {
  for (const ElementInfo& element : allElements())
    for (const test::Cells cells : {test::Cells{1, 1, 1}, test::Cells{3, 2, 2}, test::Cells{17, 13, 11}})
      expectSoundLayout(test::distortedBox(element.name, cells));
}

TEST(PatchLayout, TakesFlatAndPointlikeMeshes) {
  Mesh flat = test::distortedBox("tet4", {20, 20, 1});
  expectSoundLayout(flat);
  flat.X.setZero();
  expectSoundLayout(flat);
}

RC_GTEST_PROP(PatchLayout, HoldsEveryElementOfAnyCount, ()) {
  const auto& element = allElements()[*rc::gen::inRange<std::size_t>(0, allElements().size())];
  const Mesh whole = test::distortedBox(element.name, {4, 4, 4});
  expectSoundLayout(test::firstElements(whole, *rc::gen::inRange<std::size_t>(1, whole.elementCount() + 1)));
}

}  // namespace
}  // namespace ringwatch
