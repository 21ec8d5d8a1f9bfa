#include <ringwatch/gpu/imex/device_imex.h>

#include <cmath>
#include <limits>

#include <ringwatch/gpu/device_status.h>
#include <ringwatch/gpu/imex/device_imex_impl.h>

namespace ringwatch {
namespace {

constexpr unsigned long long noFault = ~0ULL;
/// The vectors of ImexView with a number a lane, one after the other in Impl::lanes.
enum LaneVector : std::size_t { laneMass, laneU, laneV, laneR, laneZ, laneP, laneQ, laneS, laneSolution, laneVectors };

/// [element][entry] as [entry][element].
template <class T>
std::vector<T> byEntry(const std::vector<T>& from, std::size_t elements) {
  std::vector<T> to(from.size());
  if (elements == 0) return to;
  const std::size_t entries = from.size() / elements;
  for (std::size_t e = 0; e < elements; ++e)
    for (std::size_t i = 0; i < entries; ++i) to[i * elements + e] = from[e * entries + i];
  return to;
}

void check(const DeviceImexOptions& options, double h, const std::vector<std::vector<ElementRef>>& clusters) {
  const double alpha = options.dissipation;
  if (!(h > 0) || !std::isfinite(h)) throw InputError(joinText("step ", h, " s: must be > 0 and finite"));
  if (!(alpha >= 0 && alpha <= 1)) throw InputError(joinText("dissipation ", alpha, ": must be >= 0 and <= 1"));
  if (!(options.tolerance > 0 && options.tolerance < 1))
    throw InputError(joinText("tolerance ", options.tolerance, ": must be > 0 and < 1"));
  if (options.iterations < 1) throw InputError(joinText("iterations ", options.iterations, ": must be >= 1"));
  for (const auto& elements : clusters)
    if (elements.empty()) throw InputError("a cluster without elements");
}

std::size_t lanesOf(const ImexPlan& plan) { return 32 * static_cast<std::size_t>(plan.sliceCount()); }
std::size_t valuesOf(const ImexPlan& plan) { return 96 * static_cast<std::size_t>(plan.rowBegin.back()); }

/// Bytes that the plan takes on the device.
std::size_t bytesOf(const ImexPlan& plan, const DevicePart<double>& body) {
  std::size_t need = sizeof(double) * (laneVectors * lanesOf(plan) + valuesOf(plan) + 3 * lanesOf(plan)) +
                     sizeof(std::int32_t) * (plan.node.size() + plan.column.size() + plan.rowBegin.size() +
                                             plan.slice.size() + plan.first.size() + plan.contributions.size()) +
                     plan.clusters.size() * sizeof(ImexCluster) +
                     9 * sizeof(double) * static_cast<std::size_t>(plan.blockCount) +
                     body.u.size() * (sizeof(Row4<double>) + 3 * sizeof(double));
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const std::size_t n = body.blocks[b].elementNodes;
    need += plan.blocks[b].count() *
            (sizeof(double) * (9 * (n * (n + 1) / 2) + 3 * n + 11) + sizeof(std::int32_t) * (n + 2));
  }
  return need;
}

}  // namespace

DeviceImex::Impl::Impl(DeviceBody<double>& deviceBody, const Mesh& mesh,
                       const std::vector<std::vector<ElementRef>>& wanted, double h, const DeviceImexOptions& options)
    : whole(deviceBody.impl()), body(whole.only("imex")) {
  check(options, h, wanted);
  for (const auto& elements : wanted) {
    firstElement.push_back(elements.front());
    clusterSize.push_back(elements.size());
  }
  std::vector<bool> held(mesh.nodeCount(), false);
  const std::vector<std::uint8_t> bits = body.constrained.download();
  for (std::size_t i = 0; i < held.size() && !bits.empty(); ++i) held[i] = bits[body.deviceNode[i]] != 0;
  const ImexPlan plan = planImex(mesh, wanted, held);
  const ImexTeams who = planTeams(plan.clusters, imexResidentBlocks());
  bytes = bytesOf(plan, body);
  requireDeviceMemory(bytes);
  rotated = DeviceVector<double>(9 * static_cast<std::size_t>(plan.blockCount));
  makeBlocks(plan);
  upload(plan, who);
  makeView(plan, who, options, h);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (blocks[b].view.count > 0)
      blocks[b].operations.restTangents(body.blocks[b].view, body.blocks[b].law, blocks[b].view, view, body.stream);
  body.stream.synchronize();
}

void DeviceImex::Impl::upload(const ImexPlan& plan, const ImexTeams& who) {
  // Nodes by their device numbers, and the masses of their lanes.
  std::vector<std::int32_t> deviceNode(plan.node.size(), -1);
  std::vector<double> mass(lanesOf(plan), 0);
  for (std::size_t i = 0; i < plan.node.size(); ++i) {
    if (plan.node[i] < 0) continue;
    deviceNode[i] = body.deviceNode[plan.node[i]];
    for (std::size_t c = 0; c < 3; ++c)
      mass[i / sliceNodes * 32 + i % sliceNodes * 3 + c] = 1 / body.inverseMass[deviceNode[i]];
  }
  node = DeviceVector<std::int32_t>(deviceNode);
  column = DeviceVector<std::int32_t>(plan.column);
  rowBegin = DeviceVector<std::int32_t>(plan.rowBegin);
  teamOfBlock = DeviceVector<std::int32_t>(who.teamOfBlock);
  ofBlocks = DeviceVector<std::int32_t>(who.ofBlocks);
  ofWarps = DeviceVector<std::int32_t>(who.ofWarps);
  teams = DeviceVector<ImexTeam>(who.teams);
  clusters = DeviceVector<ImexCluster>(plan.clusters);
  slice = DeviceVector<std::int32_t>(plan.slice);
  first = DeviceVector<std::int32_t>(plan.first);
  contributions = DeviceVector<ImexContribution>(plan.contributions);
  lanes = DeviceVector<double>(laneVectors * lanesOf(plan));
  value = DeviceVector<double>(valuesOf(plan));
  preconditioner = DeviceVector<double>(3 * lanesOf(plan));
  partial = DeviceVector<double>(4 * static_cast<std::size_t>(who.teamBlocks));
  arrived = DeviceVector<unsigned long long>(std::vector<unsigned long long>(who.teams.size(), 0));
  status = DeviceVector<ImexStatus>(std::vector<ImexStatus>{{noFault, 0, 0}});
  keptU = DeviceVector<Row4<double>>(body.u.size());
  keptV = DeviceVector<double>(body.v.size());
  lanes.fill(0);
  lanes.upload(mass);      // laneMass is the first
  preconditioner.fill(0);  // idle lanes
}

void DeviceImex::Impl::makeView(const ImexPlan& plan, const ImexTeams& who, const DeviceImexOptions& options,
                                double h) {
  const double alpha = options.dissipation, beta = 0.25 * (1 + alpha) * (1 + alpha);
  const auto lanesAt = [&](LaneVector k) { return lanes.data() + k * lanesOf(plan); };
  view.w = beta * h * h;
  view.h = h;
  view.c = alpha / (beta * h);
  view.tolerance = options.tolerance;
  view.iterations = options.iterations;
  view.sliceCount = plan.sliceCount();
  view.rowCount = plan.rowBegin.back();
  view.node = node.data();
  view.mass = lanesAt(laneMass);
  view.u = lanesAt(laneU);
  view.v = lanesAt(laneV);
  view.r = lanesAt(laneR);
  view.z = lanesAt(laneZ);
  view.p = lanesAt(laneP);
  view.q = lanesAt(laneQ);
  view.s = lanesAt(laneS);
  view.solution = lanesAt(laneSolution);
  view.matrix = {value.data(), preconditioner.data(), column.data(),        rowBegin.data(),
                 slice.data(), first.data(),          contributions.data(), rotated.data()};
  view.clusters = clusters.data();
  view.blockCount = who.blockCount;
  view.teamBlocks = who.teamBlocks;
  view.teamOfBlock = teamOfBlock.data();
  view.teams = teams.data();
  view.ofBlocks = ofBlocks.data();
  view.ofWarps = ofWarps.data();
  view.ofBlocksCount = static_cast<std::int32_t>(who.ofBlocks.size());
  view.ofWarpsCount = static_cast<std::int32_t>(who.ofWarps.size());
  view.arrived = arrived.data();
  view.partial = partial.data();
  view.status = status.data();
}

void DeviceImex::Impl::makeBlocks(const ImexPlan& plan) {
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const ImexPlan::Elements& from = plan.blocks[b];
    const DevicePart<double>::Block& own = body.blocks[b];
    const std::size_t count = from.count(), n = static_cast<std::size_t>(own.elementNodes);
    std::vector<std::int32_t> placeOf(own.elementCount), place;
    for (std::size_t i = 0; i < own.elements.size(); ++i)
      if (own.elements[i] >= 0) placeOf[own.elements[i]] = static_cast<std::int32_t>(i);
    for (const std::int32_t e : from.element) place.push_back(placeOf[e]);
    Block& block = blocks.emplace_back();
    block.operations = tangentOperations(own.type, own.lawIndex);
    block.place = DeviceVector<std::int32_t>(place);
    block.node = DeviceVector<std::int32_t>(byEntry(from.node, count));
    block.cluster = DeviceVector<std::int32_t>(from.cluster);
    block.shape = DeviceVector<double>(byEntry(from.shape, count));
    block.rest = DeviceVector<double>(count * 9 * (n * (n + 1) / 2));
    block.restHighest = DeviceVector<double>(count);
    block.rotation = DeviceVector<double>(count * 10);
    block.view = {static_cast<std::int32_t>(count),
                  static_cast<std::int32_t>(n * (n + 1) / 2),
                  block.place.data(),
                  block.node.data(),
                  block.shape.data(),
                  block.rest.data(),
                  block.restHighest.data(),
                  block.rotation.data(),
                  rotated.data() + 9 * static_cast<std::size_t>(from.firstBlock),
                  block.cluster.data()};
  }
}

void DeviceImex::Impl::enqueueStep() {
  launchKeepNodes(view, body.nodes, body.stream);
  // The matrices are made beside the explicit step: both need the positions before it, which are kept.
  side.forked.record(body.stream);
  side.forked.holdUp(side.stream);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (blocks[b].view.count > 0) {
      blocks[b].operations.rotateTangents(body.blocks[b].view, body.blocks[b].law, blocks[b].view, view, side.stream);
      launchRotateBlocks(blocks[b].view, side.stream);
    }
  launchAssembleClusters(view, body.nodes, side.stream);
  side.joined.record(side.stream);
  whole.enqueueStep();
  side.joined.holdUp(body.stream);
  launchSolveClusters(view, body.nodes, body.stream);
}

void DeviceImex::Impl::copyState(bool back) {
  const auto copy = [&](auto& state, auto& copied) {
    checkCuda(cudaMemcpyAsync(back ? state.data() : copied.data(), back ? copied.data() : state.data(),
                              state.size() * sizeof(*state.data()), cudaMemcpyDeviceToDevice, body.stream),
              "copy of the state");
  };
  copy(body.u, keptU);
  copy(body.v, keptV);
}

DeviceImex::DeviceImex(DeviceBody<double>& body, const Mesh& mesh, const std::vector<std::vector<ElementRef>>& clusters,
                       double h, const DeviceImexOptions& options)
    : impl_(std::make_unique<Impl>(body, mesh, clusters, h, options)) {}
DeviceImex::~DeviceImex() {
  if (impl_) cudaStreamSynchronize(impl_->body.stream);
}

void DeviceImex::step(std::int64_t count) {
  Impl& m = *impl_;
  m.body.setStep(m.view.h);
  if (!m.kept) {
    m.copyState(false);
    m.keptStep = m.body.clock.download().front().step;
    m.asked = 0;
    m.kept = true;
  }
  m.run(count);
  m.asked += count;
}

DeviceImex::Status DeviceImex::status() {
  Impl& m = *impl_;
  m.body.stream.synchronize();
  const ImexStatus status = m.status.download().front();
  const std::int64_t asked = m.kept ? m.asked : 0;
  m.kept = false;
  if (status.fault == noFault) return {asked, ""};
  const std::int64_t taken = static_cast<std::int64_t>(status.fault >> 32) - m.keptStep;
  const std::size_t cluster = status.fault & 0x7fffffffU;
  const auto fault = static_cast<ImexFault>(status.fault >> 31 & 1U);
  m.copyState(true);
  m.body.stream.synchronize();
  const double h = m.view.h;
  m.body.clock.upload(std::vector<DeviceClock>{{h, m.keptStep}});
  m.run(taken);
  m.body.stream.synchronize();
  m.status.upload(std::vector<ImexStatus>{{noFault, status.iterations, 0}});
  return {taken, joinText(fault == ImexFault::notFinite ? "the implicit matrix is not finite"
                                                        : "conjugate gradients did not converge",
                          " in the cluster of ", m.clusterSize[cluster], " elements at element ",
                          m.firstElement[cluster].block, ":", m.firstElement[cluster].element)};
}

std::int64_t DeviceImex::iterations() const {
  impl_->body.stream.synchronize();
  return static_cast<std::int64_t>(impl_->status.download().front().iterations);
}
std::size_t DeviceImex::bytes() const { return impl_->bytes; }

}  // namespace ringwatch
