#include <ringwatch/integrators/partitioned_body_system.h>

#include <ringwatch/base/error.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/body/sub_body.h>
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {
namespace {

std::vector<std::vector<bool>> flags(const Mesh& mesh, const std::vector<ElementRef>& elements) {
  std::vector<std::vector<bool>> chosen;
  for (const MeshBlock& block : mesh.blocks) chosen.emplace_back(block.elementCount(), false);
  for (const ElementRef e : elements) {
    const auto block = static_cast<std::size_t>(e.block), element = static_cast<std::size_t>(e.element);
    if (e.block < 0 || block >= chosen.size() || e.element < 0 || element >= chosen[block].size())
      throw InputError(joinText("element ", e.block, ":", e.element, ": the body has no such element"));
    chosen[block][element] = true;
  }
  return chosen;
}
std::vector<std::vector<bool>> inverse(std::vector<std::vector<bool>> chosen) {
  for (std::vector<bool>& block : chosen) block.flip();
  return chosen;
}

}  // namespace

PartitionedBodySystem::PartitionedBodySystem(const Body& body, const std::vector<ElementRef>& stiff,
                                             const RayleighDamping& damping)
    : body_(body),
      chosen_(flags(body.mesh(), stiff)),
      nonstiff_(body, inverse(chosen_), true, {0, damping.beta}),
      stiff_(body, chosen_, false, damping) {}

PartitionedBodySystem::Part::Part(const Body& whole, const std::vector<std::vector<bool>>& chosen, bool loaded,
                                  const RayleighDamping& damping)
    : whole_(whole), loaded_(loaded), damping_(damping) {
  std::vector<ElementRef> elements;
  for (std::size_t b = 0; b < chosen.size(); ++b)
    for (std::size_t e = 0; e < chosen[b].size(); ++e)
      if (chosen[b][e]) elements.push_back({b, e});
  if (elements.empty()) return;
  nodes_ = nodesOfElements(whole, elements);
  body_.emplace(subBody(whole, elements, nodes_, whole.lumpedMass()(nodes_), whole.threads()));
}

void PartitionedBodySystem::Part::gather(const NodeVectors& all, NodeVectors& own) const {
  own.resize(3, nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) own.col(i) = all.col(nodes_[i]);
}

void PartitionedBodySystem::Part::acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) {
  if (loaded_)
    a = whole_.externalForce();
  else
    a.setZero(3, x.cols());
  if (body_) {
    gather(x, x_);
    body_->internalForce(x_, force_, workspace_);
    for (std::size_t i = 0; i < nodes_.size(); ++i) a.col(nodes_[i]) -= force_.col(i);
    if (damping_.beta != 0) {
      gather(v, u_);
      body_->tangentProduct(x_, u_, force_, workspace_);
      for (std::size_t i = 0; i < nodes_.size(); ++i) a.col(nodes_[i]) -= damping_.beta * force_.col(i);
    }
  }
  for (Eigen::Index i = 0; i < a.cols(); ++i) a.col(i) /= whole_.lumpedMass()[i];
  if (damping_.alpha != 0) a -= damping_.alpha * v;
  whole_.constraints().clearConstrained(a);
}

void PartitionedBodySystem::Part::stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) {
  // Ku may be u.
  if (body_) {
    gather(x, x_);
    gather(u, u_);
    body_->tangentProduct(x_, u_, force_, workspace_);
  }
  Ku.setZero(3, x.cols());
  if (!body_) return;
  for (std::size_t i = 0; i < nodes_.size(); ++i) Ku.col(nodes_[i]) = force_.col(i);
}

Eigen::SparseMatrix<double> PartitionedBodySystem::Part::stiffness(const NodeVectors& x) {
  Eigen::SparseMatrix<double> K(3 * x.cols(), 3 * x.cols());
  if (!body_) return K;
  gather(x, x_);
  const Eigen::SparseMatrix<double> own = body_->assembleTangent(x_);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(own.nonZeros());
  const auto dof = [&](Eigen::Index d) { return 3 * nodes_[d / 3] + static_cast<int>(d % 3); };
  for (Eigen::Index column = 0; column < own.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(own, column); entry; ++entry)
      entries.emplace_back(dof(entry.row()), dof(column), entry.value());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

void PartitionedBodySystem::Part::stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) {
  blocks.assign(x.cols(), Eigen::Matrix3d::Zero());
  if (!body_) return;
  gather(x, x_);
  body_->assembleBlocks(x_, blocks_);
  for (std::size_t i = 0; i < nodes_.size(); ++i) blocks[nodes_[i]] = diagonalBlock(blocks_, i);
}

}  // namespace ringwatch
