#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/body/element_operators.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A group of elements that lie close together, handled by one thread at a time. Element kernels add nodal values into
/// the patch's own slots (one row of 4 numbers for each node of the patch); the body then sums the slots of each node
/// in a fixed order. That needs no atomics and gives the same bits for any number of threads.
struct Patch {
  std::int32_t batchBegin, batchEnd;  // batches of `lanes` elements
  std::int32_t nodeBegin, nodeEnd;    // into PatchLayout::nodes; also the patch's slots, counted within the block
};

/// The elements of a block ordered along a space-filling curve, cut into patches and, within them, into batches.
struct PatchLayout {
  static constexpr int lanes = nativeWidth;
  std::vector<Patch> patches;
  std::vector<std::int32_t> nodes;           // mesh nodes of each patch
  std::vector<std::int32_t> elements;        // [batch][lane] position in the mesh block; -1 for a lane without element
  std::vector<std::uint16_t> localNodes;     // [batch][node][lane] position in the patch's node list
  std::vector<std::int32_t> batchOfElement;  // by position in the mesh block: batch * lanes + lane

  /// A patch has no more nodes: its rows fit on the stack.
  static constexpr int maxPatchNodes = 1024;

  std::int32_t batchCount() const { return static_cast<std::int32_t>(elements.size() / lanes); }
};
PatchLayout layOutPatches(const Mesh& mesh, const MeshBlock& block);

/// Sees the deformation gradients of elements while a pass computes with them.
class GradientVisitor {
 public:
  /// F[(q * 9 + i) * lanes + lane] of the elements of a batch at the quadrature points q, row by row.
  virtual void visit(std::int32_t batch, const double* F) = 0;

 protected:
  ~GradientVisitor() = default;
};

/// What a pass over batches of elements gives. What is not asked for is not computed.
struct BatchEvaluation {
  double* slots = nullptr;             ///< the internal force, N, is added into the slots of the patch
  double* energy = nullptr;            ///< strain energy, J, is added lane by lane: energy[lanes]
  GradientVisitor* visitor = nullptr;  ///< sees the deformation gradients
};

/// The virtual face of the elements of one type, law and quadrature rule. One virtual call a patch or batch, never an
/// element; the arithmetic is in ElementBatch. Positions and other nodal vectors are 3×N, column by column.
class ElementBlock {
 public:
  virtual ~ElementBlock() = default;
  ElementBlock(const ElementBlock&) = delete;
  ElementBlock& operator=(const ElementBlock&) = delete;

  const ElementInfo& element() const { return *element_; }
  const QuadratureRule& rule() const { return *rule_; }
  const Material& material() const { return material_; }
  const PatchLayout& layout() const { return layout_; }
  std::int32_t elementCount() const { return static_cast<std::int32_t>(layout_.batchOfElement.size()); }
  /// Nodes of an element, by position in the mesh block.
  std::span<const std::int32_t> nodesOf(std::int32_t e) const {
    const auto n = static_cast<std::size_t>(element_->nodes);
    return {connectivity_.data() + static_cast<std::size_t>(e) * n, n};
  }

  /// Copies the nodes of a patch from a 3×N vector into rows of four numbers, the last one zero: rows[4 * nodes].
  void gatherRows(const Patch& patch, const double* x, double* rows) const;

  /// Internal force ∂energy/∂x, strain energy and deformation gradients of batches [first, last) of a patch, whatever
  /// of them is asked for, in one pass. rows: positions, as gatherRows gives them.
  virtual void evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                               const BatchEvaluation& evaluation) const = 0;
  /// Adds K(x) v of the batches into the slots of their patch; K the exact tangent ∂force/∂x, N/m. rows: x, vRows: v.
  virtual void tangentProductBatches(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                                     double* slots) const = 0;
  /// Exact tangents of the elements of a batch: K[(row * 3n + column) * lanes + lane], rows and columns 3·node +
  /// component, N/m. Lanes without an element get zeros.
  virtual void tangentBatch(std::int32_t batch, const double* x, double* K) const = 0;
  /// The same for any elements of the block, one a lane (-1: none).
  virtual void tangentOf(const std::int32_t* elements, const double* x, double* K) const = 0;
  /// Σ_q w_q ∇N_a · ∇N_b of any elements, one a lane: L[(a * n + b) * lanes + lane], m; the matrix Σ w BᵀB is L ⊗ I₃.
  virtual void laplacianOf(const std::int32_t* elements, double* L) const = 0;
  /// Deformation gradients at positions x of any elements, one a lane (-1: none), F[(q * 9 + i) * lanes + lane] row by
  /// row, q the quadrature point, and how fast the tangent can grow from there, drift[lane].
  virtual void deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const = 0;
  /// max_q Σ_a |∂N_a/∂X| of the elements of a batch, 1/m: norms[lane].
  virtual void gradientNormBatch(std::int32_t batch, double* norms) const = 0;
  /// Least determinant of F over the quadrature points of each element of a batch: determinants[lane].
  virtual void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const = 0;

  /// Volume at rest of each element of a batch, m³: volumes[lane].
  virtual void volumeBatch(std::int32_t batch, double* volumes) const = 0;

 protected:
  ElementBlock(const Mesh& mesh, const MeshBlock& block, const Material& material, const QuadratureRule& rule)
      : element_(&elementInfo(block.type)),
        rule_(&rule),
        material_(material),
        layout_(layOutPatches(mesh, block)),
        connectivity_(block.connectivity) {}

 private:
  const ElementInfo* element_;
  const QuadratureRule* rule_;
  Material material_;
  PatchLayout layout_;
  std::span<const std::int32_t> connectivity_;  // the mesh's
};

/// A patch in a pass over a body. A visitor runs its batches, each once and in ascending order.
class PatchPass {
 public:
  /// slots, energy: as in BatchEvaluation.
  PatchPass(const ElementBlock& block, std::int32_t patch, const double* rows, double* slots, double* energy)
      : block_(block), patch_(patch), rows_(rows), slots_(slots), energy_(energy) {}

  std::int32_t index() const { return patch_; }
  const Patch& patch() const { return block_.layout().patches[static_cast<std::size_t>(patch_)]; }
  /// Positions of the patch's nodes, as ElementBlock::gatherRows gives them.
  const double* rows() const { return rows_; }
  /// Computes what is wanted of batches [first, last); the visitor sees their deformation gradients.
  void run(std::int32_t first, std::int32_t last, GradientVisitor* visitor = nullptr) const {
    if (slots_ || energy_ || visitor) block_.evaluateBatches(first, last, rows_, {slots_, energy_, visitor});
  }

 private:
  const ElementBlock& block_;
  std::int32_t patch_;
  const double* rows_;
  double *slots_, *energy_;
};

/// Takes part in a pass over a body (Body::evaluate): runs the batches of each patch and may see their deformation
/// gradients.
class PatchVisitor {
 public:
  /// Called from several threads at once, each patch from one.
  virtual void visitPatch(std::size_t block, const PatchPass& pass) = 0;

 protected:
  ~PatchVisitor() = default;
};

/// The block for a mesh block: picks ElementBatch<element, law>. Throws InputError when the element has no rule of that
/// name ("" is the default), NumericalError when an element has a Jacobian determinant <= 0 at a quadrature point. The
/// block reads the mesh block's connectivity, whose array must outlive it; the mesh may move.
std::unique_ptr<ElementBlock> makeElementBlock(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                               std::string_view ruleName = {});

}  // namespace ringwatch
