#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ringwatch/handlers/certified_selection.h>

namespace ringwatch {

/// A certified selection that is kept while state, step and mesh change. It remembers of each explicit element its
/// shapes D_e, the deformation gradients F0 at which l_e was evaluated, and how fast l_e can grow from there
/// (TangentDrift); at other positions, with R the rotation that brings F0 closest to F,
///   K_e(x) ≼ l(δ) R D_e Rᵀ,   δ = max_q |F_q - R F0_q|,   l(δ) = l_e + linear δ + quadratic δ²,
/// holds without evaluating K_e, for objective laws; R = I for others and at nodes that are held in some directions
/// only. What is summed at the nodes from that is the proof; elements are evaluated again only where it fails: at nodes
/// whose sum is above lambda m_i, and if that does not help, or elements are new, the choice is made again among them
/// and their neighbours, with all others as they are.
class KeptSelection {
 public:
  /// The choice for a limit of lambda, rad²/s², at positions x (3×N, m): from scratch the first time and where more
  /// than half of all elements would be looked at again. keep: elements that stay chosen; others that were chosen are
  /// given back only where the choice is made again. Constraints of elements that it knows must be those they were
  /// chosen with. Throws as selectCertified.
  const CertifiedSelection& choose(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep);
  /// Goes over to a mesh after a cut: elements that the cut has changed are new.
  void carryOver(const CutMesh& cut);

  /// Elements of which the last choice evaluated a tangent.
  std::int64_t judged() const { return static_cast<std::int64_t>(chosenElements(judged_).size()); }
  /// The last choice; its `evaluations` are all that it took.
  const CertifiedSelection& last() const { return last_; }

 private:
  struct Growth {  // of l_e about the anchor, N/m; proven while δ <= radius
    double value = 0;
    float linear = 0, quadratic = 0, radius = -1;  // < 0: not known
  };
  struct Known {  // elements of a block
    std::vector<Growth> growth;
    std::vector<float> anchor;  // [element][quadrature point][9], F0
  };
  /// What is known of an element at other positions.
  struct Now {
    double value = 0;  // l(δ); infinite beyond the radius
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  };
  using Numbers = std::vector<std::vector<std::int32_t>>;

  bool knows(const Body& body) const;
  void indexNodes(const Body& body);
  std::span<const ElementRef> elementsAt(std::int32_t node) const {
    const auto i = static_cast<std::size_t>(node);
    return {elementsAt_.data() + firstAt_[i], elementsAt_.data() + firstAt_[i + 1]};
  }
  void start(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep);
  /// Evaluates the elements of a part of the body, whose numbers in it are given, with shapes of its own.
  void learn(const Body& part, const NodeVectors& x, const Numbers& numbers, const NodalShapes& shapes);
  void lookAtAll(const Body& body, const NodeVectors& x);
  void evaluateAtX(const Body& body, const NodeVectors& x, const ElementFlags& elements);
  void sumAt(const Body& body, const std::vector<std::int32_t>& nodes);
  std::vector<std::int32_t> hotNodes(const Body& body, const std::vector<std::int32_t>& among, double lambda) const;
  bool chooseAround(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep,
                    const ElementFlags& core);

  CertifiedSelection last_;
  std::vector<Known> known_;  // by block; empty before the first choice
  ElementFlags judged_;
  // While it chooses.
  std::vector<std::vector<Now>> now_;
  std::vector<std::size_t> firstAt_;  // nodes + 1: into elementsAt_
  std::vector<ElementRef> elementsAt_;
};

}  // namespace ringwatch
