#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/SparseCore>

#include <ringwatch/base/name_table.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/body/block_matrix.h>
#include <ringwatch/body/constraints.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// How an element's mass goes to its nodes.
enum class Lumping {
  rowSum,  ///< m_a = ρ ∫ N_a dV, row sums of the consistent mass; diagonal scaling for elements without positive ones
  equal,   ///< mass over node count, as Fierz 2013 has it
  diagonalScaling,  ///< diagonal of the consistent mass, scaled to the element's mass (Hinton, Rock & Zienkiewicz 1976)
};
inline constexpr auto lumpingNames = nameTable<Lumping>({
    {Lumping::rowSum, "row-sum", "row sums of the consistent mass, or diagonal-scaling where one is not positive"},
    {Lumping::equal, "equal", "the same at each node"},
    {Lumping::diagonalScaling, "diagonal-scaling", "diagonal of the consistent mass, scaled"},
});

struct BodyOptions {
  std::map<std::string, std::string> rules;  // element name -> quadrature rule name; the default rule where absent
  Lumping lumping = Lumping::rowSum;
  int threads = 0;  // 0: all that OpenMP offers
};

/// What one pass over the elements of a body is asked for, and what it found. What is not asked for is not computed.
struct StepEvaluation {
  bool wantsForce = true;
  bool wantsEnergy = false;
  PatchVisitor* visitor = nullptr;  ///< sees the deformation gradients that it wants
  NodeVectors internalForce;        ///< ∂(strain energy)/∂x, 3×N, N
  double strainEnergy = 0;          ///< J
  double wallTime = 0;              ///< s, of the pass
};

/// An assembled tangent with what its assembly keeps from call to call.
struct SparseTangent {
  BlockMatrix blocks;
  Eigen::SparseMatrix<double> matrix;  // 3N×3N, N/m, degree of freedom 3·node + component
};

/// Mesh + material + density made computable. Knows no time. All passes are const and keep their scratch memory in a
/// Workspace that the caller owns, so that threads can share a body.
class Body {
 public:
  /// Scratch memory of the passes; reuse it from call to call. One a thread of the caller.
  struct Workspace {
    AlignedVector<double> slots;
    std::vector<double> energies;  // of the patches, J
  };

  /// Throws InputError for an unknown rule, NumericalError for an element whose volume or nodal mass is not positive or
  /// when the lumped mass does not add up to density × volume.
  Body(Mesh mesh, const Material& material, const BodyOptions& options = {});
  Body(Mesh mesh, const std::vector<Material>& materialOfBlock, const BodyOptions& options = {});
  /// Of blocks made elsewhere, one for each of the mesh, with the lumped mass of each node, kg. Answers for what its
  /// blocks know.
  Body(Mesh mesh, std::vector<std::unique_ptr<ElementBlock>> blocks, Eigen::VectorXd lumpedMass, int threads = 0);
  /// Some elements of another body, chosen[block][element], on all of its nodes and with its lumped mass, constraints
  /// and loads. Blocks keep their numbers and chosen elements their order; a block may end up empty. For bodies made of
  /// a mesh and materials. Throws InputError when `chosen` does not fit the mesh.
  Body(const Body& whole, const std::vector<std::vector<bool>>& chosen);

  const Mesh& mesh() const { return mesh_; }
  std::int32_t nodeCount() const { return static_cast<std::int32_t>(mesh_.nodeCount()); }
  const std::vector<std::unique_ptr<ElementBlock>>& blocks() const { return blocks_; }
  /// Lumped mass of each node, kg.
  const Eigen::VectorXd& lumpedMass() const { return lumpedMass_; }
  double totalMass() const { return lumpedMass_.sum(); }
  /// Adds a point mass, kg, to a node: a part that is not meshed, or mass scaling. Only inertia changes; loads that are
  /// set and the elements' own mass stay. Throws InputError unless the node exists and mass >= 0 and finite.
  void addNodalMass(std::int32_t node, double mass);
  /// Volume at rest, m³.
  double volume() const { return volume_; }
  int threads() const { return options_.threads; }

  Constraints& constraints() { return constraints_; }
  const Constraints& constraints() const { return constraints_; }
  /// Grows whenever the lumped mass or the set of free components changes. An object that keeps results which depend on
  /// them compares it with the value that it has kept, and computes them again when the two differ.
  std::int64_t version() const { return constraints_.version() + massVersion_.value(); }
  /// Dead nodal forces, 3×N, N.
  NodeVectors& externalForce() { return externalForce_; }
  const NodeVectors& externalForce() const { return externalForce_; }
  /// Adds mass × acceleration to the nodal forces; acceleration in m/s².
  void addBodyForce(const Eigen::Vector3d& acceleration);

  /// Throws InputError unless `values`, an argument called `name`, is 3×N.
  void checkNodal(std::string_view name, const NodeVectors& values) const;

  /// Internal force, strain energy and deformation gradients at positions x (3×N, m), whatever of them is asked for, in
  /// one pass over the elements. In parallel, with the same bits for any number of threads. The equation of motion is
  /// m a = externalForce - internalForce.
  void evaluate(const NodeVectors& x, StepEvaluation& evaluation, Workspace& workspace) const;
  /// The internal force alone, 3×N, N.
  void internalForce(const NodeVectors& x, NodeVectors& f, Workspace& workspace) const;
  /// The strain energy alone, J.
  double energy(const NodeVectors& x, Workspace& workspace) const;
  /// The sum at the nodes, 3×N, of what addPatch adds into the slots of each patch of each block (the slots are zero
  /// before); in parallel, the same bits for any number of threads.
  void sumOverPatches(NodeVectors& result, Workspace& workspace,
                      const std::function<void(std::size_t block, std::int32_t patch, double* slots)>& addPatch) const;
  /// K(x) v with the exact tangent K = ∂f/∂x.
  void tangentProduct(const NodeVectors& x, const NodeVectors& v, NodeVectors& Kv, Workspace& workspace) const;
  /// Exact tangent of one element, 3n×3n, N/m.
  Eigen::MatrixXd elementTangent(ElementRef element, const NodeVectors& x) const;
  /// Exact tangent of all elements as node blocks. The pattern is made when `matrix` is empty and reused else.
  void assembleBlocks(const NodeVectors& x, BlockMatrix& matrix) const;
  /// Lumped mass that an element gives to its nodes, kg: mass[n].
  void elementLumpedMass(ElementRef element, double* mass) const;
  /// Exact tangent as a sparse matrix; constrained degrees of freedom are kept. The pattern is made when `tangent` is
  /// empty and reused else.
  void assembleTangent(const NodeVectors& x, SparseTangent& tangent) const;
  /// The same from scratch, pattern included.
  Eigen::SparseMatrix<double> assembleTangent(const NodeVectors& x) const;
  /// Least det F over all elements and quadrature points, with its element.
  struct LeastDeterminant {
    double value;
    ElementRef element;
  };
  LeastDeterminant leastDeterminant(const NodeVectors& x) const;

  /// Calls visit(block index, batch, K) for every batch, in parallel, with the packed tangents of
  /// ElementBlock::tangentBatch; visit writes to places of its own.
  template <class Visit>
  void forEachTangentBatch(const NodeVectors& x, const Visit& visit) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const ElementBlock& block = *blocks_[b];
      const auto size = static_cast<std::size_t>(9 * block.element().nodes * block.element().nodes);
      const std::int32_t batches = block.layout().batchCount();
      constexpr std::int32_t chunk = 64;
      parallelFor(0, (batches + chunk - 1) / chunk, threads(), [&](std::int64_t c) {
        AlignedVector<NativePack> K(size);
        const auto end = std::min<std::int32_t>(batches, static_cast<std::int32_t>(c + 1) * chunk);
        for (auto batch = static_cast<std::int32_t>(c) * chunk; batch < end; ++batch) {
          block.tangentBatch(batch, x.data(), reinterpret_cast<double*>(K.data()));
          visit(b, batch, K.data());
        }
      });
    }
  }

 private:
  struct PatchRef {
    std::int32_t block, patch;
    std::int64_t firstSlot;  // of the patch, counted over all blocks
  };
  void lumpMass();
  void pass(const NodeVectors& x, PatchVisitor* visitor, NodeVectors* force, double* energy,
            Workspace& workspace) const;
  void sumSlots(NodeVectors& result, const double* slots) const;
  void makePattern(BlockMatrix& matrix) const;
  void placePairs(BlockMatrix& matrix) const;
  void indexSlots();
  Mesh mesh_;
  BodyOptions options_;
  std::vector<std::unique_ptr<ElementBlock>> blocks_;
  std::vector<Material> materials_;
  Eigen::VectorXd lumpedMass_;
  ChangeCount massVersion_;
  double volume_ = 0;
  Constraints constraints_;
  NodeVectors externalForce_;
  std::vector<PatchRef> patches_;
  std::int64_t slotCount_ = 0;
  std::vector<std::int64_t> nodeSlotBegin_;  // N+1
  std::vector<std::int64_t> nodeSlot_;       // slots of each node, ascending
};

}  // namespace ringwatch
