#pragma once
#include <memory>
#include <span>
#include <vector>

#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// The bracket of the critical step for a code that hands over element tangents and lumped masses only: any physics
/// with three degrees of freedom a node whose tangents are symmetric. Knows neither shapes nor laws nor positions. The
/// safe side is the block nodal bound, the optimistic side the larger of reduced 1-ring and Rayleigh quotient, both
/// proven for the tangents handed over. Shapes and mode are kept from call to call, so that a step after a step costs a
/// few eigenvalues an element.
class TangentBracket {
 public:
  /// Elements of one size. nodes: element after element, nodesPerElement (2 to 20) node numbers each.
  struct Elements {
    int nodesPerElement;
    std::span<const std::int32_t> nodes;
  };

  /// lumpedMass: a mass for each node, kg. constrained: 3 flags a node, 1 where a component does not move; empty when
  /// all are free. Nothing is kept by reference. Throws InputError, naming node or element and value, for a mass that
  /// is not positive, a node number outside the masses or repeated in an element, or wrong sizes.
  TangentBracket(std::span<const double> lumpedMass, const std::vector<Elements>& elements,
                 std::span<const std::uint8_t> constrained = {}, int threads = 0);
  ~TangentBracket();

  /// The bracket, s. tangents: for each group of elements, element after element, the 3n×3n tangent, N/m, rows and
  /// columns 3·node + component. Of a tangent that is symmetric only to rounding the symmetric part (K + Kᵀ)/2 counts,
  /// and the bracket is proven for that. limit: the integrator's largest stable h·omega. `controlling.block` is the
  /// group. Both sides are infinite when nothing stiff is free. Throws InputError, naming group, element and value, for
  /// a tangent that is not finite, not symmetric (to 1e-8 of its largest entry) or of another size, for a limit that is
  /// not positive and finite, and for tangents so large or small that their sixth powers leave the range of a double
  /// (entries K_ij and K_ij/√(m_i m_j) outside 1e-40 to 1e40); NumericalError where rounding makes the two sides cross.
  CriticalStep evaluate(const std::vector<std::span<const double>>& tangents, double limit);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch
