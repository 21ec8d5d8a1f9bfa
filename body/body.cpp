#include <ringwatch/body/body.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include <Eigen/LU>

#include <ringwatch/base/double_double.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/rigid_block.h>
#include <ringwatch/meshes/jacobian.h>
#include <ringwatch/meshes/part_of_mesh.h>

namespace ringwatch {
namespace {

double sumOf(std::span<const double> parts) {
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

/// det J of an element at a point with the shape gradients dN, in twice the precision.
double wideDeterminant(const NodeVectors& X, std::span<const std::int32_t> nodes, const double (*dN)[3]) {
  using Wide = DoubleDouble<double>;
  auto J = Matrix3<Wide>::zero();
  for (std::size_t a = 1; a < nodes.size(); ++a)
    for (int i = 0; i < 3; ++i) {
      const Wide edge = Wide::sum(X(i, nodes[a]), -X(i, nodes[0]));
      for (int j = 0; j < 3; ++j) J(i, j) += edge * Wide(dN[a][j]);
    }
  return determinant(J).rounded();
}

}  // namespace

Body::Body(Mesh mesh, const Material& material, const BodyOptions& options)
    : Body(std::move(mesh), std::vector<Material>{material}, options) {}

Body::Body(Mesh mesh, const std::vector<Material>& materialOfBlock, const BodyOptions& options)
    : TangentSource(Constraints(mesh.nodeCount()), options.threads),
      mesh_(std::move(mesh)),
      options_(options),
      materials_(materialOfBlock),
      externalForce_(NodeVectors::Zero(3, mesh_.X.cols())) {
  if (mesh_.blocks.empty()) throw InputError("the mesh has no volume elements: a body needs at least one");
  requireValid(mesh_);
  // One material serves all blocks.
  if (materials_.size() == 1) materials_.resize(mesh_.blocks.size(), materials_.front());
  if (materials_.size() != mesh_.blocks.size())
    throw InputError(
        joinText(materials_.size(), " materials for ", mesh_.blocks.size(), " blocks: give one, or one a block"));
  for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
    const ElementRules& rules = options_.rulesOfBlock.empty() ? options_.rules : options_.rulesOfBlock.at(b);
    const auto rule = rules.find(elementInfo(mesh_.blocks[b].type).name);
    blocks_.push_back(makeElementBlock(mesh_, mesh_.blocks[b], materials_[b], rule == rules.end() ? "" : rule->second,
                                       options_.hourglassControl));
  }
  setElements(tangentsOfBlocks(), lumpMass());
}

Body::Body(Mesh mesh, std::vector<std::unique_ptr<ElementBlock>> blocks, Eigen::VectorXd lumpedMass, int threads)
    : TangentSource(Constraints(mesh.nodeCount()), threads),
      mesh_(std::move(mesh)),
      blocks_(std::move(blocks)),
      externalForce_(NodeVectors::Zero(3, mesh_.X.cols())) {
  requireValid(mesh_);
  if (blocks_.size() != mesh_.blocks.size())
    throw InputError(joinText(blocks_.size(), " blocks for a mesh of ", mesh_.blocks.size()));
  if (lumpedMass.size() != mesh_.X.cols())
    throw InputError(joinText(lumpedMass.size(), " lumped masses for ", mesh_.X.cols(), " nodes"));
  setElements(tangentsOfBlocks(), std::move(lumpedMass));
}

Body::Body(const Body& whole, const std::vector<std::vector<bool>>& chosen)
    : TangentSource(whole.constraints(), whole.threads()),
      options_(whole.options_),
      externalForce_(whole.externalForce_),
      domain_(whole.domain_) {
  if (whole.discreteForces() && !whole.discreteForces()->nodes().empty())
    throw InputError("chosen elements: a body with springs or contact cannot be taken apart into its elements");
  const Mesh& all = whole.mesh_;
  bool fits = chosen.size() == all.blocks.size();
  for (std::size_t b = 0; fits && b < chosen.size(); ++b) fits = chosen[b].size() == all.blocks[b].elementCount();
  if (!fits) throw InputError("chosen elements: one flag is needed for each element of each block");
  mesh_ = meshOfElements(all, chosen);
  mesh_.X = all.X;
  mesh_.nodeIds = all.nodeIds;
  mesh_.nodeSets = all.nodeSets;
  double volumes[lanes];
  for (std::size_t b = 0; b < chosen.size(); ++b) {
    const ElementBlock& face = *whole.blocks_[b];
    materials_.push_back(face.material());
    blocks_.push_back(
        makeElementBlock(mesh_, mesh_.blocks[b], face.material(), face.rule().name, face.hourglassControl()));
    for (std::int32_t batch = 0; batch < blocks_.back()->layout().batchCount(); ++batch) {
      blocks_.back()->volumeBatch(batch, volumes);
      for (double volume : volumes) volume_ += volume;
    }
  }
  wrapRigidBlocks();
  setElements(tangentsOfBlocks(), whole.lumpedMass());
  if (!whole.damping_) return;
  std::vector<DampingConstants> ofBlocks;
  for (const DampedBlock* block : whole.damping_->blocks())
    ofBlocks.push_back(block ? block->constants() : DampingConstants{});
  setElementDamping(ofBlocks);
  damping_->setFactor(whole.damping_->factor());
}

void Body::tie(std::string name, std::vector<std::int32_t> nodes, RigidGuide guide) {
  if (damping_) throw InputError(joinText("rigid body ", name, ": elements damp already; tie nodes before"));
  constraints().tie(RigidBody(std::move(name), std::move(nodes), mesh_.X, lumpedMass(), std::move(guide)));
  wrapRigidBlocks();
  replaceElements(tangentsOfBlocks());
}

void Body::wrapRigidBlocks() {
  std::vector<std::int32_t> bodyOf(mesh_.nodeCount(), -1);
  std::int32_t count = 0;
  for (const std::vector<RigidBody>* bodies : {&constraints().rigidBodies(), &constraints().prescribedBodies()})
    for (const RigidBody& body : *bodies) {
      for (const std::int32_t node : body.nodes()) bodyOf[node] = count;
      ++count;
    }
  if (count == 0) return;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    bool rigid = blocks_[b]->elementCount() > 0;
    for (std::int32_t e = 0; rigid && e < blocks_[b]->elementCount(); ++e) {
      const auto own = blocks_[b]->nodesOf(e);
      rigid = bodyOf[own[0]] >= 0 &&
              std::ranges::all_of(own, [&](std::int32_t node) { return bodyOf[node] == bodyOf[own[0]]; });
    }
    if (rigid && !dynamic_cast<const RigidBlock*>(blocks_[b].get()))
      blocks_[b] = std::make_unique<RigidBlock>(mesh_.blocks[b], std::move(blocks_[b]));
  }
}

void Body::setElementDamping(const std::vector<DampingConstants>& ofBlocks) {
  if (damping_) throw InputError("element damping: the body has it already");
  if (ofBlocks.size() != blocks_.size())
    throw InputError(joinText(ofBlocks.size(), " constants of damping for ", blocks_.size(), " blocks"));
  for (std::size_t b = 0; b < ofBlocks.size(); ++b) {
    const DampingConstants& own = ofBlocks[b];
    for (const double value : {own.linearBulk, own.quadraticBulk, own.shearViscosity, own.volumeViscosity,
                               own.massProportional, own.hourglassViscosity})
      if (!(value >= 0) || !std::isfinite(value))
        throw InputError(joinText("element damping: a constant is ", value, "; must be >= 0 and finite"));
    const QuadratureRule& rule = blocks_[b]->rule();
    if (own.hourglassViscosity > 0 && !rule.uniformStrain)
      throw InputError(joinText("element damping: hourglass viscosity goes with a rule of uniform strain; ",
                                blocks_[b]->element().name, " has the rule ", rule.name));
  }
  damping_ = std::make_unique<ElementDamping>();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!ofBlocks[b].any()) {
      damping_->addBlock(nullptr);
      continue;
    }
    std::vector<double> masses;
    if (ofBlocks[b].massProportional > 0) {
      const std::size_t n = blocks_[b]->nodesPerElement();
      masses.resize(n * static_cast<std::size_t>(blocks_[b]->elementCount()));
      for (std::int32_t e = 0; e < blocks_[b]->elementCount(); ++e)
        elementLumpedMass({b, e}, masses.data() + n * static_cast<std::size_t>(e));
    }
    auto damped = std::make_unique<DampedBlock>(mesh_, mesh_.blocks[b], std::move(blocks_[b]), ofBlocks[b], masses,
                                                damping_->sharedFactor());
    damping_->addBlock(damped.get());
    blocks_[b] = std::move(damped);
  }
  replaceElements(tangentsOfBlocks(), damping_.get());
}

void Body::setElementDamping(const Body& whole, const std::vector<std::vector<std::int32_t>>& elements) {
  damping_ = std::make_unique<ElementDamping>();
  damping_->shareFactor(*whole.damping_);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const DampedBlock* from = whole.damping_->blocks()[b];
    if (!from) {
      damping_->addBlock(nullptr);
      continue;
    }
    std::vector<double> masses;
    if (from->constants().massProportional > 0) {
      const std::size_t n = blocks_[b]->nodesPerElement();
      masses.resize(n * elements[b].size());
      for (std::size_t e = 0; e < elements[b].size(); ++e)
        whole.elementLumpedMass({static_cast<std::int32_t>(b), elements[b][e]}, masses.data() + n * e);
    }
    auto damped = std::make_unique<DampedBlock>(mesh_, mesh_.blocks[b], std::move(blocks_[b]), from->constants(),
                                                masses, damping_->sharedFactor(), from, elements[b]);
    damping_->addBlock(damped.get());
    blocks_[b] = std::move(damped);
  }
  replaceElements(tangentsOfBlocks(), damping_.get());
}

void Body::addElementDampingForce(NodeVectorsView x, NodeVectorsView v, NodeVectors& f, Workspace& workspace) const {
  if (!damping_) return;
  sumOverPatches(workspace.damping, workspace, [&](std::size_t b, std::int32_t p, double* slots) {
    const DampedBlock* block = damping_->blocks()[b];
    if (!block) return;
    alignas(64) double rows[4 * PatchLayout::maxPatchNodes], vRows[4 * PatchLayout::maxPatchNodes];
    const Patch& patch = block->layout().patches[p];
    block->gatherRows(patch, x.data(), rows);
    block->gatherRows(patch, v.data(), vRows);
    block->addForce(patch, rows, vRows, slots);
  });
  f += workspace.damping;
}

void Body::followDampingRates(NodeVectorsView x, NodeVectorsView v) {
  if (!damping_ || !damping_->dependsOnRates()) return;
  parallelFor(0, patches().size(), threads(), [&](std::int64_t i) {
    const PatchRef& ref = patches()[i];
    DampedBlock* block = damping_->blocks()[ref.block];
    if (!block || !block->dependsOnRates()) return;
    alignas(64) double rows[4 * PatchLayout::maxPatchNodes], vRows[4 * PatchLayout::maxPatchNodes];
    const Patch& patch = block->layout().patches[ref.patch];
    block->gatherRows(patch, x.data(), rows);
    block->gatherRows(patch, v.data(), vRows);
    block->follow(patch, rows, vRows);
  });
}

std::vector<const ElementTangents*> Body::tangentsOfBlocks() const {
  std::vector<const ElementTangents*> tangents;
  for (const auto& block : blocks_) tangents.push_back(block.get());
  return tangents;
}

void elementLumpedMass(const Mesh& mesh, const ElementBlock& block, Lumping lumping, std::int32_t number,
                       double* mass) {
  const ElementInfo& element = block.element();
  const double density = block.material().density;
  const auto nodes = block.nodesOf(number);
  const int n = element.nodes;
  double N[maxElementNodes], dN[maxElementNodes][3], diagonal[maxElementNodes];
  std::fill(mass, mass + n, 0.0);
  std::fill(diagonal, diagonal + n, 0.0);
  for (const QuadraturePoint& point : element.massRule.points) {
    element.shape(point.xi, N);
    element.shapeGradient(point.xi, dN);
    const Eigen::Matrix3d J = jacobianOf(mesh.X, nodes.data(), n, dN[0]);
    double volume = J.determinant();
    // The determinant of a flat element cancels.
    constexpr double flat = 1e-2;
    if (const double size = J.norm(); !(volume > flat * size * size * size))
      volume = wideDeterminant(mesh.X, nodes, dN);
    const double w = density * volume * point.weight;
    for (int a = 0; a < n; ++a) {
      mass[a] += w * N[a];
      diagonal[a] += w * N[a] * N[a];
    }
  }
  if (lumping == Lumping::equal) {
    double sum = 0;
    for (int a = 0; a < n; ++a) sum += mass[a];
    std::fill(mass, mass + n, sum / n);
  } else if (lumping == Lumping::diagonalScaling || !element.positiveRowSums) {
    double sum = 0, trace = 0;
    for (int a = 0; a < n; ++a) {
      sum += mass[a];
      trace += diagonal[a];
    }
    for (int a = 0; a < n; ++a) mass[a] = diagonal[a] * (sum / trace);
  }
}

LumpedMass lumpedMass(const Mesh& mesh, const std::vector<std::unique_ptr<ElementBlock>>& blocks, Lumping lumping) {
  LumpedMass result{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.nodeCount())), 0};
  Eigen::VectorXd& lumped = result.ofNode;
  double expected = 0, mass[maxElementNodes], volumes[lanes];
  for (const auto& own : blocks) {
    const ElementBlock& block = *own;
    const double density = block.material().density;
    double blockMass = 0, ruleVolume = 0;
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      elementLumpedMass(mesh, block, lumping, e, mass);
      const auto nodes = block.nodesOf(e);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        lumped[nodes[a]] += mass[a];
        blockMass += mass[a];
      }
    }
    result.volume += blockMass / density;
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
  for (Eigen::Index i = 0; i < lumped.size(); ++i)
    if (!(lumped[i] > 0)) throw NumericalError(joinText("node ", i, ": lumped mass ", lumped[i], " kg must be > 0"));
  if (!(std::abs(lumped.sum() - expected) <= 1e-10 * expected))
    throw NumericalError(joinText("lumped mass ", lumped.sum(), " kg differs from density x volume ", expected, " kg"));
  return result;
}

Eigen::VectorXd Body::lumpMass() {
  LumpedMass lumped = ringwatch::lumpedMass(mesh_, blocks_, options_.lumping);
  volume_ = lumped.volume;
  return std::move(lumped.ofNode);
}

void Body::addBodyForce(const Eigen::Vector3d& acceleration) {
  externalForce_ += acceleration * lumpedMass().transpose();
}

template <class PassPatch>
void Body::passAll(NodeArrival* arrival, const PassPatch& passPatch) const {
  const auto count = static_cast<std::int64_t>(patches().size());
  if (!arrival) return parallelFor(0, count, threads(), passPatch);
  const std::span<const std::int64_t> without = arrival->patchesWithout(), with = arrival->patchesWith();
  constexpr std::int64_t pieces = 4;  // with a call between them, without which some messages would not move
  const auto early = static_cast<std::int64_t>(without.size());
  for (std::int64_t piece = 0; piece < pieces; ++piece) {
    parallelFor(early * piece / pieces, early * (piece + 1) / pieces, threads(),
                [&](std::int64_t i) { passPatch(without[i]); });
    arrival->progress();
  }
  arrival->complete();
  parallelFor(0, static_cast<std::int64_t>(with.size()), threads(), [&](std::int64_t i) { passPatch(with[i]); });
}

void Body::pass(NodeVectorsView x, PatchVisitor* visitor, Wanted wanted, Workspace& workspace,
                const NodeRangeVisitor& visit) const {
  NodeVectors* const force = wanted.force;
  double* const energy = wanted.energy;
  const bool damps = damping_ && force && wanted.velocities;
  if (force) workspace.slots.resize(4 * slotCount());
  if (energy) workspace.energies.resize(patches().size());
  const auto passPatch = [&, this](std::int64_t p) {
    const PatchRef& ref = patches()[p];
    const std::size_t blockIndex = ref.block;
    const ElementBlock& block = *blocks_[blockIndex];
    const Patch& patch = block.layout().patches[ref.patch];
    BatchEvaluation all;
    if (wanted.force) {
      all.slots = workspace.slots.data() + 4 * ref.firstSlot;
      std::fill(all.slots, all.slots + 4 * static_cast<std::ptrdiff_t>(patch.nodeEnd - patch.nodeBegin), 0.0);
    }
    alignas(64) double energies[lanes] = {};
    alignas(64) double rows[4 * PatchLayout::maxPatchNodes], vRows[4 * PatchLayout::maxPatchNodes];
    block.gatherRows(patch, x.data(), rows);
    if (wanted.energy) all.energy = energies;
    if (damps && damping_->blocks()[blockIndex]) {
      block.gatherRows(patch, wanted.velocities->data(), vRows);
      all.velocities = vRows;
    }
    const PatchPass own(block, ref.patch, rows, all);
    if (visitor)
      visitor->visitPatch(blockIndex, own);
    else
      own.run();
    if (wanted.energy) workspace.energies[p] = sumOf(energies);
  };
  passAll(wanted.arrival, passPatch);
  const DiscreteForces* discrete = discreteForces();
  if (force) sumSlots(*force, workspace.slots.data(), discrete ? nullptr : visit);
  if (energy) *energy = sumOf(workspace.energies);
  if (!discrete) return;
  if (energy) *energy += discrete->energy(x);
  if (!force) return;
  discrete->addInternalForce(x, *force);
  if (visit) visit(0, nodeCount());
}

void Body::evaluate(NodeVectorsView x, StepEvaluation& evaluation, Workspace& workspace) const {
  const auto begin = std::chrono::steady_clock::now();
  pass(x, evaluation.visitor,
       {evaluation.wantsForce ? &evaluation.internalForce : nullptr,
        evaluation.wantsEnergy ? &evaluation.strainEnergy : nullptr, evaluation.velocities, evaluation.arrival},
       workspace, nullptr);
  evaluation.wallTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Body::internalForce(NodeVectorsView x, NodeVectors& f, Workspace& workspace, const NodeRangeVisitor& visit) const {
  pass(x, nullptr, {.force = &f}, workspace, visit);
}

void Body::resistingForce(NodeVectorsView x, const NodeVectors& v, NodeVectors& f, Workspace& workspace,
                          const NodeRangeVisitor& visit) const {
  pass(x, nullptr, {.force = &f, .velocities = &v}, workspace, visit);
}

double Body::energy(NodeVectorsView x, Workspace& workspace) const {
  double energy = 0;
  pass(x, nullptr, {.energy = &energy}, workspace, nullptr);
  return energy;
}

Body::LeastDeterminant Body::leastDeterminant(NodeVectorsView x, Among among) const {
  LeastDeterminant least{infinity, {}};
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementBlock& block = *blocks_[b];
    if (among == Among::whereInversionIsAnError && block.material().info().allowsInversion) continue;
    std::vector<double> values(block.layout().elements.size());
    parallelFor(0, block.layout().batchCount(), threads(), [&](std::int64_t batch) {
      block.minimumDeterminantBatch(batch, x.data(), values.data() + batch * lanes);
    });
    for (std::size_t i = 0; i < values.size(); ++i)
      if (block.layout().elements[i] >= 0 && !(values[i] >= least.value)) {
        least = {values[i], {b, block.layout().elements[i]}};
        if (std::isnan(values[i])) return least;
      }
  }
  return least;
}

}  // namespace ringwatch
