#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/body/discrete_forces.h>

namespace ringwatch {

/// What the work of a monitor goes to.
enum class WorkOn {
  tests,        ///< of validity balls, at every observation
  evaluations,  ///< of elements that have left theirs, and of how far these could grow
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
  double besideTests() const { return total() - (*this)[WorkOn::tests]; }
  Work& operator+=(const Work& other) {
    for (std::size_t i = 0; i < worksOn; ++i) of[i] += other.of[i];
    return *this;
  }
};

/// What a monitor may spend along a run: a share of the work of the steps themselves, earned step by step. Work is
/// counted, not timed, so that runs repeat bit by bit, in units of some 3.5 ns of a table that holds within a half for
/// every element with St. Venant-Kirchhoff: an element of n nodes and q quadrature points takes 0.4 n + (0.2 + 0.33 n)
/// q units for its force, 0.32 n q where that goes one direction after the other, and (3n)³/26 for an evaluation among
/// all others, which is the highest eigenvalue of a 3n×3n matrix: a tet4 21 forces, a hex8 26, a hex20 48. Of single
/// elements along a run a pack takes as long as one, and the first is far from what the run has just computed, in code
/// and in memory.
///
/// Tests of validity balls and of all numbers for being finite, which no observation can do without, come off the
/// income first; a part of it is there for the rest in any case. That is divided, so that nothing starves the rest: for
/// the lower side of the bracket; for nothing but the proof that the step which is taken is stable (Theorem 14,
/// docs/theory/incremental_certificate.md); for directions of negative stiffness; while there is no such proof, for
/// telling whether the step is proven unstable (Theorem 8, docs/theory/rings_and_rayleigh.md), in small bodies more
/// than the budget has for it; and for the upper side what is left, and what the others cannot keep.
class WorkAccount {
 public:
  /// share: of a step's work; from `noLimit` on there is no limit. steps: of the run, as far as known; every: steps
  /// from one observation to the next. inAdvance: work before which there is no limit either, for bodies of which some
  /// rebuilds take no more.
  explicit WorkAccount(const Body& body, double share, std::int64_t steps = 0, double inAdvance = 0,
                       std::int64_t every = 1)
      : share_(share),
        force_(ofForce(body)),
        atStart_(share < noLimit ? shareAtStart * share * static_cast<double>(steps) * force_ : 0),
        // A body of a few elements could not afford to look at one of them.
        income_(share >= noLimit ? 0
                : share > 0      ? std::max(share * static_cast<double>(every) * force_, leastIncome)
                                 : 0),
        evaluation_(ofEvaluation(body)),
        rebuild_(ofRebuild(body)),
        advance_(rebuildsInAdvance * rebuild_ <= inAdvance ? inAdvance : 0),
        mostForVerdict_(
            income_ > 0 ? searchesKept * ofDiagonal(body) + ofProducts(body, productsKept) + ofDearestRing(body) : 0),
        mostForSearches_(income_ > 0 ? searchesKept * ofProducts(body, productsKept) : 0),
        besideTests_(income_),
        balance_(stepsInAdvance / static_cast<double>(every) * (1 - shareOfMode) * income_),
        verdict_(income_ > 0
                     ? std::max(ofDiagonal(body) + ofDearestRing(body), std::min(mostForVerdict_, verdictAtStart))
                     : 0) {}

  static constexpr double noLimit = 100;
  bool limited() const { return share_ < noLimit && !(advance_ > 0); }
  /// Whether the first observation may take so much at once: no more than a part of what all steps of the run earn.
  bool affordsAtStart(double work) const { return !limited() || work <= atStart_; }
  /// A step's own work.
  double force() const { return force_; }
  /// What is earned from one observation to the next for the lower side.
  double incomeForMode() const { return shareOfMode * besideTests_; }
  /// And for telling whether a step that is not certified is proven unstable.
  double incomeForVerdict() const {
    return income_ > 0 ? std::max(shareOfVerdict * besideTests_, std::min(forcesForVerdict * force_, leastForVerdict))
                       : 0;
  }

  static double ofForce(const ElementBlock& block) {
    const double nodes = block.nodesPerElement(), points = static_cast<double>(block.rule().points.size());
    if (block.goesByDirections()) return unitsByDirections * nodes * points;
    return unitsOfGathering * nodes + (unitsOfPoint + unitsOfGradient * nodes) * points;
  }
  static double ofEvaluation(const ElementBlock& block) {
    const double size = 3.0 * block.nodesPerElement();
    return size * size * size / 26;
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
  /// One more element of a block, besides so many others at the same observation.
  static double ofEvaluation(const ElementBlock& block, std::size_t others) {
    return ofSingle(evaluationOfSingles, block, others) + (others % lanes == 0 ? lanes * ofEvaluation(block) : 0);
  }
  /// The same, of looking whether a ball can grow: gradients, the stored ones too, and the law's coefficients.
  static double ofGrowth(const ElementBlock& block, std::size_t others) {
    return ofSingle(growthOfSingles, block, others);
  }
  /// Some elements at one observation.
  static double ofEvaluation(const Body& body, std::span<const ElementRef> elements) {
    return ofSingles(body, elements,
                     [](const ElementBlock& block, std::size_t others) { return ofEvaluation(block, others); });
  }
  static double ofGrowth(const Body& body, std::span<const ElementRef> elements) {
    return ofSingles(body, elements,
                     [](const ElementBlock& block, std::size_t others) { return ofGrowth(block, others); });
  }
  /// Allowances for all elements; strain norms as well where weights are new.
  static double ofDistribution(const Body& body, bool newWeights) {
    return (newWeights ? evaluationsOfNewWeights : evaluationsOfDistribution) * ofEvaluation(body);
  }
  /// Moving all allowances, and radii with them.
  static double ofMove(const Body& body) { return unitsOfMove * elements(body); }
  /// A lowering: radii, and the visit of every element that follows. What leaves its ball then comes on top.
  static double ofLowering(const Body& body) { return ofMove(body) + ofForce(body); }
  static double ofRebuild(const Body& body) { return evaluationsOfRebuild * ofEvaluation(body); }
  /// Tangent products of a body, and of their rounding, which costs as much.
  static double ofProducts(const Body& body, int products) { return forcesOfProduct * products * ofForce(body); }
  /// The same of a region of a body, whose vectors are gathered and few, with what that takes beside products.
  static double ofRegion(const Body& part, int products) {
    return unitsOfRegion + dearerInRegion * ofProducts(part, products);
  }
  /// Reading positions and velocities of all nodes, for what is not a number.
  static double ofNodes(const Body& body) { return unitsOfNode * body.nodeCount(); }
  /// Velocities of all nodes that can touch, for how far these may come before the next observation.
  static double ofContact(const Body& body) {
    std::size_t nodes = 0;
    if (const DiscreteForces* discrete = body.discreteForces()) {
      for (const PenaltyContact& contact : discrete->contacts()) nodes += contact.nodes.size();
      for (const SurfaceSearch& surface : discrete->surfaces()) nodes += surface.nodes().size();
    }
    return unitsOfContactNode * static_cast<double>(nodes);
  }
  /// An update of a MovedBound that evaluates and moves so many elements, with the sums at their nodes.
  static double ofMotion(const Body& body, std::int64_t evaluated, std::int64_t moved) {
    return forcesOfTests * ofForce(body) +
           (static_cast<double>(evaluated) + evaluationsOfMotion * static_cast<double>(moved)) * ofEvaluation(body) /
               elements(body);
  }
  /// Measuring the motions of all groups of a RestBound, new references of some elements, and bounds of nodes.
  static double ofMotions(const Body& body) { return forcesOfMotions * ofForce(body); }
  static double ofReferences(const Body& body, std::int64_t count) {
    return forcesOfReference * ofForce(body) * static_cast<double>(count) / elements(body);
  }
  static double ofBoundedNodes(const Body& body, std::int64_t count) {
    return forcesOfBounds * ofForce(body) * static_cast<double>(count) / body.nodeCount();
  }
  /// The diagonal of the tangents of all elements.
  static double ofDiagonal(const Body& body) { return evaluationsOfTangent * ofEvaluation(body); }
  /// A reduced ring, with its eigenvectors and the tangents of the elements around; all of them together, without.
  static double ofRing(const ElementBlock& block) {
    const double size = 3.0 * block.nodesPerElement();
    return unitsOfRing + unitsOfEigenvectors * size * size * size;
  }
  static double ofDearestRing(const Body& body) {
    double dearest = 0;
    for (const auto& block : body.blocks()) dearest = std::max(dearest, ofRing(*block));
    return dearest;
  }
  static double ofAllRings(const Body& body) { return evaluationsOfAllRings * ofEvaluation(body); }

  /// An observation's income: that of the steps from the last one on. No more is kept than two rebuilds cost; for the
  /// lower side, than all reduced rings twice and some products do. seeksVerdict: the step that is taken is not
  /// certified.
  void earn(bool seeksVerdict = false) {
    besideTests_ = std::max(income_ - testsSince_, leastBesideTests * income_);
    testsSince_ = 0;
    balance_ += incomeForProvenSide(seeksVerdict);
    save(mode_, incomeForMode(), evaluationsForMode * evaluation_ + productsKept * forcesOfProduct * force_);
    save(proof_, shareOfProof * besideTests_, evaluationsForProof * evaluation_);
    save(searches_, shareOfSearches * besideTests_, mostForSearches_);
    if (seeksVerdict) verdict_ = std::min(verdict_ + incomeForVerdict(), mostForVerdict_);
    balance_ = std::min(balance_, rebuildsKept * rebuild_);
    asked_ += (askedSince_ - asked_) / stepsOfMean;
    askedSince_ = 0;
  }
  /// What evaluations and repairs have lately asked for, over what is earned for them: above 1 balls are too small for
  /// what there is.
  double load() const { return income_ > 0 ? asked_ / incomeForProvenSide() : loadWithoutIncome; }
  /// All balls have grown: what was asked for before says nothing more of them.
  void ballsGrow() { asked_ = std::min(asked_, incomeForProvenSide()); }
  void spend(const Work& work) {
    takeInAdvance(work.total());
    testsSince_ += work[WorkOn::tests];
    balance_ = std::max(balance_ - work.besideTests(), -mostOwed());
    askedSince_ += work[WorkOn::evaluations] + work[WorkOn::repairs];
  }
  /// What was asked for in vain.
  void refuse(double work) { askedSince_ += work; }
  void spendOnProof(double work) { take(proof_, work); }
  void spendOnMode(double work) { take(mode_, work); }
  void spendOnVerdict(double work) { take(verdict_, work); }
  void spendOnSearches(double work) { take(searches_, work); }
  bool affordsForSearches(double work) const { return has(searches_, work); }
  bool affords(double work) const { return has(balance_, work); }
  /// Returns what is left for the proven side, and beside it for the proof of the step that is taken alone.
  double available() const { return income_ > 0 ? std::max(balance_, 0.0) : 0; }
  double availableForProof() const { return income_ > 0 ? std::max(proof_, 0.0) : 0; }
  bool affordsForProof(double work) const { return has(proof_, work); }
  bool affordsForMode(double work) const { return has(mode_, work); }
  bool affordsForVerdict(double work) const { return has(verdict_, work); }
  /// What single elements may take by overdraft where the certified eigenvalue would have to rise far.
  double overdraft() const { return income_ > 0 ? forcesOfOverdraft * force_ + leastIncome : 0; }
  template <class Archive>
  void archive(Archive& a) {
    a(share_, force_, atStart_, income_, evaluation_, rebuild_, advance_, mostForVerdict_, mostForSearches_,
      besideTests_, testsSince_, balance_, mode_, proof_, verdict_, searches_, asked_, askedSince_);
  }

 private:
  double incomeForProvenSide(bool seeksVerdict = false) const {
    return (1 - shareOfMode - shareOfProof - shareOfSearches - (seeksVerdict ? shareOfVerdict : 0)) * besideTests_;
  }
  /// Adds an income to the tokens of one use; what exceeds the most goes to the proven side.
  void save(double& tokens, double income, double most) {
    tokens += income;
    balance_ += std::max(tokens - most, 0.0);
    tokens = std::min(tokens, most);
  }
  void takeInAdvance(double work) { advance_ = std::max(advance_ - work, 0.0); }
  void take(double& tokens, double work) {
    takeInAdvance(work);
    tokens = std::max(tokens - work, -mostOwed());
  }
  /// Nothing is paid from no income, not even what costs nothing now.
  bool has(double tokens, double work) const { return !limited() || (income_ > 0 && tokens >= work); }
  /// What is owed beyond that is forgiven: it would stop all that makes a bound narrower for the rest of a run.
  double mostOwed() const { return mostOwedOfEvaluation * evaluation_; }
  /// Work on what is in no cache: of the first element at an observation, of a pack and of each element, with so much
  /// more for each quadrature point.
  struct Singles {
    double first, firstPoint, pack, packPoint, each, eachPoint;
  };
  /// Less in blocks whose force leaves something in the caches.
  static double ofSingle(const Singles& of, const ElementBlock& block, std::size_t others) {
    const auto points = static_cast<double>(block.rule().points.size()),
               force = static_cast<double>(block.elementCount()) * ofForce(block);
    return std::clamp(force / forceOfCaches, leastOfSingles, 1.0) *
           ((others == 0 ? of.first + of.firstPoint * points : 0) +
            (others % lanes == 0 ? of.pack + of.packPoint * points : 0) + of.each + of.eachPoint * points);
  }
  template <class Of>
  static double ofSingles(const Body& body, std::span<const ElementRef> elements, const Of& of) {
    std::vector<std::size_t> counts(body.blocks().size(), 0);
    double work = 0;
    for (const ElementRef e : elements) work += of(*body.blocks()[e.block], counts[e.block]++);
    return work;
  }
  template <class Of>
  static double sum(const Body& body, const Of& of) {
    double work = 0;
    for (const auto& block : body.blocks()) work += static_cast<double>(block->elementCount()) * of(*block);
    return work;
  }
  static double elements(const Body& body) { return static_cast<double>(body.mesh().elementCount()); }

  // As measured with AVX-512. Of forces with tet4, tet10, hex8, hex20, wedge6 and pyramid5, in blocks of 5000 and of
  // 100 000 (`ringwatch_bench_body --benchmark_filter=force`).
  static constexpr double unitsByDirections = 0.32, unitsOfGathering = 0.4, unitsOfPoint = 0.2, unitsOfGradient = 0.33;
  // Of rings and regions along runs of 100 000 tetrahedra, wedges and pyramids and 40 000 hexahedra.
  // evaluationsOfRebuild: 6 to 14 of them, with their strain norms.
  static constexpr double evaluationsOfTangent = 0.4, evaluationsOfRebuild = 12, forcesOfProduct = 1.9,
                          dearerInRegion = 1.3;
  // Of tet4, hex8 and wedge6, neighbours and far from each other, in blocks of 5000 and 100 000
  // (`ringwatch_bench_monitor --benchmark_filter=singles`).
  static constexpr double forceOfCaches = 60000, leastOfSingles = 0.2;
  static constexpr Singles evaluationOfSingles{
      .first = 2000, .firstPoint = 550, .pack = 600, .packPoint = 0, .each = 60, .eachPoint = 40},
      growthOfSingles{.first = 1600, .firstPoint = 130, .pack = 320, .packPoint = 110, .each = 20, .eachPoint = 25};
  // Of MovedBound with bars of 1600 and 100 000 tetrahedra.
  static constexpr double forcesOfTests = 0.08, evaluationsOfMotion = 2;
  // Of RestBound with bars of 30 000 tetrahedra, wedges, pyramids and hexahedra.
  static constexpr double forcesOfMotions = 0.15, forcesOfReference = 6, forcesOfBounds = 0.7;
  static constexpr double unitsOfRing = 12000, unitsOfEigenvectors = 1.2, unitsOfRegion = 1000;
  static constexpr double evaluationsOfDecomposition = 2.8, evaluationsOfFactorisation = 2.8;
  static constexpr double evaluationsOfShares = 22, evaluationsOfIteration = 2;
  static constexpr double unitsOfMove = 1.6, unitsOfNode = 0.25, unitsOfContactNode = 0.3;
  static constexpr double evaluationsOfNewWeights = 1.7, evaluationsOfDistribution = 0.6, evaluationsOfAllRings = 1.6;
  // What is kept at most of each income: of rebuilds, of all rings for the lower side, of refreshes for the proof, of
  // searches among all nodes for the verdict and for negative stiffness.
  static constexpr double rebuildsKept = 2, evaluationsForMode = 4, evaluationsForProof = 6, searchesKept = 2,
                          productsKept = 12;
  /// What load() is where nothing is earned: as if twice too much were asked for.
  static constexpr double loadWithoutIncome = 2;
  static constexpr double leastIncome = 2000, leastBesideTests = 0.2, shareOfMode = 0.3, shareOfProof = 0.15,
                          shareOfVerdict = 0.25, shareOfSearches = 0.1, shareAtStart = 0.3, forcesOfOverdraft = 0.5,
                          mostOwedOfEvaluation = 0.2;
  static constexpr double stepsOfMean = 32, stepsInAdvance = 100, rebuildsInAdvance = 7.5;
  // stepsInAdvance: of income, so that the first elements that leave their balls can be evaluated.
  // mostOwedOfEvaluation: a few rounds of these.
  /// Units an observation, no more than some forces of a step: a body of a few thousand elements is searched once in
  /// ten then.
  static constexpr double leastForVerdict = 14000, forcesForVerdict = 8;
  /// Units: all that small bodies may keep, so that a first contact that is too stiff is seen at once; larger ones
  /// begin with a search.
  static constexpr double verdictAtStart = 1e6;
  double share_, force_, atStart_, income_, evaluation_, rebuild_, advance_, mostForVerdict_, mostForSearches_;
  double besideTests_, testsSince_ = 0;  // what an observation earns but for tests; of tests, since
  double balance_, mode_ = 0, proof_ = 0, verdict_, searches_ = 0;
  double asked_ = 0, askedSince_ = 0;  // at an observation, on average; at the last one
};

}  // namespace ringwatch
