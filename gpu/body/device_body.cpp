#include <ringwatch/gpu/body/device_body.h>

#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/meshes/jacobian.h>

namespace ringwatch {
namespace {

/// J⁻¹ and w det J of every quadrature point, as BlockView::geometry has them.
template <class R>
std::vector<R> tabulateGeometry(const Mesh& mesh, const MeshBlock& block, const QuadratureRule& rule,
                                const DeviceBlockPlan& plan, std::size_t b) {
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
      throw NumericalError(joinText("block ", b, ": an element has a Jacobian determinant that is not positive"));
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
  return input.mesh->nodeCount() * (2 * sizeof(Row4<R>) + vectors * sizeof(R) + (isHeld(input) ? 1 : 0)) +
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
DeviceBody<R>::Impl::Impl(const DeviceBodyInput& input, const DevicePlan& plan) {
  const Mesh& mesh = *input.mesh;
  nodeCount = static_cast<std::int32_t>(mesh.nodeCount());
  elementCount = static_cast<std::int64_t>(mesh.elementCount());
  patchCount = plan.patchCount;
  deviceNode = plan.deviceNode;
  X = mesh.X;
  inverseMass.resize(mesh.nodeCount());
  for (std::size_t i = 0; i < inverseMass.size(); ++i) {
    const double mass = input.lumpedMass[i];
    if (!(mass > 0)) throw InputError(joinText("node ", i, ": lumped mass ", mass, " kg must be > 0 on the device"));
    inverseMass[deviceNode[i]] = static_cast<R>(1 / mass);
  }
  // First all that goes to the device, on the host: then the need is known before anything is allocated.
  std::vector<std::vector<R>> geometry;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    requireForDevice(input, b);
    geometry.push_back(tabulateGeometry<R>(mesh, mesh.blocks[b], *input.rules[b], plan.blocks[b], b));
  }
  bytes = bytesOfNodes<R>(input, plan);
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) bytes += bytesOf(geometry[b]) + bytesOfBlock(plan.blocks[b]);
  requireDeviceMemory(bytes);
  std::int32_t firstPatch = 0;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    addBlock(input, plan.blocks[b], b, firstPatch, geometry[b]);
    firstPatch += blocks.back().view.patchCount;
  }
  makeNodes(input, plan);
}

template <class R>
void DeviceBody<R>::Impl::addBlock(const DeviceBodyInput& input, const DeviceBlockPlan& from, std::size_t b,
                                   std::int32_t firstPatch, const std::vector<R>& geometry) {
  const MeshBlock& meshBlock = input.mesh->blocks[b];
  Block& block = blocks.emplace_back();
  block.type = meshBlock.type;
  block.lawIndex = input.materials[b].law.index();
  block.elementNodes = meshBlock.nodesPerElement();
  block.threads = from.threads;
  block.points = elementInfo(block.type).constantGradient ? 1 : static_cast<int>(input.rules[b]->points.size());
  block.elementCount = meshBlock.elementCount();
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
void DeviceBody<R>::Impl::makeNodes(const DeviceBodyInput& input, const DevicePlan& plan) {
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
  NodeVectors v0 = NodeVectors::Zero(3, nodeCount);
  if (isHeld(input)) {
    std::vector<std::uint8_t> bits(count, 0);
    for (std::int32_t i = 0; i < nodeCount; ++i)
      for (int c = 0; c < 3; ++c)
        if (input.constraints->isConstrained(i, c)) bits[deviceNode[i]] |= static_cast<std::uint8_t>(1U << c);
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
void DeviceBody<R>::Impl::uploadVectors(const NodeVectors& values, DeviceVector<R>& to) {
  if (values.cols() != nodeCount)
    throw InputError(joinText("nodal vectors of ", values.cols(), " nodes for a body of ", nodeCount));
  const std::size_t count = nodeCount;
  std::vector<R> ordered(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      ordered[c * count + static_cast<std::size_t>(deviceNode[i])] = static_cast<R>(values(c, i));
  stream.synchronize();
  to.upload(ordered);
}

template <class R>
NodeVectors DeviceBody<R>::Impl::toMesh(const std::vector<Row4<R>>& rows) const {
  NodeVectors values(3, nodeCount);
  for (std::int32_t i = 0; i < nodeCount; ++i) {
    const Row4<R>& row = rows[deviceNode[i]];
    values.col(i) << static_cast<double>(row.x), static_cast<double>(row.y), static_cast<double>(row.z);
  }
  return values;
}

template <class R>
void DeviceBody<R>::Impl::enqueueForce(typename PatchOperations<R>::Launch PatchOperations<R>::*which, const R* along,
                                       Row4<R>* to) {
  for (const Block& block : blocks) (block.operations.*which)(block.view, nodes, block.law, along, to, stream);
}

template <class R>
void DeviceBody<R>::Impl::enqueueStep() {
  enqueueForce(&PatchOperations<R>::step, nullptr, nullptr);
  launchFinishStep<R>(nodes, stream);
}

template <class R>
void DeviceBody<R>::Impl::setStep(double wanted) {
  if (wanted == h) return;
  stream.synchronize();
  checkCuda(cudaMemcpy(&clock.data()->h, &wanted, sizeof wanted, cudaMemcpyHostToDevice), "copy of the step");
  h = wanted;
}

template <class R>
DeviceBody<R>::DeviceBody(const DeviceBodyInput& input, const DevicePlan* plan)
    : impl_(std::make_unique<Impl>(input, plan ? *plan : planPatches(*input.mesh))) {
  setPositions(input.mesh->X);
}
template <class R>
DeviceBody<R>::~DeviceBody() = default;

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
  return impl_->bytes;
}

template <class R>
void DeviceBody<R>::setPositions(const NodeVectors& x) {
  if (x.cols() != impl_->nodeCount)
    throw InputError(joinText("positions of ", x.cols(), " nodes for a body of ", impl_->nodeCount));
  std::vector<Row4<R>> rows(impl_->nodeCount);
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const std::size_t at = impl_->deviceNode[i];
    const Eigen::Vector3d u = x.col(i) - impl_->X.col(i);
    rows[at] = {static_cast<R>(u[0]), static_cast<R>(u[1]), static_cast<R>(u[2]), impl_->inverseMass[at]};
  }
  impl_->stream.synchronize();
  impl_->u.upload(rows);
}
template <class R>
void DeviceBody<R>::setVelocities(const NodeVectors& v) {
  impl_->uploadVectors(v, impl_->v);
}
template <class R>
NodeVectors DeviceBody<R>::positions() const {
  impl_->stream.synchronize();
  return impl_->X + impl_->toMesh(impl_->u.download());
}
template <class R>
NodeVectors DeviceBody<R>::velocities() const {
  impl_->stream.synchronize();
  const std::vector<R> ordered = impl_->v.download();
  const std::size_t count = impl_->nodeCount;
  NodeVectors v(3, impl_->nodeCount);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      v(c, i) = static_cast<double>(ordered[c * count + static_cast<std::size_t>(impl_->deviceNode[i])]);
  return v;
}

template <class R>
void DeviceBody<R>::computeForce() {
  impl_->enqueueForce(&PatchOperations<R>::force, nullptr, impl_->result.data());
  launchSumSlots<R>(impl_->nodes, impl_->result.data(), impl_->stream);
}
template <class R>
void DeviceBody<R>::computeTangentProduct() {
  impl_->enqueueForce(&PatchOperations<R>::tangentProduct, impl_->direction.data(), impl_->result.data());
  launchSumSlots<R>(impl_->nodes, impl_->result.data(), impl_->stream);
}
template <class R>
NodeVectors DeviceBody<R>::internalForce() {
  computeForce();
  impl_->stream.synchronize();
  return impl_->toMesh(impl_->result.download());
}
template <class R>
NodeVectors DeviceBody<R>::tangentProduct(const NodeVectors& direction) {
  impl_->uploadVectors(direction, impl_->direction);
  computeTangentProduct();
  impl_->stream.synchronize();
  return impl_->toMesh(impl_->result.download());
}
template <class R>
double DeviceBody<R>::strainEnergy() {
  for (const auto& block : impl_->blocks)
    block.operations.energy(block.view, impl_->nodes, block.law, impl_->partial.data(), impl_->stream);
  launchSum(impl_->partial.data(), impl_->patchCount, impl_->sum.data(), impl_->stream);
  impl_->stream.synchronize();
  return impl_->sum.download().front();
}
template <class R>
double DeviceBody<R>::kineticEnergy() {
  launchKineticEnergy<R>(impl_->nodes, impl_->partial.data(), impl_->sum.data(), impl_->stream);
  impl_->stream.synchronize();
  return impl_->sum.download().front();
}

template <class R>
void DeviceBody<R>::step(double h, std::int64_t count) {
  impl_->setStep(h);
  impl_->repeat(count, impl_->stepGraphs, [&] { impl_->enqueueStep(); });
}
template <class R>
std::int64_t DeviceBody<R>::steps() const {
  impl_->stream.synchronize();
  return impl_->clock.download().front().step;
}
template <class R>
void DeviceBody<R>::synchronize() const {
  impl_->stream.synchronize();
}

template class DeviceBody<double>;
template class DeviceBody<float>;

}  // namespace ringwatch
