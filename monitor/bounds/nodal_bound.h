#pragma once
#include <array>
#include <span>
#include <vector>

#include <ringwatch/base/short_floats.h>
#include <ringwatch/body/tangent_source.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/nodal_weights.h>

namespace ringwatch {

class Domain;

/// A nodal bound that is enough, rad²/s². Below it sweeps go on while they have taken fewer evaluations and two of them
/// gain more than leastGain, but not below one that is ample; nor while two of them gain less than leastOfRest of what
/// the bound is above that.
struct SweepTarget {
  double value = 0, evaluations = 0, leastGain = 0, ample = 0, leastOfRest = 0;
};

/// The block nodal bound, a proven upper bound of the highest eigenvalue of M⁻¹K. For any symmetric positive definite
/// 3×3 weights D_(e,a), one for each element and node, and l_e = max(0, lambda_max(D_e⁻¹ K_e)):
///   K_e ≼ l_e D_e,  so that  lambda_max(M⁻¹K) <= max_i lambda_max(S_i),  S_i = (1/m_i) Σ_(e∋i) l_e D_(e,a(i)).
/// True for every symmetric K_e, indefinite ones included. Discrete forces of the source count in S_i by their
/// majorants (DiscreteForces::majorants). Good weights make it tight: they start at ((K_e²)_aa)^½ and are swept, D_a
/// ← R_i D_a R_i with R_i = (S_i/t)^-½, t the bound. Weights are kept from call to call. Theorem 1,
/// docs/theory/eigenvalue_bounds.md.
class NodalBound {
 public:
  /// Weights to start from: ((K²)_aa)^½, or |K_aa|. What sweeps can reach depends on it, since they multiply the
  /// weights of all elements at a node by the same matrix. The rows win on nearly all meshes; |K_aa| on some regular
  /// ones.
  enum class Start { rows, diagonal };

  explicit NodalBound(const TangentSource& source);

  /// The bound at x, as the source reads it: the best of up to `sweeps` + 1 evaluations. From scratch when nothing is
  /// kept. It ends when two sweeps lowered the bound by no more than leastGain, relative, or to what is enough.
  UpperBound evaluate(NodeVectorsView x, int sweeps, Start start = Start::rows, double leastGain = 0,
                      const SweepTarget& enough = {});
  /// Elements that are not in the source and share nodes with it, by their Σ l_e D_e at each node (N of them, N/m):
  /// they count in every sum and thus in the bound, and are not swept.
  void setOutside(std::vector<Eigen::Matrix3d> sums) { outside_ = std::move(sums); }
  /// The source is a part of a body (body/domain.h): sums and the bound are those of the whole from here on, and
  /// weights of an element the same in every part that has it (Theorem 79, docs/theory/distribution.md). By reference.
  void setDomain(Domain& domain);
  /// The majorants that discrete forces count with, in place of those at the positions of an evaluation: one for each
  /// of their nodes(), N/m.
  void setMajorants(std::vector<Eigen::Matrix3d> majorants) {
    majorants_ = std::move(majorants);
    keepsMajorants_ = true;
  }
  /// One of them, by the place of its node.
  void setMajorant(std::int32_t place, const Eigen::Matrix3d& majorant) { majorants_[place] = majorant; }
  /// Those of setMajorants or of the last evaluation; empty without discrete forces.
  const std::vector<Eigen::Matrix3d>& majorants() const { return majorants_; }
  /// That of a node, N/m.
  Eigen::Matrix3d majorantAt(std::int32_t node) const;
  /// Forgets the weights.
  void reset() { started_ = false; }
  /// The bound with the weights as they are now: that of the last sweep, which need not be the best.
  double last() const { return last_; }

  /// An element at a node: which of the block's weights is its own there.
  struct Incidence {
    std::int32_t block;
    std::int32_t place;  // (batch * n + a) * lanes + lane
  };
  /// The incidences of one node, to loop over.
  class Incidences {
   public:
    class Iterator {
     public:
      Iterator(const std::int32_t* code, const std::int32_t* firstOfBlock) : code_(code), firstOfBlock_(firstOfBlock) {}
      Incidence operator*() const {
        std::int32_t block = 0;
        while (*code_ >= firstOfBlock_[block + 1]) ++block;  // sources have a few groups
        return {block, *code_ - firstOfBlock_[block]};
      }
      Iterator& operator++() {
        ++code_;
        return *this;
      }
      bool operator!=(const Iterator& other) const { return code_ != other.code_; }

     private:
      const std::int32_t *code_, *firstOfBlock_;
    };
    Incidences(std::span<const std::int32_t> codes, const std::int32_t* firstOfBlock)
        : codes_(codes), firstOfBlock_(firstOfBlock) {}
    Iterator begin() const { return {codes_.data(), firstOfBlock_}; }
    Iterator end() const { return {codes_.data() + codes_.size(), firstOfBlock_}; }

   private:
    std::span<const std::int32_t> codes_;
    const std::int32_t* firstOfBlock_;
  };
  Incidences incidences(std::int32_t node) const {
    const std::size_t i = node;
    return {{incidence_.data() + incidenceBegin_[i], incidence_.data() + incidenceBegin_[i + 1]}, firstOfBlock_.data()};
  }
  ElementRef elementAt(Incidence at) const;
  /// The elements that have at least one of the nodes, ascending.
  std::vector<ElementRef> elementsAt(std::span<const std::int32_t> nodes) const;
  /// The incidence of an element at its node a.
  Incidence incidenceOf(ElementRef e, int a) const;
  /// L of a weight D = L Lᵀ, lower triangle 00, 11, 22, 21, 20, 10. Any weights give a bound, so those in memory may as
  /// well be rounded ones, each an L of 16 bits an entry, all at most 1 by size.
  using Factor = std::array<ShortRoot, 6>;
  static Factor factorOf(const Eigen::Matrix3d& D);
  static Eigen::Matrix3d weightOf(const Factor& L);
  Factor factor(Incidence at) const;
  void setFactor(Incidence at, const Factor& L);
  Eigen::Matrix3d weight(Incidence at) const { return weightOf(factor(at)); }
  /// Sets the weight, to within the rounding to a Factor.
  void setWeight(Incidence at, const Eigen::Matrix3d& D) { setFactor(at, factorOf(D)); }
  /// Sets the weights at all nodes of an element, of any size: they get trace 1 over the element.
  void setWeights(ElementRef e, std::span<const Eigen::Matrix3d> weights);
  /// The weights of the elements of a batch at their nodes: D[a].
  void weightsOf(std::int32_t block, std::int32_t batch, Symmetric3<NativePack>* D) const;
  /// Sets them, of any size: they get trace 1 over the element.
  void setWeightsOf(std::int32_t block, std::int32_t batch, const Symmetric3<NativePack>* D);
  /// l_e at x of any elements of a group, one a lane (-1: none): values[lane].
  void elementValues(std::int32_t block, const std::int32_t* elements, NodeVectorsView x, double* values) const;
  /// Symmetric matrices of elements, one a lane, as ElementTangents::tangentOf gives tangents; overwritten.
  struct ElementMatrices {
    NativePack* matrices;
    const NativePack* rounding;  ///< T_a of the nodes: |ΔA_ab| <= √(T_a T_b)
    double* largest;             ///< max(0, lambda_max(D_e⁻¹ A_e)), rounded up: [lane]
  };
  /// Computes the largest eigenvalues of any matrices of such elements, without the rows and columns of constrained
  /// components.
  void weightedLargest(std::int32_t block, const std::int32_t* elements, std::span<const ElementMatrices> sets) const;
  /// l_e of the last sweep.
  double value(ElementRef e) const;
  /// lambda_max(S_i) of every node at the last sweep, rad²/s².
  const std::vector<double>& nodal() const { return nodal_; }
  /// nodal() with the weights as they are and other element values, [block][batch * lanes + lane].
  const std::vector<double>& sumsOf(const std::vector<std::span<const RoundedUp<float>>>& values);
  /// Gives the memory back that only evaluate(), value(), nodal() and sumsOf() need; the weights stay.
  void releaseSums();

  /// The element whose value of the last evaluation from scratch is rounded up by the largest share of itself.
  struct RoundingShare {
    double share = 0;
    ElementRef element{};
  };
  /// The elements above largeRounding, by share: their shapes, or their states, leave little to say in double
  /// precision.
  const std::vector<RoundingShare>& poorlyConditioned() const { return poorlyConditioned_; }
  static constexpr double largeRounding = 1e-3;

  /// Elements times evaluations in the last call, of a part those that it counts (Domain::counts).
  std::int64_t evaluations() const { return evaluations_; }

  template <class Archive>
  void archive(Archive& a) {
    a(started_, weights_, values_, sums_, factors_, outside_, majorants_, keepsMajorants_, nodal_, changed_,
      evaluations_, last_, poorlyConditioned_);
  }

 private:
  using Pack = NativePack;
  void prepareSums();
  /// l_e of all elements; weights start from scratch unless `start` is nullptr.
  void evaluateAll(NodeVectorsView x, const Start* start);
  /// Σ l_e D_(e,a(i)) of a pack of nodes, N/m; zero beyond the last one.
  Symmetric3<Pack> sumOfElements(std::int64_t pack) const;
  /// The sums of the nodes that have changed, and the largest of all.
  double sumAtNodes();
  /// Has the sums of the other parts in place of those that are not whole here.
  void completeSums();
  /// New weights and values where they stand in the way of a lower bound.
  void sweep(NodeVectorsView x, double bound);
  void findFactors(double bound);
  void setValue(ElementRef e, double value);

  const TangentSource* source_;
  bool started_ = false;
  struct StoredFactor {
    alignas(Pack::width * sizeof(ShortRoot)) ShortRoot m[6][Pack::width];
  };
  /// Of any elements of a block, one a lane (-1: the first one's again).
  void gather(std::size_t block, const std::int32_t* elements, StoredFactor* factors) const;
  static CholeskyFactor<Pack> load(const StoredFactor& stored);
  static void store(const Symmetric3<Pack>& weight, StoredFactor& stored);

  std::vector<AlignedVector<StoredFactor>> weights_;  // [block][batch * n + a]
  std::vector<AlignedVector<Pack>> values_;           // [block][batch], l_e
  std::vector<std::int64_t> incidenceBegin_;
  std::vector<std::int32_t> incidence_;     // firstOfBlock_[block] + place
  std::vector<std::int32_t> firstOfBlock_;  // blocks + 1
  AlignedVector<Symmetric3<Pack>> sums_;    // S_i, one node a lane
  AlignedVector<Symmetric3<Pack>> factors_;
  std::vector<Eigen::Matrix3d> outside_;  // by node; empty for none
  Domain* domain_ = nullptr;              // of a part
  std::vector<Eigen::Matrix3d> majorants_;
  bool keepsMajorants_ = false;
  std::vector<double> nodal_;
  std::vector<std::uint8_t> changed_;  // by node: since its sum was made
  std::int64_t evaluations_ = 0;
  double last_ = 0;
  std::vector<RoundingShare> poorlyConditioned_;
};

}  // namespace ringwatch
