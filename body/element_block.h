#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/body/batch_balls.h>
#include <ringwatch/body/batch_motion.h>
#include <ringwatch/body/bulk_viscosity.h>
#include <ringwatch/body/element_operators.h>
#include <ringwatch/body/element_tangents.h>
#include <ringwatch/elements/hourglass.h>
#include <ringwatch/materials/principal_tangent.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Sees the deformation gradients of elements.
class GradientVisitor {
 public:
  /// F[(q * 9 + i) * lanes + lane] of the elements of a batch at the quadrature points q, row by row.
  virtual void visit(std::int32_t batch, const double* F) = 0;

 protected:
  ~GradientVisitor() = default;
};

/// What a pass over batches of elements gives. What is not asked for is not computed.
struct BatchEvaluation {
  double* slots = nullptr;              ///< the internal force, N, is added into the slots of the patch
  double* energy = nullptr;             ///< strain energy, J, is added lane by lane: energy[lanes]
  GradientVisitor* visitor = nullptr;   ///< sees the deformation gradients, in a pass without forces
  const BatchBalls* balls = nullptr;    ///< the deformation gradients are compared with them
  const BatchMotion* motion = nullptr;  ///< the same of the reference states of groups
  /// Rows of the velocities, of a block whose elements damp: their damping force is added to the internal force.
  const double* velocities = nullptr;
  const BulkViscosity* bulk = nullptr;  ///< of blocks that addBulkViscosity, is added to the internal force
};

/// What controls the hourglass modes of a pack of elements of uniform strain (elements/hourglass.h): at every state
/// their tangent exceeds that of the law by (stiffness Σ_α γ_α γ_αᵀ) ⊗ I₃, which is positive semidefinite.
struct HourglassVectors {
  static constexpr int count = 4, nodes = 8;
  NativePack gamma[count][nodes];
  NativePack stiffness;  ///< k, N/m; 0 in lanes without an element
  NativePack volume;     ///< at rest, m³; 0 in lanes without an element
  NativePack rounding;   ///< blocks of c Σ γ γᵀ ⊗ I₃ as computed err by at most c times this (Theorem 72)
};

/// The virtual face of the elements of one type, law and quadrature rule. One virtual call a patch or batch, never an
/// element; the arithmetic is in ElementBatch. Positions and other nodal vectors are 3×N, column by column.
class ElementBlock : public ElementTangents {
 public:
  const ElementInfo& element() const { return *element_; }
  const QuadratureRule& rule() const { return *rule_; }
  const Material& material() const { return material_; }
  /// Of rules of uniform strain.
  const HourglassControl& hourglassControl() const { return hourglassControl_; }

  /// Internal force ∂energy/∂x, strain energy and deformation gradients of batches [first, last) of a patch, whatever
  /// of them is asked for, in one pass. rows: positions, as gatherRows gives them.
  virtual void evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                               const BatchEvaluation& evaluation) const = 0;
  /// Adds K(x) v of the batches into the slots of their patch; K the exact tangent ∂force/∂x, N/m. rows: x, vRows: v.
  virtual void tangentProductBatches(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                                     double* slots) const = 0;
  void addTangentProduct(const Patch& patch, const double* x, const double* v, double* slots) const final;
  /// Σ_q w_q ∇N_a · ∇N_b of any elements, one a lane: L[(a * n + b) * lanes + lane], m; the matrix Σ w BᵀB is L ⊗ I₃.
  /// rounding: its T_a, T[a * lanes + lane], as tangentBatch gives those of the tangent.
  virtual void laplacianOf(const std::int32_t* elements, double* L, double* rounding) const = 0;
  /// Deformation gradients at positions x of any elements, one a lane (-1: none), F[(q * 9 + i) * lanes + lane] row by
  /// row, q the quadrature point, and how fast the tangent can grow from there, drift[lane].
  virtual void deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const = 0;
  /// principalTangent() of the law, for a pack of stretches. False, and nothing written, where the law has none and of
  /// rules with a share at the mean gradient.
  virtual bool principalTangentAt(const NativePack (&)[3], PrincipalTangent<NativePack>&) const { return false; }
  /// Least determinant of F over the quadrature points of each element of a batch: determinants[lane].
  virtual void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const = 0;

  /// Cauchy stress of each element of a batch at positions x, Pa, averaged over the element as it is there, and the
  /// deformation gradients at its points, F[(q * 9 + i) * lanes + lane]: stress[i * lanes + lane], i one of xx, yy, zz,
  /// yz, xz, xy. With σ = P Fᵀ / det F it is Σ_q w_q P_q F_qᵀ / Σ_q w_q det F_q, of a law of small strain, which is not
  /// objective, the mean of P. Not a number where that volume is not positive.
  virtual void stressBatch(std::int32_t batch, const double* x, double* stress, double* F) const = 0;
  /// Volume at rest of each element of a batch, m³: volumes[lane].
  virtual void volumeBatch(std::int32_t batch, double* volumes) const = 0;
  /// Hourglass control of any elements of a rule of uniform strain, one a lane. False, and nothing written, of other
  /// rules.
  virtual bool hourglassOf(const std::int32_t*, HourglassVectors&) const { return false; }
  /// Whether forces are computed one direction after the other (elements/directions.h), in far fewer operations.
  virtual bool goesByDirections() const = 0;
  /// Whether evaluateBatches() has the forces of BatchEvaluation::bulk among its own.
  virtual bool addsBulkViscosity() const { return false; }

 protected:
  ElementBlock(const MeshBlock& block, const Material& material, const QuadratureRule& rule, PatchLayout layout,
               const HourglassControl& hourglassControl = {})
      : ElementTangents(block.nodesPerElement(), std::move(layout), block.connectivity),
        element_(&elementInfo(block.type)),
        rule_(&rule),
        material_(material),
        hourglassControl_(hourglassControl) {}

  /// stressBatch from Σ w P Fᵀ, or Σ w P of laws of small strain, and the volume that it is divided by.
  static void storeStress(const Matrix3<NativePack>& sum, const NativePack& volume, double* stress) {
    using P = NativePack;
    const P half = select(volume > P(0.0), P(0.5) / volume, P(std::numeric_limits<double>::quiet_NaN()));
    for (const auto& [row, column] : {std::pair{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}) {
      (half * (sum(row, column) + sum(column, row))).store(stress);
      stress += lanes;
    }
  }

 private:
  const ElementInfo* element_;
  const QuadratureRule* rule_;
  Material material_;
  HourglassControl hourglassControl_;
};

/// A patch in a pass over a body. A visitor runs it, once.
class PatchPass {
 public:
  /// all: what is wanted of every batch.
  PatchPass(const ElementBlock& block, std::int32_t patch, const double* rows, const BatchEvaluation& all)
      : block_(block), patch_(patch), rows_(rows), all_(all) {}

  std::int32_t index() const { return patch_; }
  const Patch& patch() const { return block_.layout().patches[patch_]; }
  /// Positions of the patch's nodes, as ElementBlock::gatherRows gives them.
  const double* rows() const { return rows_; }
  /// Computes what is wanted of all batches, and compares their deformation gradients with balls or what they were.
  void run(const BatchBalls* balls = nullptr, const BatchMotion* motion = nullptr) const {
    if (!all_.slots && !all_.energy && !balls && !motion) return;
    BatchEvaluation own = all_;
    own.balls = balls;
    own.motion = motion;
    block_.evaluateBatches(patch().batchBegin, patch().batchEnd, rows_, own);
  }
  /// The visitor sees the deformation gradients of a batch.
  void visit(std::int32_t batch, GradientVisitor& visitor) const {
    block_.evaluateBatches(batch, batch + 1, rows_, {.visitor = &visitor});
  }

 private:
  const ElementBlock& block_;
  std::int32_t patch_;
  const double* rows_;
  BatchEvaluation all_;
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
/// block reads the mesh block's connectivity, whose array must outlive it; the mesh may move. layout: of its elements,
/// as layOutPart gives it; without, that of layOutPatches.
std::unique_ptr<ElementBlock> makeElementBlock(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                               std::string_view ruleName = {},
                                               const HourglassControl& hourglassControl = {},
                                               std::optional<PatchLayout> layout = {});

}  // namespace ringwatch
