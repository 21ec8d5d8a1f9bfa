#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

#include <ringwatch/gpu/body/device_cut.h>
#include <tests/gpu/cases.h>
#include <tests/gpu/checks.h>

using namespace ringwatch;
using checks::expect;
using checks::expectAtMost;
using checks::Test;

/// The cut of a plan over several devices, and what they exchange, without any.
namespace {

std::vector<double> oneEach(const Mesh& mesh) { return std::vector<double>(mesh.blocks.size(), 1.0); }

/// Mesh nodes by the device nodes of a plan.
std::vector<std::int32_t> meshNodesOf(const DevicePlan& plan) {
  std::vector<std::int32_t> nodes(static_cast<std::size_t>(plan.nodeCount()), -1);
  for (std::size_t i = 0; i < plan.deviceNode.size(); ++i)
    if (plan.deviceNode[i] >= 0) nodes.at(plan.deviceNode[i]) = static_cast<std::int32_t>(i);
  return nodes;
}

/// What a patch adds at a node: any number that depends on both.
double shareOf(std::int32_t patch, std::int32_t node) {
  return std::sin(1.0 + 7.13 * patch + 0.37 * node) * std::exp2(node % 40 - 20);
}

std::int32_t wholePatchOf(const DevicePlan& plan, std::size_t patch) {
  return plan.wholePatch.empty() ? static_cast<std::int32_t>(patch) : plan.wholePatch[patch];
}

/// The slots of a plan with what its own patches add; the others are not numbers.
std::vector<double> filledSlots(const DevicePlan& plan) {
  const std::vector<std::int32_t> meshNode = meshNodesOf(plan);
  std::vector<double> slots(static_cast<std::size_t>(plan.slotCount), std::numeric_limits<double>::quiet_NaN());
  std::size_t patch = 0;
  for (const DeviceBlockPlan& block : plan.blocks)
    for (std::size_t p = 0; p < block.patches.size(); ++p, ++patch)
      for (std::size_t i = 0; i < static_cast<std::size_t>(block.patches[p].nodeCount); ++i) {
        const std::size_t at = p * static_cast<std::size_t>(block.nodeCapacity) + i;
        slots.at(static_cast<std::size_t>(block.firstSlot) + at) =
            shareOf(wholePatchOf(plan, patch), meshNode[block.nodes[at]]);
      }
  return slots;
}

/// The sums at shared nodes, by mesh node, as the device makes them.
std::map<std::int32_t, double> sumsOf(const DevicePlan& plan, const std::vector<double>& slots) {
  const std::vector<std::int32_t> meshNode = meshNodesOf(plan);
  std::map<std::int32_t, double> sums;
  for (std::int32_t s = 0; s < plan.sharedCount(); ++s) {
    double sum = 0;
    for (std::int32_t i = plan.slotBegin[s]; i < plan.slotBegin[s + 1]; ++i) sum += slots.at(plan.slot[i]);
    sums[meshNode[plan.interiorCount + s]] = sum;
  }
  return sums;
}

/// Exchanges slots between the parts as SlotExchange does, by the lists alone. The number of slots that travel.
std::size_t exchange(const std::vector<DevicePlan>& parts, std::vector<std::vector<double>>& slots) {
  std::size_t sent = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const SlotLists& own : parts[p].exchanges)
      for (const SlotLists& theirs : parts[own.with].exchanges) {
        if (theirs.with != p) continue;
        expect(theirs.received == static_cast<std::int32_t>(own.send.size()), "both sides list as many slots");
        for (std::size_t i = 0; i < own.send.size(); ++i, ++sent)
          slots[own.with].at(static_cast<std::size_t>(theirs.firstReceived) + i) = slots[p].at(own.send[i]);
      }
  return sent;
}

/// Whether blocks of a part are those of the whole: elements, nodes and rows, patch by patch.
bool patchesAgree(const Mesh& mesh, const DevicePlan& part) {
  const std::vector<std::int32_t> meshNode = meshNodesOf(part);
  bool right = true;
  for (const DeviceBlockPlan& block : part.blocks) {
    const MeshBlock& from = mesh.blocks[block.block];
    const std::size_t n = from.nodesPerElement(), threads = block.threads;
    right = right && block.threads == patchThreads(static_cast<int>(n));
    for (std::size_t p = 0; p < block.patches.size(); ++p)
      for (std::size_t t = 0; t < static_cast<std::size_t>(block.patches[p].elementCount); ++t)
        for (std::size_t a = 0; a < n; ++a) {
          const std::size_t local = block.corners[(p * threads + t) * n + a];
          right = right && meshNode.at(block.nodes[p * static_cast<std::size_t>(block.nodeCapacity) + local]) ==
                               from.element(block.elements[p * threads + t])[a];
          const auto group = p * static_cast<std::size_t>(block.groups()) + local / 32;
          int found = 0;
          for (auto row = block.groupRow[group]; row < block.groupRow[group + 1]; ++row)
            found += block.rows[static_cast<std::size_t>(row) * 32 + local % 32] == a * threads + t;
          right = right && found == 1;
        }
  }
  return right;
}

void checkCut(const Mesh& mesh, const DevicePlan& whole, const std::vector<std::int32_t>& partOf, std::size_t count,
              const std::string& what) {
  const std::vector<DevicePlan> parts = cutPlan(whole, partOf, count);
  std::vector<int> patchSeen(static_cast<std::size_t>(whole.patchCount), 0), elements(mesh.blocks.size(), 0);
  std::vector<std::set<std::size_t>> partsAt(mesh.nodeCount());
  bool right = true;
  for (std::size_t p = 0; p < count; ++p) {
    const DevicePlan& part = parts[p];
    right = right && patchesAgree(mesh, part) && part.wholePatch.size() == static_cast<std::size_t>(part.patchCount);
    for (const std::int32_t patch : part.wholePatch) {
      ++patchSeen.at(patch);
      right = right && partOf[patch] == static_cast<std::int32_t>(p);
    }
    for (const DeviceBlockPlan& block : part.blocks)
      for (const DevicePatch& patch : block.patches) elements[block.block] += patch.elementCount;
    for (const std::int32_t node : meshNodesOf(part)) partsAt.at(node).insert(p);
  }
  for (std::size_t b = 0; b < elements.size(); ++b)
    right = right && elements[b] == static_cast<int>(mesh.blocks[b].elementCount());
  expect(right, what + ": parts have the patches of the whole");
  expect(std::set<int>(patchSeen.begin(), patchSeen.end()) == std::set<int>{1}, what + ": every patch is in one part");

  // Border first: no patch behind the first blocks has a node of another part.
  bool first = true;
  for (const DevicePlan& part : parts) {
    const std::vector<std::int32_t> meshNode = meshNodesOf(part);
    for (std::size_t b = 0; b < part.blocks.size(); ++b)
      for (std::size_t p = 0; p < part.blocks[b].patches.size(); ++p) {
        bool border = false;
        for (std::size_t i = 0; i < static_cast<std::size_t>(part.blocks[b].patches[p].nodeCount); ++i) {
          const std::size_t at = p * static_cast<std::size_t>(part.blocks[b].nodeCapacity) + i;
          border = border || partsAt[meshNode[part.blocks[b].nodes[at]]].size() > 1;
        }
        first = first && border == (b < part.borderBlocks);
      }
  }
  expect(first, what + ": patches at the border come first");

  // Traffic: every slot of a border node goes to each other part that has the node.
  std::size_t expected = 0;
  const std::vector<std::int32_t> wholeNode = meshNodesOf(whole);
  for (std::int32_t s = 0; s < whole.sharedCount(); ++s)
    expected += static_cast<std::size_t>(whole.slotBegin[s + 1] - whole.slotBegin[s]) *
                (partsAt[wholeNode[whole.interiorCount + s]].size() - (whole.slotBegin[s] < whole.slotBegin[s + 1]));
  std::vector<std::vector<double>> slots;
  for (const DevicePlan& part : parts) slots.push_back(filledSlots(part));
  expect(exchange(parts, slots) == expected, what + ": each slot of a border node goes to each other part there, once");

  const std::map<std::int32_t, double> sums = sumsOf(whole, filledSlots(whole));
  bool same = true;
  std::size_t found = 0;
  for (std::size_t p = 0; p < count; ++p)
    for (const auto& [node, sum] : sumsOf(parts[p], slots[p])) {
      same = same && sum == sums.at(node);
      ++found;
    }
  expect(same, what + ": sums at shared nodes have the bits of the whole");
  expect(found >= sums.size(), what + ": every shared node is somewhere");
}

void cutsPlans() {
  std::vector<Mesh> meshes{mixedBar()};
  for (const char* element : elementNames) meshes.push_back(bar(element, {9, 8, 7}));
  meshes.front().X.conservativeResize(3, meshes.front().X.cols() + 1);  // a node of no element
  meshes.front().X.rightCols(1).setZero();
  meshes.front().nodeIds.push_back(meshes.front().nodeIds.size());
  std::mt19937 generator(17);
  for (const Mesh& mesh : meshes) {
    const DevicePlan whole = planPatches(mesh);
    for (std::size_t count = 1; count <= 4; ++count) {
      const std::string what = std::to_string(count) + " parts of " + std::to_string(mesh.elementCount()) + " elements";
      checkCut(mesh, whole, partsOfPatches(whole, oneEach(mesh), count), count, what);
      std::vector<std::int32_t> random(static_cast<std::size_t>(whole.patchCount));
      for (std::int32_t& part : random) part = static_cast<std::int32_t>(generator() % count);
      checkCut(mesh, whole, random, count, what + " at random");
      for (std::int32_t& part : random) part = static_cast<std::int32_t>(count) - 1;
      checkCut(mesh, whole, random, count, what + ", one of which has all patches");
    }
  }
}

void sharesWork() {
  const Mesh mesh = mixedBar();
  const DevicePlan whole = planPatches(mesh);
  std::vector<double> work;
  for (const MeshBlock& block : mesh.blocks) work.push_back(block.nodesPerElement());
  double most = 0, sum = 0;
  std::vector<double> ofPatch;
  for (const DeviceBlockPlan& block : whole.blocks)
    for (const DevicePatch& patch : block.patches) {
      ofPatch.push_back(patch.elementCount * work[block.block]);
      most = std::max(most, ofPatch.back());
      sum += ofPatch.back();
    }
  for (const std::size_t count : {1, 2, 3, 4, 7}) {
    const std::vector<std::int32_t> partOf = partsOfPatches(whole, work, count);
    std::vector<double> share(count, 0);
    for (std::size_t p = 0; p < partOf.size(); ++p) share.at(partOf[p]) += ofPatch[p];
    for (const double one : share)
      expectAtMost(std::abs(one - sum / static_cast<double>(count)), most, "a part's work is off by a patch at most");
    expect(std::is_sorted(partOf.begin(), partOf.end()), "parts are runs of patches");
  }
  // As many parts as patches, and work that lies in one of them: each part has a patch.
  const auto patches = static_cast<std::size_t>(whole.patchCount);
  std::vector<double> uneven(mesh.blocks.size(), 1e-9);
  uneven.front() = 1;
  for (const std::size_t count : {patches, patches / 2}) {
    const std::vector<std::int32_t> partOf = partsOfPatches(whole, uneven, count);
    expect(std::set<std::int32_t>(partOf.begin(), partOf.end()).size() == count, "every part has a patch");
  }
}

const Test tests[] = {
    {"cut-plans", false, cutsPlans},
    {"cut-shares", false, sharesWork},
};

}  // namespace
