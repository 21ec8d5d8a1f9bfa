#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <ringwatch/body/tangent_source.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>

namespace ringwatch {

/// A proven upper bound of the highest eigenvalue of M⁻¹K by sharing stiffness among elements. With A_e the element
/// tangents in mass-scaled coordinates and any symmetric P_e on the nodes of element e with
///   Σ_e P_e = sigma I - Σ_e A_e   (assembled),   eps_e = max(0, -lambda_min(P_e)),
/// P_e + eps_e I ≽ 0 sums up to   lambda_max(M⁻¹K) <= sigma + max_i Σ_(e∋i) eps_e.
/// The block nodal bound is the special case P_e = block diagonal - A_e; here neighbours also exchange the stiffness
/// between two nodes that they share, which closes the gap that every choice of weights leaves on regular grids.
///
/// The P_e are found by minimising Σ |P_e's negative part|² over the affine set: a step removes the negative parts and
/// spreads what is then missing from the sum evenly over the elements that share a block (a projection), accelerated
/// after Nesterov (Beck & Teboulle 2009) and restarted when the sum rises (O'Donoghue & Candès 2015). An element
/// is left alone while its least eigenvalue cannot have sunk below zero, which the norms of its changes tell (Weyl).
/// Iterations work in single precision; once they promise enough, and at the end, the sum is made right and every eps_e
/// is proven in double precision. Theorem 12, docs/theory/exchange.md; that iterates keep the sum: Theorem 13.
struct ExchangeBound {
  UpperBound upper;
  int iterations = 0;
  std::int64_t decompositions = 0;  // of element matrices: nearly all of the cost
};

/// x: 3×N, m. weights: evaluated at x; the start. sigma: rad²/s², best just above the truth; any value gives a bound.
/// accept: stops when the bound is at or below it. Memory: exchangeBoundBytes, some 60 n² bytes an element
/// of n nodes. The value is infinite when the tangent is not finite.
ExchangeBound exchangeUpperBound(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                                 double sigma, double accept, int maxIterations);
/// Memory that it needs, bytes.
std::int64_t exchangeBoundBytes(const TangentSource& source);

/// What it is asked for, by default and where nothing else is: the optimistic over the safe step, less 1, that is
/// narrow enough; iterations; bytes.
struct ExchangePolicy {
  static constexpr double width = 0.01;
  static constexpr int iterations = 60;
  static constexpr std::int64_t mostBytes = 4LL << 30;
  /// Upper over lower eigenvalue that is narrow enough, and that sigma aims for: the rest of the width is left for what
  /// single elements exceed it by.
  static constexpr double narrow(double width) { return (1 + width) * (1 + width); }
  static constexpr double aim(double width) { return 1 + partOfSigma * (narrow(width) - 1); }
  static bool worth(const TangentSource& source, UpperBound upper, LowerBound lower,
                    double width = ExchangePolicy::width) {
    return upper.value > narrow(width) * lower.value && exchangeBoundBytes(source) <= mostBytes;
  }

 private:
  /// Iterations to a width of 1, 3 and 5 % of bars of all elements are fewest from 0.7 to 0.9.
  static constexpr double partOfSigma = 0.8;
};
ExchangeBound exchangeUpperBound(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                                 LowerBound lower, double width = ExchangePolicy::width);

namespace detail {
/// The matrices P_e of a source.
class ExchangeSplit {
 public:
  virtual ~ExchangeSplit() = default;
};
}  // namespace detail

/// The exchange bound of a source that is kept from state to state: at a new state and sigma what is then missing from
/// Σ_e P_e = sigma I - Σ_e A_e is spread over the P_e of the last one, so that one or two iterations do where tangents
/// have changed little. Proven at every state for that state alone: Theorem 12, and Theorem 13 (a) for any P_e,
/// docs/theory/exchange.md.
class KeptExchangeBound {
 public:
  /// source: by reference.
  explicit KeptExchangeBound(const TangentSource& source);
  ~KeptExchangeBound();

  /// As exchangeUpperBound. weights: where the first state starts from; later only their majorants count.
  ExchangeBound evaluate(NodeVectorsView x, const NodalBound& weights, double sigma, double accept, int maxIterations);

 private:
  const TangentSource& source_;
  std::int64_t version_ = 0;
  std::unique_ptr<detail::ExchangeSplit> split_;
};

/// The bound as matrices that anybody can add up: G_e = P_e + A_e + a margin, which is at least A_e and at least zero,
/// in whole numbers g of unitOfEntries() sqrt(m_a m_b), of constrained components zero. Those that elements hold of the
/// block between two different nodes add up to zero exactly; upper is what those of a node's own block add up to.
struct ExchangeShares {
  static constexpr int wide = 30, narrow = 15;
  int bits = wide;   ///< of a whole number, beside its sign
  UpperBound upper;  ///< infinite: the tangent is not finite
  double unit = 0;   ///< rad²/s², of wide numbers a power of two
  /// Mesh block by mesh block, element by element: the lower triangle of g, row by row.
  std::vector<std::int32_t> entries;

  double unitOfEntries() const { return std::ldexp(unit, -bits); }
};
/// As exchangeUpperBound, with its policy; of the last iterate.
ExchangeShares exchangeShares(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                              LowerBound lower);

/// Adds to element tangents, one a lane (-1: none) and as ElementTangents::tangentOf gives them, what room they are to
/// have beside them, N/m, and to their rounding T what that errs by.
using ExchangeRoom = std::function<void(std::size_t block, const std::int32_t* elements, NativePack* K, NativePack* T)>;
struct ExchangeWork {
  int iterations;
  std::int64_t decompositions;
};
/// The same of tangents with room, in narrow numbers. from: those of another state, to go on from; nullptr: from the
/// weights, evaluated at x. majorants: of discrete forces, in place of those of the weights, beside which the sums at
/// nodes are to have room; nullptr: those. sigma, accept: of the sum of the tangents with their room.
ExchangeShares roomyExchangeShares(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                                   const ExchangeShares* from, const ExchangeRoom& room,
                                   const std::vector<Eigen::Matrix3d>* majorants, double sigma, double accept,
                                   int mostIterations, ExchangeWork& work);

}  // namespace ringwatch
