#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/base/archive.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/element_damping.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>
#include <ringwatch/monitor/incremental/outside_balls.h>

namespace ringwatch {

/// How much room a share of the exchange bound has for its element's motion. No constant here bears on what is proven
/// (Theorems 75 to 77, docs/theory/incremental_exchange.md): each trades evaluations against the width of the bound.
struct ExchangeRoomPolicy {
  /// Change of the deformation gradients that shares have room for when they are made, at most, and what that may cost
  /// of the eigenvalue. How much it costs is the law's.
  double room = 0.02, mostCost = 0.035;
  /// Parts of it that are tried, one after the other, for a ball around the present state, down to the least one that
  /// the caller wants. What is proven with little room is soon outside again.
  static constexpr double parts[] = {1, 0.5, 0.25};
  /// Where none of them fits: raises of the certified eigenvalue that are tried, with that least part.
  static constexpr double raises[] = {1.01, 1.02, 1.04, 1.08, 1.15};
  /// Angle by which a node's surroundings must have turned, rad, before its frame is turned with them.
  double leastRotation = 0.003;
  /// Upper over lower eigenvalue, both with room, that iterations aim for and end at.
  double aim = 1.01, narrow = 1.03;
  /// Where a proof of an eigenvalue is enough: the most room, what iterations end at, which is reached in a few, and
  /// the part of the eigenvalue that is left for raises.
  double mostRoom = 0.15, narrowForProof = 1.08, margin = 0.03;
  /// Contact that has come and gone since the last shares were made, or is nearer than this share of the distance
  /// between nodes, has room in the next ones, up to this share of the eigenvalue at its nodes.
  double near = 0.5, mostReserved = 0.3;
};

/// The exchange bound of a body kept along a run (docs/theory/incremental_exchange.md). Its proof is: a symmetric
/// matrix G_e for each element, at least zero, which add up to at most σ; a rotation R_i for each node; and for each
/// element a ball |F_q - F0_q| <= r in which its tangent is at most G_e in its nodes' frames. What its balls do not
/// prove an LDLᵀ factorisation does: no eigenvalues. G_e is stored in whole numbers of 16 bits whose sum is exact.
/// Tangents of elements that damp are those of K + f C (Theorem 83). At the nodes of discrete forces their majorants at
/// the very state are added to the sums (Theorem 82), so that contact comes and goes at no cost but that of its nodes.
class ExchangeCertificate {
 public:
  /// weights: of the body, by reference; only which elements are at a node is read, but by share().
  ExchangeCertificate(const Body& body, const NodalBound& weights, const ExchangeRoomPolicy& policy = {});

  /// Memory of the proof, and what making shares takes beside it, bytes.
  static std::int64_t bytes(const Body& body);

  /// Whether highest eigenvalues are proven to be at most certifiedEigenvalue() at the positions of the last call.
  bool holds() const { return holds_; }
  bool hasShares() const { return unit_ > 0; }
  /// rad²/s²; infinite while nothing is proven.
  double certifiedEigenvalue() const { return std::max(ofElements(), beside_); }
  /// The part of it that discrete forces have no part in.
  double ofElements() const { return holds_ ? sigma_ * scale_ : std::numeric_limits<double>::infinity(); }
  /// Shares at x from the weights, which were evaluated there, or from the present shares. mode: 3×N, a guess of the
  /// top mode; lower: a lower bound at x. Both are only aimed by. wanted: an eigenvalue whose proof is enough, rad²/s²:
  /// shares get as much room as it leaves them; 0 for none.
  ExchangeWork share(NodeVectorsView x, NodeVectorsView mode, LowerBound lower, int mostIterations, double wanted = 0);
  /// From the positions of the last call to x: what has left its ball is proven anew, and the eigenvalue raised where
  /// that needs it. Ends the proof where a raise above mostRaise would be needed, or the body has changed.
  /// leastPart: of the room, that every ball is to have; more room costs a raise, and less is proven anew. Unless
  /// nullptr, `evaluation` is filled in at x by the pass that tests the balls; its visitor is not used.
  void follow(NodeVectorsView x, double mostRaise, double leastPart = 0.25, StepEvaluation* evaluation = nullptr);
  void forget() { holds_ = false; }
  /// Of the last share() or follow(): elements that were factored, and the work of testing balls, WorkAccount's units.
  std::int64_t factored() const { return factored_; }
  /// The elements that the last follow() factored, with det F and -lambda_min(∂P/∂F) at most: an element that inverts
  /// is among them.
  struct Seen {
    ElementRef element;
    double determinant, negative;
  };
  const std::vector<Seen>& seen() const { return seenElements_; }
  double workOfTests() const { return workOfTests_; }

  /// The largest eigenvalue of A_e - G_e in frames over certifiedEigenvalue(), and by how much the sum at a node
  /// exceeds it, from exact tangents and dense eigenvalues; for tests: at most 0 but for rounding.
  double verify(NodeVectorsView x) const;

  template <class Archive>
  void archive(Archive& a) {
    bool has = !blocks_.empty();
    a(has);
    if (has)
      makeBlocks();
    else
      blocks_.clear();
    for (BlockData& data : blocks_) a(data.balls, data.entries, data.counted);
    a(holds_, turned_, room_, sigma_, scale_, unit_, beside_, dampingFactor_, frames_, surroundings_, sums_, seen_,
      factored_, workOfTests_);
    archiveVersion(a, version_, body_.version());
  }

 private:
  /// entries: [batch][entry of the lower triangle, row by row][lane]. rates: the block where its damping depends on
  /// velocities, else nullptr; counted: its coefficients, by place, when elements were proven last.
  struct BlockData {
    ValidityBalls balls;
    std::vector<std::int16_t> entries;
    const DampedBlock* rates = nullptr;
    std::vector<double> counted = {};
    bool rateHasRisen(std::size_t place) const { return rates->coefficient(place) > counted[place]; }
  };
  /// What a proof came to: the raise that it needs (1: none, infinity: more than any that is tried), and the ball.
  struct Proof {
    double raise = std::numeric_limits<double>::infinity(), radius = -1, fromStored = 0;
    double determinant = std::numeric_limits<double>::infinity(), negative = 0;
  };
  /// Memory for shares: none before there are some.
  void makeBlocks();
  /// What the majorants of discrete forces at x add up to with the shares at their nodes.
  void addDiscreteForces(NodeVectorsView x);
  /// The majorants that shares are to have room for beside them at x.
  std::vector<Eigen::Matrix3d> majorantsToCome(NodeVectorsView x, double eigenvalue);
  void prove(NodeVectorsView x, const std::vector<ElementRef>& elements, double leastPart, std::vector<Proof>& proofs);
  void provePack(NodeVectorsView x, std::int32_t block, const std::int32_t* elements, double leastPart, Proof* proofs);
  /// Proves elements outside of their balls at x, with frames that turn and a raise where it takes them; turned nodes'
  /// elements are added to them.
  void proveAnew(NodeVectorsView x, std::vector<ElementRef>& outside, double mostRaise, double leastPart);
  /// Proves elements at x and gives them their balls; returns the raise that they need.
  double renew(NodeVectorsView x, const std::vector<ElementRef>& elements, double leastPart);
  /// Turns the frames of the elements' nodes with their surroundings, and returns all elements at those that turned.
  std::vector<ElementRef> turnFrames(NodeVectorsView x, const std::vector<ElementRef>& elements);
  /// The rotations of nodes' surroundings since the reference configuration: of the mean of their elements' gradients.
  std::vector<Eigen::Quaternionf> surroundingsOf(NodeVectorsView x, const std::vector<std::int32_t>& nodes) const;
  std::size_t placeOf(ElementRef e) const;
  /// The lower triangle of G_e in frames, rad²/s², without scale_.
  void loadShare(ElementRef e, double* G) const;
  /// The present shares in their frames, rounded anew: a start for others, of which nothing has to be proven.
  ExchangeShares allShares() const;
  bool sharesAreDefinite() const;
  void store(const ExchangeShares& shares);

  const Body& body_;
  const NodalBound& weights_;
  ExchangeRoomPolicy policy_;
  std::vector<BlockData> blocks_;
  bool holds_ = false, turned_ = false;      // turned_: a frame is not 1
  double room_ = 0;                          // of the present shares
  double sigma_ = 0, scale_ = 1, unit_ = 0;  // sums of G_e are at most sigma_; G_e counts scale_ times
  double beside_ = 0;                        // of the sums and the majorants at nodes of discrete forces, if above
  std::vector<Eigen::Matrix3d> frames_;
  std::vector<Eigen::Quaternionf> surroundings_;  // when shares were made
  std::int64_t version_ = 0;                      // of the body, that the proof is for
  double dampingFactor_ = 0;                      // of elements, that the proof is for
  std::int64_t factored_ = 0;
  double workOfTests_ = 0;
  std::vector<Seen> seenElements_;
  // At the nodes of discrete forces: sums of G_e, without scale_; the largest majorants since shares were made; those
  // at x, and where they are not zero.
  std::vector<Eigen::Matrix3d> sums_, seen_, majorants_;
  std::vector<std::int32_t> majorantsAt_;
  OutsideBalls outsideBalls_;
};

}  // namespace ringwatch
