#include <ringwatch/gpu/body/device_cut.h>

#include <algorithm>
#include <utility>

#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

/// Where the slots of a plan belong.
class SlotOwners {
 public:
  SlotOwners(const DevicePlan& whole, const std::vector<std::int32_t>& partOfPatch) : partOfPatch_(partOfPatch) {
    std::int32_t patch = 0;
    for (const DeviceBlockPlan& block : whole.blocks) {
      if (block.patches.empty()) continue;
      blocks_.push_back({block.firstSlot, block.nodeCapacity, patch});
      patch += static_cast<std::int32_t>(block.patches.size());
    }
  }
  std::int32_t partOf(std::int32_t slot) const {
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), slot,
                                        [](std::int32_t s, const Block& block) { return s < block.firstSlot; });
    const Block& block = *(after - 1);
    return partOfPatch_[block.firstPatch + (slot - block.firstSlot) / block.capacity];
  }

 private:
  struct Block {
    std::int32_t firstSlot, capacity, firstPatch;
  };
  std::vector<Block> blocks_;
  const std::vector<std::int32_t>& partOfPatch_;
};

/// Makes the plan of one part.
class PartPlanner {
 public:
  PartPlanner(const DevicePlan& whole, const std::vector<std::int32_t>& partOfPatch, const SlotOwners& owners,
              const std::vector<bool>& atBorder, std::int32_t part)
      : whole_(whole), partOfPatch_(partOfPatch), owners_(owners), atBorder_(atBorder), part_(part) {}

  DevicePlan plan(std::size_t parts) {
    numberNodes();
    localSlot_.assign(static_cast<std::size_t>(whole_.slotCount), -1);
    for (const bool border : {true, false}) {
      std::int32_t firstPatch = 0;
      for (const DeviceBlockPlan& block : whole_.blocks) {
        takeBlock(block, firstPatch, border);
        firstPatch += static_cast<std::int32_t>(block.patches.size());
      }
      if (border) plan_.borderBlocks = plan_.blocks.size();
    }
    listExchanges(parts);
    listSlots();
    return std::move(plan_);
  }

 private:
  bool isBorder(std::int32_t node) const {
    return node >= whole_.interiorCount && atBorder_[node - whole_.interiorCount];
  }
  /// Calls visit(node) for all nodes of this part's patches, one after the other.
  template <class Visit>
  void forEachNode(const Visit& visit) const {
    std::size_t patch = 0;
    for (const DeviceBlockPlan& block : whole_.blocks)
      for (std::size_t own = 0; own < block.patches.size(); ++own, ++patch) {
        if (partOfPatch_[patch] != part_) continue;
        const auto capacity = static_cast<std::size_t>(block.nodeCapacity);
        for (std::size_t i = 0; i < static_cast<std::size_t>(block.patches[own].nodeCount); ++i)
          visit(block.nodes[own * capacity + i]);
      }
  }

  void numberNodes() {
    localNode_.assign(static_cast<std::size_t>(whole_.nodeCount()), -1);
    forEachNode([&](std::int32_t node) { localNode_[node] = 0; });
    if (part_ == 0)
      for (std::int32_t s = 0; s < whole_.sharedCount(); ++s)
        if (whole_.slotBegin[s] == whole_.slotBegin[s + 1]) localNode_[whole_.interiorCount + s] = 0;
    std::int32_t count = 0;
    for (std::size_t node = 0; node < localNode_.size(); ++node) {
      if (localNode_[node] == 0) localNode_[node] = count++;
      if (static_cast<std::int32_t>(node) == whole_.interiorCount - 1) plan_.interiorCount = count;
    }
    plan_.deviceNode.resize(whole_.deviceNode.size());
    for (std::size_t i = 0; i < plan_.deviceNode.size(); ++i) plan_.deviceNode[i] = localNode_[whole_.deviceNode[i]];
  }

  /// The patches of a block that are this part's, those with nodes at the border or the others.
  void takeBlock(const DeviceBlockPlan& from, std::int32_t firstPatch, bool border) {
    DeviceBlockPlan to;
    to.block = from.block;
    to.threads = from.threads;
    to.nodeCapacity = from.nodeCapacity;
    to.firstSlot = plan_.slotCount;
    to.groupRow.push_back(0);
    const auto capacity = static_cast<std::size_t>(from.nodeCapacity), threads = static_cast<std::size_t>(from.threads),
               groups = static_cast<std::size_t>(from.groups());
    for (std::size_t p = 0; p < from.patches.size(); ++p) {
      if (partOfPatch_[static_cast<std::size_t>(firstPatch) + p] != part_) continue;
      const std::int32_t* nodes = from.nodes.data() + p * capacity;
      if (std::any_of(nodes, nodes + from.patches[p].nodeCount, [&](std::int32_t n) { return isBorder(n); }) != border)
        continue;
      to.patches.push_back(from.patches[p]);
      plan_.wholePatch.push_back(firstPatch + static_cast<std::int32_t>(p));
      const auto copy = [p](const auto& all, auto& own, std::size_t each) {
        own.insert(own.end(), all.begin() + static_cast<std::ptrdiff_t>(p * each),
                   all.begin() + static_cast<std::ptrdiff_t>((p + 1) * each));
      };
      copy(from.elements, to.elements, threads);
      copy(from.corners, to.corners, from.corners.size() / from.patches.size());
      for (std::size_t i = 0; i < capacity; ++i) {
        localSlot_[static_cast<std::size_t>(from.firstSlot) + p * capacity + i] = plan_.slotCount++;
        to.nodes.push_back(nodes[i] < 0 ? -1 : localNode_[nodes[i]]);
      }
      const std::int32_t first = from.groupRow[p * groups], last = from.groupRow[(p + 1) * groups],
                         shift = to.groupRow.back() - first;
      for (std::size_t g = 1; g <= groups; ++g) to.groupRow.push_back(from.groupRow[p * groups + g] + shift);
      to.rows.insert(to.rows.end(), from.rows.begin() + static_cast<std::ptrdiff_t>(first) * 32,
                     from.rows.begin() + static_cast<std::ptrdiff_t>(last) * 32);
      to.rowCapacity = std::max(to.rowCapacity, last - first);
    }
    if (to.patches.empty()) return;
    plan_.patchCount += static_cast<std::int32_t>(to.patches.size());
    plan_.blocks.push_back(std::move(to));
  }

  /// Both sides of an exchange list its slots node by node, and those of a node in the order of the whole plan.
  void listExchanges(std::size_t parts) {
    std::vector<SlotLists> with(parts);
    std::vector<std::vector<std::int32_t>> receive(parts);
    std::vector<std::int32_t> others;
    for (std::int32_t s = 0; s < whole_.sharedCount(); ++s) {
      if (!atBorder_[s] || localNode_[whole_.interiorCount + s] < 0) continue;
      others.clear();
      const auto begin = whole_.slot.begin() + whole_.slotBegin[s], end = whole_.slot.begin() + whole_.slotBegin[s + 1];
      for (auto slot = begin; slot != end; ++slot) {
        const std::int32_t owner = owners_.partOf(*slot);
        if (owner == part_) continue;
        receive[owner].push_back(*slot);
        if (std::find(others.begin(), others.end(), owner) == others.end()) others.push_back(owner);
      }
      for (auto slot = begin; slot != end; ++slot)
        if (owners_.partOf(*slot) == part_)
          for (const std::int32_t other : others) with[other].send.push_back(localSlot_[*slot]);
    }
    for (std::size_t q = 0; q < parts; ++q) {
      if (receive[q].empty()) continue;
      with[q].with = q;
      with[q].firstReceived = plan_.slotCount;
      with[q].received = static_cast<std::int32_t>(receive[q].size());
      for (const std::int32_t slot : receive[q]) localSlot_[slot] = plan_.slotCount++;
      plan_.exchanges.push_back(std::move(with[q]));
    }
  }

  void listSlots() {
    plan_.slotBegin.push_back(0);
    for (std::int32_t s = 0; s < whole_.sharedCount(); ++s) {
      if (localNode_[whole_.interiorCount + s] < 0) continue;
      for (std::int32_t i = whole_.slotBegin[s]; i < whole_.slotBegin[s + 1]; ++i)
        plan_.slot.push_back(localSlot_[whole_.slot[i]]);
      plan_.slotBegin.push_back(static_cast<std::int32_t>(plan_.slot.size()));
    }
  }

  const DevicePlan& whole_;
  const std::vector<std::int32_t>& partOfPatch_;
  const SlotOwners& owners_;
  const std::vector<bool>& atBorder_;  // by shared node
  std::int32_t part_;
  std::vector<std::int32_t> localNode_, localSlot_;  // by those of the whole plan; -1: not here
  DevicePlan plan_;
};

}  // namespace

std::vector<std::int32_t> partsOfPatches(const DevicePlan& whole, const std::vector<double>& workOfElement,
                                         std::size_t parts) {
  std::vector<double> before{0};  // work of all patches before each
  for (const DeviceBlockPlan& block : whole.blocks)
    for (const DevicePatch& patch : block.patches)
      before.push_back(before.back() + patch.elementCount * workOfElement[block.block]);
  const std::size_t count = before.size() - 1;
  std::vector<std::int32_t> partOf(count);
  std::size_t begin = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    std::size_t end = count;
    if (part + 1 < parts) {
      const double share = before.back() * static_cast<double>(part + 1) / static_cast<double>(parts);
      // The patch that a share ends in goes to the next part: so two parts meet at the first plane of the bisection.
      end = static_cast<std::size_t>(std::upper_bound(before.begin(), before.end(), share) - before.begin()) - 1;
      end = std::clamp(end, begin + 1, count - (parts - 1 - part));
    }
    std::fill(partOf.begin() + static_cast<std::ptrdiff_t>(begin), partOf.begin() + static_cast<std::ptrdiff_t>(end),
              static_cast<std::int32_t>(part));
    begin = end;
  }
  return partOf;
}

std::vector<DevicePlan> cutPlan(const DevicePlan& whole, const std::vector<std::int32_t>& partOfPatch,
                                std::size_t parts) {
  const SlotOwners owners(whole, partOfPatch);
  std::vector<bool> atBorder(static_cast<std::size_t>(whole.sharedCount()), false);
  for (std::int32_t s = 0; s < whole.sharedCount(); ++s)
    for (std::int32_t i = whole.slotBegin[s] + 1; i < whole.slotBegin[s + 1]; ++i)
      if (owners.partOf(whole.slot[i]) != owners.partOf(whole.slot[whole.slotBegin[s]])) atBorder[s] = true;
  std::vector<DevicePlan> plans(parts);
  parallelFor(0, static_cast<std::int64_t>(parts), 0, [&](std::int64_t part) {
    plans[part] = PartPlanner(whole, partOfPatch, owners, atBorder, static_cast<std::int32_t>(part)).plan(parts);
  });
  return plans;
}

}  // namespace ringwatch
