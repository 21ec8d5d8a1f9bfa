#pragma once
#include <memory>
#include <span>
#include <vector>

#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// Masses of nodes with 1 to 6 degrees of freedom each: three for solids, two in a plane, one for a scalar wave, six
/// for shells and beams. A component's mass is what its tangent entries are divided by to give rad²/s²: kg for a
/// displacement, kg m² for a rotation.
struct NodalMass {
  enum class Form {
    scalar,    ///< one number a node, for all its degrees of freedom
    diagonal,  ///< one for each degree of freedom
    block      ///< a symmetric positive definite matrix a node, e.g. of an offset rotary inertia
  };
  std::span<const double> values;  ///< node after node
  int degreesOfFreedom = 3;        ///< of every node
  Form form = Form::scalar;
};

/// The bracket of the critical step for a code that hands over element tangents and lumped masses only: any physics
/// whose tangents are symmetric, with up to six degrees of freedom a node. Knows neither geometry nor laws nor
/// positions. The safe side is the block nodal bound (Theorem 1, docs/theory/eigenvalue_bounds.md) or, where that is
/// not within 1 % of the optimistic side, the exchange bound (Theorems 12 and 13, docs/theory/exchange.md); the
/// optimistic side is the larger of reduced 1-ring and Rayleigh quotient (Theorems 9 and 8,
/// docs/theory/rings_and_rayleigh.md); both are proven for the tangents handed over. Weights, exchanged stiffness and
/// mode are kept from call to call, so that a step after a step costs a few eigenvalues an element; the first call
/// costs some twenty times as much. Exchange takes exchangeBoundBytes of memory, and is left out above
/// ExchangePolicy::mostBytes. Nodes of more than three degrees of freedom, and masses that are blocks, are bounded in
/// blocks of three after scaling by M^-½, which keeps the proof (Theorem 7, docs/theory/eigenvalue_bounds.md) and makes
/// the safe side a little smaller.
///
///   TangentBracket bracket(lumpedMass, {{2, nodesOfBars}});  // once
///   const CriticalStep step = bracket.evaluate({tangentsOfBars}, 2.0);  // in the time loop; 6×6 numbers a bar
///   const double h = 0.98 * step.safe;
class TangentBracket {
 public:
  /// Elements of one size.
  struct Elements {
    int nodesPerElement;                  ///< 2 to 20; 2 to 10 with more than three degrees of freedom
    std::span<const std::int32_t> nodes;  ///< element after element, nodesPerElement node numbers each
    /// That the tangents of these elements have at each node, the first ones of the node: solids beside shells have 3
    /// of 6. 0: all.
    int degreesOfFreedom = 0;
  };

  /// constrained: a flag for each degree of freedom of each node, 1 where it does not move; empty when all are free.
  /// Nothing is kept by reference. Throws InputError, naming node or element and value, for a mass that is not positive
  /// (definite), a node number outside the masses or repeated in an element, or wrong sizes.
  TangentBracket(const NodalMass& mass, const std::vector<Elements>& elements,
                 std::span<const std::uint8_t> constrained = {}, int threads = 0);
  /// Three degrees of freedom a node; lumpedMass: a mass for each node, kg.
  TangentBracket(std::span<const double> lumpedMass, const std::vector<Elements>& elements,
                 std::span<const std::uint8_t> constrained = {}, int threads = 0)
      : TangentBracket(NodalMass{lumpedMass}, elements, constrained, threads) {}
  ~TangentBracket();

  /// The bracket, s. tangents: for each group of elements, element after element, the symmetric tangent, n nodes of d
  /// degrees of freedom each, nd×nd numbers, rows and columns d·node + component. Of a tangent that is symmetric only
  /// to rounding the symmetric part (K + Kᵀ)/2 counts, and the bracket is proven for that. limit: the integrator's
  /// largest stable h·omega. `controlling.block` is the group. Both sides are infinite when nothing stiff is free.
  /// Throws InputError, naming group, element and value, for a tangent that is not finite, not symmetric (to 1e-8 of
  /// its largest entry) or of another size, for a limit that is not positive and finite, and for tangents so large or
  /// small that their sixth powers leave the range of a double (entries K_ij and K_ij/√(m_i m_j) outside 1e-40 to
  /// 1e40); NumericalError where rounding makes the two sides cross.
  /// searchNegative: whether `lowestRing` is of a search in the whole body too (LowestModeSearch), which takes up to
  /// 49 products with the tangent; else it is of the rings at hand alone.
  CriticalStep evaluate(const std::vector<std::span<const double>>& tangents, double limit,
                        bool searchNegative = false);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch
