#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/pack.h>
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

  std::int32_t batchCount() const { return static_cast<std::int32_t>(elements.size() / lanes); }
};
PatchLayout layOutPatches(const Mesh& mesh, const MeshBlock& block);

struct DeformationWatch;

/// How fast an element's highest eigenvalue can grow when its deformation gradients move away from an anchor. With l
/// the largest eigenvalue of D⁻¹K_e at the anchor, b >= lambda_max(D⁻¹ Σ_q w_q B_qᵀB_q), and |F_q - F0_q| <= δ <=
/// radius for all q:
///   l(F) <= l + (2 √((l + b negative) kappa b) + b linear) δ + b (kappa + quadratic) δ².
struct TangentDrift {
  TangentDriftCoefficients<double> law{0, 0, 0, 0};              // largest of the points'
  double determinant = std::numeric_limits<double>::infinity();  // least det F0
  double inversionDistance = 0;  // no F_q inverts while |F_q - F0_q| is smaller; 0 when one is inverted
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

  /// Adds the internal force ∂energy/∂x, N, of the patch into its slots, which must be zero before.
  virtual void forcePatch(const Patch& patch, const double* x, double* slots) const = 0;
  /// Adds K(x) v of the patch into its slots; K the exact tangent ∂force/∂x, N/m.
  virtual void tangentProductPatch(const Patch& patch, const double* x, const double* v, double* slots) const = 0;
  /// Strain energy of the patch, J.
  virtual double energyPatch(const Patch& patch, const double* x) const = 0;
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
  /// Appends the elements of a patch that have left their balls at positions x to `left`.
  virtual void lookAtPatch(std::int32_t patch, const double* x, DeformationWatch& watch,
                           std::vector<std::int32_t>& left) const = 0;
  /// forcePatch and lookAtPatch in one pass over the elements.
  virtual void forceAndLookPatch(std::int32_t patch, const double* x, DeformationWatch& watch, double* slots,
                                 std::vector<std::int32_t>& left) const = 0;
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

/// The block for a mesh block: picks ElementBatch<element, law>. Throws InputError when the element has no rule of that
/// name ("" is the default), NumericalError when an element has a Jacobian determinant <= 0 at a quadrature point. The
/// block reads the mesh block's connectivity, whose array must outlive it; the mesh may move.
std::unique_ptr<ElementBlock> makeElementBlock(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                               std::string_view ruleName = {});

}  // namespace ringwatch
