#pragma once
#include <vector>

#include <ringwatch/extensions/tetrahedra/coloured_tetrahedra.h>

namespace ringwatch {

/// Tetrahedra with filtered modes (filterModes), turned with them: R is the rotation closest to F at x. As all forces
/// of a tetrahedron they are given by its strain E = sym(RᵀF) - I, with u the displacements in its frame and E = G u:
///   K' = Gᵀ Ĉ G,   b_k = Gᵀ c_k,
/// Ĉ 6×6. The modes that are filtered out are scaled and mixed such that each has the compliance 1 and
/// I + h² Yᵀ G M⁻¹ Gᵀ Y, Y = (c_1 …), is diagonal: a visit is then, mode by mode, s_k ← s_k + (c_k·E - s_k)/d_k.
class FilteredTetrahedra {
 public:
  /// elements: of type tet4. allowance: of each, by node, N/m, > 0. h: s. Mass, constraints and rest shapes are those
  /// of the body now; it must outlive this.
  FilteredTetrahedra(const Body& body, const std::vector<ElementRef>& elements,
                     const std::vector<Eigen::Vector4d>& allowance, double h);

  /// Adds to the accelerations a (3×N, m/s²) those by K' at positions x (m); then those by which the filtered-out modes
  /// move the predicted positions x + h (v + h a), forward and back over the elements in each of some passes, which may
  /// be none. Forces are free of torque about x; constrained components stay. False when a result is not
  /// finite; a is undefined then.
  bool act(const NodeVectors& x, const NodeVectors& v, NodeVectors& a, int passes);
  /// Modes that were filtered out, of all elements.
  int modes() const { return modes_; }

 private:
  using P = ColouredTetrahedra::P;
  static constexpr int lanes = ColouredTetrahedra::lanes;
  /// An element's constants, one lane each, in the axes of H (principalTetrahedron).
  struct Batch {
    P gradient[3][3];  // ∂N_a/∂X of nodes 1 to 3, 1/m
    P kept[21];        // Ĉ, upper triangle row by row, N·m; work is E·ĈE/2, so shear counts twice in it
    P mode[6][6];      // c_k, √(N·m)
    P inverse[6];      // 1/d_k
    P inertia[3];      // A = H⁻¹, kg·m²; 0 with constrained nodes, no torque to be free of
  };
  /// What visits hand on: the rotation, from step to step, and s_k, √(N·m).
  struct Memory {
    Matrix3<P> R;
    P s[6];
  };
  void setElement(std::size_t element, const Body& body, ElementRef e, const Eigen::Vector4d& allowance, double h);
  void keep(std::int32_t batch);
  template <bool first, bool last>
  void relax(std::int32_t batch);

  ColouredTetrahedra tetrahedra_;
  AlignedVector<Batch> batches_;
  AlignedVector<Memory> memory_;
  int modes_ = 0;
};

}  // namespace ringwatch
