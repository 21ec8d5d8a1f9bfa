#pragma once
#include <ringwatch/gpu/body/device_body.h>
#include <ringwatch/gpu/body/patch_operations.h>
#include <ringwatch/gpu/body/slot_exchange.h>
#include <ringwatch/gpu/device_stream.h>
#include <ringwatch/gpu/device_vector.h>

namespace ringwatch {

/// What of a body is on one device: all of it, or a part that cutPlan has made. Calls need that device to be current.
template <class R>
struct DevicePart {
  struct Block {
    ElementType type;
    std::size_t lawIndex = 0;
    int elementNodes = 0, threads = 0, points = 0;  // points at which geometry is stored
    std::size_t elementCount = 0;
    std::vector<std::int32_t> elements;  // [patch][thread] position in the mesh block, -1: none
    PatchOperations<R> operations;
    LawParameters law;
    BlockView<R> view;
    DeviceVector<DevicePatch> patches;
    DeviceVector<std::uint16_t> corners, rows;
    DeviceVector<std::int32_t> nodes, groupRow;
    DeviceVector<R> geometry;
  };

  DevicePart(const DeviceBodyInput& input, DevicePlan plan, int device);
  /// geometry: of the block's points, as tabulateGeometry makes it.
  void addBlock(const DeviceBodyInput& input, const DeviceBlockPlan& from, std::int32_t firstPatch,
                const std::vector<R>& geometry);
  void makeNodes(const DeviceBodyInput& input, const DevicePlan& plan);
  /// From and to nodal arrays in the mesh's numbering; only this part's nodes are read and written.
  void uploadPositions(const NodeVectors& x);
  void uploadVectors(const NodeVectors& values, DeviceVector<R>& to);
  void takeRows(const DeviceVector<Row4<R>>& rows, NodeVectors& to) const;
  void takePositions(NodeVectors& to) const;
  void takeVelocities(NodeVectors& to) const;
  void setStep(double h);
  /// Puts `count` steps into the stream, as graphs of `bunch` and of one, which are captured at the first call:
  /// enqueue(steps) puts some in.
  template <class Enqueue>
  void repeat(std::int64_t count, std::unique_ptr<DeviceGraph> (&graphs)[2], const Enqueue& enqueue) {
    if (!graphs[0]) {
      graphs[0] = std::make_unique<DeviceGraph>(stream, [&] { enqueue(1); });
      graphs[1] = std::make_unique<DeviceGraph>(stream, [&] { enqueue(bunch); });
    }
    inBunches(count, [&](std::int64_t steps) { graphs[steps == 1 ? 0 : 1]->launch(stream); });
  }
  /// Calls take(bunch) as often as that goes, and take(1) for what is left.
  template <class Take>
  static void inBunches(std::int64_t count, const Take& take) {
    for (; count >= bunch; count -= bunch) take(bunch);
    for (; count > 0; --count) take(1);
  }

  static constexpr std::int64_t bunch = 20;

  std::int32_t nodeCount = 0;
  std::int64_t elementCount = 0;
  std::int32_t patchCount = 0;
  std::size_t bytes = 0;
  int device = 0;
  std::vector<std::int32_t> deviceNode, meshNode;  // of the part's nodes, each by the other; -1: not in this part
  std::vector<R> inverseMass;                      // by device node
  NodeVectors X;                                   // reference positions, by device node
  std::size_t borderBlocks = 0;
  std::vector<std::int32_t> wholePatch;
  std::vector<SlotLists> exchanges;
  DeviceStream stream;
  std::vector<Block> blocks;
  NodeView<R> nodes;
  DeviceVector<Row4<R>> u, slots, result;
  DeviceVector<R> v, external, direction;
  DeviceVector<std::uint8_t> constrained;
  DeviceVector<std::int32_t> slotBegin, slot;
  DeviceVector<double> partial, sum;
  DeviceVector<DeviceClock> clock;
  double h = 0;
};

extern template struct DevicePart<double>;
extern template struct DevicePart<float>;

template <class R>
struct DeviceBody<R>::Impl {
  using Part = DevicePart<R>;

  Impl(const DeviceBodyInput& input, const DevicePlan& plan, std::vector<int> devices);

  /// The part of a body that is on one device alone, the current one. Throws InputError for another body: `what` does
  /// not run on several.
  Part& only(const char* what);
  /// Puts work on all patches into the streams of all parts: launch(part, number of the block) for each block, those at
  /// the border first, so that their slots travel while others are computed; beside(part) before and finish(part) after
  /// what is received is there.
  template <class Launch, class Beside, class Finish>
  void enqueue(SlotExchange& slots, const Launch& launch, const Beside& beside, const Finish& finish) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const OnDevice here(parts[p]->device);
      for (std::size_t b = 0; b < parts[p]->borderBlocks; ++b) launch(p, b);
      slots.pack(p);
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const OnDevice here(parts[p]->device);
      for (std::size_t b = parts[p]->borderBlocks; b < parts[p]->blocks.size(); ++b) launch(p, b);
      beside(p);
      slots.await(p);
      finish(p);
      slots.release(p);
    }
  }
  /// The same for an operation of the patches, with the body's own slots.
  template <class Finish>
  void enqueueForce(typename PatchOperations<R>::Launch PatchOperations<R>::*which, const Finish& finish);
  void enqueueStep();
  /// Calls f(part) with the part's device as the current one.
  template <class F>
  void forEachPart(const F& f) const {
    for (const std::unique_ptr<Part>& part : parts) {
      const OnDevice here(part->device);
      f(*part);
    }
  }
  void setStep(double h);
  void synchronize() const;
  void requireNodes(const NodeVectors& values, const char* what) const;
  /// What lies in the parts' results, in the mesh's numbering.
  NodeVectors results() const;
  /// Σ, in the order of the whole plan, of what the parts have for each patch.
  double sumOfPatches();
  double kineticEnergy();

  /// Puts `count` steps into the streams, in bunches: on one device as graphs.
  template <class Enqueue>
  void repeat(std::int64_t count, std::unique_ptr<DeviceGraph> (&graphs)[2], const Enqueue& enqueue) {
    if (parts.size() > 1) return Part::inBunches(count, enqueue);
    const OnDevice here(parts.front()->device);
    parts.front()->repeat(count, graphs, enqueue);
  }

  std::int32_t nodeCount = 0;
  std::int64_t elementCount = 0;
  std::int32_t patchCount = 0;
  std::vector<std::int32_t> wholeNode;  // device number in the whole plan, by mesh node
  std::vector<std::unique_ptr<Part>> parts;
  std::unique_ptr<SlotExchange> exchange;  // of the parts' slots
  std::unique_ptr<DeviceGraph> stepGraphs[2];
};

}  // namespace ringwatch
