#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/body/block_matrix.h>
#include <ringwatch/body/constraints.h>
#include <ringwatch/body/damped_elements.h>
#include <ringwatch/body/element_tangents.h>

namespace ringwatch {

class DiscreteForces;
/// A range of nodes, the end not among them.
using NodeRangeVisitor = std::function<void(std::int64_t begin, std::int64_t end)>;

/// An assembled tangent with what its assembly keeps from call to call.
struct SparseTangent {
  BlockMatrix blocks;
  Eigen::SparseMatrix<double> matrix;  // 3N×3N, N/m, degree of freedom 3·node + component
};

/// What the bounds of the highest frequency are proven from: batches of symmetric element tangents, the nodes that they
/// couple, three degrees of freedom a node, of which constrained ones leave the problem, and a lumped mass for each
/// node; and of springs and contact, where there are any. A Body is one, at any positions; TangentBracket makes one of
/// the tangents that another code hands over.
///
/// x: the state, as ElementTangents reads it. All passes are const and keep their scratch memory in a Workspace that
/// the caller owns, so that threads can share a source. Results have the same bits for any number of threads.
class TangentSource {
 public:
  /// Scratch memory of the passes; reuse it from call to call. One a thread of the caller.
  struct Workspace {
    AlignedVector<double> slots;
  };

  /// tangents: by reference, at most nodes below lumpedMass.size(). lumpedMass: kg, a positive number for each node.
  /// threads: 0 for all that OpenMP offers.
  TangentSource(std::vector<const ElementTangents*> tangents, Eigen::VectorXd lumpedMass, int threads);
  TangentSource(TangentSource&&) noexcept;
  TangentSource& operator=(TangentSource&&) noexcept;
  ~TangentSource();

  /// Elements in groups of one number of nodes each; ElementRef::block counts them.
  const std::vector<const ElementTangents*>& tangents() const { return tangents_; }
  std::int32_t nodeCount() const { return static_cast<std::int32_t>(lumpedMass_.size()); }
  std::int64_t elementCount() const;
  /// Lumped mass of each node, kg.
  const Eigen::VectorXd& lumpedMass() const { return lumpedMass_; }
  int threads() const { return threads_; }

  Constraints& constraints() { return constraints_; }
  const Constraints& constraints() const { return constraints_; }
  /// Grows whenever the lumped mass or the set of free components changes. An object that keeps results which depend on
  /// them compares it with the value that it has kept, and computes them again when the two differ.
  std::int64_t version() const { return constraints_.version() + massVersion_.value(); }
  /// Adds a point mass, kg, to a node: a part that is not meshed, or mass scaling. Only inertia changes; loads that are
  /// set and the elements' own mass stay. Throws InputError unless the node exists and mass >= 0 and finite.
  void addNodalMass(std::int32_t node, double mass);

  /// Springs and contact that count in forces, energies and tangents from now on; they replace those that there were.
  /// Throws InputError when they are of another number of nodes.
  void setDiscreteForces(DiscreteForces forces);
  /// nullptr for none.
  DiscreteForces* discreteForces() { return discrete_.get(); }
  const DiscreteForces* discreteForces() const { return discrete_.get(); }

  /// The elements' own damping, f C of which is in their tangents; nullptr for none.
  const DampedElements* dampedElements() const { return damped_; }
  /// vᵀ f C(x) v of the elements' own damping; 0 without.
  double elementDampingForm(NodeVectorsView x, NodeVectorsView v, Workspace& workspace) const;

  /// Throws InputError unless `values`, an argument called `name`, is 3×N.
  void checkNodal(std::string_view name, NodeVectorsView values) const;

  /// The sum at the nodes, 3×N, of what addPatch adds into the slots of each patch of each group (the slots are zero
  /// before); in parallel.
  void sumOverPatches(NodeVectors& result, Workspace& workspace,
                      const std::function<void(std::size_t block, std::int32_t patch, double* slots)>& addPatch) const;
  /// K(x) v with the exact tangent K, and f C(x) v of discrete forces (DiscreteForces::setDampingFactor) and of
  /// elements that damp; dampingFactor: another f.
  void tangentProduct(NodeVectorsView x, NodeVectorsView v, NodeVectors& Kv, Workspace& workspace,
                      std::optional<double> dampingFactor = {}) const;
  /// Exact tangent of one element, 3n×3n, N/m.
  Eigen::MatrixXd elementTangent(ElementRef element, NodeVectorsView x) const;
  /// Exact tangent of all elements as node blocks, and of discrete forces as tangentProduct() has it. The pattern is
  /// made when `matrix` is empty or contact of surfaces couples other nodes than it holds, and reused else.
  void assembleBlocks(NodeVectorsView x, BlockMatrix& matrix) const;
  /// Exact tangent as a sparse matrix; constrained degrees of freedom are kept. The pattern is made as by
  /// assembleBlocks().
  void assembleTangent(NodeVectorsView x, SparseTangent& tangent) const;
  /// Exact tangent as a sparse matrix of its own, pattern included.
  Eigen::SparseMatrix<double> assembleTangent(NodeVectorsView x) const;

  /// What the rounding of element tangents comes to at the nodes, Σ_e T_(e,a(i)), N/m (ElementTangents::tangentBatch):
  /// τ of N numbers. Blocks of the assembled K err by at most √(τ_i τ_j), and vᵀKv, from tangents or products with
  /// them, by at most mostNodesOfAnElement() Σ_i τ_i |v_i|². Theorem 42, docs/theory/floating_point.md.
  Eigen::VectorXd tangentRounding(NodeVectorsView x, Workspace& workspace) const;
  int mostNodesOfAnElement() const;
  /// That bound for a vector v, 3×N, N m or what v's squares times N/m are.
  double formRounding(NodeVectorsView x, const NodeVectors& v, Workspace& workspace) const;

  /// Calls visit(block index, batch, K), or visit(block index, batch, K, T) where it takes the rounding too, for every
  /// batch, in parallel, with the packed tangents of ElementTangents::tangentBatch; visit writes to places of its own.
  template <class Visit>
  void forEachTangentBatch(NodeVectorsView x, const Visit& visit) const {
    for (std::size_t b = 0; b < tangents_.size(); ++b) {
      const ElementTangents& block = *tangents_[b];
      const std::size_t size = 9 * block.nodesPerElement() * block.nodesPerElement();
      const std::int32_t batches = block.layout().batchCount();
      constexpr std::int32_t chunk = 64;
      parallelFor(0, (batches + chunk - 1) / chunk, threads(), [&](std::int64_t c) {
        AlignedVector<NativePack> K(size);
        const auto end = std::min<std::int32_t>(batches, static_cast<std::int32_t>(c + 1) * chunk);
        for (auto batch = static_cast<std::int32_t>(c) * chunk; batch < end; ++batch) {
          if constexpr (std::is_invocable_v<Visit, std::size_t, std::int32_t, NativePack*, const NativePack*>) {
            NativePack rounding[maxElementNodes];
            block.tangentBatch(batch, x.data(), reinterpret_cast<double*>(K.data()),
                               reinterpret_cast<double*>(rounding));
            visit(b, batch, K.data(), rounding);
          } else {
            block.tangentBatch(batch, x.data(), reinterpret_cast<double*>(K.data()));
            visit(b, batch, K.data());
          }
        }
      });
    }
  }

 protected:
  /// A source without elements, for classes that make them and the masses themselves: setElements must follow.
  TangentSource(Constraints constraints, int threads);
  void setElements(std::vector<const ElementTangents*> tangents, Eigen::VectorXd lumpedMass);
  /// Other tangents of the same elements, laid out alike, which hold f C of `damped`, where that is given.
  void replaceElements(std::vector<const ElementTangents*> tangents, const DampedElements* damped = nullptr);

  struct PatchRef {
    std::int32_t block, patch;
    std::int64_t firstSlot;  // of the patch, counted over all groups
  };
  const std::vector<PatchRef>& patches() const { return patches_; }
  std::int64_t slotCount() const { return slotCount_; }
  /// The sums of each node's slots; visit: see Body::internalForce.
  void sumSlots(NodeVectors& result, const double* slots, const NodeRangeVisitor& visit = nullptr) const;

 private:
  void makePattern(BlockMatrix& matrix) const;
  void placePairs(BlockMatrix& matrix) const;
  void findLooseBlocks(BlockMatrix& matrix) const;
  void addDiscreteBlocks(NodeVectorsView x, BlockMatrix& matrix) const;

  std::vector<const ElementTangents*> tangents_;
  Eigen::VectorXd lumpedMass_;
  ChangeCount massVersion_;
  Constraints constraints_;
  std::unique_ptr<DiscreteForces> discrete_;
  const DampedElements* damped_ = nullptr;
  int threads_;
  std::vector<PatchRef> patches_;
  std::int64_t slotCount_ = 0;
  std::vector<std::int64_t> nodeSlotBegin_;  // N+1
  std::vector<std::int64_t> nodeSlot_;       // slots of each node, ascending
};

}  // namespace ringwatch
