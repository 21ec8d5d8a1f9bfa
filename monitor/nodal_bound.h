#pragma once
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/symmetric3.h>

namespace ringwatch {

/// The block nodal bound, a proven upper bound of the highest eigenvalue of M⁻¹K. For any symmetric positive definite 3×3
/// shapes D_(e,a), one for each element and node, and l_e = max(0, lambda_max(D_e⁻¹ K_e)):
///   K_e ≼ l_e D_e,  hence  lambda_max(M⁻¹K) <= max_i lambda_max(S_i),  S_i = (1/m_i) Σ_(e∋i) l_e D_(e,a(i)).
/// True for every symmetric K_e, indefinite ones included. Good shapes make it tight: they start at (K_aa)^½ or K_aa and are swept,
/// D_a ← R_i D_a R_i with R_i = (S_i/t)^-½, t the bound. Shapes are kept from call to call.
class NodalBound {
 public:
  /// Shapes to start from. The root wins on irregular meshes, the stiffness itself on regular ones.
  enum class Start { rootOfStiffness, stiffness };

  explicit NodalBound(const Body& body);

  /// The bound at positions x (3×N, m): the best of up to `sweeps` + 1 evaluations. From scratch when nothing is kept.
  UpperBound evaluate(const NodeVectors& x, int sweeps, Start start = Start::rootOfStiffness);
  /// Forgets the shapes.
  void reset() { started_ = false; }
  /// lambda_max(S_i) of every node at the last sweep, rad²/s².
  const std::vector<double>& nodal() const { return nodal_; }
  /// Elements times evaluations in the last call.
  std::int64_t evaluations() const { return evaluations_; }

 private:
  using Pack = NativePack;
  struct Incidence {
    std::int32_t block;
    std::int32_t place;  // (batch * n + a) * lanes + lane
  };
  void startShapes(const NodeVectors& x, Start start);
  void evaluateElements(const NodeVectors& x);
  double sumAtNodes();
  void sweepShapes(double bound);

  const Body* body_;
  bool started_ = false;
  std::vector<AlignedVector<Symmetric3<Pack>>> shapes_;  // [block][batch * n + a]
  std::vector<AlignedVector<Pack>> values_;              // [block][batch], l_e
  std::vector<std::int64_t> incidenceBegin_;
  std::vector<Incidence> incidence_;
  AlignedVector<Symmetric3<Pack>> sums_;  // S_i, one node a lane
  AlignedVector<Symmetric3<Pack>> factors_;
  std::vector<double> nodal_;
  std::int64_t evaluations_ = 0;
};

}  // namespace ringwatch
