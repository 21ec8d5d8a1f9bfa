#include <ringwatch/body/body.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include <ringwatch/base/error.h>

namespace ringwatch {

Body::Body(Mesh mesh, const Material& material, const BodyOptions& options)
    : Body(std::move(mesh), std::vector<Material>{material}, options) {}

Body::Body(Mesh mesh, const std::vector<Material>& materialOfBlock, const BodyOptions& options)
    : mesh_(std::move(mesh)),
      options_(options),
      materials_(materialOfBlock),
      constraints_(mesh_.nodeCount()),
      externalForce_(NodeVectors::Zero(3, mesh_.X.cols())) {
  if (mesh_.blocks.empty()) throw InputError("the mesh has no volume elements: a body needs at least one");
  // One material serves all blocks.
  if (materials_.size() == 1) materials_.resize(mesh_.blocks.size(), materials_.front());
  if (materials_.size() != mesh_.blocks.size())
    throw InputError(
        joinText(materials_.size(), " materials for ", mesh_.blocks.size(), " blocks: give one, or one a block"));
  for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
    const auto rule = options_.rules.find(std::string(elementInfo(mesh_.blocks[b].type).name));
    blocks_.push_back(
        makeElementBlock(mesh_, mesh_.blocks[b], materials_[b], rule == options_.rules.end() ? "" : rule->second));
  }
  lumpMass();
  indexSlots();
}

Body::Body(Mesh mesh, std::vector<std::unique_ptr<ElementBlock>> blocks, Eigen::VectorXd lumpedMass, int threads)
    : mesh_(std::move(mesh)),
      blocks_(std::move(blocks)),
      lumpedMass_(std::move(lumpedMass)),
      constraints_(mesh_.nodeCount()),
      externalForce_(NodeVectors::Zero(3, mesh_.X.cols())) {
  options_.threads = threads;
  if (blocks_.size() != mesh_.blocks.size())
    throw InputError(joinText(blocks_.size(), " blocks for a mesh of ", mesh_.blocks.size()));
  if (lumpedMass_.size() != nodeCount())
    throw InputError(joinText(lumpedMass_.size(), " lumped masses for ", nodeCount(), " nodes"));
  indexSlots();
}

Body::Body(const Body& whole, const std::vector<std::vector<bool>>& chosen)
    : options_(whole.options_),
      lumpedMass_(whole.lumpedMass_),
      constraints_(whole.constraints_),
      externalForce_(whole.externalForce_) {
  const Mesh& all = whole.mesh_;
  bool fits = chosen.size() == all.blocks.size();
  for (std::size_t b = 0; fits && b < chosen.size(); ++b) fits = chosen[b].size() == all.blocks[b].elementCount();
  if (!fits) throw InputError("chosen elements: one flag is needed for each element of each block");
  mesh_.X = all.X;
  mesh_.nodeIds = all.nodeIds;
  for (std::size_t b = 0; b < chosen.size(); ++b) {
    const MeshBlock& from = all.blocks[b];
    MeshBlock block{from.type, {}, {}};
    for (std::size_t e = 0; e < from.elementCount(); ++e) {
      if (!chosen[b][e]) continue;
      block.ids.push_back(from.id(e));
      block.connectivity.insert(block.connectivity.end(), from.element(e), from.element(e) + from.nodesPerElement());
    }
    mesh_.blocks.push_back(std::move(block));
  }
  double volumes[PatchLayout::lanes];
  for (std::size_t b = 0; b < chosen.size(); ++b) {
    const ElementBlock& face = *whole.blocks_[b];
    materials_.push_back(face.material());
    blocks_.push_back(makeElementBlock(mesh_, mesh_.blocks[b], face.material(), face.rule().name));
    for (std::int32_t batch = 0; batch < blocks_.back()->layout().batchCount(); ++batch) {
      blocks_.back()->volumeBatch(batch, volumes);
      for (double volume : volumes) volume_ += volume;
    }
  }
  indexSlots();
}

void Body::addNodalMass(std::int32_t node, double mass) {
  if (node < 0 || node >= nodeCount() || !(mass >= 0) || !std::isfinite(mass))
    throw InputError(joinText("node ", node, ", added mass ", mass, " kg: the node must be one of ", nodeCount(),
                              " and the mass >= 0 and finite"));
  if (mass == 0) return;
  lumpedMass_[node] += mass;
  massVersion_.add();
}

void Body::checkNodal(std::string_view name, const NodeVectors& values) const {
  if (values.cols() != nodeCount())
    throw InputError(
        joinText(name, " is 3 x ", values.cols(), ": must be 3 x ", nodeCount(), ", a column for each node"));
}

void Body::elementLumpedMass(ElementRef ref, double* mass) const {
  const ElementBlock& block = *blocks_[static_cast<std::size_t>(ref.block)];
  const ElementInfo& element = block.element();
  const double density = block.material().density;
  const auto nodes = block.nodesOf(ref.element);
  const int n = element.nodes;
  double N[maxElementNodes], dN[maxElementNodes][3], diagonal[maxElementNodes];
  std::fill(mass, mass + n, 0.0);
  std::fill(diagonal, diagonal + n, 0.0);
  for (const QuadraturePoint& point : element.massRule.points) {
    element.shape(point.xi, N);
    element.shapeGradient(point.xi, dN);
    // Relative to the first node: far from the origin, products of large coordinates would lose the element's size.
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    for (int a = 1; a < n; ++a)
      J += (mesh_.X.col(nodes[static_cast<std::size_t>(a)]) - mesh_.X.col(nodes[0])) * Eigen::RowVector3d::Map(dN[a]);
    const double w = density * J.determinant() * point.weight;
    for (int a = 0; a < n; ++a) {
      mass[a] += w * N[a];
      diagonal[a] += w * N[a] * N[a];
    }
  }
  if (options_.lumping == Lumping::equal) {
    double sum = 0;
    for (int a = 0; a < n; ++a) sum += mass[a];
    std::fill(mass, mass + n, sum / n);
  } else if (options_.lumping == Lumping::diagonalScaling || !element.positiveRowSums) {
    double sum = 0, trace = 0;
    for (int a = 0; a < n; ++a) {
      sum += mass[a];
      trace += diagonal[a];
    }
    for (int a = 0; a < n; ++a) mass[a] = diagonal[a] * (sum / trace);
  }
}

void Body::lumpMass() {
  lumpedMass_ = Eigen::VectorXd::Zero(nodeCount());
  double expected = 0, mass[maxElementNodes], volumes[PatchLayout::lanes];
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementBlock& block = *blocks_[b];
    const double density = block.material().density;
    double blockMass = 0, ruleVolume = 0;
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      elementLumpedMass({static_cast<std::int32_t>(b), e}, mass);
      const auto nodes = block.nodesOf(e);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        lumpedMass_[nodes[a]] += mass[a];
        blockMass += mass[a];
      }
    }
    volume_ += blockMass / density;
    // The volume of the stiffness rule and the mass rule's: two ways to the same number, except for quadratic elements
    // with curved sides, whose Jacobian a rule made for straight ones does not integrate exactly.
    const bool exact =
        block.element().order == 1 || block.rule().points.size() >= block.element().massRule.points.size();
    for (std::int32_t batch = 0; batch < block.layout().batchCount(); ++batch) {
      block.volumeBatch(batch, volumes);
      for (double volume : volumes) ruleVolume += volume;
    }
    expected += exact ? density * ruleVolume : blockMass;
  }
  for (std::int32_t i = 0; i < nodeCount(); ++i)
    if (!(lumpedMass_[i] > 0))
      throw NumericalError(joinText("node ", i, ": lumped mass ", lumpedMass_[i], " kg must be > 0"));
  if (!(std::abs(totalMass() - expected) <= 1e-10 * expected))
    throw NumericalError(joinText("lumped mass ", totalMass(), " kg differs from density x volume ", expected, " kg"));
}

void Body::indexSlots() {
  std::vector<std::int64_t> count(mesh_.nodeCount() + 1, 0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto& block = blocks_[b];
    const std::vector<Patch>& patches = block->layout().patches;
    for (std::size_t p = 0; p < patches.size(); ++p)
      patches_.push_back(
          {static_cast<std::int32_t>(b), static_cast<std::int32_t>(p), slotCount_ + patches[p].nodeBegin});
    for (std::int32_t node : block->layout().nodes) ++count[static_cast<std::size_t>(node) + 1];
    slotCount_ += static_cast<std::int64_t>(block->layout().nodes.size());
  }
  for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
  nodeSlotBegin_ = count;
  nodeSlot_.resize(static_cast<std::size_t>(slotCount_));
  std::int64_t slot = 0;
  for (const auto& block : blocks_)
    for (std::int32_t node : block->layout().nodes)
      nodeSlot_[static_cast<std::size_t>(count[static_cast<std::size_t>(node)]++)] = slot++;
}

void Body::addBodyForce(const Eigen::Vector3d& acceleration) {
  externalForce_ += acceleration * lumpedMass_.transpose();
}

void Body::sumSlots(NodeVectors& result, const double* slots) const {
  result.resize(3, nodeCount());
  constexpr std::int64_t chunk = 2048;
  const std::int64_t nodes = nodeCount();
  parallelFor(0, (nodes + chunk - 1) / chunk, threads(), [&](std::int64_t c) {
    const std::int64_t end = std::min(nodes, (c + 1) * chunk);
    for (std::int64_t i = c * chunk; i < end; ++i) {
      double sum[3] = {0, 0, 0};
      for (std::int64_t s = nodeSlotBegin_[static_cast<std::size_t>(i)];
           s < nodeSlotBegin_[static_cast<std::size_t>(i) + 1]; ++s) {
        const double* row = slots + 4 * nodeSlot_[static_cast<std::size_t>(s)];
        for (int k = 0; k < 3; ++k) sum[k] += row[k];
      }
      for (int k = 0; k < 3; ++k) result(k, i) = sum[k];
    }
  });
}

void Body::sumOverPatches(
    NodeVectors& result, Workspace& workspace,
    const std::function<void(std::size_t block, std::int32_t patch, double* slots)>& addPatch) const {
  workspace.slots.resize(static_cast<std::size_t>(4 * slotCount_));
  double* slots = workspace.slots.data();
  parallelFor(0, static_cast<std::int64_t>(patches_.size()), threads(), [&](std::int64_t p) {
    const PatchRef& ref = patches_[static_cast<std::size_t>(p)];
    double* own = slots + 4 * ref.firstSlot;
    const auto block = static_cast<std::size_t>(ref.block);
    const Patch& patch = blocks_[block]->layout().patches[static_cast<std::size_t>(ref.patch)];
    std::fill(own, own + 4 * static_cast<std::ptrdiff_t>(patch.nodeEnd - patch.nodeBegin), 0.0);
    addPatch(block, ref.patch, own);
  });
  sumSlots(result, slots);
}

void Body::pass(const NodeVectors& x, PatchVisitor* visitor, NodeVectors* force, double* energy,
                Workspace& workspace) const {
  if (force) workspace.slots.resize(static_cast<std::size_t>(4 * slotCount_));
  if (energy) workspace.energies.resize(patches_.size());
  parallelFor(0, static_cast<std::int64_t>(patches_.size()), threads(), [&](std::int64_t p) {
    const PatchRef& ref = patches_[static_cast<std::size_t>(p)];
    const auto blockIndex = static_cast<std::size_t>(ref.block);
    const ElementBlock& block = *blocks_[blockIndex];
    const Patch& patch = block.layout().patches[static_cast<std::size_t>(ref.patch)];
    double* slots = nullptr;
    if (force) {
      slots = workspace.slots.data() + 4 * ref.firstSlot;
      std::fill(slots, slots + 4 * static_cast<std::ptrdiff_t>(patch.nodeEnd - patch.nodeBegin), 0.0);
    }
    alignas(64) double energies[PatchLayout::lanes] = {};
    alignas(64) double rows[4 * PatchLayout::maxPatchNodes];
    block.gatherRows(patch, x.data(), rows);
    const PatchPass pass(block, ref.patch, rows, slots, energy ? energies : nullptr);
    if (visitor)
      visitor->visitPatch(blockIndex, pass);
    else
      pass.run(patch.batchBegin, patch.batchEnd);
    if (energy) {
      double sum = 0;
      for (const double part : energies) sum += part;
      workspace.energies[static_cast<std::size_t>(p)] = sum;
    }
  });
  if (force) sumSlots(*force, workspace.slots.data());
  if (energy) {
    *energy = 0;
    for (const double part : workspace.energies) *energy += part;
  }
}

void Body::evaluate(const NodeVectors& x, StepEvaluation& evaluation, Workspace& workspace) const {
  const auto begin = std::chrono::steady_clock::now();
  pass(x, evaluation.visitor, evaluation.wantsForce ? &evaluation.internalForce : nullptr,
       evaluation.wantsEnergy ? &evaluation.strainEnergy : nullptr, workspace);
  evaluation.wallTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Body::internalForce(const NodeVectors& x, NodeVectors& f, Workspace& workspace) const {
  pass(x, nullptr, &f, nullptr, workspace);
}

double Body::energy(const NodeVectors& x, Workspace& workspace) const {
  double energy = 0;
  pass(x, nullptr, nullptr, &energy, workspace);
  return energy;
}

void Body::tangentProduct(const NodeVectors& x, const NodeVectors& v, NodeVectors& Kv, Workspace& workspace) const {
  sumOverPatches(Kv, workspace, [&](std::size_t b, std::int32_t p, double* slots) {
    const ElementBlock& block = *blocks_[b];
    const Patch& patch = block.layout().patches[static_cast<std::size_t>(p)];
    alignas(64) double rows[4 * PatchLayout::maxPatchNodes], vRows[4 * PatchLayout::maxPatchNodes];
    block.gatherRows(patch, x.data(), rows);
    block.gatherRows(patch, v.data(), vRows);
    block.tangentProductBatches(patch.batchBegin, patch.batchEnd, rows, vRows, slots);
  });
}

Eigen::MatrixXd Body::elementTangent(ElementRef ref, const NodeVectors& x) const {
  const ElementBlock& block = *blocks_.at(static_cast<std::size_t>(ref.block));
  const std::int32_t place = block.layout().batchOfElement.at(static_cast<std::size_t>(ref.element));
  const int size = 3 * block.element().nodes, lane = place % PatchLayout::lanes;
  AlignedVector<NativePack> K(static_cast<std::size_t>(size * size));
  block.tangentBatch(place / PatchLayout::lanes, x.data(), reinterpret_cast<double*>(K.data()));
  Eigen::MatrixXd result(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) result(i, j) = K[static_cast<std::size_t>(i * size + j)][lane];
  return result;
}

Body::LeastDeterminant Body::leastDeterminant(const NodeVectors& x) const {
  LeastDeterminant least{std::numeric_limits<double>::infinity(), {}};
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementBlock& block = *blocks_[b];
    std::vector<double> values(block.layout().elements.size());
    parallelFor(0, block.layout().batchCount(), threads(), [&](std::int64_t batch) {
      block.minimumDeterminantBatch(static_cast<std::int32_t>(batch), x.data(),
                                    values.data() + batch * PatchLayout::lanes);
    });
    for (std::size_t i = 0; i < values.size(); ++i)
      if (block.layout().elements[i] >= 0 && !(values[i] >= least.value)) {
        least = {values[i], {static_cast<std::int32_t>(b), block.layout().elements[i]}};
        if (std::isnan(values[i])) return least;
      }
  }
  return least;
}

}  // namespace ringwatch
