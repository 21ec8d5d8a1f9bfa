#include <ringwatch/gpu/body/device_body.h>

#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/body/device_cut.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/meshes/jacobian.h>

namespace ringwatch {
namespace {

/// Nodes that a thread takes at least, where vectors are put in the device's order.
constexpr std::int64_t nodesOfThread = 10000;

/// J⁻¹ and w det J of every quadrature point, as BlockView::geometry has them.
template <class R>
std::vector<R> tabulateGeometry(const Mesh& mesh, const MeshBlock& block, const QuadratureRule& rule,
                                const DeviceBlockPlan& plan) {
  const ElementInfo& element = elementInfo(block.type);
  const int n = element.nodes, points = element.constantGradient ? 1 : static_cast<int>(rule.points.size());
  const auto entries = static_cast<std::size_t>(element.constantGradient ? 9 : 10),
             threads = static_cast<std::size_t>(plan.threads);
  std::vector<double> dN(3 * n * points);
  for (int q = 0; q < points; ++q)
    element.shapeGradient(rule.points[q].xi,
                          reinterpret_cast<double(*)[3]>(dN.data() + static_cast<std::ptrdiff_t>(3 * n * q)));
  std::vector<R> geometry(plan.patches.size() * static_cast<std::size_t>(points) * entries * threads, R(0));
  std::vector<std::uint8_t> bad(plan.patches.size(), 0);
  parallelFor(0, plan.patches.size(), 0, [&](std::int64_t p) {
    const std::size_t patch = p;
    for (std::size_t t = 0; t < threads; ++t) {
      const std::int32_t e = plan.elements[patch * threads + t];
      if (e < 0) continue;
      for (int q = 0; q < points; ++q) {
        const Eigen::Matrix3d J =
            jacobianOf(mesh.X, block.element(e), n, dN.data() + static_cast<std::ptrdiff_t>(3 * n * q));
        const double determinant = J.determinant();
        if (!(determinant > 0)) bad[patch] = 1;
        const Eigen::Matrix3d inverse = J.inverse();
        R* to = geometry.data() +
                (patch * static_cast<std::size_t>(points) + static_cast<std::size_t>(q)) * entries * threads + t;
        for (int i = 0; i < 9; ++i) to[static_cast<std::size_t>(i) * threads] = static_cast<R>(inverse(i / 3, i % 3));
        if (entries == 10) to[9 * threads] = static_cast<R>(rule.points[q].weight * determinant);
      }
    }
  });
  for (const std::uint8_t flag : bad)
    if (flag)
      throw NumericalError(
          joinText("block ", plan.block, ": an element has a Jacobian determinant that is not positive"));
  return geometry;
}

template <class T>
std::size_t bytesOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

bool isLoaded(const DeviceBodyInput& input) { return input.externalForce && !input.externalForce->isZero(0); }
bool isHeld(const DeviceBodyInput& input) { return input.constraints && input.constraints->any(); }

/// Throws InputError for a law or a rule that the device does not have.
void requireForDevice(const DeviceBodyInput& input, std::size_t b) {
  if (input.materials[b].outside)
    throw InputError(joinText("block ", b, ": the law \"", input.materials[b].lawName(),
                              "\" is registered for the CPU: choose another law, or device = \"cpu\""));
  if (input.rules[b]->shares.mean() || input.rules[b]->uniformStrain)
    throw InputError(joinText("block ", b, ": rule \"", input.rules[b]->name,
                              "\" evaluates the element's mean, which the device does not: choose another rule, or "
                              "device = \"cpu\""));
}

/// Bytes on the device of what belongs to nodes, and of the patches' sums.
template <class R>
std::size_t bytesOfNodes(const DeviceBodyInput& input, const DevicePlan& plan) {
  const std::size_t vectors = isLoaded(input) ? 9 : 6;
  return static_cast<std::size_t>(plan.nodeCount()) *
             (2 * sizeof(Row4<R>) + vectors * sizeof(R) + (isHeld(input) ? 1 : 0)) +
         static_cast<std::size_t>(plan.slotCount) * sizeof(Row4<R>) + bytesOf(plan.slotBegin) + bytesOf(plan.slot) +
         static_cast<std::size_t>(plan.patchCount) * sizeof(double);
}

/// The same of a block, but for its geometry.
std::size_t bytesOfBlock(const DeviceBlockPlan& plan) {
  return bytesOf(plan.patches) + bytesOf(plan.corners) + bytesOf(plan.rows) + bytesOf(plan.nodes) +
         bytesOf(plan.groupRow);
}

}  // namespace

DeviceBodyInput DeviceBodyInput::of(const Body& body) {
  if (body.elementDamping()) throw InputError("a body whose elements damp: the device takes undamped ones alone");
  if (body.discreteForces()) throw InputError("a body with springs or contact: the device takes elements alone");
  DeviceBodyInput input;
  input.mesh = &body.mesh();
  for (const auto& block : body.blocks()) {
    input.materials.push_back(block->material());
    input.rules.push_back(&block->rule());
  }
  input.lumpedMass = body.lumpedMass();
  input.constraints = &body.constraints();
  input.externalForce = &body.externalForce();
  return input;
}

template <class R>
DevicePart<R>::DevicePart(const DeviceBodyInput& input, DevicePlan plan, int onDevice) : device(onDevice) {
  const Mesh& mesh = *input.mesh;
  nodeCount = plan.nodeCount();
  patchCount = plan.patchCount;
  borderBlocks = plan.borderBlocks;
  wholePatch = std::move(plan.wholePatch);
  exchanges = std::move(plan.exchanges);
  plan.exchanges = {};
  deviceNode = std::move(plan.deviceNode);
  meshNode.resize(static_cast<std::size_t>(nodeCount));
  X.resize(3, nodeCount);
  inverseMass.resize(meshNode.size());
  for (std::size_t i = 0; i < deviceNode.size(); ++i) {
    const std::int32_t at = deviceNode[i];
    if (at < 0) continue;
    const double mass = input.lumpedMass[i];
    if (!(mass > 0)) throw InputError(joinText("node ", i, ": lumped mass ", mass, " kg must be > 0 on the device"));
    meshNode[at] = static_cast<std::int32_t>(i);
    X.col(at) = mesh.X.col(i);
    inverseMass[at] = static_cast<R>(1 / mass);
  }
  // First all that goes to the device, on the host: then the need is known before anything is allocated.
  std::vector<std::vector<R>> geometry;
  bytes = bytesOfNodes<R>(input, plan) + SlotExchange::bytesOnDevice(exchanges, sizeof(Row4<R>));
  for (const DeviceBlockPlan& block : plan.blocks) {
    requireForDevice(input, block.block);
    geometry.push_back(tabulateGeometry<R>(mesh, mesh.blocks[block.block], *input.rules[block.block], block));
    bytes += bytesOf(geometry.back()) + bytesOfBlock(block);
  }
  requireDeviceMemory(bytes);
  std::int32_t firstPatch = 0;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    addBlock(input, plan.blocks[b], firstPatch, geometry[b]);
    firstPatch += blocks.back().view.patchCount;
    elementCount += static_cast<std::int64_t>(blocks.back().elementCount);
  }
  makeNodes(input, plan);
}

template <class R>
void DevicePart<R>::addBlock(const DeviceBodyInput& input, const DeviceBlockPlan& from, std::int32_t firstPatch,
                             const std::vector<R>& geometry) {
  const std::size_t b = from.block;
  const MeshBlock& meshBlock = input.mesh->blocks[b];
  Block& block = blocks.emplace_back();
  block.type = meshBlock.type;
  block.lawIndex = input.materials[b].law.index();
  block.elementNodes = meshBlock.nodesPerElement();
  block.threads = from.threads;
  block.points = elementInfo(block.type).constantGradient ? 1 : static_cast<int>(input.rules[b]->points.size());
  for (const DevicePatch& patch : from.patches) block.elementCount += static_cast<std::size_t>(patch.elementCount);
  block.elements = from.elements;
  block.operations = patchOperations<R>(block.type, block.lawIndex);
  block.law = {input.materials[b].law, input.rules[b]};
  block.patches = DeviceVector<DevicePatch>(from.patches);
  block.corners = DeviceVector<std::uint16_t>(from.corners);
  block.rows = DeviceVector<std::uint16_t>(from.rows);
  block.nodes = DeviceVector<std::int32_t>(from.nodes);
  block.groupRow = DeviceVector<std::int32_t>(from.groupRow);
  block.geometry = DeviceVector<R>(geometry);
  block.view = {static_cast<std::int32_t>(from.patches.size()),
                firstPatch,
                from.firstSlot,
                from.nodeCapacity,
                from.rowCapacity,
                static_cast<std::int32_t>(input.rules[b]->points.size()),
                block.patches.data(),
                block.corners.data(),
                block.nodes.data(),
                block.groupRow.data(),
                block.rows.data(),
                block.geometry.data()};
}

template <class R>
void DevicePart<R>::makeNodes(const DeviceBodyInput& input, const DevicePlan& plan) {
  const std::size_t count = nodeCount;
  u = DeviceVector<Row4<R>>(count);
  result = DeviceVector<Row4<R>>(count);
  slots = DeviceVector<Row4<R>>(static_cast<std::size_t>(plan.slotCount));
  v = DeviceVector<R>(3 * count);
  direction = DeviceVector<R>(3 * count);
  slotBegin = DeviceVector<std::int32_t>(plan.slotBegin);
  slot = DeviceVector<std::int32_t>(plan.slot);
  partial = DeviceVector<double>(std::max<std::size_t>(static_cast<std::size_t>(patchCount), kineticParts));
  sum = DeviceVector<double>(1);
  clock = DeviceVector<DeviceClock>(std::vector<DeviceClock>{{0, 0}});
  if (isLoaded(input)) {
    external = DeviceVector<R>(3 * count);
    uploadVectors(*input.externalForce, external);
  }
  NodeVectors v0 = NodeVectors::Zero(3, input.mesh->X.cols());
  if (isHeld(input)) {
    std::vector<std::uint8_t> bits(count, 0);
    for (std::size_t at = 0; at < count; ++at)
      for (int c = 0; c < 3; ++c)
        if (input.constraints->isConstrained(meshNode[at], c)) bits[at] |= static_cast<std::uint8_t>(1U << c);
    constrained = DeviceVector<std::uint8_t>(bits);
    input.constraints->imposeVelocity(v0);
  }
  uploadVectors(v0, v);
  nodes.count = nodeCount;
  nodes.interiorCount = plan.interiorCount;
  nodes.u = u.data();
  nodes.v = v.data();
  nodes.external = external.data();
  nodes.constrained = constrained.data();
  nodes.slots = slots.data();
  nodes.slotBegin = slotBegin.data();
  nodes.slot = slot.data();
  nodes.clock = clock.data();
  result.fill(0);
}

template <class R>
void DevicePart<R>::uploadPositions(const NodeVectors& x) {
  std::vector<Row4<R>> rows(meshNode.size());
  parallelFor(
      0, nodeCount, 0,
      [&](std::int64_t at) {
        const Eigen::Vector3d d = x.col(meshNode[at]) - X.col(at);
        rows[at] = {static_cast<R>(d[0]), static_cast<R>(d[1]), static_cast<R>(d[2]), inverseMass[at]};
      },
      nodesOfThread);
  stream.synchronize();
  u.upload(rows);
}

template <class R>
void DevicePart<R>::uploadVectors(const NodeVectors& values, DeviceVector<R>& to) {
  const std::size_t count = nodeCount;
  std::vector<R> ordered(3 * count);
  parallelFor(
      0, nodeCount, 0,
      [&](std::int64_t at) {
        for (std::size_t c = 0; c < 3; ++c)
          ordered[c * count + static_cast<std::size_t>(at)] = static_cast<R>(values(c, meshNode[at]));
      },
      nodesOfThread);
  stream.synchronize();
  to.upload(ordered);
}

template <class R>
void DevicePart<R>::takeRows(const DeviceVector<Row4<R>>& from, NodeVectors& to) const {
  stream.synchronize();
  const std::vector<Row4<R>> rows = from.download();
  parallelFor(
      0, nodeCount, 0,
      [&](std::int64_t at) {
        to.col(meshNode[at]) << static_cast<double>(rows[at].x), static_cast<double>(rows[at].y),
            static_cast<double>(rows[at].z);
      },
      nodesOfThread);
}

template <class R>
void DevicePart<R>::takePositions(NodeVectors& to) const {
  takeRows(u, to);
  parallelFor(
      0, nodeCount, 0, [&](std::int64_t at) { to.col(meshNode[at]) = X.col(at) + to.col(meshNode[at]); },
      nodesOfThread);
}

template <class R>
void DevicePart<R>::takeVelocities(NodeVectors& to) const {
  stream.synchronize();
  const std::vector<R> ordered = v.download();
  const std::size_t count = nodeCount;
  parallelFor(
      0, nodeCount, 0,
      [&](std::int64_t at) {
        for (std::size_t c = 0; c < 3; ++c)
          to(c, meshNode[at]) = static_cast<double>(ordered[c * count + static_cast<std::size_t>(at)]);
      },
      nodesOfThread);
}

template <class R>
DeviceBody<R>::Impl::Impl(const DeviceBodyInput& input, const DevicePlan& plan, std::vector<int> devices) {
  const Mesh& mesh = *input.mesh;
  nodeCount = static_cast<std::int32_t>(mesh.nodeCount());
  elementCount = static_cast<std::int64_t>(mesh.elementCount());
  patchCount = plan.patchCount;
  wholeNode = plan.deviceNode;
  if (devices.empty()) checkCuda(cudaGetDevice(&devices.emplace_back()), "cudaGetDevice");
  requireDevices(devices);
  devices.resize(std::clamp<std::size_t>(static_cast<std::size_t>(patchCount), 1, devices.size()));
  if (devices.size() == 1) {
    const OnDevice here(devices.front());
    parts.push_back(std::make_unique<Part>(input, plan, devices.front()));
  } else {
    std::vector<double> work;  // of an element: what a point costs grows with the element's nodes
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      work.push_back(static_cast<double>(input.rules[b]->points.size()) * mesh.blocks[b].nodesPerElement());
    std::vector<DevicePlan> plans = cutPlan(plan, partsOfPatches(plan, work, devices.size()), devices.size());
    for (std::size_t p = 0; p < devices.size(); ++p) {
      const OnDevice here(devices[p]);
      parts.push_back(std::make_unique<Part>(input, std::move(plans[p]), devices[p]));
    }
  }
  std::vector<SlotExchange::Part> ends;
  for (const auto& part : parts) ends.push_back({part->device, part->stream, part->slots.data(), &part->exchanges});
  exchange = std::make_unique<SlotExchange>(ends, sizeof(Row4<R>));
}

template <class R>
void DeviceBody<R>::Impl::requireNodes(const NodeVectors& values, const char* what) const {
  if (values.cols() != nodeCount)
    throw InputError(joinText(what, " of ", values.cols(), " nodes for a body of ", nodeCount));
}

template <class R>
NodeVectors DeviceBody<R>::Impl::results() const {
  NodeVectors values(3, nodeCount);
  forEachPart([&](const Part& part) { part.takeRows(part.result, values); });
  return values;
}

template <class R>
DevicePart<R>& DeviceBody<R>::Impl::only(const char* what) {
  if (parts.size() > 1) throw InputError(joinText(what, " on ", parts.size(), " GPUs: a body on one is needed"));
  int current = 0;
  checkCuda(cudaGetDevice(&current), "cudaGetDevice");
  if (current != parts.front()->device)
    throw InputError(
        joinText(what, ": the body is on GPU ", parts.front()->device, ", and GPU ", current, " is the current one"));
  return *parts.front();
}

template <class R>
template <class Finish>
void DeviceBody<R>::Impl::enqueueForce(typename PatchOperations<R>::Launch PatchOperations<R>::*which,
                                       const Finish& finish) {
  const auto launch = [&](std::size_t p, std::size_t b) {
    Part& part = *parts[p];
    const typename Part::Block& block = part.blocks[b];
    (block.operations.*which)(block.view, part.nodes, block.law, part.direction.data(), part.result.data(),
                              part.stream);
  };
  enqueue(
      *exchange, launch, [](std::size_t) {}, [&](std::size_t p) { finish(*parts[p]); });
}

template <class R>
void DeviceBody<R>::Impl::enqueueStep() {
  enqueueForce(&PatchOperations<R>::step, [](Part& part) { launchFinishStep<R>(part.nodes, part.stream); });
}

template <class R>
void DeviceBody<R>::Impl::setStep(double wanted) {
  forEachPart([&](Part& part) { part.setStep(wanted); });
}

template <class R>
void DevicePart<R>::setStep(double wanted) {
  if (wanted == h) return;
  stream.synchronize();
  checkCuda(cudaMemcpy(&clock.data()->h, &wanted, sizeof wanted, cudaMemcpyHostToDevice), "copy of the step");
  h = wanted;
}

template <class R>
void DeviceBody<R>::Impl::synchronize() const {
  forEachPart([](const Part& part) { part.stream.synchronize(); });
}

template <class R>
double DeviceBody<R>::Impl::sumOfPatches() {
  Part& first = *parts.front();
  const OnDevice here(first.device);
  if (parts.size() == 1) {
    launchSum(first.partial.data(), patchCount, first.sum.data(), first.stream);
    first.stream.synchronize();
    return first.sum.download().front();
  }
  std::vector<double> all(static_cast<std::size_t>(patchCount));
  forEachPart([&](const Part& part) {
    part.stream.synchronize();
    const std::vector<double> own = part.partial.download();
    for (std::size_t p = 0; p < part.wholePatch.size(); ++p) all[part.wholePatch[p]] = own[p];
  });
  const DeviceVector<double> ordered(all);
  launchSum(ordered.data(), patchCount, first.sum.data(), first.stream);
  first.stream.synchronize();
  return first.sum.download().front();
}

template <class R>
double DeviceBody<R>::Impl::kineticEnergy() {
  Part& first = *parts.front();
  const OnDevice here(first.device);
  NodeView<R> view = first.nodes;
  DeviceVector<Row4<R>> u;
  DeviceVector<R> v;
  if (parts.size() > 1) {
    // Masses and velocities in the order of the whole plan, in which one device adds them up.
    const std::size_t count = nodeCount;
    std::vector<Row4<R>> rows(count);
    std::vector<R> ordered(3 * count);
    forEachPart([&](const Part& part) {
      part.stream.synchronize();
      const std::vector<R> own = part.v.download();
      for (std::size_t at = 0; at < part.meshNode.size(); ++at) {
        const std::size_t to = wholeNode[part.meshNode[at]];
        rows[to].w = part.inverseMass[at];
        for (std::size_t c = 0; c < 3; ++c) ordered[c * count + to] = own[c * part.meshNode.size() + at];
      }
    });
    u = DeviceVector<Row4<R>>(rows);
    v = DeviceVector<R>(ordered);
    view.count = nodeCount;
    view.u = u.data();
    view.v = v.data();
  }
  launchKineticEnergy<R>(view, first.partial.data(), first.sum.data(), first.stream);
  first.stream.synchronize();
  return first.sum.download().front();
}

template <class R>
DeviceBody<R>::DeviceBody(const DeviceBodyInput& input, const DevicePlan* plan, const std::vector<int>& devices)
    : impl_(std::make_unique<Impl>(input, plan ? *plan : planPatches(*input.mesh), devices)) {
  setPositions(input.mesh->X);
}
template <class R>
DeviceBody<R>::~DeviceBody() {
  // Devices may still wait for each other's copies.
  for (const auto& part : impl_->parts) cudaStreamSynchronize(part->stream);
}

template <class R>
std::int32_t DeviceBody<R>::nodeCount() const {
  return impl_->nodeCount;
}
template <class R>
std::int64_t DeviceBody<R>::elementCount() const {
  return impl_->elementCount;
}
template <class R>
std::size_t DeviceBody<R>::bytes() const {
  std::size_t sum = 0;
  for (const auto& part : impl_->parts) sum += part->bytes;
  return sum;
}
template <class R>
std::vector<int> DeviceBody<R>::devices() const {
  std::vector<int> all;
  for (const auto& part : impl_->parts) all.push_back(part->device);
  return all;
}
template <class R>
std::size_t DeviceBody<R>::bytesExchanged() const {
  return impl_->exchange->bytes();
}

template <class R>
void DeviceBody<R>::setPositions(const NodeVectors& x) {
  impl_->requireNodes(x, "positions");
  impl_->forEachPart([&](auto& part) { part.uploadPositions(x); });
}
template <class R>
void DeviceBody<R>::setVelocities(const NodeVectors& v) {
  impl_->requireNodes(v, "velocities");
  impl_->forEachPart([&](auto& part) { part.uploadVectors(v, part.v); });
}
template <class R>
NodeVectors DeviceBody<R>::positions() const {
  NodeVectors x(3, impl_->nodeCount);
  impl_->forEachPart([&](const auto& part) { part.takePositions(x); });
  return x;
}
template <class R>
NodeVectors DeviceBody<R>::velocities() const {
  NodeVectors v(3, impl_->nodeCount);
  impl_->forEachPart([&](const auto& part) { part.takeVelocities(v); });
  return v;
}

template <class R>
void DeviceBody<R>::computeForce() {
  impl_->enqueueForce(&PatchOperations<R>::force,
                      [](auto& part) { launchSumSlots<R>(part.nodes, part.result.data(), part.stream); });
}
template <class R>
void DeviceBody<R>::computeTangentProduct() {
  impl_->enqueueForce(&PatchOperations<R>::tangentProduct,
                      [](auto& part) { launchSumSlots<R>(part.nodes, part.result.data(), part.stream); });
}
template <class R>
NodeVectors DeviceBody<R>::internalForce() {
  computeForce();
  return impl_->results();
}
template <class R>
NodeVectors DeviceBody<R>::tangentProduct(const NodeVectors& direction) {
  impl_->requireNodes(direction, "a direction");
  impl_->forEachPart([&](auto& part) { part.uploadVectors(direction, part.direction); });
  computeTangentProduct();
  return impl_->results();
}
template <class R>
double DeviceBody<R>::strainEnergy() {
  impl_->forEachPart([](auto& part) {
    for (const auto& block : part.blocks)
      block.operations.energy(block.view, part.nodes, block.law, part.partial.data(), part.stream);
  });
  return impl_->sumOfPatches();
}
template <class R>
double DeviceBody<R>::kineticEnergy() {
  return impl_->kineticEnergy();
}

template <class R>
void DeviceBody<R>::step(double h, std::int64_t count) {
  impl_->setStep(h);
  impl_->repeat(count, impl_->stepGraphs, [&](std::int64_t steps) {
    for (; steps > 0; --steps) impl_->enqueueStep();
  });
}
template <class R>
std::int64_t DeviceBody<R>::steps() const {
  const OnDevice here(impl_->parts.front()->device);
  impl_->parts.front()->stream.synchronize();
  return impl_->parts.front()->clock.download().front().step;
}
template <class R>
void DeviceBody<R>::synchronize() const {
  impl_->synchronize();
}

template struct DevicePart<double>;
template struct DevicePart<float>;
template class DeviceBody<double>;
template class DeviceBody<float>;

}  // namespace ringwatch
