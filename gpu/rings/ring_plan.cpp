#include <ringwatch/gpu/rings/ring_plan.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

constexpr int threads = patchThreads(4), nodesOfElement = 4;

struct LocalPair {
  std::uint64_t key;  // device nodes, the larger one first
  std::vector<std::uint16_t> blocks;
  bool shared = false;
};
using PairsOfPatch = std::vector<LocalPair>;

/// The pairs of a patch by key, and which of them each element has.
PairsOfPatch pairsOf(const RingPatchesInput& input, std::size_t p, RingBlockPlan& plan) {
  const std::size_t places = p * threads;
  struct Entry {
    std::uint64_t key;
    std::uint16_t block;
  };
  std::vector<Entry> entries;
  for (int t = 0; t < (*input.patches)[p].elementCount; ++t) {
    std::array<std::int32_t, nodesOfElement> node{};
    std::array<int, nodesOfElement> order{0, 1, 2, 3};
    for (std::size_t a = 0; a < nodesOfElement; ++a) {
      const std::size_t local = (*input.corners)[(places + static_cast<std::size_t>(t)) * nodesOfElement + a];
      node[a] = (*input.nodes)[p * static_cast<std::size_t>(input.nodeCapacity) + local];
    }
    const auto nodeAt = [&](int a) { return node[a]; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return nodeAt(a) < nodeAt(b); });
    unsigned packed = 0;
    for (std::size_t a = 0; a < nodesOfElement; ++a) packed |= static_cast<unsigned>(order[a]) << (2 * a);
    plan.order[places + static_cast<std::size_t>(t)] = static_cast<std::uint8_t>(packed);
    int pair = 0;
    for (std::size_t a = 0; a < nodesOfElement; ++a)
      for (std::size_t b = 0; b <= a; ++b, ++pair)
        entries.push_back(
            {static_cast<std::uint64_t>(nodeAt(order[a])) << 32 | static_cast<std::uint32_t>(nodeAt(order[b])),
             static_cast<std::uint16_t>(pair * threads + t)});
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.block < b.block; });
  PairsOfPatch pairs;
  for (const Entry& entry : entries) {
    if (pairs.empty() || pairs.back().key != entry.key) pairs.push_back({entry.key, {}});
    pairs.back().blocks.push_back(entry.block);
  }
  return pairs;
}

/// Whether another patch may have a pair too: the smaller node, the key's lower half, is interior in most of them.
bool mayBeShared(const LocalPair& pair, std::int32_t interiorCount) {
  return static_cast<std::int32_t>(pair.key & 0xffffffffU) >= interiorCount;
}

/// The keys of the pairs that several patches have, ascending.
std::vector<std::uint64_t> sharedKeysOf(const std::vector<std::vector<PairsOfPatch>>& all, std::int32_t interiorCount) {
  std::vector<std::uint64_t> candidates;  // once for each patch
  for (const auto& patches : all)
    for (const PairsOfPatch& pairs : patches)
      for (const LocalPair& pair : pairs)
        if (mayBeShared(pair, interiorCount)) candidates.push_back(pair.key);
  std::sort(candidates.begin(), candidates.end());
  std::vector<std::uint64_t> shared;
  for (std::size_t i = 0; i + 1 < candidates.size(); ++i)
    if (candidates[i] == candidates[i + 1] && (shared.empty() || shared.back() != candidates[i]))
      shared.push_back(candidates[i]);
  return shared;
}

/// The shared pairs of a patch come last. Those of many blocks first, so that the threads of a warp have about the same
/// number to sum.
void orderPairs(PairsOfPatch& pairs, const std::vector<std::uint64_t>& sharedKeys, std::int32_t interiorCount) {
  for (LocalPair& pair : pairs)
    pair.shared =
        mayBeShared(pair, interiorCount) && std::binary_search(sharedKeys.begin(), sharedKeys.end(), pair.key);
  std::stable_sort(pairs.begin(), pairs.end(), [](const LocalPair& x, const LocalPair& y) {
    return x.shared != y.shared ? y.shared : x.blocks.size() > y.blocks.size();
  });
}

/// Numbers of pairs and slots, over all blocks so far.
struct Counts {
  std::int64_t pairs = 0, slots = 0;
};

/// The patches of a block, with the numbers of their pairs and slots.
void addPatches(const std::vector<PairsOfPatch>& patches, RingBlockPlan& block, Counts& counts) {
  std::size_t most = 0;
  for (const PairsOfPatch& pairs : patches) {
    const auto own = std::count_if(pairs.begin(), pairs.end(), [](const LocalPair& pair) { return !pair.shared; });
    block.patches.push_back({static_cast<std::int32_t>(pairs.size()), static_cast<std::int32_t>(own),
                             static_cast<std::int32_t>(counts.pairs), static_cast<std::int32_t>(counts.slots)});
    counts.pairs += own;
    counts.slots += static_cast<std::int64_t>(pairs.size()) - own;
    most = std::max(most, pairs.size());
    if (std::max(counts.pairs, counts.slots) >
        std::numeric_limits<std::int32_t>::max() - static_cast<std::int64_t>(pairs.size()))
      throw InputError("too many node pairs for reduced rings on the device");
  }
  block.pairCapacity = static_cast<int>((most + 31) / 32 * 32);
}

/// Which local pair each element's pairs are, and the rows of what they sum up; which pair each slot is a part of.
/// Consumes the patches.
void addRows(std::vector<PairsOfPatch>& patches, const std::vector<std::uint64_t>& sharedKeys, std::int32_t ownTotal,
             RingBlockPlan& block, RingPlan& plan) {
  std::vector<std::vector<std::uint16_t>> rowsOf(patches.size());
  std::vector<std::vector<std::int32_t>> rowEnd(patches.size());
  parallelFor(0, patches.size(), 0, [&](std::int64_t at) {
    const std::size_t p = at;
    PairsOfPatch& pairs = patches[p];
    const RingPatch& patch = block.patches[p];
    std::vector<std::vector<std::uint16_t>> blocksOf(pairs.size());
    for (std::size_t l = 0; l < pairs.size(); ++l) {
      for (const std::uint16_t own : pairs[l].blocks)
        block.pairs[p * threads * tetrahedronPairs + own] = static_cast<std::uint16_t>(l);
      blocksOf[l] = std::move(pairs[l].blocks);
      if (pairs[l].shared)
        plan.slotPair[patch.firstSlot + static_cast<std::int32_t>(l) - patch.ownCount] =
            ownTotal + static_cast<std::int32_t>(std::lower_bound(sharedKeys.begin(), sharedKeys.end(), pairs[l].key) -
                                                 sharedKeys.begin());
    }
    for (std::size_t first = 0; first < static_cast<std::size_t>(block.pairCapacity); first += 32) {
      fillRows(blocksOf, std::min(first, pairs.size()), std::min(first + 32, pairs.size()), tetrahedronPairs * threads,
               rowsOf[p]);
      rowEnd[p].push_back(rowsOf[p].size() / 32);
    }
    pairs = {};
  });
  block.groupRow.push_back(0);
  for (std::size_t p = 0; p < rowsOf.size(); ++p) {
    const std::int32_t before = block.rows.size() / 32;
    for (const std::int32_t end : rowEnd[p]) block.groupRow.push_back(before + end);
    block.rows.insert(block.rows.end(), rowsOf[p].begin(), rowsOf[p].end());
    block.rowCapacity = std::max(block.rowCapacity, static_cast<int>(rowsOf[p].size() / 32));
  }
}

/// The slots of each shared pair, ascending.
void addSharedSlots(RingPlan& plan, std::int32_t ownTotal, std::size_t sharedCount) {
  plan.sharedBegin.assign(sharedCount + 1, 0);
  for (const std::int32_t pair : plan.slotPair) ++plan.sharedBegin[static_cast<std::size_t>(pair - ownTotal) + 1];
  std::partial_sum(plan.sharedBegin.begin(), plan.sharedBegin.end(), plan.sharedBegin.begin());
  plan.sharedSlot.resize(plan.slotPair.size());
  std::vector<std::int32_t> next(plan.sharedBegin.begin(), plan.sharedBegin.end() - 1);
  for (std::size_t slot = 0; slot < plan.slotPair.size(); ++slot)
    plan.sharedSlot[next[plan.slotPair[slot] - ownTotal]++] = static_cast<std::int32_t>(slot);
}

}  // namespace

RingPlan planRings(const std::vector<RingPatchesInput>& blocks, std::int32_t interiorCount) {
  RingPlan plan;
  plan.blocks.resize(blocks.size());
  std::vector<std::vector<PairsOfPatch>> all(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t patches = blocks[b].patches->size();
    plan.blocks[b].order.assign(patches * threads, 0);
    plan.blocks[b].pairs.assign(patches * threads * tetrahedronPairs, 0);
    all[b].resize(patches);
    parallelFor(0, patches, 0, [&](std::int64_t p) { all[b][p] = pairsOf(blocks[b], p, plan.blocks[b]); });
  }
  const std::vector<std::uint64_t> sharedKeys = sharedKeysOf(all, interiorCount);
  Counts counts;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    parallelFor(0, all[b].size(), 0, [&](std::int64_t p) { orderPairs(all[b][p], sharedKeys, interiorCount); });
    addPatches(all[b], plan.blocks[b], counts);
  }
  const std::int32_t ownTotal = counts.pairs;
  plan.pairCount = ownTotal + static_cast<std::int32_t>(sharedKeys.size());
  plan.slotPair.resize(counts.slots);
  for (std::size_t b = 0; b < blocks.size(); ++b) addRows(all[b], sharedKeys, ownTotal, plan.blocks[b], plan);
  addSharedSlots(plan, ownTotal, sharedKeys.size());
  return plan;
}

}  // namespace ringwatch
