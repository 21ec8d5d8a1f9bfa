#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/gpu/body/device_patches.h>

namespace ringwatch {

/// The part of each patch of a plan, counted over all blocks: runs of patches in the order of their bisection, of about
/// equal work; every part has some. workOfElement: of each block, in any unit. parts: 1 up to the number of patches.
std::vector<std::int32_t> partsOfPatches(const DevicePlan& whole, const std::vector<double>& workOfElement,
                                         std::size_t parts);

/// Cuts the plan of a mesh into parts, one for each device. A part has its patches with all their nodes, so that a node
/// at patches of several parts (a border node) is in all of these. There each part has a slot for every patch of the
/// whole mesh: its own patches fill theirs, the others' are received. A border node's slots are summed in the order of
/// the whole plan, by every part that has it: so all of them find the same bits, those of the whole (Theorem 93,
/// docs/theory/distribution.md). Nodes of no element are in the first part.
///
/// partOfPatch: of each patch, 0 to parts - 1; any assignment does. A part without patches has no nodes.
std::vector<DevicePlan> cutPlan(const DevicePlan& whole, const std::vector<std::int32_t>& partOfPatch,
                                std::size_t parts);

}  // namespace ringwatch
