#include <ringwatch/gpu/rings/device_rings.h>

#include <cmath>

#include <ringwatch/gpu/device_status.h>
#include <ringwatch/gpu/rings/device_rings_impl.h>

namespace ringwatch {

DeviceRings::Impl::Impl(DeviceBody<double>& deviceBody) : body(deviceBody.impl().only("reduced rings")) {
  std::vector<std::vector<DevicePatch>> patches;
  std::vector<std::vector<std::uint16_t>> corners;
  std::vector<std::vector<std::int32_t>> nodes;
  for (std::size_t b = 0; b < body.blocks.size(); ++b) {
    if (body.blocks[b].type != elementTypeOf<Tet4>)
      throw InputError(joinText("block ", b, ": elements of type ", elementInfo(body.blocks[b].type).name,
                                ": reduced rings on the device are for tet4 alone"));
    patches.push_back(body.blocks[b].patches.download());
    corners.push_back(body.blocks[b].corners.download());
    nodes.push_back(body.blocks[b].nodes.download());
  }
  std::vector<RingPatchesInput> inputs;
  for (std::size_t b = 0; b < body.blocks.size(); ++b)
    inputs.push_back({&patches[b], &corners[b], &nodes[b], body.blocks[b].view.nodeCapacity});
  const RingPlan plan = planRings(inputs, body.nodes.interiorCount);

  std::size_t need = 9 * sizeof(double) * (static_cast<std::size_t>(plan.pairCount) + plan.slotPair.size()) +
                     sizeof(std::int32_t) * (2 * plan.slotPair.size() + plan.sharedBegin.size());
  for (const RingBlockPlan& from : plan.blocks)
    need += from.patches.size() * (sizeof(RingPatch) + patchThreads(4) * sizeof(double)) + from.order.size() +
            sizeof(std::uint16_t) * (from.pairs.size() + from.rows.size()) +
            sizeof(std::int32_t) * from.groupRow.size();
  requireDeviceMemory(need);
  pair = DeviceVector<double>(9 * static_cast<std::size_t>(plan.pairCount));
  slots = DeviceVector<double>(9 * plan.slotPair.size());
  slotPair = DeviceVector<std::int32_t>(plan.slotPair);
  sharedBegin = DeviceVector<std::int32_t>(plan.sharedBegin);
  sharedSlot = DeviceVector<std::int32_t>(plan.sharedSlot);
  view = {plan.pairCount,
          plan.pairCount - plan.sharedCount(),
          static_cast<std::int32_t>(plan.slotPair.size()),
          pair.data(),
          slots.data(),
          slotPair.data(),
          sharedBegin.data(),
          sharedSlot.data()};
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const RingBlockPlan& from = plan.blocks[b];
    Block& block = blocks.emplace_back();
    block.operations = tangentOperations(body.blocks[b].type, body.blocks[b].lawIndex);
    block.patches = DeviceVector<RingPatch>(from.patches);
    block.order = DeviceVector<std::uint8_t>(from.order);
    block.pairs = DeviceVector<std::uint16_t>(from.pairs);
    block.groupRow = DeviceVector<std::int32_t>(from.groupRow);
    block.rows = DeviceVector<std::uint16_t>(from.rows);
    block.largest = DeviceVector<double>(from.patches.size() * patchThreads(4));
    block.highest = DeviceVector<HighestRing>(static_cast<std::size_t>(ringBlocks(from.patches.size())));
    block.view = {from.pairCapacity,  from.rowCapacity,      block.patches.data(), block.order.data(),
                  block.pairs.data(), block.groupRow.data(), block.rows.data()};
  }
}

DeviceRings::DeviceRings(DeviceBody<double>& body) : impl_(std::make_unique<Impl>(body)) {}
DeviceRings::~DeviceRings() { cudaStreamSynchronize(impl_->body.stream); }

void DeviceRings::compute() {
  Impl& m = *impl_;
  for (std::size_t b = 0; b < m.blocks.size(); ++b)
    m.blocks[b].operations.assembleRings(m.body.blocks[b].view, m.body.nodes, m.body.blocks[b].law, m.blocks[b].view,
                                         m.view, m.body.stream);
  launchSumPairs(m.view, m.body.stream);
  for (std::size_t b = 0; b < m.blocks.size(); ++b)
    launchRingEigenvalues(m.body.blocks[b].view, m.blocks[b].view, m.view, m.blocks[b].largest.data(),
                          m.blocks[b].highest.data(), m.body.stream);
}

DeviceRings::Highest DeviceRings::highest() {
  compute();
  Impl& m = *impl_;
  m.body.stream.synchronize();
  Highest result;
  for (std::size_t b = 0; b < m.blocks.size(); ++b)
    for (const HighestRing& ring : m.blocks[b].highest.download()) {
      if (!(ring.value > result.value || std::isnan(ring.value)) || std::isnan(result.value)) continue;
      result.value = ring.value;
      result.element = {b, m.body.blocks[b].elements[ring.place]};
    }
  return result;
}

std::vector<std::vector<double>> DeviceRings::evaluate() {
  compute();
  Impl& m = *impl_;
  m.body.stream.synchronize();
  std::vector<std::vector<double>> result(m.blocks.size());
  for (std::size_t b = 0; b < m.blocks.size(); ++b) {
    const std::vector<std::int32_t>& elements = m.body.blocks[b].elements;
    const std::vector<double> largest = m.blocks[b].largest.download();
    result[b].resize(m.body.blocks[b].elementCount);
    for (std::size_t place = 0; place < elements.size(); ++place)
      if (elements[place] >= 0) result[b][elements[place]] = largest[place];
  }
  return result;
}

}  // namespace ringwatch
