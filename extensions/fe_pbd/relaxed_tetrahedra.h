#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/extensions/tetrahedra/coloured_tetrahedra.h>

namespace ringwatch {

/// What the nodes of a handled element are moved towards.
enum class GoalShape {
  rigid,  ///< the element at rest, turned and shifted, by one factor α for all of its modes: Fierz 2013's
  linear  ///< the strained element that implicit Euler finds: each mode of strain by its own factor
};

/// Tetrahedra that pull the predicted positions x* = x + h (v + h a) of their nodes towards goal shapes (position-based
/// dynamics). With the deformation gradient F* = R S of x*, R the closest rotation also for inverted elements, element
/// e asks for the forces
///   f_a = -V P ∂N_a/∂X.
/// A = Σ m_a X_a X_aᵀ about the centre of mass and H = Σ ∂N_a ∂N_aᵀ/m_a = A⁻¹; a fixed node has 1/m_a = 0.
///
/// rigid, Fierz 2013's: all elements at once, each with m_a its share 1/(overlap count) of the nodal mass.
/// V P = (α/h²) (F* - R) A moves node a by α (goal_a - x*_a), and α = 1 - (1 + h² λ_max)⁻¹ with the highest eigenvalue
/// λ_max of M_e⁻¹K_e at rest (Fierz 2013, eq. 4.19) on that share of mass.
///
/// linear: element after element, each on all of the mass of its nodes, forward and back. P = R σ, σ = C E' the stress
/// at the strain E' that an implicit Euler step of the corotational law leaves of E* = S - I when R is held,
///   E' = E* - h² V sym(σ H),   so that V σ = (C⁻¹/V + h² B)⁻¹ E*,  B σ = sym(σ H),
/// and on every later visit (C⁻¹/V + h² B) Δ(V σ) = E - C⁻¹σ. In the principal axes of H the 6×6 matrix is three shear
/// factors and a rank-one change of a diagonal, so every mode has its α = h²λ/(1 + h²λ), deviatoric and volumetric ones
/// alike. With D = C⁻¹/V + h² B over all elements and L its part below the diagonal blocks N in the order of the
/// visits, a pass takes (N + L) N⁻¹ (N + L)ᵀ ≽ D for D: near rest the nodes move by a matrix P, (I + h² M⁻¹K)⁻¹ ≼ P ≼ I
/// in the metric of M, K the stiffness of all elements here, and more passes converge to implicit Euler from the soft
/// side. Theorem 37, docs/theory/handlers.md.
///
/// Each element's forces are made free of torque about x by the rigid rotation that costs least, so that both momenta
/// are kept to rounding where no node is constrained.
class RelaxedTetrahedra {
 public:
  /// elements: of type tet4. h: s, passes: 1 to 32 (rigid takes one). Mass, constraints and rest shapes are those of
  /// the body now; it must outlive this.
  RelaxedTetrahedra(const Body& body, const std::vector<ElementRef>& elements, double h, GoalShape goal, int passes);

  /// Adds f/m to the accelerations a (3×N, m/s²) of a step from positions x (m) with velocities v (m/s); constrained
  /// components stay. False when a result is not finite; a is undefined then.
  bool relax(const NodeVectors& x, const NodeVectors& v, NodeVectors& a);

  int passes() const { return passes_; }
  std::size_t nodeCount() const { return tetrahedra_.nodes().size(); }
  /// The most elements at a node.
  int largestOverlap() const { return tetrahedra_.largestOverlap(); }
  /// 1 - (1 + h² λ_max)⁻¹ of each element, in the order given.
  const std::vector<double>& alpha() const { return alpha_; }

 private:
  using P = ColouredTetrahedra::P;
  static constexpr int lanes = ColouredTetrahedra::lanes;
  /// An element's constants, one lane each.
  struct Batch {
    P gradient[3][3];       // ∂N_a/∂X of nodes 1 to 3 in the principal axes of H, 1/m
    P normal[3], coupling;  // linear: d_i of diag(d) + c d dᵀ over normal strains, N·m; rigid: α/(h² η_i), kg·m²/s²
    P shear[3];             // of strains 12, 20, 01, N·m
    P compliance, dilatation;  // C⁻¹/V = compliance I - dilatation 1⊗1, 1/(N·m)
    P inertia[3];              // A, kg·m²; linear: 0 with constrained nodes, no torque to be free of
  };
  /// What visits hand on: the rotation, from step to step, and V σ, 00 11 22 12 20 01, N·m.
  struct Memory {
    Matrix3<P> R;
    P stress[6];
  };

  void setElement(std::size_t element, const Body& body, ElementRef e, const std::vector<int>& overlap, double h);
  template <GoalShape goal, bool first, bool last>
  void visit(std::int32_t batch);

  ColouredTetrahedra tetrahedra_;
  GoalShape goal_;
  int passes_;
  AlignedVector<Batch> batches_;
  AlignedVector<Memory> memory_;
  std::vector<double> alpha_;
};

}  // namespace ringwatch
