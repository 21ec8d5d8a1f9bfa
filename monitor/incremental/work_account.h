#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// What the work of a monitor goes to.
enum class WorkOn {
  tests,        ///< of validity balls, at every observation
  evaluations,  ///< of elements that have left theirs
  repairs,      ///< around elements above their allowances
  sweeps,       ///< of all weights or allowances
  mode,         ///< the lower side
  searches      ///< for negative stiffness
};
inline constexpr std::string_view workNames[] = {"tests", "evaluations", "repairs", "sweeps", "mode", "searches"};
inline constexpr std::size_t worksOn = std::size(workNames);

/// Work by what it went to, in WorkAccount's units or as a share of a step's own.
struct Work {
  std::array<double, worksOn> of{};

  double& operator[](WorkOn what) { return of[static_cast<std::size_t>(what)]; }
  double operator[](WorkOn what) const { return of[static_cast<std::size_t>(what)]; }
  double total() const {
    double sum = 0;
    for (const double part : of) sum += part;
    return sum;
  }
  Work& operator+=(const Work& other) {
    for (std::size_t i = 0; i < worksOn; ++i) of[i] += other.of[i];
    return *this;
  }
};

/// What a monitor may spend along a run: a share of the work of the steps themselves, earned step by step. Work is
/// counted, not timed, so that runs repeat bit by bit, in units of a table that holds within a half for every element:
/// an element of n nodes and q quadrature points takes n q units for its force, 0.4 n q where that goes one direction
/// after the other, and (3n)³/14 for an evaluation, which is the highest eigenvalue of a 3n×3n matrix: a tet4 31
/// forces, a hex8 39, a hex20 29.
///
/// There are two purses, one for each side of the bracket, so that neither starves the other; what one cannot keep the
/// other gets. A third one, as much again, is for nothing but the proof that the step which is taken is stable
/// (Theorem 14, docs/theory/incremental_certificate.md); a fourth one, as much again and more in small bodies, for
/// telling, while there is no such proof, whether it is proven unstable (Theorem 8, docs/theory/rings_and_rayleigh.md);
/// a fifth one, of a tenth as much, for directions of negative stiffness.
class WorkAccount {
 public:
  /// share: of a step's work; from `noLimit` on there is no limit. steps: of the run, as far as known. inAdvance: work
  /// before which there is no limit either, for bodies of which some rebuilds take no more.
  explicit WorkAccount(const Body& body, double share, std::int64_t steps = 0, double inAdvance = 0)
      : share_(share),
        force_(ofForce(body)),
        atStart_(share < noLimit ? share * static_cast<double>(steps) * force_ : 0),
        // A body of a few elements could not afford to look at one of them.
        income_(share >= noLimit ? 0
                : share > 0      ? std::max(share * force_, leastIncome)
                                 : 0),
        evaluation_(ofEvaluation(body)),
        rebuild_(ofRebuild(body)),
        advance_(rebuildsInAdvance * rebuild_ <= inAdvance ? inAdvance : 0),
        mostForVerdict_(income_ > 0 ? 2 * ofDiagonal(body) + ofProducts(body, productsKept) : 0),
        mostForSearches_(income_ > 0 ? 2 * ofProducts(body, productsKept) : 0),
        balance_(stepsInAdvance * (1 - shareOfMode) * income_),
        verdict_(mostForVerdict_) {}

  static constexpr double noLimit = 100;
  bool limited() const { return share_ < noLimit && !(advance_ > 0); }
  /// Whether the first observation may take so much at once: no more than all steps of the run earn.
  bool affordsAtStart(double work) const { return !limited() || work <= atStart_; }
  /// A step's own work.
  double force() const { return force_; }
  /// What a step earns for the lower side.
  double incomeForMode() const { return shareOfMode * income_; }
  /// And for telling whether a step that is not certified is proven unstable.
  double incomeForVerdict() const {
    return income_ > 0 ? std::max(income_, std::min(forcesForVerdict * force_, leastForVerdict)) : 0;
  }

  static double ofForce(const ElementBlock& block) {
    const double all = block.nodesPerElement() * static_cast<double>(block.rule().points.size());
    return block.goesByDirections() ? shareByDirections * all : all;
  }
  static double ofEvaluation(const ElementBlock& block) {
    const double size = 3.0 * block.nodesPerElement();
    return size * size * size / 14;
  }
  /// Decompositions and factorisations of so many elements' matrices, with their tangents, for the exchange bound.
  static double ofExchange(const Body& body, double decompositions, double factorisations) {
    const double evaluations = ofEvaluation(body) / elements(body);
    return (evaluationsOfDecomposition * decompositions + evaluationsOfFactorisation * factorisations) * evaluations;
  }
  /// Making shares that prove a given eigenvalue, by so many decompositions an element: matrices of all elements are
  /// gone through in memory many times beside those.
  static double ofShares(const Body& body, double decompositions) {
    return (evaluationsOfShares + evaluationsOfIteration * decompositions) * ofEvaluation(body);
  }
  /// The work of all elements, or of some.
  static double ofForce(const Body& body) {
    return sum(body, [](const ElementBlock& block) { return ofForce(block); });
  }
  static double ofEvaluation(const Body& body) {
    return sum(body, [](const ElementBlock& block) { return ofEvaluation(block); });
  }
  static double ofEvaluation(const Body& body, std::span<const ElementRef> elements) {
    double work = 0;
    for (const ElementRef e : elements) work += ofEvaluation(*body.blocks()[e.block]);
    return work;
  }
  /// Of looking whether a ball can grow: gradients, and the law's coefficients.
  static double ofGrowth(const Body& body, std::span<const ElementRef> elements) {
    double work = 0;
    for (const ElementRef e : elements) work += forcesOfGrowth * ofForce(*body.blocks()[e.block]);
    return work;
  }
  /// Allowances for all elements; strain norms as well where weights are new.
  static double ofDistribution(const Body& body, bool newWeights) {
    return (newWeights ? 1.5 : 0.3) * ofEvaluation(body);
  }
  /// Moving all allowances, and radii with them.
  static double ofMove(const Body& body) { return unitsOfMove * elements(body); }
  /// A lowering: radii, and the visit of every element that follows. What leaves its ball then comes on top.
  static double ofLowering(const Body& body) { return ofMove(body) + ofForce(body); }
  static double ofRebuild(const Body& body) { return evaluationsOfRebuild * ofEvaluation(body); }
  /// Tangent products of a body, and of their rounding, which costs as much.
  static double ofProducts(const Body& body, int products) { return forcesOfProduct * products * ofForce(body); }
  /// The diagonal of the tangents of all elements.
  static double ofDiagonal(const Body& body) { return evaluationsOfTangent * ofEvaluation(body); }
  /// Reduced rings of elements, with their eigenvectors; all of them together, without.
  static double ofRing(const ElementBlock& block) {
    const double size = 3.0 * block.nodesPerElement();
    return 3 * size * size * size;
  }
  static double ofAllRings(const Body& body) { return 1.5 * ofEvaluation(body); }

  /// A step's income. No more is kept than a rebuild and an evaluation cost; for the lower side, than all reduced rings
  /// and some products do.
  void earn() {
    const double mostOfMode = 2 * evaluation_ + productsKept * forcesOfProduct * force_;
    mode_ += shareOfMode * income_;
    balance_ += (1 - shareOfMode) * income_ + std::max(mode_ - mostOfMode, 0.0);
    mode_ = std::min(mode_, mostOfMode);
    balance_ = std::min(balance_, rebuild_ + evaluation_);
    proof_ = std::min(proof_ + income_, 3 * evaluation_);
    verdict_ = std::min(verdict_ + incomeForVerdict(), mostForVerdict_);
    searches_ = std::min(searches_ + shareOfSearches * income_, mostForSearches_);
    asked_ += (askedSince_ - asked_) / stepsOfMean;
    askedSince_ = 0;
  }
  /// What evaluations, repairs and half of the tests have lately asked for, over what is earned for them: above 1 balls
  /// are too small for what there is.
  double load() const { return income_ > 0 ? asked_ / ((1 - shareOfMode) * income_) : 2; }
  /// All balls have grown: what was asked for before says nothing more of them.
  void ballsGrow() { asked_ = std::min(asked_, (1 - shareOfMode) * income_); }
  /// Tests of balls count for no more than a part of an income: what is left keeps the bracket narrow.
  void spend(const Work& work) {
    takeInAdvance(work.total());
    const double tests = std::min(work[WorkOn::tests], mostOfTests * income_);
    balance_ = std::max(balance_ - (work.total() - work[WorkOn::tests]) - tests, -mostOwed());
    askedSince_ += mostOfTests * work[WorkOn::tests] + work[WorkOn::evaluations] + work[WorkOn::repairs];
  }
  /// What was asked for in vain.
  void refuse(double work) { askedSince_ += work; }
  void spendOnProof(double work) { take(proof_, work); }
  void spendOnMode(double work) { take(mode_, work); }
  void spendOnVerdict(double work) { take(verdict_, work); }
  void spendOnSearches(double work) { take(searches_, work); }
  bool affordsForSearches(double work) const { return has(searches_, work); }
  bool affords(double work) const { return has(balance_, work); }
  bool affordsForProof(double work) const { return has(proof_, work); }
  bool affordsForMode(double work) const { return has(mode_, work); }
  bool affordsForVerdict(double work) const { return has(verdict_, work); }
  /// What single elements may take on credit where the certified eigenvalue would have to rise far.
  double credit() const { return income_ > 0 ? forcesOfCredit * force_ + leastIncome : 0; }

 private:
  void takeInAdvance(double work) { advance_ = std::max(advance_ - work, 0.0); }
  void take(double& purse, double work) {
    takeInAdvance(work);
    purse = std::max(purse - work, -mostOwed());
  }
  /// Nothing is paid from no income, not even what costs nothing now.
  bool has(double purse, double work) const { return !limited() || (income_ > 0 && purse >= work); }
  /// What is owed beyond that is forgiven: it would stop all that makes a bound narrower for the rest of a run.
  double mostOwed() const { return mostOwedOfEvaluation * evaluation_; }
  template <class Of>
  static double sum(const Body& body, const Of& of) {
    double work = 0;
    for (const auto& block : body.blocks()) work += static_cast<double>(block->elementCount()) * of(*block);
    return work;
  }
  static double elements(const Body& body) { return static_cast<double>(body.mesh().elementCount()); }

  // As measured on an EPYC of AVX-512. evaluationsOfRebuild: 6 to 14 of them, with their strain norms.
  static constexpr double evaluationsOfTangent = 0.25, evaluationsOfRebuild = 12, forcesOfGrowth = 3,
                          forcesOfProduct = 1.6;
  static constexpr double evaluationsOfDecomposition = 1.5, evaluationsOfFactorisation = 1.5;
  static constexpr double evaluationsOfShares = 14, evaluationsOfIteration = 2.5;
  static constexpr double unitsOfMove = 2.2, shareByDirections = 0.4;
  static constexpr double productsKept = 12;
  static constexpr double leastIncome = 2000, shareOfMode = 0.3, shareOfSearches = 0.1, forcesOfCredit = 0.5,
                          mostOfTests = 0.5, mostOwedOfEvaluation = 0.1;
  static constexpr double stepsOfMean = 32, stepsInAdvance = 100, rebuildsInAdvance = 4;
  // stepsInAdvance: of income, so that the first elements that leave their balls can be evaluated.
  // mostOwedOfEvaluation: a few rounds of these.
  /// Units a step, no more than some of its own forces: a body of a few thousand elements is searched once in ten steps
  /// then.
  static constexpr double leastForVerdict = 20000, forcesForVerdict = 6;
  double share_, force_, atStart_, income_, evaluation_, rebuild_, advance_, mostForVerdict_, mostForSearches_;
  double balance_, mode_ = 0, proof_ = 0, verdict_, searches_ = 0;
  double asked_ = 0, askedSince_ = 0;  // in a step, on average; in the last one
};

}  // namespace ringwatch
