#pragma once
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/rings/device_rings.h>
#include <ringwatch/gpu/tangent_operations.h>

namespace ringwatch {

struct DeviceRings::Impl {
  struct Block {
    TangentOperations operations;
    RingBlockView view;
    DeviceVector<RingPatch> patches;
    DeviceVector<std::uint8_t> order;
    DeviceVector<std::uint16_t> pairs, rows;
    DeviceVector<std::int32_t> groupRow;
    DeviceVector<double> largest;
    DeviceVector<HighestRing> highest;
  };

  explicit Impl(DeviceBody<double>& deviceBody);

  DevicePart<double>& body;
  std::vector<Block> blocks;
  RingView view;
  DeviceVector<double> pair, slots;
  DeviceVector<std::int32_t> slotPair, sharedBegin, sharedSlot;
};

}  // namespace ringwatch
